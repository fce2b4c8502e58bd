# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gap, angle and radii at one point of a shape, from FreeCAD's own geometry. Needs no window."""

import math

import FreeCAD as App

from . import combs
from .compat import translate


def at_edge(shape, number, point):
    """(gap, angle in degrees or None, [radius across the edge on each face]) where `point` is nearest.

    The gap is that between the two surfaces; a radius is math.inf where the face is straight.
    """
    edge = shape.Edges[number - 1]
    first, last = edge.ParameterRange
    t = min(max(edge.Curve.parameter(point), first), last)
    foot, tangent = edge.valueAt(t), edge.tangentAt(t)
    feet, normals, radii = [], [], []
    for face in combs.faces_at(shape, number):
        u, v = face.Surface.parameter(foot)
        normal = face.normalAt(u, v)
        feet.append(face.Surface.value(u, v))
        normals.append(normal)
        bend = combs.normal_curvature(face, u, v, normal.cross(tangent))
        radii.append(1.0 / abs(bend) if abs(bend) > 1e-12 else math.inf)
    gap = (feet[0] - feet[1]).Length if len(feet) == 2 else 0.0
    angle = math.degrees(normals[0].getAngle(normals[1])) if len(normals) == 2 else None
    return gap, angle, radii


def at_face(shape, number, point):
    """The two principal radii of a face where `point` is nearest, the smaller one first."""
    face = shape.Faces[number - 1]
    u, v = face.Surface.parameter(point)
    bends = (abs(face.Surface.curvature(u, v, kind)) for kind in ("Max", "Min"))
    return sorted(1.0 / bend if bend > 1e-12 else math.inf for bend in bends)


def text(shape, kind, number, point):
    """What stands at a point of an element ("Edge", 9), in words."""
    try:
        if kind == "Edge":
            gap, angle, radii = at_edge(shape, number, point)
            said = translate("Edge{} here: gap {:.2g} mm").format(number, gap)
            if angle is not None:
                said += translate(", angle {:.3g}°").format(angle)
            return said + translate(", radii across {}").format(_radii(radii))
        if kind == "Face":
            return translate("Face{} here: radii {}").format(
                number, _radii(at_face(shape, number, point))
            )
    except Exception:  # a pole of a sphere, the tip of a cone: FreeCAD raises several kinds
        pass
    return translate("{}{}: nothing can be measured at this point.").format(kind, number)


def outward(shape, number, point):
    """The mean normal of the faces at a point of an edge: from there it is seen."""
    total = App.Vector()
    for face in combs.faces_at(shape, number):
        try:
            total += face.normalAt(*face.Surface.parameter(App.Vector(*point)))
        except Exception:  # as above
            continue
    return total


def _radii(radii):
    flat = translate("flat")
    return ", ".join(flat if radius > 1e9 else f"{radius:.4g} mm" for radius in radii)
