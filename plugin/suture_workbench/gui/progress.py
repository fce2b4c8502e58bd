# SPDX-License-Identifier: LGPL-2.1-or-later
"""Follows a task without blocking the window."""

import time

import FreeCADGui as Gui

from ..compat import QtCore, QtWidgets, run_loop, translate
from ..errors import SutureError

_POLL_MS = 40
_SHOW_AFTER_SECONDS = 0.4


class Watcher(QtCore.QObject):
    """Asks a task again and again whether it is done, then calls `done(result)` or `failed(error)`.

    Every task that was started is followed to its end, also after `cancel`: then nothing is called,
    but the processes are seen out.
    """

    def __init__(self, done, failed, advanced=None):
        super().__init__()
        self._done, self._failed = done, failed
        self._advanced = advanced or (lambda fraction, stage: None)
        self._task = None
        self._leaving = []
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_POLL_MS)
        self._timer.timeout.connect(self._poll)

    def busy(self):
        return self._task is not None

    def leaving(self):
        """Whether a cancelled task is still on its way out."""
        return bool(self._leaving)

    def start(self, task):
        """Starts a task in place of the one that runs."""
        self.cancel()
        self._task = task
        self._timer.start()
        try:
            task.start()
        except SutureError as error:
            self._task = None
            self._failed(error)

    def release(self):
        """Hands the running task over to somebody who waits for it."""
        task, self._task = self._task, None
        return task

    def cancel(self):
        if self._task is not None:
            self._task.cancel()
            self._leaving.append(self._task)
            self._task = None

    def _poll(self):
        self._leaving = [task for task in self._leaving if task.running()]
        task = self._task
        if task is None:
            if not self._leaving:
                self._timer.stop()
            return
        if task.running():
            self._advanced(*task.progress())
            return
        self._task = None
        try:
            result = task.result()
        except Exception as error:  # whatever it is, the user has to see it
            self._failed(error)
            return
        self._done(result)


def run_with_dialog(task):
    """The task's result, waited for with a dialog that can stop it; timers and repaints go on.

    A task that runs already is waited for as it is.
    """
    if not task.started():
        task.start()
    began = time.monotonic()
    while task.running() and time.monotonic() - began < _SHOW_AFTER_SECONDS:
        # No clicks before the dialog is there to keep them from the document.
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents, _POLL_MS)
        time.sleep(0.005)
    if task.running():
        _wait_in_dialog(task)
    return task.result()


def _wait_in_dialog(task):
    dialog = _Dialog(task.cancel)
    loop = QtCore.QEventLoop()

    def poll():
        if task.running():
            dialog.advance(*task.progress())
        else:
            loop.quit()

    timer = QtCore.QTimer()
    timer.timeout.connect(poll)
    timer.start(_POLL_MS)
    dialog.show()
    application = QtWidgets.QApplication.instance()
    application.installEventFilter(dialog)
    try:
        run_loop(loop)
    finally:
        application.removeEventFilter(dialog)
        timer.stop()
        dialog.done(0)
        dialog.deleteLater()
        task.kill()


class _Dialog(QtWidgets.QDialog):
    """Stays until the task has ended: nobody may touch the document before."""

    def __init__(self, stop):
        super().__init__(Gui.getMainWindow())
        self.setObjectName("SutureProgress")
        self.setWindowTitle("Suture")
        self.setWindowModality(QtCore.Qt.ApplicationModal)
        self.setMinimumWidth(360)
        self._stop, self._stopping = stop, False
        self._label = QtWidgets.QLabel(translate("Working…"))
        self._bar = QtWidgets.QProgressBar()
        self._bar.setRange(0, 1000)
        self._button = QtWidgets.QPushButton(translate("Stop"))
        self._button.clicked.connect(self.reject)
        layout = QtWidgets.QVBoxLayout(self)
        for widget in (self._label, self._bar, self._button):
            layout.addWidget(widget)

    def advance(self, fraction, stage):
        self._bar.setValue(int(1000 * fraction))
        if stage and not self._stopping and stage != self._label.text():
            self._label.setText(stage)

    def eventFilter(self, watched, event):
        """While FreeCAD recomputes, a filter of its own swallows every click and key; this one was
        installed later, so it comes first, and lets those for the dialog through."""
        kind = event.type()
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
            if watched is self._button or watched == self.windowHandle():
                watched.event(event)
                return True
        if kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            self.reject()
            return True
        return False

    def reject(self):
        """Esc, the window's cross, and the button."""
        self._stopping = True
        self._label.setText(translate("Stopping…"))
        self._button.setEnabled(False)
        self._stop()
