# SPDX-License-Identifier: LGPL-2.1-or-later
"""Get the program: install it from a file, locate it, or build it from this addon's source."""

import os

import FreeCADGui as Gui

from .. import ADDON, install, program, settings
from ..compat import QtCore, QtGui, QtWidgets, run_loop, translate
from ..errors import SutureError
from .forms import find, load_form


class ProgramDialog:
    """A dialog that stays until the user has a program, or gives up."""

    def __init__(self, parent=None):
        self.form = QtWidgets.QDialog(parent or Gui.getMainWindow())
        self.form.setWindowTitle(translate("The program suture"))
        self.form.setObjectName("SutureProgramDialog")
        self.form.setMinimumWidth(420)
        QtWidgets.QVBoxLayout(self.form).addWidget(load_form("program"))
        find(self.form, "SutureOutput", QtWidgets.QPlainTextEdit).hide()
        find(self.form, "SutureStopBuild").hide()
        script = ADDON / "suture"
        self._command = f"{script} --version"
        find(self.form, "SutureBuild").setEnabled(script.is_file())
        find(self.form, "SutureCopy", QtWidgets.QPushButton).setEnabled(script.is_file())
        find(self.form, "SutureCommand", QtWidgets.QLabel).setText(
            ".../suture --version"
            if script.is_file()
            else translate("This addon has no source with it.")
        )
        find(self.form, "SutureCommand").setToolTip(self._command)
        for name, action in (
            ("SutureInstallFile", self._install),
            ("SutureLocate", self._locate),
            ("SutureBuild", self._start_build),
            ("SutureCopy", self._copy),
            ("SutureStopBuild", self._stop_build),
        ):
            find(self.form, name).clicked.connect(action)
        find(self.form, "buttons", QtWidgets.QDialogButtonBox).rejected.connect(self.form.reject)
        self._process = QtCore.QProcess(self.form)
        self._process.setProcessChannelMode(QtCore.QProcess.MergedChannels)
        self._process.readyRead.connect(self._read)
        self._process.finished.connect(self._built)
        self._look()

    def run(self):
        run_loop(self.form)
        self._stop_build()
        self.form.deleteLater()

    def install(self, path):
        """Installs a bundle or a wheel, and says what came of it."""
        self._try(lambda: install.install(path))

    def locate(self, path):
        """Takes the program at a path from now on."""

        def take():
            install.version(path)
            settings.save_program(path)

        self._try(take)

    def _try(self, action):
        try:
            action()
        except SutureError as error:
            find(self.form, "SutureProgramState", QtWidgets.QLabel).setText(str(error))
            return
        self._look()

    def _look(self):
        """Says which program there is."""
        try:
            path = program.find()
            text = translate("Found: {} ({}).").format(path, install.version(path))
        except SutureError as error:
            text = str(error)
        find(self.form, "SutureProgramState", QtWidgets.QLabel).setText(text)

    def _install(self):
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self.form,
            translate("Bundle or wheel of Suture"),
            "",
            translate("Suture (*.tar.xz *.tar.gz *.zip *.whl)"),
        )
        if path:
            settings.save_program("")  # what was chosen before gives way
            self.install(path)

    def _locate(self):
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.form, translate("Program suture"))
        if path:
            self.locate(path)

    def _copy(self):
        QtGui.QGuiApplication.clipboard().setText(self._command)
        find(self.form, "SutureProgramState", QtWidgets.QLabel).setText(translate("Copied. Paste it into a terminal."))

    # -- building

    def _start_build(self):
        find(self.form, "SutureOutput", QtWidgets.QPlainTextEdit).clear()
        find(self.form, "SutureOutput", QtWidgets.QPlainTextEdit).show()
        find(self.form, "SutureStopBuild").show()
        find(self.form, "SutureBuild").setEnabled(False)
        find(self.form, "SutureProgramState", QtWidgets.QLabel).setText(translate("Building…"))
        environment = QtCore.QProcessEnvironment()
        for key, value in program.environment().items():
            environment.insert(key, value)
        self._process.setProcessEnvironment(environment)
        if os.name == "posix":  # in a group of its own, so that all of it can be stopped
            self._process.start("setsid", ["--wait", str(ADDON / "suture"), "--version"])
        else:
            self._process.start(str(ADDON / "suture"), ["--version"])

    def _read(self):
        find(self.form, "SutureOutput", QtWidgets.QPlainTextEdit).appendPlainText(bytes(self._process.readAll()).decode(errors="replace").rstrip())

    def _built(self, code, *_):
        find(self.form, "SutureStopBuild").hide()
        find(self.form, "SutureBuild").setEnabled(True)
        if code == 0:
            self._look()
        else:
            find(self.form, "SutureProgramState", QtWidgets.QLabel).setText(
                translate("Building failed (exit code {}); the last lines say why.").format(code)
            )

    def _stop_build(self):
        if self._process.state() == QtCore.QProcess.NotRunning:
            return
        program.end_children(int(self._process.processId()))
        self._process.terminate()
        self._process.waitForFinished(2000)
