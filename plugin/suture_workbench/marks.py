# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges known by a point as well as by their number, which changes when a shape is put together anew."""

import FreeCAD as App
import Part

_SAME = 1e-6  # of the shape's size: a point that is nearer lies on the edge


def written(shape, number):
    """The mark of an edge as text: its number, and its middle."""
    edge = shape.Edges[number - 1]
    point = edge.valueAt(sum(edge.ParameterRange) / 2)
    return f"{number} {point.x!r} {point.y!r} {point.z!r}"


def read(text):
    """(number, point) of a mark."""
    number, *point = text.split()
    return int(number), App.Vector(*map(float, point))


def number_at(shape, number, point):
    """The number of the edge through a point: the old one if it still goes there, else the only one
    that does. Where there is none, or more than one, the shape itself has changed: the old number."""
    edges = shape.Edges
    reach = max(_SAME * shape.BoundBox.DiagonalLength, 1e-7)
    if number <= len(edges) and _through(edges[number - 1], point, reach):
        return number
    others = [index for index, edge in enumerate(edges, 1) if _through(edge, point, reach)]
    return others[0] if len(others) == 1 else number


def _through(edge, point, reach):
    if edge.Degenerated:
        return False
    box = edge.BoundBox
    box.enlarge(reach)
    return box.isInside(point) and edge.distToShape(Part.Vertex(point))[0] <= reach
