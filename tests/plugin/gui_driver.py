"""Runs inside FreeCAD's window (test_gui.py starts it) and does what a user does there.

A scenario is a generator: it acts, then yields what to wait for. SUTURE_SCENARIO names it (gui_walk.walk),
SUTURE_OUT is the folder for its pictures and for result.json: {"error": text or null, "said": {}}.
"""

import importlib
import json
import os
import re
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

OUT = Path(os.environ["SUTURE_OUT"])
ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
sys.path.append(str(ROOT / "tests/support"))

from time_limits import limit  # noqa: E402

WINDOW = (1240, 860)
TICK_MS = 20


class Driver:
    """What scenarios use: looks for widgets, clicks, waits, takes pictures."""

    def __init__(self):
        self.window = Gui.getMainWindow()
        self.ticks = 0
        self.said = {}
        self.out = OUT

    # -- waiting

    def until(self, what, condition, seconds=90):
        return what, condition, time.monotonic() + limit(seconds)

    def pause(self, seconds):
        end = time.monotonic() + seconds
        return self.until("a pause", lambda: time.monotonic() >= end, seconds + 30)

    def preview(self):
        """A preview that has come, good or bad."""
        return self.until("the preview", lambda: self.there("SutureSides") and self.settled())

    def settled(self):
        """Whether the panel has found out what it runs the program for."""
        return self.there("SutureStatus") and self.state() in ("good", "bad")

    # -- widgets

    def find(self, name, kind=QtGui.QWidget):
        """The visible widget of a name."""
        found = [w for w in self.window.findChildren(kind, name) if w.isVisible()]
        if not found:
            raise AssertionError(f"no visible widget {name}")
        return found[-1]

    def there(self, name):
        return any(w.isVisible() for w in self.window.findChildren(QtGui.QWidget, name))

    def state(self):
        return self.find("SutureStatus").property("state")

    def choose(self, combo, key):
        """Chooses an entry of a combo box by its key."""
        box = self.find(combo, QtGui.QComboBox)
        index = box.findData(key)
        if index < 0:
            raise AssertionError(f"{combo} has no {key}")
        box.setCurrentIndex(index)

    def unfold(self, name):
        """Opens a part of the panel that is folded away."""
        button = self.find(name, QtGui.QToolButton)
        if not button.isChecked():
            self.click(button)

    def status(self):
        return self.find("SutureStatus").text()

    def click(self, widget, position=None, modifiers=QtCore.Qt.NoModifier):
        """Presses and releases the left button over a widget, by default in its middle."""
        position = position or widget.rect().center()
        if isinstance(widget, QtGui.QCheckBox):
            position = QtCore.QPoint(10, widget.height() // 2)  # beside its text nothing happens
        for kind, buttons in (
            (QtCore.QEvent.MouseMove, QtCore.Qt.NoButton),
            (QtCore.QEvent.MouseButtonPress, QtCore.Qt.LeftButton),
            (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton),
        ):
            button = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else QtCore.Qt.LeftButton
            place = QtCore.QPointF(position)
            outside = QtCore.QPointF(widget.mapToGlobal(position))
            event = QtGui.QMouseEvent(kind, place, outside, button, buttons, modifiers)
            QtGui.QApplication.postEvent(widget, event)

    def click_row(self, tree, row, column=0):
        tree.scrollToItem(row)
        rectangle = tree.visualItemRect(row)
        left = tree.header().sectionViewportPosition(column) + 40
        self.click(tree.viewport(), QtCore.QPoint(left, rectangle.center().y()))

    def tick_row(self, tree, row):
        """Clicks the box of a row."""
        option = QtGui.QStyleOptionViewItem()
        option.rect = tree.visualItemRect(row)
        option.features |= QtGui.QStyleOptionViewItem.HasCheckIndicator
        box = tree.style().subElementRect(QtGui.QStyle.SE_ItemViewItemCheckIndicator, option, tree)
        self.click(tree.viewport(), box.center())

    def press(self, standard_button, within=None):
        """Presses OK, Cancel or Close of the task panel, or of another window."""
        for box in (within or self.window).findChildren(QtGui.QDialogButtonBox):
            button = box.button(standard_button) if box.isVisible() else None
            if button is not None:
                self.click(button)
                return
        raise AssertionError("no such button")

    def tool(self, command):
        """Clicks the button of a command in the toolbar, as soon as it can be (`yield from` it)."""

        def ready():
            return [
                button
                for button in self.window.findChildren(QtGui.QToolButton)
                if button.isVisible()
                and button.isEnabled()
                and button.defaultAction() is not None
                and button.defaultAction().objectName() == command
            ]

        yield self.until(f"the button {command}", ready)
        self.click(ready()[0])

    def choose_file(self, path, filter_word, picture=None):
        """Fills in FreeCAD's file dialog, as with the keyboard, and accepts (`yield from` it)."""

        def dialogs():
            windows = QtGui.QApplication.topLevelWidgets()
            return [w for w in windows if isinstance(w, QtGui.QFileDialog) and w.isVisible()]

        yield self.until("the file dialog", dialogs)
        yield self.pause(0.3)
        dialog = dialogs()[0]
        chosen = [text for text in dialog.nameFilters() if filter_word in text][0]
        dialog.selectNameFilter(chosen)
        dialog.filterSelected.emit(chosen)
        line = dialog.findChild(QtGui.QLineEdit)
        if picture:  # of what is filled in, without the list of somebody's files
            line.setText(Path(path).name)
            part = QtCore.QRect(0, dialog.height() - 70, dialog.width(), 70)
            dialog.grab(part).save(str(OUT / f"{picture}.png"))
        line.setText(str(path))
        key = QtCore.Qt.Key_Return
        event = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, key, QtCore.Qt.NoModifier)
        QtGui.QApplication.postEvent(line, event)

    def key(self, widget, key):
        """Presses and releases a key over a widget."""
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            QtGui.QApplication.postEvent(widget, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier))

    def view_widget(self):
        """The widget of the 3D view."""
        return [w for w in self.window.findChildren(QtGui.QGraphicsView) if w.isVisible()][-1]

    def drawn(self):
        """How many layers of ours the view has."""
        from pivy import coin  # noqa: F401  without it 1.x gives no scene graph

        scene = Gui.ActiveDocument.ActiveView.getSceneGraph()
        nodes = (scene.getChild(index) for index in range(scene.getNumChildren()))
        return [node.getName().getString() for node in nodes].count("SutureOverlay")

    def panel_width(self, pixels):
        """Makes the task panel as wide as FreeCAD does by default."""
        docks = [d for d in self.window.findChildren(QtGui.QDockWidget) if d.isVisible()]
        for dock in docks:
            if dock.objectName() in ("Combo View", "Tasks", "Model", "Tree view"):
                self.window.resizeDocks([dock], [pixels], QtCore.Qt.Horizontal)

    def python_errors(self):
        """What the report view has of Python's errors."""
        views = self.window.findChildren(QtGui.QTextEdit)
        text = "\n".join(v.toPlainText() for v in views if v.objectName() == "Report view")
        text = re.sub(r"<class 'suture_workbench\.errors\.\w+'>", "", text)  # a sentence for the user
        return re.findall(r"(?m)^.*(?:Traceback \(most|\b[A-Z]\w*(?:Error|Exception)\b).*$", text)

    def later(self, action):
        """Does something that opens a dialog of its own: this function returns before it is closed."""
        QtCore.QTimer.singleShot(0, action)

    def dialog_open(self):
        return bool(Gui.Control.activeDialog())

    # -- the 3D view

    def look(self, x, y, z):
        """Looks from a direction at the whole model."""
        view = Gui.ActiveDocument.ActiveView
        view.setAnimationEnabled(False)
        view.viewIsometric()
        view.setCameraOrientation(
            App.Rotation(App.Vector(1, -1, 0), App.Vector(0, 0, 1), App.Vector(x, y, z), "ZYX")
        )
        view.fitAll()

    def pick(self, element, point):
        """Moves to an element near a point of the model until FreeCAD names it, then clicks."""
        view = Gui.ActiveDocument.ActiveView
        x0, y0 = view.getPointOnScreen(App.Vector(*point))
        viewport = self.view_widget().viewport()
        around = sorted(
            ((dx, dy) for dx in range(-9, 10) for dy in range(-9, 10)),
            key=lambda d: d[0] ** 2 + d[1] ** 2,
        )
        for dx, dy in around:
            seen = view.getObjectInfo((x0 + dx, y0 + dy))
            if seen and seen["Component"] == element:
                # The view counts in the size that it was last drawn in.
                width, height = view.getSize()
                x = (x0 + dx) * viewport.width() / width
                y = viewport.height() - 1 - (y0 + dy) * viewport.height() / height
                self.click(viewport, QtCore.QPoint(round(x), round(y)))
                return
        raise AssertionError(f"{element} is not to be seen")

    def picture(self, name):
        self.window.statusBar().clearMessage()
        Gui.updateGui()
        self.window.screen().grabWindow(self.window.winId()).save(str(OUT / f"{name}.png"))

    def picture_of_all(self, name):
        """The whole screen, dialogs included."""
        self.window.screen().grabWindow(0).save(str(OUT / f"{name}.png"))


def tidy(driver):
    """A window as for a picture: no console, a wide panel."""
    driver.window.setGeometry(0, 0, *WINDOW)
    for dock in driver.window.findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    driver.panel_width(440)


def finish(driver, error):
    if not error and driver.python_errors():
        error = "Python errors in the report view:\n" + "\n".join(driver.python_errors())
    result = {"error": error, "said": driver.said}
    (OUT / "result.json").write_text(json.dumps(result, indent=1), encoding="utf-8")
    sys.stdout.flush()
    os._exit(1 if error else 0)


def main():
    sys.path.insert(0, str(ROOT / "tests/plugin"))
    module, function = os.environ["SUTURE_SCENARIO"].split(".")
    driver = Driver()
    try:
        scenario = getattr(importlib.import_module(module), function)
    except BaseException:
        finish(driver, traceback.format_exc())
    tidy(driver)
    steps = scenario(driver)
    waiting = [None]

    def advance():
        driver.ticks += 1
        try:
            if waiting[0] is not None:
                what, condition, deadline = waiting[0]
                if not condition():
                    if time.monotonic() > deadline:
                        driver.picture("failed")
                        raise AssertionError(f"waited in vain for {what}")
                    return
            waiting[0] = next(steps)
        except StopIteration:
            finish(driver, None)
        except BaseException:
            finish(driver, traceback.format_exc())

    global timer
    timer = QtCore.QTimer()
    timer.timeout.connect(advance)
    timer.start(TICK_MS)


timer = None
QtCore.QTimer.singleShot(1000, main)
