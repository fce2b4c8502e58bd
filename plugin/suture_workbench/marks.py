# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges and faces known by a point as well as by their number, which changes when a shape is put
together anew."""

import FreeCAD as App
import Part

_SAME = 1e-6  # of the shape's size: a point that is nearer lies on the edge


def written(shape, number, kind="Edge"):
    """The mark of an edge or face as text: its number ("9", "Face9"), and a point inside it."""
    point = _middle(shape.Edges[number - 1]) if kind == "Edge" else _inside(shape.Faces[number - 1])
    name = f"{number}" if kind == "Edge" else f"{kind}{number}"
    return f"{name} {point.x!r} {point.y!r} {point.z!r}"


def read(text):
    """(("Edge", number), point) of a mark."""
    name, *point = text.split()
    kind = name.rstrip("0123456789")
    return (kind or "Edge", int(name[len(kind) :])), App.Vector(*map(float, point))


def number_at(shape, number, point, kind="Edge"):
    """The number of the edge or face through a point: the old one if it still goes there, else the
    only one that does. Where there is none, or more than one, the shape itself has changed: the old
    number."""
    elements = shape.Edges if kind == "Edge" else shape.Faces
    reach = max(_SAME * shape.BoundBox.DiagonalLength, 1e-7)
    if number <= len(elements) and _through(elements[number - 1], point, reach):
        return number
    others = [index for index, one in enumerate(elements, 1) if _through(one, point, reach)]
    return others[0] if len(others) == 1 else number


def _middle(edge):
    return edge.valueAt(sum(edge.ParameterRange) / 2)


def _inside(face):
    """The point of a face that lies deepest in it, of those on a grid of parameters."""
    u0, u1, v0, v1 = face.ParameterRange
    grid = [(u0 + i * (u1 - u0) / 12, v0 + j * (v1 - v0) / 12) for i in range(1, 12) for j in range(1, 12)]
    points = [face.valueAt(u, v) for u, v in grid if face.isPartOfDomain(u, v)]
    if not points:
        return _middle(face.Edges[0])
    border = Part.Compound(face.Edges)
    return max(points, key=lambda point: border.distToShape(Part.Vertex(point))[0])


def _through(element, point, reach):
    if element.ShapeType == "Edge" and element.Degenerated:
        return False
    box = element.BoundBox
    box.enlarge(reach)
    return box.isInside(point) and element.distToShape(Part.Vertex(point))[0] <= reach
