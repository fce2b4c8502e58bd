# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, each a name, a picture, a text and what it does."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import RESOURCES
from ..compat import mark, translate
from ..errors import SutureError
from ..feature import FilledShape
from . import failures, pick


class Command:
    """What FreeCAD asks of a command."""

    def __init__(self, name, text, tip, keys, action, active):
        self._name, self._text, self._tip, self._keys = name, text, tip, keys
        self._action, self._active = action, active

    def GetResources(self):
        return {
            "Pixmap": str(RESOURCES / "icons" / f"{self._name}.svg"),
            "MenuText": translate(self._text),
            "ToolTip": translate(self._tip),
            "Accel": self._keys,
        }

    def IsActive(self):
        return self._active()

    def Activated(self):
        try:
            self._action()
        except Exception as error:  # the last place where it can be shown
            failures.show(error)


def _target():
    item = pick.target()
    if item is None:
        raise SutureError(translate("Select the object to work on, or one of its edges or faces."))
    return item


def _open(panel, item=None):
    if Gui.Control.activeDialog():
        raise SutureError(translate("Finish the open task first."))
    if item is None:
        panel().show()
    else:
        panel(item).show(item.obj.Document)


def find_holes():
    from .holes_panel import HolesPanel

    _open(HolesPanel, _target())


def fill():
    from .fill_panel import FillPanel

    item = _target()
    filled = isinstance(getattr(item.obj, "Proxy", None), FilledShape)
    if filled and not (item.edges or item.faces):
        item.obj.ViewObject.Proxy.setEdit(item.obj.ViewObject)
        return
    _open(FillPanel, item)


def check():
    from .check_panel import CheckPanel

    _open(CheckPanel, _target())


def zebra():
    from .reflection import toggle_zebra

    toggle_zebra(_target())


def combs():
    from .reflection import toggle_combs

    toggle_combs(_target())


def convert():
    from .convert_panel import ConvertPanel

    _open(ConvertPanel)


def _document():
    return App.ActiveDocument is not None


# name, text, tip, keys, action, when it can be used
_COMMANDS = [
    (
        "Suture_FindHoles",
        mark("Find holes…"),
        mark("List the holes of a shape, show them, choose which to fill"),
        "S, H",
        find_holes,
        _document,
    ),
    (
        "Suture_Fill",
        mark("Fill holes…"),
        mark("Fill holes with smooth faces: at the selected edges or faces, or all of the shape"),
        "S, F",
        fill,
        _document,
    ),
    (
        "Suture_Check",
        mark("Check continuity…"),
        mark("Measure gap, angle and curvature along every edge of a shape"),
        "S, C",
        check,
        _document,
    ),
    (
        "Suture_Zebra",
        mark("Zebra stripes"),
        mark("Show reflected stripes on the selected shape, or take them away"),
        "S, Z",
        zebra,
        _document,
    ),
    (
        "Suture_Combs",
        mark("Curvature combs"),
        mark("Show how both faces bend at the selected edges, or take the combs away"),
        "S, K",
        combs,
        _document,
    ),
    (
        "Suture_Convert",
        mark("Convert files…"),
        mark("Fill the holes of files on disk, or convert them, without opening them"),
        "S, V",
        convert,
        lambda: True,
    ),
]
NAMES = [command[0] for command in _COMMANDS]


def register():
    for command in _COMMANDS:
        Gui.addCommand(command[0], Command(*command))
