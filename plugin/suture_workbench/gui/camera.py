# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turns the camera of the 3D view to what a row of a list stands for."""

import FreeCAD as App
import FreeCADGui as Gui

# A view that is less than 53 degrees off the direction from which something is seen best is left as it is.
_GOOD_ENOUGH = 0.6


def look_at(points, placement, radius, outward=None):
    """Brings the box around points, and some room, into the view; with `outward`, the direction that
    they face, it is seen from there. All are seen from `placement`."""
    if not hasattr(Gui.ActiveDocument.ActiveView, "getCameraNode"):
        return  # a drawing or a spreadsheet is on top
    box = App.BoundBox()
    for point in points:
        box.add(placement.multVec(App.Vector(*point)))
    box.enlarge(radius)
    if outward is not None and outward.Length > 0:
        _turn(placement.Rotation.multVec(outward).normalize())
    _frame(box)


def _turn(outward):
    """Looks at what faces `outward` unless the camera already does, as little turned as will do."""
    view = Gui.ActiveDocument.ActiveView
    towards_eye = App.Vector(view.getViewDirection()) * -1
    if towards_eye.dot(outward) >= _GOOD_ENOUGH:
        return
    aside = towards_eye - outward * towards_eye.dot(outward)
    eye = outward + (aside.normalize() * 0.6 if aside.Length > 1e-6 else App.Vector())
    eye.normalize()
    up = App.Vector(0, 0, 1) if abs(eye.z) < 0.95 else App.Vector(0, 1, 0)
    rotation = App.Rotation(App.Vector(), up, eye, "ZYX")
    view.getCameraNode().orientation = tuple(rotation.Q)


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
