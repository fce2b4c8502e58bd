#!/usr/bin/python3
"""The two surfaces of the paper's table corner, drawn with the cones and the cylinder that they join.

    docs/figures/algebraic.py SUTURE PICTURE.png
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, "/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402
import Part  # noqa: E402

HERE = Path(__file__).resolve().parent
PROBLEM = HERE.parent / "examples" / "table_corner.json"
CENTRE = FreeCAD.Vector(1, 1, 1)
# The quarter circles (centre, radius 1): from the corner `start`, through the middle, to `end`.
ARCS = ((0, 1, 1), (1, 1, 0)), ((1, 1, 0), (1, 0, 1)), ((1, 0, 1), (0, 1, 1))
REACH = 0.8  # how far the neighbours are drawn


def arc(start, end):
    a, b = FreeCAD.Vector(*start), FreeCAD.Vector(*end)
    middle = CENTRE + ((a - CENTRE) + (b - CENTRE)).normalize()
    return Part.Arc(a, middle, b).toShape()


def apex(hessian, linear):
    """Where the gradient H x + l of a cone's polynomial vanishes."""
    m = FreeCAD.Matrix(*hessian[0], 0, *hessian[1], 0, *hessian[2], 0, 0, 0, 0, 1)
    return m.inverse().multVec(FreeCAD.Vector(*(-x for x in linear)))


def cone_piece(edge, tip, outwards):
    """The cone through an arc, continued away from the hole."""
    away = 1.0 if (edge.valueAt(edge.FirstParameter) - tip).dot(outwards) > 0 else -1.0
    scale = 1.0 + away * REACH / abs((CENTRE - tip).dot(outwards))
    matrix = FreeCAD.Matrix()
    matrix.move(-tip)
    matrix.scale(scale, scale, scale)
    matrix.move(tip)
    return Part.makeRuledSurface(edge, edge.transformGeometry(matrix))


def neighbours():
    cone1 = apex(((-50, 10, 0), (10, -2, 10), (0, 10, -50)), (40, -8, 40))
    cone2 = apex(((2, 4, 4), (4, 8, 0), (4, 0, 8)), (-6, -12, -12))
    edges = [arc(*ends) for ends in ARCS]
    return [
        cone_piece(edges[0], cone1, FreeCAD.Vector(0, 1, 0)),
        cone_piece(edges[1], cone2, FreeCAD.Vector(1, 0, 0)),
        edges[2].extrude(FreeCAD.Vector(0, 0, REACH)),
    ]


def main(suture, picture):
    problem = json.loads(PROBLEM.read_text())
    with tempfile.TemporaryDirectory() as scratch:
        before, *filled = (Path(scratch) / f"{name}.step" for name in ("before", "quartic", "cubic"))
        Part.makeCompound(neighbours()).exportStep(str(before))
        for after, choice in zip(filled, ({"degree": 4, "cells": "axis"}, {"degree": 3, "cells": "inner"})):
            file, faces = Path(scratch) / "problem.json", Path(scratch) / "faces.step"
            file.write_text(json.dumps({**problem, **choice}))
            subprocess.run([suture, "algebraic", file, "-o", faces], check=True)
            shape = Part.Shape()
            shape.read(str(faces))
            Part.makeCompound([*neighbours(), shape]).exportStep(str(after))
        words = [before, filled[0], picture, "--beside", filled[1], "--zebra", "--view=-1,-0.8,-0.6",
                 "--names", "degree 4 in 3 cells,degree 3 in 7 cells"]  # fmt: skip
        subprocess.run([sys.executable, HERE / "render.py", *map(str, words)], check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
