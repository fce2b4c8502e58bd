# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forms of .ui files, and what is done with their parts."""

import FreeCADGui as Gui

from .. import RESOURCES
from ..compat import QtCore, QtWidgets


def load_form(name):
    """A widget with the form of a .ui file; its texts are translated as ours are (its class is our
    context).

    PySide hears of the end only of what Python has made, as the widget around the form: what it still
    holds of others may turn up again in the place of something new. So look for a child whenever it
    is used, and keep none.
    """
    form = QtWidgets.QWidget()
    layout = QtWidgets.QVBoxLayout(form)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(Gui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui")))
    return form


def find(form, name, kind=QtWidgets.QWidget):
    """The child of a form; to be used at once."""
    return form.findChild(kind, name)


def put(form, name, widget):
    """Puts a widget where the form has a placeholder of that name."""
    place = find(form, name)
    place.setObjectName("")
    place.hide()
    for layout in form.findChildren(QtWidgets.QLayout):
        if layout.indexOf(place) >= 0:
            layout.replaceWidget(place, widget)
            break
    widget.setObjectName(widget.objectName() or name)
    place.deleteLater()
    return widget


def connect_folds(form):
    """Lets every button that has a property `folds` open and fold the widget of that name."""
    for button in form.findChildren(QtWidgets.QToolButton):
        folded, name = button.property("folds"), button.objectName()
        if not folded:
            continue

        def fold(on, name=name, folded=folded):
            find(form, folded).setVisible(on)
            arrow = QtCore.Qt.DownArrow if on else QtCore.Qt.RightArrow
            find(form, name, QtWidgets.QToolButton).setArrowType(arrow)

        button.toggled.connect(fold)
        fold(button.isChecked())
