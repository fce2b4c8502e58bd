# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, each a name, a picture, a text and what it does."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import RESOURCES
from ..compat import translate
from ..errors import SutureError
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


def _open(panel):
    if Gui.Control.activeDialog():
        raise SutureError(translate("Finish the open task first."))
    panel().show()


def find_holes():
    from .holes_panel import HolesPanel

    item = _target()
    _open(lambda: HolesPanel(item))


def fill():
    from .fill_panel import FillPanel

    item = _target()
    if getattr(getattr(item.obj, "Proxy", None), "__class__", None).__name__ == "FilledShape" and not (
        item.edges or item.faces
    ):
        item.obj.ViewObject.Proxy.setEdit(item.obj.ViewObject)
        return
    _open(lambda: FillPanel(item))


def check():
    from .check_panel import CheckPanel

    item = _target()
    _open(lambda: CheckPanel(item))


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


# translate() is called where they are shown; here only marked by tests/plugin's extraction.
_COMMANDS = [
    ("Suture_FindHoles", "Find holes…", "List the holes of a shape, show them, choose which to fill", "S, H", find_holes, _document),
    ("Suture_Fill", "Fill holes…", "Fill holes with smooth faces: of the selected edges or faces, or all of the shape", "S, F", fill, _document),
    ("Suture_Check", "Check continuity…", "Measure how smoothly the faces of a shape meet: gap, angle and curvature along every edge", "S, C", check, _document),
    ("Suture_Zebra", "Zebra stripes", "Show reflection stripes on the selected shape, or take them away", "S, Z", zebra, _document),
    ("Suture_Combs", "Curvature combs", "Show how both faces bend at the selected edges, or take the combs away", "S, K", combs, _document),
    ("Suture_Convert", "Convert files…", "Fill the holes of files on disk, or convert them, without opening them", "S, V", convert, lambda: True),
]
NAMES = [command[0] for command in _COMMANDS]


def register():
    for command in _COMMANDS:
        Gui.addCommand(command[0], Command(*command))
