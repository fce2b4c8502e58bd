"""What FreeCAD's Part module says of a file before and after a hole was filled."""

import math
import sys

sys.path.insert(0, "/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402, F401  Part needs it loaded first
import Part  # noqa: E402

# A file has 15 digits: two readings of the same face agree to this much, relative to its size.
SAME = 1e-6
AREA = 1e-9  # relative: of a face that nobody has touched
TOLERANCE = 1e-9  # mm: two readings of the same edge compute its tolerance anew

SAMPLES = 400  # per edge, and one more
PEAKS = 5  # that are looked at more closely
NARROWINGS = 24  # by thirds, at most
SETTLED, SMALL = 1e-3, 1e-7  # a peak is found when all in the interval about it agree so well
FAR = 0.01  # of an edge's length: beyond, its curve on the surface may lead to another sheet
STEPS, ARRIVED = 60, 1e-13  # of Newton's method for the nearest point, and the last move that counts


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


class Side:
    """A face along one of its edges: nearest points of its surface and its outward normals there."""

    def __init__(self, face, edge):
        self.surface = face.Surface
        self.sign = -1.0 if face.Orientation == "Reversed" else 1.0
        self.curve = face.curveOnSurface(edge)[0]
        self.far = FAR * edge.Length
        self.bounds = self.surface.bounds()
        self.periodic = self.surface.isUPeriodic(), self.surface.isVPeriodic()

    def inside(self, u, v):
        low_u, high_u, low_v, high_v = self.bounds
        return (
            u if self.periodic[0] else min(max(u, low_u), high_u),
            v if self.periodic[1] else min(max(v, low_v), high_v),
        )  # fmt: skip

    def at(self, point, t):
        u, v = self.nearest(point, t)
        if self.surface.value(u, v).distanceToPoint(point) > self.far:
            other = self.surface.projectPoint(point, "LowerDistanceParameters")
            u, v = min((u, v), other, key=lambda p: self.surface.value(*p).distanceToPoint(point))
        du, dv = self.surface.tangent(u, v)  # raises where a pole has none
        return self.surface.value(u, v), du.cross(dv).normalize() * self.sign

    def nearest(self, point, t):
        """From where the edge runs on the surface: FreeCAD's own projections miss points at times."""
        start = self.curve.value(t)
        u, v = self.inside(start.x, start.y)
        rest = point - self.surface.value(u, v)
        for _ in range(STEPS):
            du, dv = self.surface.getDN(u, v, 1, 0), self.surface.getDN(u, v, 0, 1)
            a, b, c = du.dot(du), du.dot(dv), dv.dot(dv)
            e, f = du.dot(rest), dv.dot(rest)
            move_u, move_v = (c * e - b * f) / (a * c - b * b), (a * f - b * e) / (a * c - b * b)
            # At the surface's border the nearest point is the nearest on that border.
            if self.inside(u + move_u, v)[0] == u:
                move_u, move_v = 0.0, f / c
            elif self.inside(u, v + move_v)[1] == v:
                move_u, move_v = e / a, 0.0
            for _ in range(STEPS):
                next_u, next_v = self.inside(u + move_u, v + move_v)
                next_rest = point - self.surface.value(next_u, next_v)
                if next_rest.Length <= rest.Length * (1 + SAME):
                    break
                move_u, move_v = move_u / 2, move_v / 2
            moved = abs(next_u - u) + abs(next_v - v)
            u, v, rest = next_u, next_v, next_rest
            if moved <= ARRIVED * (abs(u) + abs(v)):
                break
        return u, v


def measure(edge, sides, t):
    """Gap, and angle in degrees, at one parameter of the edge."""
    point = edge.valueAt(t)
    (p1, n1), (p2, n2) = (side.at(point, t) for side in sides)
    return p1.distanceToPoint(p2), math.degrees(math.atan2(n1.cross(n2).Length, n1.dot(n2)))


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
    sides = [Side(face, edge) for face in faces]

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
    new = Part.Compound([facts.face for facts in added])
    u1, u2, v1, v2 = truth.ParameterRange
    points = []
    for i in range(across):
        for j in range(across):
            u, v = u1 + (u2 - u1) * (i + 0.5) / across, v1 + (v2 - v1) * (j + 0.5) / across
            if truth.isPartOfDomain(u, v):
                points.append(truth.valueAt(u, v))
    return max(Part.Vertex(point).distToShape(new)[0] for point in points)
