# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, and selecting for the user."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import places


def selected():
    """places.Selected of everything selected that has a shape."""
    return places.selection(Gui.Selection.getSelectionEx("", 0))


def anything():
    """Whether there is something to work on: for the commands' IsActive, so it must be quick."""
    return App.ActiveDocument is not None and bool(Gui.Selection.getSelection())


def target():
    """The one object to work on: the selected one, else the only visible one that has faces."""
    found = selected()
    if found:
        return found[0]
    document = App.ActiveDocument
    visible = [
        obj
        for obj in (document.Objects if document else [])
        if obj.ViewObject is not None
        and obj.ViewObject.Visibility
        and not obj.isDerivedFrom("App::Part")
        and not obj.isDerivedFrom("App::Origin")
        and not obj.isDerivedFrom("App::OriginFeature")
        and places.base_of(obj) is obj
        and places.has_shape(obj)
        and places.shape_of(obj).Faces
    ]
    if len(visible) != 1:
        return None
    return places.Selected(visible[0], [], [], visible[0], "")


def select_edges(item, edges):
    """Selects edges of an object, so that the view shows them."""
    Gui.Selection.clearSelection()
    for edge in edges:
        name = f"{item.path}Edge{edge}"
        Gui.Selection.addSelection(item.top.Document.Name, item.top.Name, name)


def look_at(points, placement, radius):
    """Turns the camera to the box around points, and some room."""
    moved = [placement.multVec(App.Vector(*point)) for point in points]
    box = App.BoundBox()
    for point in moved:
        box.add(point)
    box.enlarge(radius)
    _frame(box)


def _frame(box):
    """Moves the camera so that a box fills the view; the direction stays."""
    from pivy import coin

    view = Gui.ActiveDocument.ActiveView
    camera = view.getCameraNode()
    width, height = view.getSize()
    region = coin.SbViewportRegion(width, height)
    node = coin.SoSeparator()
    place = coin.SoTranslation()
    place.translation = tuple(box.Center)
    cube = coin.SoCube()
    cube.width, cube.height, cube.depth = (
        max(x, 1e-6) for x in (box.XLength, box.YLength, box.ZLength)
    )
    node.addChild(place)
    node.addChild(cube)
    camera.viewAll(node, region)
