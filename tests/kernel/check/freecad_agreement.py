"""Measures gap and angle of every edge with FreeCAD's Part module and compares with our figures.

Argument: a folder with shape.brep and edges.tsv (edge, face, face, gap, angle in degrees).
Ends with 0 if all agree to 1 % or 1e-6 (mm, degrees), 1 if not, 77 if there is no FreeCAD.
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
RELATIVE, ABSOLUTE = 0.01, 1e-6


class Side:
    """A face: nearest points of its surface and its outward normals there."""

    def __init__(self, face):
        self.surface = face.Surface
        self.sign = -1.0 if face.Orientation == "Reversed" else 1.0

    def at(self, point):
        u, v = self.surface.projectPoint(point, "LowerDistanceParameters")
        nearest = self.surface.value(u, v)
        du, dv = self.surface.tangent(u, v)
        return nearest, du.cross(dv).normalize() * self.sign


def measure(edge, sides, t):
    """Gap, and angle in degrees, at one parameter of the edge."""
    point = edge.valueAt(t)
    (p1, n1), (p2, n2) = (side.at(point) for side in sides)
    return p1.distanceToPoint(p2), math.degrees(math.atan2(n1.cross(n2).Length, n1.dot(n2)))


def largest(edge, sides):
    """Largest gap and angle: even samples, then thirds of the interval about the best one."""
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
        t, best = max(((t, m[which]) for t, m in samples), key=lambda s: s[1])
        low, high = max(first, t - step), min(last, t + step)
        for _ in range(14):
            a, b = low + (high - low) / 3, high - (high - low) / 3
            try:
                at_a, at_b = measure(edge, sides, a)[which], measure(edge, sides, b)[which]
            except Exception:
                break
            best = max(best, at_a, at_b)
            low, high = (low, b) if at_a >= at_b else (a, high)
        result.append(best)
    return result


def agrees(ours, theirs):
    return abs(ours - theirs) <= max(ABSOLUTE, RELATIVE * max(ours, theirs))


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
            if not agrees(our, their):
                failures += 1
                print(f"Edge{edge_number} Face{face1} Face{face2} {name}: {our} FreeCAD: {their}")
    print(f"{compared} edges compared, {failures} figures differ")
    return 1 if failures or compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
