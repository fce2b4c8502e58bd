# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which way a hole faces: from where it is seen. Needs no window."""

import FreeCAD as App

_POINTS_ON_AN_EDGE = 12


def outward(shape, edges, faces):
    """The direction from which the loop of `edges` (in their order around it) is seen best.

    It is perpendicular to the area that the loop encloses. The side is that of its neighbours'
    normals, or, where these say nothing (a box without its lid), away from the middle of the shape.
    """
    loop = _chain([shape.Edges[number - 1] for number in edges])
    middle = sum(loop, App.Vector()) * (1.0 / len(loop))
    area = App.Vector()
    for before, after in zip(loop, loop[1:] + loop[:1]):
        area += (before - middle).cross(after - middle)
    normals = _normals(shape, edges, faces)
    length = sum(shape.Edges[number - 1].Length for number in edges)
    if area.Length < 1e-3 * length * length:  # a loop that encloses no area, like a slit
        return normals if normals.Length > 0 else middle - shape.BoundBox.Center
    area.normalize()
    side = area.dot(normals) / max(len(edges), 1)
    if abs(side) < 0.1:
        side = area.dot(middle - shape.BoundBox.Center)
    return area if side >= 0 else area * -1


def _chain(edges):
    """Points around the loop."""
    points = []
    for index, edge in enumerate(edges):
        line = edge.discretize(_POINTS_ON_AN_EDGE)
        if index:
            forwards = (line[0] - points[-1]).Length <= (line[-1] - points[-1]).Length
        elif len(edges) > 1:  # ends where the next edge has an end
            ends = [vertex.Point for vertex in edges[1].Vertexes]
            forwards = min((line[-1] - end).Length for end in ends) <= min(
                (line[0] - end).Length for end in ends
            )
        else:
            forwards = True
        points += line if forwards else line[::-1]
    return points


def _normals(shape, edges, faces):
    """The sum of the neighbours' normals, one for each edge."""
    total = App.Vector()
    for edge, face in zip(edges, faces):
        edge, face = shape.Edges[edge - 1], shape.Faces[face - 1]
        first, last = edge.ParameterRange
        try:
            total += face.normalAt(*face.Surface.parameter(edge.valueAt((first + last) / 2)))
        except Exception:  # the tip of a cone has none
            continue
    return total
