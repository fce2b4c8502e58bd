"""What FreeCAD's Part module says of a file before and after a hole was filled."""

import math
import sys
from pathlib import Path

sys.path.insert(0, "/usr/lib/freecad-python3/lib")
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "kernel/check"))

import FreeCAD  # noqa: E402, F401  Part needs it loaded first
import Part  # noqa: E402
from freecad_agreement import Side, measure  # noqa: E402

# A file has 15 digits: two readings of the same face agree to this much, relative to its size.
SAME = 1e-6
AREA = 1e-9  # relative: of a face that nobody has touched
TOLERANCE = 1e-9  # mm: two readings of the same edge compute its tolerance anew

SAMPLES = 100  # per edge, and one more
PEAKS = 3  # that are looked at more closely
NARROWINGS = 24  # by thirds, at most
SETTLED, SMALL = 1e-3, 1e-7  # a peak is found when all in the interval about it agree so well


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


def difference(was, now, edges_too):
    """What an untouched face must have kept and has not, or nothing.

    edges_too: also the tolerances of its edges and vertices. Those that bound a new face may grow.
    """
    if now.kind != was.kind:
        return f"{was.kind} became {now.kind}"
    if abs(now.area - was.area) > AREA * was.area:
        return f"area {was.area} became {now.area}"
    before, after = [was.tolerance], [now.tolerance]
    if edges_too:
        before += sorted(part.Tolerance for part in was.face.Edges + was.face.Vertexes)
        after += sorted(part.Tolerance for part in now.face.Edges + now.face.Vertexes)
    if len(before) != len(after):
        return f"{len(before)} tolerances became {len(after)}"
    worst = max(zip(before, after), key=lambda pair: abs(pair[0] - pair[1]))
    return f"tolerance {worst[0]} became {worst[1]}" if abs(worst[0] - worst[1]) > TOLERANCE else ""


def match(olds, news):
    """([(old, new)] of the faces that stand in the same place, the other old ones, the other new ones)"""
    pairs, lost = [], list(olds)
    for facts in news:
        old = next((old for old in lost if old.stands_where(facts)), None)
        if old is not None:
            lost.remove(old)
            pairs.append((old, facts))
    matched = [new for _, new in pairs]
    return pairs, lost, [facts for facts in news if facts not in matched]


class Comparison:
    """The faces of a filled model.

    `kept`: [(what it may be, the face)], `added` ones, and `lost` ones of before. OCCT's reader mends
    some faces a little differently each time that it reads them: `reread` is the model of before,
    written and read once more by OCCT alone, and a face may also be what it is there.
    """

    def __init__(self, before, after, reread=None):
        old, new = ([FaceFacts(face) for face in shape.Faces] for shape in (before, after))
        pairs, self.lost, self.added = match(old, new)
        references = {id(facts): [was] for was, facts in pairs}
        if reread is not None:
            again = [FaceFacts(face) for face in reread.Faces]
            _, lost_there, _ = match(old, again)
            self.lost = [facts for facts in self.lost if facts not in lost_there]
            for was, facts in match(again, new)[0]:
                references.setdefault(id(facts), []).append(was)
        self.kept = [(references[id(facts)], facts) for facts in new if id(facts) in references]
        self.added = [facts for facts in self.added if id(facts) not in references]


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


def peak(function, low, high, value):
    """The largest value in an interval, narrowed by thirds; `value` is that in its middle."""
    for _ in range(NARROWINGS):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        at_a, at_b = function(a), function(b)
        spread = max(at_a, at_b, value) - min(at_a, at_b, value)
        value = max(at_a, at_b, value)
        if spread <= max(SMALL, SETTLED * value):
            break
        low, high = (low, b) if at_a >= at_b else (a, high)
    return value


def largest(edge, faces):
    """[largest gap in mm, largest angle in degrees] between two faces along their common edge."""
    sides = [Side(face) for face in faces]

    def measured(t):
        try:
            return measure(edge, sides, t)
        except Exception:  # FreeCAD raises its own kinds at singular points: no figure there
            return 0.0, 0.0

    first, last = edge.ParameterRange
    parameters = [first + (last - first) * i / SAMPLES for i in range(SAMPLES)] + [last]
    samples = [measured(t) for t in parameters]
    result = []
    for which in (0, 1):
        values = [sample[which] for sample in samples]
        ends = [-1.0, *values, -1.0]
        tops = [i for i, value in enumerate(values) if value >= max(ends[i], ends[i + 2])]
        tops.sort(key=lambda i: -values[i])
        result.append(
            max(
                peak(
                    lambda t, which=which: measured(t)[which],
                    parameters[max(i - 1, 0)], parameters[min(i + 1, SAMPLES)], values[i],
                )
                for i in tops[:PEAKS]
            )
        )  # fmt: skip
    return result


def largest_gap_and_angle(shape, added):
    """Over all edges of the new faces: (gap in mm, angle in degrees)."""
    gap = angle = 0.0
    new = [facts.face for facts in added]
    for edge, faces in uses_of_edges(shape):
        if edge.Degenerated or len(faces) != 2 or not any(f.isSame(n) for f in faces for n in new):
            continue
        if faces[0].isSame(faces[1]):
            continue  # a seam of the new face: a projection cannot tell its sides
        edge_gap, edge_angle = largest(edge, faces)
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
