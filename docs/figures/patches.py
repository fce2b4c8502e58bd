#!/usr/bin/python3
"""Draws the patches of docs/methods/manifold.md: the figures 6 to 11 of its source, made anew.

    docs/figures/patches.py SUTURE PICTURE.png

SUTURE is the program. Border zones are grey, the middle is orange. Needs what render.py needs.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

from render import EDGE, NEW, OLD, Canvas, triangles
import numpy as np
import Part
from PIL import Image, ImageDraw

PANE = 180

# title, sides, layers, columns, options
PANES = (
    ("3 sides, k = 0", 3, 6, [2], ["--k", "0"]),
    ("3 sides, k = 1", 3, 6, [2], ["--k", "1"]),
    ("3 sides, k = 2", 3, 8, [2], ["--k", "2"]),
    ("5 sides, k = 3", 5, 7, [2], ["--k", "3"]),
    ("6 sides, k = 2", 6, 6, [2], ["--k", "2"]),
    ("7 sides, k = 2", 7, 6, [1], ["--k", "2"]),
    ("5 sides, f = 0.3", 5, 6, [2], ["--k", "2", "--aperture", "0.3"]),
    ("5 sides, f = 0.8", 5, 6, [2], ["--k", "2", "--aperture", "0.8"]),
    ("5 sides, f = 1.2", 5, 6, [2], ["--k", "2", "--aperture", "1.2"]),
)


def star(sides, layers, columns):
    """A mesh of convex outline: its corners on a circle, its layers bent up and down."""
    angle = 2.0 * math.pi / sides
    vertices, faces, numbers = [], [], {}

    def vertex(x, y):
        key = round(x, 9), round(y, 9)
        if key not in numbers:
            numbers[key] = len(vertices) + 1
            r = math.hypot(x, y)
            height = 1.8 * math.cos(0.55 * r) + 0.5 * math.sin(0.9 * x)
            vertices.append((x, y, height))
        return numbers[key]

    def corner(m, depth):
        a = angle * (m + 0.5)
        return np.array([math.cos(a), math.sin(a)]) * (1.0 + depth)

    def block(m, i, j):
        """L_m: both coordinates count from the hole's corner, along the two sides that meet there."""
        deep = max(i, j)
        to = corner(m - 1, deep) if i >= j else corner(m + 1, deep)
        return corner(m, deep) + (to - corner(m, deep)) * 0.5 * abs(i - j) / (deep + 1)

    for m in range(sides):
        wide = columns[m % len(columns)]

        def middle(i, j, m=m, wide=wide):
            """C_m: between the first columns of L_(m-1) and L_m."""
            low, high = block(m - 1, 0, i), block(m, i, 0)
            return low + (high - low) * (j / wide)

        def shared(i, j, m=m):
            return block(m, i, j)

        for place, count in ((middle, wide), (shared, layers)):
            for i in range(layers):
                for j in range(count):
                    loop = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                    faces.append([vertex(*place(*at)) for at in loop])
    return vertices, faces


def write_obj(path, vertices, faces):
    lines = ["v {:.15g} {:.15g} {:.15g}".format(*v) for v in vertices]
    lines += ["f " + " ".join(map(str, face)) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def draw(program, title, sides, layers, columns, options):
    vertices, faces = star(sides, layers, columns)
    with tempfile.TemporaryDirectory() as folder:
        mesh, out = Path(folder) / "star.obj", Path(folder) / "star.brep"
        write_obj(mesh, vertices, faces)
        subprocess.run([program, "patch", mesh, "-o", out, "--tolerance", "1e-3", *options],
                       check=False, stdout=subprocess.DEVNULL)
        shape = Part.Shape()
        shape.read(str(out))
    box = shape.BoundBox
    centre = np.array([box.Center.x, box.Center.y, box.Center.z])
    canvas = Canvas(PANE, PANE, np.array([0.3, -1.0, 1.3]), centre, 0.78 * box.DiagonalLength, 10)
    for number, face in enumerate(shape.Faces):
        strip = number < sides
        canvas.fill(*triangles(face, 0.05), OLD if strip else NEW, False)
    for line in shape.Edges:
        canvas.line(np.array([[p.x, p.y, p.z] for p in line.discretize(40)]))
    pane = Image.new("RGB", (PANE, PANE + 24), "white")
    pane.paste(canvas.image(), (0, 24))
    ImageDraw.Draw(pane).text((8, 6), title, fill=tuple(int(255 * c) for c in EDGE))
    return pane


def main():
    program, picture = sys.argv[1:]
    panes = [draw(program, *pane) for pane in PANES]
    sheet = Image.new("RGB", (3 * PANE, 3 * (PANE + 24)), "white")
    for k, pane in enumerate(panes):
        sheet.paste(pane, (k % 3 * PANE, k // 3 * (PANE + 24)))
    sheet.save(picture)


if __name__ == "__main__":
    main()
