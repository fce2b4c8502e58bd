#!/usr/bin/python3
"""Writes the models of the pictures of docs/borders.md, and prints what of each is chosen:
docs/figures/border_models.py FOLDER. Needs Debian's freecad-python3."""

import sys
from pathlib import Path

sys.path.insert(0, "/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402
import Part  # noqa: E402

V = FreeCAD.Vector


def middle(edge):
    return edge.valueAt(sum(edge.ParameterRange) / 2)


def write(folder, name, shape, elements, wanted):
    """Prints "NAME 3,17": the edges or faces that are as wanted."""
    file = folder / f"{name}.step"
    shape.exportStep(str(file))
    found = enumerate(getattr(Part.read(str(file)), elements), 1)
    print(name, ",".join(str(n) for n, element in found if wanted(element)))


def spline(*points, ends=None):
    """ends   the tangent at both ends"""
    curve = Part.BSplineCurve()
    tangents = {"InitialTangent": ends, "FinalTangent": ends} if ends else {}
    curve.interpolate(Points=[V(*p) for p in points], **tangents)
    return curve.toShape()


def sheets():
    """Two strips of cylinders, and two loose curves from one to the other."""
    def strip(y, begin):
        arc = Part.makeCircle(40, V(0, y, 40), V(1, 0, 0), begin, begin + 20)
        return arc.extrude(V(60, 0, 0))

    curves = [spline((x, 0, 0), (x, 20, 6), (x, 40, 0), ends=V(0, 1, 0)) for x in (0, 60)]
    return Part.makeCompound([strip(0, 250), strip(40, 270), *curves])


def elbow():
    pipe = Part.makeCylinder(5, 12).Faces[0]
    other = pipe.copy()
    other.Placement = FreeCAD.Placement(V(18, 0, 30), FreeCAD.Rotation(V(0, 1, 0), 90))
    return Part.makeCompound([pipe, other])


def rounded(radius, count):
    box = Part.makeBox(30, 22, 16)
    at = V(30, 22, 16)
    edges = [e for e in box.Edges if any((v.Point - at).Length < 1e-9 for v in e.Vertexes)]
    return box.makeFillet(radius, edges[:count])


def leaning():
    """A zone of a ball, and a circle on the ball above it."""
    zone = Part.makeSphere(20, V(), V(0, 0, 1), -20, 20).Faces[0]
    return Part.makeCompound([zone, Part.makeCircle(16, V(0, 0, 12))])


def window_with_curve():
    """A plate with a round window, and a curve over it."""
    plate = Part.Face(Part.makePolygon([V(*p) for p in ((-30, -24, 0), (30, -24, 0), (30, 24, 0), (-30, 24, 0), (-30, -24, 0))]))
    window = Part.makeCylinder(18, 2, V(0, 0, -1))
    return Part.makeCompound([plate.cut(window), spline((-9, -3, 4), (0, 0, 7), (9, 3, 4))])


def tin():
    """A cylinder with a window across its seam."""
    solid = Part.makeCylinder(10, 30)
    (wall,) = (f for f in solid.Faces if "Cylinder" in f.Surface.TypeId)
    flat = [f for f in solid.Faces if "Plane" in f.Surface.TypeId]
    return Part.makeShell([*flat, *wall.cut(Part.makeBox(12, 10, 12, V(0, -5, 9))).Faces])


def hull():
    """Both sides of a boat, ruled from the keel to the sheer."""
    sides = []
    for y in (12, -12):
        keel = Part.makeLine(V(0, 0, 0), V(70, 0, 2))
        sheer = spline((0, y, 12), (35, 1.1 * y, 12), (60, 0.6 * y, 12), (80, 0, 12))
        sides.append(Part.makeRuledSurface(keel, sheer))
    return Part.makeCompound(sides)


def main(folder):
    folder = Path(folder)
    loose = lambda e: abs(middle(e).y - 20) < 1 and middle(e).z > 4
    rim = lambda e: abs(middle(e).z) < 1e-6 and abs(middle(e).x - 30) < 1e-6
    write(folder, "sheets", sheets(), "Edges", lambda e: loose(e) or rim(e))
    near = lambda p: min((p - V(0, 0, 12)).Length, (p - V(18, 0, 30)).Length) < 1e-6
    write(folder, "elbow", elbow(), "Edges", lambda e: e.isClosed() and near(e.CenterOfMass))
    kind = lambda name: lambda f: type(f.Surface).__name__ == name
    write(folder, "corner", rounded(6, 3), "Faces", kind("Sphere"))
    write(folder, "fillet", rounded(6, 1), "Faces", kind("Cylinder"))
    high = lambda z: lambda e: middle(e).z > z
    write(folder, "leaning", leaning(), "Edges", high(11))
    write(folder, "curve", window_with_curve(), "Edges", high(1))
    write(folder, "tin", tin(), "Edges", lambda e: False)
    write(folder, "hull", hull(), "Edges", lambda e: False)


if __name__ == "__main__":
    main(sys.argv[1])
