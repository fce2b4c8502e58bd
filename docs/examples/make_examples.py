#!/usr/bin/python3
"""Makes the example models beside this script, with FreeCAD's Part module (Debian: freecad-python3).

    /usr/bin/python3 docs/examples/make_examples.py [DIR [NAME...]]

Each is a closed body from which a face was taken, so that it has a hole:
    suitcase_corner   a box with three rounded edges; the eighth of a sphere where they meet
    box_without_lid   a box; its top
    pipe_elbow        a bent pipe; the discs at both ends
    dome_window       a round bar with a round end; a star-shaped window in the end
    bump_window       a block with a wavy top; a star-shaped window in the top
and one that only the pictures use, made when named:
    half_round        a plate with a half-round edge; the middle of the edge
"""

import math
import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402  (makes the modules below importable)
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402


def shell_without(shape, unwanted):
    """The faces of a shape but one, sewn into an open shell."""
    faces = [face for face in shape.Faces if not unwanted(face)]
    assert len(faces) < len(shape.Faces), "no face was taken out"
    shell = Part.Shell(faces)
    assert not shell.isClosed()
    return shell


def suitcase_corner():
    box = Part.makeBox(60, 50, 40)
    corner = Vector(60, 50, 40)
    edges = [e for e in box.Edges if any(v.Point.distanceToPoint(corner) < 1e-9 for v in e.Vertexes)]
    rounded = box.makeFillet(8, edges)
    return shell_without(rounded, lambda face: isinstance(face.Surface, Part.Sphere))


def half_round():
    arc = Part.Arc(Vector(0, 5, 0), Vector(5, 0, 0), Vector(0, -5, 0)).toShape()
    lines = Part.makePolygon([Vector(0, -5, 0), Vector(-40, -5, 0), Vector(-40, 5, 0),
                              Vector(0, 5, 0)])
    profile = Part.Face(Part.Wire(lines.Edges + [arc]))
    pieces = []
    for bottom, top in ((0, 15), (15, 45), (45, 60)):
        piece = profile.copy()
        piece.translate(Vector(0, 0, bottom))
        pieces.append(piece.extrude(Vector(0, 0, top - bottom)))
    plate = pieces[0].fuse(pieces[1:])
    return shell_without(plate, lambda face: isinstance(face.Surface, Part.Cylinder)
                         and abs(face.CenterOfMass.z - 30) < 1e-6)


def box_without_lid():
    box = Part.makeBox(60, 40, 25)
    return shell_without(box, lambda face: abs(face.CenterOfMass.z - 25) < 1e-9)


def pipe_elbow():
    straight = Part.makeLine(Vector(0, 0, 0), Vector(0, 0, 40))
    bend = Part.makeCircle(30, Vector(30, 0, 40), Vector(0, 1, 0), 180, 270)
    spine = Part.Wire(Part.__sortEdges__([straight, bend]))
    profile = Part.Wire(Part.makeCircle(10, Vector(0, 0, 0), Vector(0, 0, 1)))
    tube = spine.makePipeShell([profile], True, False)
    return shell_without(tube, lambda face: isinstance(face.Surface, Part.Plane))


def star(points, outer, inner, z):
    """A closed polygon with `points` tips."""
    corners = []
    for i in range(2 * points):
        radius = outer if i % 2 == 0 else inner
        angle = math.pi * i / points + 0.2
        corners.append(Vector(radius * math.cos(angle), radius * math.sin(angle), z))
    return Part.makePolygon(corners + [corners[0]])


def cut_window(solid, face_index, wire, depth):
    """Splits a face of a solid along a prism over a wire and takes the smaller piece away."""
    prism = Part.Face(wire).extrude(Vector(0, 0, depth))
    _, origins = solid.Faces[face_index].generalFuse([prism])
    inside, outside = sorted(origins[0], key=lambda piece: piece.Area)
    assert inside.Area < outside.Area
    others = [face for i, face in enumerate(solid.Faces) if i != face_index]
    shape = Part.makeCompound(others + [outside])
    shape.sewShape()
    assert len(shape.Shells) == 1 and len(shape.Faces) == len(solid.Faces)
    return shape.Shells[0]


def dome_window():
    bar = Part.makeCylinder(20, 30).fuse(Part.makeSphere(20, Vector(0, 0, 30))).removeSplitter()
    top = max(range(len(bar.Faces)), key=lambda i: bar.Faces[i].CenterOfMass.z)
    return cut_window(bar, top, star(5, 12, 7, 40), 30)


def bump_window():
    poles = []
    for i in range(8):
        row = []
        for j in range(7):
            x, y = 80 * (i / 7 - 0.5), 70 * (j / 6 - 0.5)
            row.append(Vector(x, y, 20 + 6 * math.cos(x / 16) * math.cos(y / 19) + x * y / 400))
        poles.append(row)
    top = Part.BSplineSurface()
    top.interpolate(poles)
    block = top.toShape().extrude(Vector(0, 0, -30))
    index = max(range(len(block.Faces)), key=lambda i: block.Faces[i].CenterOfMass.z)
    return cut_window(block, index, star(6, 22, 15, 5), 40)


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    examples = (suitcase_corner, box_without_lid, pipe_elbow, dome_window, bump_window)
    named = [make for make in (*examples, half_round) if make.__name__ in sys.argv[2:]]
    for make in named or examples:
        shape = make()
        shape.exportStep(str(folder / f"{make.__name__}.step"))
        print(f"{make.__name__}: {len(shape.Faces)} faces")


if __name__ == "__main__":
    main()
