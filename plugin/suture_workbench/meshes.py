# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes as lines and triangles to be drawn. Needs no window."""

import math

import FreeCAD as App


def outline(edge, deflection):
    """An edge as a polyline, finer than faces: on a line one sees corners sooner."""
    return edge.discretize(Deflection=deflection / 10) if edge.Length > 0 else []


def fineness(shape):
    """A deflection at which a shape looks round."""
    return max(shape.BoundBox.DiagonalLength * 1e-3, 1e-6)


def mesh_of(face, deflection):
    """(points, normals, triangles) of a face, with the surface's own normals."""
    points, triangles = face.tessellate(deflection)
    # The nodes' parameters come in another order: found again by place, else by projection.
    digits = 3 - math.floor(math.log10(deflection))
    parameters = {_rounded(face.valueAt(u, v), digits): (u, v) for u, v in face.getUVNodes()}
    normals = []
    for index, point in enumerate(points):
        u, v = parameters.get(_rounded(point, digits)) or face.Surface.parameter(point)
        try:
            normal = face.normalAt(u, v)
        except Exception:  # at a pole or the tip of a cone there is none
            normal = _mean_normal(index, points, triangles)
        normals.append(tuple(normal))
    return [tuple(point) for point in points], normals, triangles


def _mean_normal(index, points, triangles):
    """That of the triangles around a point."""
    total = App.Vector()
    for a, b, c in triangles:
        if index in (a, b, c):
            total += (points[b] - points[a]).cross(points[c] - points[a])
    return total.normalize() if total.Length > 0 else App.Vector(0, 0, 1)


def _rounded(point, digits):
    return tuple(round(x, digits) for x in point)
