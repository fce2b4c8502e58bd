# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, each a name, a picture, a text and what it does."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import RESOURCES, places
from ..compat import QT_TRANSLATE_NOOP, translate
from ..errors import SutureError
from ..feature import FilledShape
from . import failures, pick
from .panel import Panel


class Command:
    """What FreeCAD asks of a command."""

    def __init__(self, name, text, tip, keys, action, active):
        self._name, self._text, self._tip, self._keys = name, text, tip, keys
        self._action, self._active = action, active

    def GetResources(self):
        return {
            "Pixmap": str(RESOURCES / "icons" / f"{self._name}.svg"),
            "MenuText": self._text,  # FreeCAD translates both, when the language changes too
            "ToolTip": self._tip,
            "Accel": self._keys,
        }

    def IsActive(self):
        return self._active()

    def Activated(self):
        try:
            self._action()
        except Exception as error:  # the last place where it can be shown
            failures.show(error)


def _open(panel, item=None):
    if Gui.Control.activeDialog():
        raise SutureError(translate("Finish the open task first."))
    if item is None:
        panel().show()
    else:
        panel(item).show(item.obj.Document)


def find_holes():
    from .holes_panel import HolesPanel

    _open(HolesPanel, pick.target())


def fill():
    from .fill_panel import FillPanel

    item = pick.target()
    filled = isinstance(getattr(item.obj, "Proxy", None), FilledShape)
    if filled and not (item.edges or item.faces) and not Gui.Control.activeDialog():
        item.obj.ViewObject.Proxy.doubleClicked(item.obj.ViewObject)
        return
    _open(FillPanel, item)


def _with_elements(name, fits, kind):
    """Opens a panel of elements_panel.py on what is selected; nothing of an object: on the object."""
    from .elements_panel import PANELS

    if Gui.Control.activeDialog():
        raise SutureError(translate("Finish the open task first."))
    items = pick.selected(fits) or [pick.target()]
    if kind == "Face" and len(items) > 1:
        items = [pick.target()]  # says what is wrong
    PANELS[name](items).show(items[0].obj.Document)


def fill_edges():
    _with_elements("Boundary", places.has_shape, "Edge")


def bridge():
    _with_elements("Bridge", places.has_shape, "Edge")


def replace_faces():
    _with_elements("Replace", places.has_faces, "Face")


def remove_faces():
    _with_elements("Remove", places.has_faces, "Face")


def sew():
    from .. import api

    sewn = api.sew(pick.target().obj)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(sewn)


def check():
    from .check_panel import CheckPanel

    _open(CheckPanel, pick.target())


def zebra():
    from . import shading
    from .zebra_panel import ZebraPanel

    item = pick.target()
    if isinstance(Panel.current, ZebraPanel):
        Panel.current.close()
        shading.show_on(item.obj, shading.NONE)
    elif shading.shown_on(item.obj) != shading.NONE:
        shading.show_on(item.obj, shading.NONE)
    else:
        shading.show_on(item.obj, shading.ZEBRA)
        if not Gui.Control.activeDialog():  # the sliders; the stripes need no panel
            _open(ZebraPanel, item)


def combs():
    from .reflection import toggle_combs

    toggle_combs(pick.target())


def _open_surface(command):
    from .surface_panel import SurfacePanel

    if Gui.Control.activeDialog():
        raise SutureError(translate("Finish the open task first."))
    document = App.ActiveDocument or App.newDocument()
    SurfacePanel(command).show(document)


def patch():
    _open_surface("patch")


def algebraic():
    _open_surface("algebraic")


def convert():
    from .convert_panel import ConvertPanel

    _open(ConvertPanel)


def _document():
    return App.ActiveDocument is not None


# name, text, tip, keys, action, when it can be used
_COMMANDS = [
    (
        "Suture_FindHoles",
        QT_TRANSLATE_NOOP("Suture_FindHoles", "Find holes…"),
        QT_TRANSLATE_NOOP("Suture_FindHoles", "List the holes of a shape, show them, choose which to fill"),
        "U, H",
        find_holes,
        _document,
    ),
    (
        "Suture_Fill",
        QT_TRANSLATE_NOOP("Suture_Fill", "Fill holes…"),
        QT_TRANSLATE_NOOP("Suture_Fill", "Fill holes with smooth faces: at the selected edges or faces, or all of the shape"),
        "U, F",
        fill,
        _document,
    ),
    (
        "Suture_FillEdges",
        QT_TRANSLATE_NOOP("Suture_FillEdges", "Fill from edges…"),
        QT_TRANSLATE_NOOP("Suture_FillEdges", "Make a smooth face over the selected edges: rims of one or more objects, sketches, wires"),
        "U, E",
        fill_edges,
        _document,
    ),
    (
        "Suture_Bridge",
        QT_TRANSLATE_NOOP("Suture_Bridge", "Bridge…"),
        QT_TRANSLATE_NOOP("Suture_Bridge", "Join two edges, rims or bodies by a smooth face"),
        "U, B",
        bridge,
        _document,
    ),
    (
        "Suture_ReplaceFaces",
        QT_TRANSLATE_NOOP("Suture_ReplaceFaces", "Replace faces…"),
        QT_TRANSLATE_NOOP("Suture_ReplaceFaces", "Take the selected faces away, and fill what they leave anew"),
        "U, N",
        replace_faces,
        _document,
    ),
    (
        "Suture_RemoveFaces",
        QT_TRANSLATE_NOOP("Suture_RemoveFaces", "Remove faces…"),
        QT_TRANSLATE_NOOP("Suture_RemoveFaces", "Take the selected faces away, and let their neighbours grow together: an edge where a fillet was"),
        "U, R",
        remove_faces,
        _document,
    ),
    (
        "Suture_Sew",
        QT_TRANSLATE_NOOP("Suture_Sew", "Sew faces"),
        QT_TRANSLATE_NOOP("Suture_Sew", "Join the loose faces of a shape along their common edges"),
        "U, S",
        sew,
        _document,
    ),
    (
        "Suture_Check",
        QT_TRANSLATE_NOOP("Suture_Check", "Check continuity…"),
        QT_TRANSLATE_NOOP("Suture_Check", "Measure gap, angle and curvature along every edge of a shape"),
        "U, C",
        check,
        _document,
    ),
    (
        "Suture_Zebra",
        QT_TRANSLATE_NOOP("Suture_Zebra", "Zebra stripes"),
        QT_TRANSLATE_NOOP("Suture_Zebra", "Show reflected stripes on the selected shape, or take them away"),
        "U, Z",
        zebra,
        _document,
    ),
    (
        "Suture_Combs",
        QT_TRANSLATE_NOOP("Suture_Combs", "Curvature combs"),
        QT_TRANSLATE_NOOP("Suture_Combs", "Show how both faces bend at the selected edges, or take the combs away"),
        "U, K",
        combs,
        _document,
    ),
    (
        "Suture_Patch",
        QT_TRANSLATE_NOOP("Suture_Patch", "Patch from a mesh…"),
        QT_TRANSLATE_NOOP("Suture_Patch", "Make a smooth many-sided surface from a control mesh of quads, an OBJ file"),
        "U, M",
        patch,
        lambda: True,
    ),
    (
        "Suture_Algebraic",
        QT_TRANSLATE_NOOP("Suture_Algebraic", "Algebraic surface…"),
        QT_TRANSLATE_NOOP("Suture_Algebraic", "Make the surface that joins others given by polynomials, in a JSON file"),
        "U, A",
        algebraic,
        lambda: True,
    ),
    (
        "Suture_Convert",
        QT_TRANSLATE_NOOP("Suture_Convert", "Convert files…"),
        QT_TRANSLATE_NOOP("Suture_Convert", "Fill the holes of files on disk, or convert them, without opening them"),
        "U, V",
        convert,
        lambda: True,
    ),
]
NAMES = [command[0] for command in _COMMANDS]


def register():
    for command in _COMMANDS:
        Gui.addCommand(command[0], Command(*command))
