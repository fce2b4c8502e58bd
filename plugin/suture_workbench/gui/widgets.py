# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small widgets that the panels share."""

import FreeCAD as App

from .. import settings
from ..compat import QtCore, QtWidgets, translate
from .forms import put


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


def limit_boxes(form):
    """The boxes for gap, angle and curvature, put into a form that has their places."""
    return [
        put(form, "gapPlace", number_box(settings.gap(), "mm", translate("Largest gap"))),
        put(
            form,
            "anglePlace",
            number_box(settings.angle(), "°", translate("Largest angle of tangent joins")),
        ),
        put(
            form,
            "curvaturePlace",
            number_box(
                settings.curvature(), "%", translate("Largest curvature mismatch of G2 joins")
            ),
        ),
    ]


class Tolerance(QtWidgets.QDoubleSpinBox):
    """A spin box that shows as many digits as there are."""

    def textFromValue(self, value):
        text = self.locale().toString(value, "f", self.decimals())
        return text.rstrip("0").rstrip(self.locale().decimalPoint())


# Letters on a ground of their own: they can be read in dark and light themes.
_LOOKS = {
    "good": "background: #d9efd9; color: #1d4d1d; padding: 3px; border-radius: 3px;",
    "bad": "background: #fadfd2; color: #7a2a08; padding: 3px; border-radius: 3px;",
    "plain": "",
    "busy": "",
}


class Status(QtWidgets.QWidget):
    """A line of text, a bar while something runs, and a button that stops it.

    state   "busy", or how the last run ended: "good", "bad", "plain"
    """

    def __init__(self, stop):
        super().__init__()
        self.state = "plain"
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
        row.addWidget(self.bar, 1)
        row.addWidget(self.button)
        self.way_on = QtWidgets.QPushButton()
        self.way_on.setObjectName("SutureWayOn")
        self.way_on.clicked.connect(lambda *_: self._action())
        self._action = lambda: None
        layout.addWidget(self.label)
        layout.addLayout(row)
        layout.addWidget(self.way_on)
        self.way_on.hide()
        self.bar.hide()
        self.button.hide()

    def advance(self, fraction, stage):
        self.bar.setValue(int(1000 * fraction))
        self._say(stage or translate("Working…"), "busy")

    def good(self, text):
        self._say(text, "good")

    def bad(self, text):
        self._say(text, "bad")

    def plain(self, text):
        self._say(text, "plain")

    def offer(self, text, action):
        """A button below the text, for what the user can do about it."""
        self._action = action
        self.way_on.setText(text)
        self.way_on.show()

    def _say(self, text, state):
        # Only what changes: setting a style again costs a tenth of a second of layout each time.
        self.state = state
        self.label.setProperty("state", state)
        self.way_on.hide()
        if text != self.label.text():
            self.label.setText(text)
        if _LOOKS[state] != self.label.styleSheet():
            self.label.setStyleSheet(_LOOKS[state])
        busy = state == "busy"
        if busy != self.button.isVisibleTo(self):
            self.bar.setVisible(busy)
            self.button.setVisible(busy)


def length(value):
    """A length in the user's units."""
    return App.Units.Quantity(value, App.Units.Length).UserString


def show_heading(label, text):
    """The label of what a panel works on; a long one does not widen the panel."""
    label.setText(f"<b>{text}</b>")
    label.setWordWrap(True)
    label.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
    label.setToolTip(text)
