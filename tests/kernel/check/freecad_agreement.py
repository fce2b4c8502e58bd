"""Measures gap and angle of every edge with FreeCAD's Part module and compares with our figures.

Argument: a folder with shape.brep and edges.tsv (edge, face, face, gap, angle in degrees).
Ends with 0 if all agree to 1 % or 1e-6 mm and 1e-5 degrees, 1 if not, 77 if there is no FreeCAD.
"""

import math
import pathlib
import sys

sys.path.insert(0, "/usr/lib/freecad-python3/lib")
try:
    import FreeCAD  # noqa: F401  Part needs it loaded first
    import Part
except ImportError as error:
    print(f"no FreeCAD: {error}")
    sys.exit(77)

SAMPLES = 60
NARROWINGS = 8
ON_SURFACE = 1e-7  # mm
RELATIVE = 0.01
# mm; degrees: FreeCAD's projections stop at about 1e-7 mm, beside small radii that is 1e-5 degrees
ABSOLUTE = {"gap": 1e-6, "angle": 1e-5}


class Side:
    """A face: nearest points of its surface and its outward normals there."""

    def __init__(self, face):
        self.surface = face.Surface
        self.sign = -1.0 if face.Orientation == "Reversed" else 1.0

    def at(self, point):
        # Two projections of FreeCAD, of which each misses the nearest point at times.
        u, v = self.surface.parameter(point)
        if self.surface.value(u, v).distanceToPoint(point) > ON_SURFACE:
            other = self.surface.projectPoint(point, "LowerDistanceParameters")
            u, v = min((u, v), other, key=lambda p: self.surface.value(*p).distanceToPoint(point))
        nearest = self.surface.value(u, v)
        du, dv = self.surface.tangent(u, v)
        return nearest, du.cross(dv).normalize() * self.sign


def measure(edge, sides, t):
    """Gap, and angle in degrees, at one parameter of the edge."""
    point = edge.valueAt(t)
    (p1, n1), (p2, n2) = (side.at(point) for side in sides)
    return p1.distanceToPoint(p2), math.degrees(math.atan2(n1.cross(n2).Length, n1.dot(n2)))


def refined(edge, sides, which, low, high):
    """Largest value found while the interval is narrowed by thirds."""
    best = 0.0
    for _ in range(NARROWINGS):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        try:
            at_a, at_b = measure(edge, sides, a)[which], measure(edge, sides, b)[which]
        except Exception:  # a singular point
            return best
        best = max(best, at_a, at_b)
        low, high = (low, b) if at_a >= at_b else (a, high)
    return best


def largest(edge, sides):
    """Largest gap and angle: even samples, then thirds of the intervals about the best three."""
    first, last = edge.ParameterRange
    step = (last - first) / SAMPLES
    result = []
    samples = []
    for i in range(SAMPLES + 1):
        t = min(first + i * step, last)
        try:
            samples.append((t, measure(edge, sides, t)))
        except Exception:  # FreeCAD raises its own kinds at singular points: no figure there
            continue
    for which in (0, 1):
        values = [(m[which], t) for t, m in samples]
        peaks = [
            values[i]
            for i in range(len(values))
            if values[i] >= max(values[max(i - 1, 0)], values[min(i + 1, len(values) - 1)])
        ]
        best = 0.0
        for value, t in sorted(peaks, reverse=True)[:3]:
            best = max(best, value, refined(edge, sides, which, max(first, t - step), min(last, t + step)))
        result.append(best)
    return result


def agrees(name, ours, theirs):
    return abs(ours - theirs) <= max(ABSOLUTE[name], RELATIVE * max(ours, theirs))


def main(folder):
    shape = Part.Shape()
    shape.read(str(folder / "shape.brep"))
    compared = failures = 0
    for line in (folder / "edges.tsv").read_text().splitlines():
        numbers = line.split("\t")
        edge_number, face1, face2 = map(int, numbers[:3])
        if face1 == face2:
            continue  # a projection cannot tell the two sides of a seam
        sides = [Side(shape.Faces[face - 1]) for face in (face1, face2)]
        theirs = largest(shape.Edges[edge_number - 1], sides)
        compared += 1
        for name, our, their in zip(("gap", "angle"), map(float, numbers[3:]), theirs):
            if not agrees(name, our, their):
                failures += 1
                print(f"Edge{edge_number} Face{face1} Face{face2} {name}: {our} FreeCAD: {their}")
    print(f"{compared} edges compared, {failures} figures differ")
    return 1 if failures or compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
