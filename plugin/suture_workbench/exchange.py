# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes to the program and back, as FreeCAD's binary BREP: exact, and numbered alike."""

import hashlib
import math

import FreeCAD as App
import Part

from .compat import translate
from .errors import SutureError

SUFFIX = ".bin"
# Fingerprints are rounded to this (mm); the offset keeps round numbers away from the boundaries, so
# that the last bits, which saving and opening a document may change, do not count.
_GRID = 1e-7
_OFFSET = 0.31830988e-7


def without_placement(shape):
    """A copy at the origin: the shape does not change when its object is moved."""
    local = shape.copy()
    local.Placement = App.Placement()
    return local


def write_shape(shape, path):
    """Writes a shape for the program."""
    shape.exportBinary(str(path))


def read_shape(path):
    """The shape that the program has written."""
    shape = Part.Shape()
    try:
        shape.importBinary(str(path))
        null = shape.isNull()
    except Exception as error:  # FreeCAD raises several kinds, and bare RuntimeError
        raise SutureError(_damaged(error)) from error
    if null or not shape.Faces:
        raise SutureError(_damaged(translate("there is no face in it")))
    return shape


def unwrapped(shape):
    """The one shape in a compound of one; the numbers stay the same."""
    while shape.ShapeType == "Compound" and len(shape.SubShapes) == 1:
        shape = shape.SubShapes[0]
    return shape


def _damaged(reason):
    return translate("The shape that the program has written cannot be read: {}.").format(reason)


def fingerprint(shape):
    """A text that stays the same as long as the shape does, also when it is saved and opened."""
    digest = hashlib.sha256()

    def add(*vectors):
        for vector in vectors:
            cells = (math.floor((x + _OFFSET) / _GRID + 0.5) for x in vector)
            digest.update(repr(tuple(cells)).encode())

    for vertex in shape.Vertexes:
        add(vertex.Point)
    for edge in shape.Edges:
        first, last = edge.ParameterRange
        if edge.Degenerated:
            continue
        digest.update(edge.Curve.TypeId.encode())
        add(*(edge.valueAt(first + t * (last - first)) for t in (0.29, 0.5, 0.83)))
    for face in shape.Faces:
        u0, u1, v0, v1 = face.ParameterRange
        digest.update((face.Surface.TypeId + face.Orientation).encode())
        add(
            *(
                face.valueAt(u0 + a * (u1 - u0), v0 + b * (v1 - v0))
                for a, b in ((0.5, 0.5), (0.21, 0.37), (0.79, 0.63))
            )
        )
    return digest.hexdigest()


def loose_faces(shape):
    """Whether faces share no edge with another: the program sews such a shape before it numbers."""
    faces = shape.Faces
    if len(faces) < 2:
        return False
    users = {}
    for index, face in enumerate(faces):
        for edge in face.Edges:
            users.setdefault(edge.hashCode(), set()).add(index)
    return any(all(len(users[edge.hashCode()]) == 1 for edge in face.Edges) for face in faces)


def same_edges(numbers, shape, other, tolerance):
    """The numbers that the edges `numbers` of `shape` have in `other`, whose faces are sewn.

    Result   {number: number}; an edge that lies on none is left out.
    """
    candidates = [
        (index, edge, edge.BoundBox)
        for index, edge in enumerate(other.Edges, 1)
        if not edge.Degenerated
    ]
    reach = max(10 * tolerance, 1e-6)
    result = {}
    for number in numbers:
        edge = shape.Edges[number - 1]
        first, last = edge.ParameterRange
        probes = [Part.Vertex(edge.valueAt(first + t * (last - first))) for t in (0.31, 0.5, 0.77)]
        best = None
        for index, candidate, box in candidates:
            box.enlarge(reach)
            inside = all(box.isInside(probe.Point) for probe in probes)
            box.enlarge(-reach)
            if not inside:
                continue
            distance = max(candidate.distToShape(probe)[0] for probe in probes)
            if distance <= reach and (best is None or distance < best[0]):
                best = (distance, index)
        if best:
            result[number] = best[1]
    return result


def changed_faces(before, after):
    """The numbers of the faces of `after` that are no faces of `before`."""

    def key(face):
        center = face.CenterOfMass
        return tuple(round(x, 5) for x in (face.Area, center.x, center.y, center.z))

    known = set(map(key, before.Faces))
    return [number for number, face in enumerate(after.Faces, 1) if key(face) not in known]


def face_origins(new_faces, count_before, count_after, gone=()):
    """For each face of the result the index of the face it was before, None for a new one.

    The program leaves the old faces in their order and puts new ones among them; `new_faces` are
    their numbers, `gone` those of faces that were taken away. Result   None where the counts do not
    fit, so that nobody is misled.
    """
    new = set(new_faces)
    if count_after - len(new) != count_before - len(gone):
        return None
    old = iter(index for index in range(count_before) if index + 1 not in gone)
    return [None if number in new else next(old) for number in range(1, count_after + 1)]
