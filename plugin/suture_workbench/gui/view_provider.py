# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a filled shape shows itself. Documents name this class: keep its name."""

import FreeCADGui as Gui

from .. import RESOURCES, exchange, places
from ..compat import Stateless, face_colors, set_face_colors


class FilledShapeView(Stateless):
    """View provider of feature.FilledShape."""

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object):
        self.Object = view_object.Object

    def getIcon(self):
        return str(RESOURCES / "icons" / "Suture_Fill.svg")

    def claimChildren(self):
        base = self.Object.Base
        return [base[0]] if base and base[0] else []

    def updateData(self, obj, name):
        if name == "NewFaces":  # set after Shape, when all is there
            self.keep_colors(obj)

    def keep_colors(self, obj):
        """The old faces have the colours that they have in the base, new ones its first colour."""
        base = obj.Base[0] if obj.Base else None
        view = getattr(base, "ViewObject", None)
        if view is None or not hasattr(view, "DiffuseColor"):
            return
        before, after = len(places.shape_of(base).Faces), len(obj.Shape.Faces)
        origins = exchange.face_origins(obj.NewFaces, before, after)
        colors = face_colors(view)
        obj.ViewObject.ShapeColor = view.ShapeColor
        obj.ViewObject.Transparency = view.Transparency
        if origins is None or len(colors) != before:
            return
        plain = tuple(float(part) for part in view.ShapeColor)
        set_face_colors(
            obj.ViewObject, [plain if origin is None else colors[origin] for origin in origins]
        )

    def onDelete(self, view_object, subs):
        base = view_object.Object.Base
        if base and base[0] and base[0].ViewObject:
            base[0].ViewObject.Visibility = True
        return True

    def doubleClicked(self, view_object):
        return self.setEdit(view_object)

    def setEdit(self, view_object, mode=0):
        from .fill_panel import FillPanel

        if mode != 0:
            return None
        obj = view_object.Object
        Gui.Control.closeDialog()
        FillPanel.edit(obj).show(obj.Document)
        return True

    def unsetEdit(self, view_object, mode=0):
        return None
