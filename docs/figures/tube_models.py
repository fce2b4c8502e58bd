#!/usr/bin/python3
"""Makes the open models of the pictures of docs/methods/tube.md.

    docs/figures/tube_models.py FOLDER

FOLDER/pentagon.step: five cylinders of radius 16 and the planes between them around a five-sided hole;
FOLDER/house.step: two rounded edges, a hollow one and the planes between them. Needs Debian's
freecad-python3.
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, "/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402,F401  (Part needs it loaded first)
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402


def write(faces, file):
    shell = Part.makeCompound(faces)
    shell.sewShape()
    shell.exportStep(str(file))


def arc(centre, a, b):
    """The arc about centre from centre + a to centre + b."""
    middle = (a + b).normalize() * a.Length
    return Part.Arc(centre + a, centre + middle, centre + b).toShape()


def polygon(*points):
    return Part.Face(Part.makePolygon([*points, points[0]]))


def pentagon(radius=16.0, tilt=math.radians(35), length=14.0):
    normals = []
    for k in range(5):
        turn = 2 * math.pi * k / 5
        normals.append(
            Vector(math.sin(tilt) * math.cos(turn), math.sin(tilt) * math.sin(turn), math.cos(tilt))
        )
    along = []
    for k in range(5):
        axis = normals[k].cross(normals[(k + 1) % 5]).normalize()
        along.append(axis * (-length if axis.z > 0 else length))
    faces = []
    for k in range(5):
        here, there = normals[k] * radius, normals[(k + 1) % 5] * radius
        faces.append(arc(Vector(), here, there).extrude(along[k]))
        faces.append(polygon(here, here + along[k - 1], here + along[k]))
    return faces


def house(r=10.0, length=10.0):
    x, y, z = Vector(r, 0, 0), Vector(0, r, 0), Vector(0, 0, r)
    far = Vector(length, 0, 0), Vector(0, length, 0), Vector(0, 0, length)
    faces = [
        arc(Vector(-r, r, r), z * -1, y * -1).extrude(far[0] * -1),
        arc(Vector(-r, -r, r), y, x).extrude(far[2]),
        arc(Vector(-r, r, -r), x, z).extrude(far[1]),
    ]
    # The planes x = 0, z = 0 and y = 0, up to where the cylinders end.
    end = r + length
    faces.append(
        polygon(Vector(0, -r, -r), Vector(0, r, -r), Vector(0, end, -r), Vector(0, end, -end),
                Vector(0, -end, -end), Vector(0, -end, end), Vector(0, -r, end), Vector(0, -r, r))
    )
    faces.append(
        polygon(Vector(-r, r, 0), Vector(-r, end, 0), Vector(-end, end, 0), Vector(-end, r, 0))
    )
    faces.append(
        polygon(Vector(-r, 0, r), Vector(-r, 0, end), Vector(-end, 0, end), Vector(-end, 0, r))
    )
    return faces


def main():
    folder = Path(sys.argv[1])
    write(pentagon(), folder / "pentagon.step")
    write(house(), folder / "house.step")


if __name__ == "__main__":
    main()
