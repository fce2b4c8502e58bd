# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small widgets that the panels share."""

import FreeCAD as App
import FreeCADGui as Gui

from ..compat import QtCore, QtGui, QtWidgets, as_int, translate

Buttons = QtWidgets.QDialogButtonBox


def number_box(value, suffix, tip, maximum=1000.0, decimals=6):
    """A spin box for a tolerance, without trailing zeros."""
    box = Tolerance()
    box.setDecimals(decimals)
    box.setRange(10.0**-decimals, maximum)
    box.setSingleStep(value / 2)
    box.setSuffix(f" {suffix}")
    box.setToolTip(tip)
    box.setValue(value)
    box.setKeyboardTracking(False)
    return box


class Tolerance(QtWidgets.QDoubleSpinBox):
    """A spin box that shows as many digits as there are."""

    def textFromValue(self, value):
        text = self.locale().toString(value, "f", self.decimals())
        return text.rstrip("0").rstrip(self.locale().decimalPoint())


class Status(QtWidgets.QWidget):
    """A line of text, a bar while something runs, and a button that stops it."""

    def __init__(self, stop):
        super().__init__()
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.label = QtWidgets.QLabel()
        self.label.setObjectName("SutureStatus")
        self.label.setWordWrap(True)
        self.label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setRange(0, 1000)
        self.button = QtWidgets.QPushButton(translate("Stop"))
        self.button.setObjectName("SutureStop")
        self.button.clicked.connect(stop)
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.bar)
        row.addWidget(self.button)
        layout.addWidget(self.label)
        layout.addLayout(row)
        self.bar.hide()
        self.button.hide()

    def advance(self, fraction, stage):
        self._busy(True)
        self.bar.setValue(int(1000 * fraction))
        self._say(stage or translate("Working…"), "")

    def good(self, text):
        self._end(text, "#2a7f2a")

    def bad(self, text):
        self._end(text, "#b8461f")

    def plain(self, text):
        self._end(text, "")

    def _end(self, text, color):
        self._busy(False)
        self._say(text, color)

    def _say(self, text, color):
        # Only what changes: setting a style again costs a tenth of a second of layout each time.
        if text != self.label.text():
            self.label.setText(text)
        style = f"color: {color};" if color else ""
        if style != self.label.styleSheet():
            self.label.setStyleSheet(style)

    def _busy(self, busy):
        if busy != self.button.isVisibleTo(self):
            self.bar.setVisible(busy)
            self.button.setVisible(busy)


class Panel:
    """A task panel: `form`, and the buttons that FreeCAD puts above it."""

    icon = ""
    title = ""
    buttons = (Buttons.Close,)
    _guard = None

    def __init__(self):
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(self.title)
        self.form.setObjectName(type(self).__name__)
        if self.icon:
            self.form.setWindowIcon(QtGui.QIcon(self.icon))
        self.layout = QtWidgets.QVBoxLayout(self.form)

    def show(self, document=None):
        """Opens the panel; it goes when `document` does."""
        self._guard = _Guard(self, document) if document is not None else None
        Gui.Control.showDialog(self)
        return self

    def close(self):
        """Takes the panel away."""
        if self._guard is not None:
            App.removeDocumentObserver(self._guard)
            self._guard = None
        self.leave()
        Gui.Control.closeDialog()
        if Gui.ActiveDocument is not None:
            Gui.ActiveDocument.resetEdit()

    def getStandardButtons(self):
        total = 0
        for button in self.buttons:
            total |= as_int(button)
        return total

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return False

    def reject(self):
        self.close()
        return True

    def leave(self):
        """Takes away what the panel has drawn and started."""


class _Guard:
    """Closes a panel when its document is closed."""

    def __init__(self, panel, document):
        self._panel, self._name = panel, document.Name
        App.addDocumentObserver(self)

    def slotDeletedDocument(self, document):
        if document.Name == self._name:
            self._panel.close()


def length(value):
    """A length in the user's units."""
    return App.Units.Quantity(value, App.Units.Length).UserString


def heading(text):
    """The label of what a panel works on; a long one does not widen the panel."""
    label = QtWidgets.QLabel(f"<b>{text}</b>")
    label.setWordWrap(True)
    label.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
    label.setToolTip(text)
    return label
