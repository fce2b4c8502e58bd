# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature combs across an edge: how both faces bend where they meet. Needs no window."""

import math
from collections import namedtuple

Comb = namedtuple("Comb", "feet curvatures normals")  # of one face along one edge


def across(edge, face, count=40):
    """The comb of `face` along `edge`: its normal curvature across the edge, towards its normal."""
    first, last = edge.ParameterRange
    feet, curvatures, normals = [], [], []
    for step in range(count + 1):
        t = first + (last - first) * step / count
        point = edge.valueAt(t)
        u, v = face.Surface.parameter(point)
        try:
            normal = face.normalAt(u, v)
            tangent = edge.tangentAt(t)
            curvature = normal_curvature(face, u, v, normal.cross(tangent))
        except Exception:  # the pole of a sphere, the tip of a cone: nothing to draw there
            continue
        feet.append(point)
        curvatures.append(curvature)
        normals.append(normal)
    return Comb(feet, curvatures, normals)


def normal_curvature(face, u, v, direction):
    """Curvature of the normal section in a direction, by Euler's formula; towards the face's normal
    where it is positive."""
    surface = face.Surface
    largest, smallest = (surface.curvature(u, v, kind) for kind in ("Max", "Min"))
    along_largest, _ = surface.curvatureDirections(u, v)
    cosine = math.cos(along_largest.getAngle(direction))
    curvature = largest * cosine**2 + smallest * (1.0 - cosine**2)
    return -curvature if face.Orientation == "Reversed" else curvature


def hairs(comb, scale):
    """The comb's hairs and its upper line as polylines; they stand on the outside of what bends."""
    tips = [
        foot - normal * (curvature * scale)
        for foot, curvature, normal in zip(comb.feet, comb.curvatures, comb.normals)
    ]
    return [[foot, tip] for foot, tip in zip(comb.feet, tips)] + ([tips] if len(tips) > 1 else [])


def good_scale(combs, size):
    """A scale at which the longest hair is a third of `size`."""
    longest = max((abs(k) for comb in combs for k in comb.curvatures), default=0.0)
    return size / (3.0 * longest) if longest > 1e-12 else 1.0


def faces_at(shape, number):
    """The faces at an edge of a shape."""
    edge = shape.Edges[number - 1]
    return [face for face in shape.Faces if any(edge.isSame(other) for other in face.Edges)]


def at_edges(shape, numbers):
    """One comb for each face at each of the edges: [(number, Comb), ...]."""
    return [
        (number, across(shape.Edges[number - 1], face))
        for number in numbers
        if not shape.Edges[number - 1].Degenerated
        for face in faces_at(shape, number)
    ]
