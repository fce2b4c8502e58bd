# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a filled shape shows itself. Documents name this class: keep its name."""

import FreeCADGui as Gui

from .. import RESOURCES, exchange, parts, places
from ..compat import (
    QtCore,
    Stateless,
    element_of,
    face_colors,
    plain_color,
    set_face_colors,
    translate,
)
from ..errors import SutureError
from . import failures


class FilledShapeView(Stateless):
    """View provider of feature.FilledShape."""

    _panel = None  # the one in which it is edited

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object):
        self.Object = view_object.Object

    def getIcon(self):
        return str(RESOURCES / "icons" / f"Suture_{_ICONS[self.Object.Task]}.svg")

    def claimChildren(self):
        return _sources(self.Object)

    def updateData(self, obj, name):
        if name == "NewFaces":  # set after Shape, when all is there
            self.keep_colors(obj)

    def keep_colors(self, obj):
        """The old faces have the colours that they have in the base, new ones its first colour."""
        sources = _sources(obj)
        views = [leaf.ViewObject for base in sources for leaf in parts.leaf_objects(base)]
        views = [view for view in views if view is not None and hasattr(view, "DiffuseColor")]
        if not views:
            return
        before = sum(len(places.shape_of(base).Faces) for base in sources)
        gone = [element_of(sub) for sub in obj.Base[1] or ()]
        gone = [int(name[4:]) for name in gone if name.startswith("Face")]
        origins = exchange.face_origins(obj.NewFaces, before, len(obj.Shape.Faces), gone)
        colors = [color for view in views for color in _colors_of(view)]
        obj.ViewObject.ShapeColor = views[0].ShapeColor
        obj.ViewObject.Transparency = views[0].Transparency
        if origins is None or len(colors) != before:
            return
        plain = plain_color(views[0])
        set_face_colors(
            obj.ViewObject, [plain if origin is None else colors[origin] for origin in origins]
        )

    def onDelete(self, view_object, subs):
        for base in _sources(view_object.Object):
            if base.ViewObject:
                base.ViewObject.Visibility = True
        return True

    def doubleClicked(self, view_object):
        obj = view_object.Object
        if Gui.Control.activeDialog():
            failures.show(SutureError(translate("Finish the open task first.")))
            return True
        # After the tree has closed its transaction: to look is no step of undo.
        QtCore.QTimer.singleShot(0, lambda: _edit(obj))
        return True

    def setEdit(self, view_object, mode=0):
        from .elements_panel import PANELS
        from .fill_panel import FillPanel

        if mode != 0:
            return None
        obj = view_object.Object
        try:
            panel = PANELS.get(obj.Task, FillPanel)
            self._panel = panel.edit(obj).show(obj.Document)
        except SutureError as error:
            failures.show(error)
            return False
        return True

    def unsetEdit(self, view_object, mode=0):
        """Esc, a second object that is edited, a document that is closed: the panel goes as by Cancel."""
        panel, self._panel = self._panel, None
        if panel is not None:
            panel.close()
        return True


_ICONS = {
    "Holes": "Fill",
    "Boundary": "FillEdges",
    "Bridge": "Bridge",
    "Replace": "ReplaceFaces",
    "Remove": "RemoveFaces",
}


def _sources(obj):
    """The objects that it is made from, the base first."""
    base = obj.Base[0] if obj.Base else None
    if base is None:
        return []
    return list(dict.fromkeys([base, *(other for other, _ in obj.MoreEdges or ())]))


def _edit(obj):
    try:
        if places.exists(obj):
            Gui.getDocument(obj.Document.Name).setEdit(obj.Name)
    except Exception as error:  # the last place where it can be shown
        failures.show(error)


def _colors_of(view):
    """One colour for each face."""
    count = len(view.Object.Shape.Faces)
    colors = face_colors(view)
    return colors if len(colors) == count else [plain_color(view)] * count
