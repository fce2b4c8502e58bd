"""What FreeCAD's Part module says of a file before and after a hole was filled."""

import math
import sys
from pathlib import Path

sys.path.insert(0, "/usr/lib/freecad-python3/lib")
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "kernel/check"))

import FreeCAD  # noqa: E402, F401  Part needs it loaded first
import Part  # noqa: E402
from freecad_agreement import Side, largest  # noqa: E402

# A file has 15 digits: two readings of the same face agree to this much, relative to its size.
SAME = 1e-6
AREA = 1e-9  # relative: of a face that nobody has touched
TOLERANCE = 1e-9  # mm: two readings of the same edge compute its tolerance anew


def read(file):
    return Part.read(str(file))


class FaceFacts:
    """Place, size and kind of a face, and how exact it and its boundary are said to be."""

    def __init__(self, face):
        self.face = face
        self.kind = type(face.Surface).__name__
        self.area = abs(face.Area)
        self.size = math.sqrt(self.area)
        self.centroid = face.CenterOfMass
        self.tolerance = face.Tolerance

    def stands_where(self, other):
        limit = SAME * max(self.size, other.size)
        return (
            self.centroid.distanceToPoint(other.centroid) <= limit
            and abs(self.area - other.area) <= limit * max(self.size, other.size)
        )  # fmt: skip


class Comparison:
    """The faces of a filled model: `kept` [(before, after)], `added`, and `lost` ones of before."""

    def __init__(self, before, after):
        self.lost = [FaceFacts(face) for face in before.Faces]
        self.kept, self.added = [], []
        for face in after.Faces:
            facts = FaceFacts(face)
            match = next((old for old in self.lost if old.stands_where(facts)), None)
            if match is None:
                self.added.append(facts)
            else:
                self.lost.remove(match)
                self.kept.append((match, facts))


def uses_of_edges(shape):
    """[(edge, faces that it bounds, how often)]: a seam bounds the same face twice."""
    found = {}
    for face in shape.Faces:
        for wire in face.Wires:
            for edge in wire.OrderedEdges if len(wire.OrderedEdges) == len(wire.Edges) else wire.Edges:
                same = found.setdefault(edge.hashCode(), [])
                entry = next((entry for entry in same if entry[0].isSame(edge)), None)
                if entry is None:
                    entry = [edge, []]
                    same.append(entry)
                entry[1].append(face)
                if edge.isSeam(face) and entry[1].count(face) == 1:
                    entry[1].append(face)
    return [entry for same in found.values() for entry in same]


def free_edges(shape):
    return [e for e, faces in uses_of_edges(shape) if len(faces) == 1 and not e.Degenerated]


def largest_gap_and_angle(shape, added):
    """Over all edges of the new faces: (gap in mm, angle in degrees)."""
    gap = angle = 0.0
    new = [facts.face for facts in added]
    for edge, faces in uses_of_edges(shape):
        if edge.Degenerated or len(faces) != 2 or not any(f.isSame(n) for f in faces for n in new):
            continue
        if faces[0].isSame(faces[1]):
            continue  # a seam of the new face: a projection cannot tell its sides
        edge_gap, edge_angle = largest(edge, [Side(face) for face in faces])
        gap, angle = max(gap, edge_gap), max(angle, edge_angle)
    return gap, angle


def largest_distance(truth, added, across=8):
    """From points all over the lost face to the nearest new face."""
    new = Part.makeCompound([facts.face for facts in added])
    u1, u2, v1, v2 = truth.ParameterRange
    points = []
    for i in range(across):
        for j in range(across):
            u, v = u1 + (u2 - u1) * (i + 0.5) / across, v1 + (v2 - v1) * (j + 0.5) / across
            if truth.isPartOfDomain(u, v):
                points.append(truth.valueAt(u, v))
    return max(Part.Vertex(point).distToShape(new)[0] for point in points)
