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
    write(folder, "hull", hull(), "Edges", lambda e: False)


if __name__ == "__main__":
    main(sys.argv[1])
