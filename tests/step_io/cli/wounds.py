"""Models for the tests of chosen edges and faces, made with FreeCAD's Part, and what is in them."""

import math
import random
import sys

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402
import Part  # noqa: E402

V = FreeCAD.Vector


def polygon(points):
    """Straight edges around the points, each by itself."""
    return [Part.makeLine(V(*a), V(*b)) for a, b in zip(points, points[1:] + points[:1])]


def sheet(points):
    return Part.Face(Part.makePolygon([V(*p) for p in [*points, points[0]]]))


def save(shape, file):
    shape.exportStep(str(file))
    return file


def edges_where(file, wanted):
    """EdgeN of the edges whose middle is where it is wanted."""
    shape = Part.read(str(file))
    numbers = []
    for number, edge in enumerate(shape.Edges, 1):
        first, last = edge.ParameterRange
        if wanted(edge.valueAt(0.5 * (first + last))):
            numbers.append(number)
    return numbers


def faces_where(file, wanted):
    """FaceN of the faces whose centre of mass is where it is wanted."""
    shape = Part.read(str(file))
    return [number for number, face in enumerate(shape.Faces, 1) if wanted(face.CenterOfMass)]


def mixed(numbers, seed):
    numbers = list(numbers)
    random.Random(seed).shuffle(numbers)
    return ",".join(str(n) for n in numbers)


def placed(shape, scale=1.0):
    """Turned, moved and scaled: nothing may hang on axes or on millimetres."""
    moved = shape.copy()
    if scale != 1.0:
        moved.scale(scale)
    moved.Placement = FreeCAD.Placement(
        V(3, -7, 11) * scale, FreeCAD.Rotation(V(1, 2, 3), math.degrees(0.7))
    )
    return moved


class Read:
    """A file as FreeCAD reads it."""

    def __init__(self, file):
        self.shape = Part.read(str(file))
        self.faces = len(self.shape.Faces)
        self.solids = len(self.shape.Solids)
        self.shells = len(self.shape.Shells)
        self.area = self.shape.Area
        self.volume = sum(s.Volume for s in self.shape.Solids)
        self.valid = self.shape.isValid()
