# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, and selecting for the user."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import parts, places
from ..compat import translate
from ..errors import SutureError


def selected(fits=places.has_faces):
    """places.Selected of everything selected that has faces, or fits otherwise."""
    return places.selection(Gui.Selection.getSelectionEx("", 0), fits)


def target():
    """The one object to work on: the selected one, else the only one that is shown.

    Anything else raises, saying what is wrong and what to do: never another object than the
    selected one.
    """
    found = selected()
    if len(found) > 1:
        raise SutureError(
            translate("Several objects are selected: {}. Select one of them.").format(
                ", ".join(item.obj.Label for item in found)
            )
        )
    if found:
        return found[0]
    unfit = [obj for obj in Gui.Selection.getSelection() if obj is not None]
    if unfit:
        raise SutureError(why_unfit(unfit[0]))
    shown = _shown_objects()
    if len(shown) == 1:
        return places.Selected(shown[0], [], [], shown[0], "")
    if not shown:
        raise SutureError(translate("There is no shape to work on: open or make one first."))
    raise SutureError(
        translate("Several objects are shown: {}. Select the one to work on.").format(
            ", ".join(obj.Label for obj in shown)
        )
    )


def why_unfit(obj):
    """Why an object cannot be worked on, and what to do."""
    if obj.isDerivedFrom("Mesh::Feature"):
        return translate(
            "{} is a mesh; Suture works on surfaces. Part > Create shape from mesh makes one, which "
            "can be selected then."
        ).format(obj.Label)
    if obj.isDerivedFrom("Points::Feature"):
        return translate("{} is a cloud of points: it has no surface to work on.").format(obj.Label)
    if places.has_shape(obj) or obj.isDerivedFrom("Part::Part2DObject"):
        return translate(
            "{} has lines only, no face. Select the solid or the surface whose hole they bound."
        ).format(obj.Label)
    return translate("{} has no shape. Select a solid, a surface or one of its edges.").format(
        obj.Label
    )


def _shown_objects():
    """What is shown and has faces; the outermost ones, so that a Part counts once."""
    document = App.ActiveDocument
    shown = [
        obj
        for obj in (document.Objects if document else [])
        if _visible(obj)
        and not obj.isDerivedFrom("App::OriginFeature")
        and not obj.isDerivedFrom("Part::Datum")
        and all(_visible(holder) for holder in places.containers(obj))
        and places.base_of(obj) is obj
        and places.has_faces(obj)
    ]
    holders = [obj for obj in shown if parts.is_container(obj)]
    inside = {name for holder in holders for name in parts.names_in(holder)}
    outer = [obj for obj in shown if obj.Name not in inside]
    if len(outer) == 1 and outer[0] in holders:
        inner = [obj for obj in shown if obj.Name in inside and obj not in holders]
        if len(inner) == 1 and len(parts.leaves(outer[0])) == 1:
            return inner  # a Part around one body is the body
    return outer


def _visible(obj):
    return obj.ViewObject is not None and obj.ViewObject.Visibility


_own_selection = False


def selecting():
    """Whether it is we who select at this moment."""
    return _own_selection


def select_edges(item, edges):
    """Selects edges of an object, so that the view shows them."""
    select_elements(item, "Edge", edges)


def select_elements(item, kind, numbers):
    """Selects edges or faces of an object."""
    global _own_selection
    _own_selection = True
    try:
        Gui.Selection.clearSelection()
        for number in numbers:
            name = item.path + parts.element_path(item.obj, kind, number)
            Gui.Selection.addSelection(item.top.Document.Name, item.top.Name, name)
    finally:
        _own_selection = False
