#!/usr/bin/python3
"""Draws the patches of docs/methods/manifold.md: the figures 6 to 11 of its source, made anew.

    docs/figures/patches.py SUTURE PICTURE.png

SUTURE is the program. Border zones are grey, the middle is orange, the control mesh is drawn in thin lines; the
red curve is the central face of the parameters, computed here by the paper's formulas, not by the program.
Needs what render.py needs.
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

PANE = 230
TITLE = 22
MESH, FACE = (0.45, 0.52, 0.60), (0.80, 0.05, 0.10)

# title, sides, layers, columns, order k, aperture (None: the program's own), height in the middle
PANES = (
    ("3 sides, k = 0", 3, 6, 2, 0, None, 0.0),
    ("3 sides, k = 1", 3, 6, 2, 1, None, 0.0),
    ("3 sides, k = 2", 3, 7, 2, 2, None, 0.0),
    ("5 sides, k = 3", 5, 7, 3, 3, None, 0.0),
    ("6 sides, k = 2", 6, 6, 2, 2, None, 0.0),
    ("7 sides, k = 2", 7, 6, 1, 2, None, 0.0),
    ("5 sides, k = 2, f = 0.3", 5, 6, 2, 2, 0.3, 4.0),
    ("5 sides, k = 2, f = 0.8", 5, 6, 2, 2, 0.8, 4.0),
    ("5 sides, k = 2, f = 1.2", 5, 6, 2, 2, 1.2, 4.0),
)


class Mesh:
    """A mesh of convex outline: its corners on a circle, its layers bent up and down."""

    def __init__(self, sides, layers, columns, bump):
        self.sides, self.layers, self.columns, self.bump = sides, layers, columns, bump
        self.vertices, self.faces, self._numbers = [], [], {}
        for m in range(sides):
            for count, first in ((columns, layers), (layers, layers + columns)):
                for i in range(layers):
                    for j in range(first, first + count):
                        loop = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                        self.faces.append([self._number(self.place(m, *at)) for at in loop])

    def place(self, m, i, j):
        """Vertex (i, j) of side m: i leads outwards, j along the side."""
        s, r = self.layers, self.columns
        if j < s:
            return self._corner(m - 1, s - j, i)
        if j > s + r:
            return self._corner(m, i, j - s - r)
        low, high = self._corner(m - 1, 0, i), self._corner(m, i, 0)
        return low + (high - low) * ((j - s) / r)

    def point(self, m, i, j):
        return self._raised(self.place(m, i, j))

    def _corner(self, m, i, j):
        """L_m: both numbers count from the hole's corner, along the two sides that meet there."""
        def at(m, depth):
            a = 2.0 * math.pi / self.sides * (m + 0.5)
            return np.array([math.cos(a), math.sin(a)]) * (1.0 + depth)

        deep = max(i, j)
        to = at(m - 1, deep) if i >= j else at(m + 1, deep)
        return at(m, deep) + (to - at(m, deep)) * 0.5 * abs(i - j) / (deep + 1)

    def _raised(self, place):
        r = math.hypot(*place)
        height = 1.8 * math.cos(0.55 * r) + 0.5 * math.sin(0.9 * place[0])
        return np.array([*place, height + self.bump * math.exp(-((r / 1.6) ** 2))])

    def _number(self, place):
        key = tuple(np.round(place, 9))
        if key not in self._numbers:
            self.vertices.append(self._raised(place))
            self._numbers[key] = len(self.vertices)
        return self._numbers[key]

    def write(self, path):
        lines = ["v {:.15g} {:.15g} {:.15g}".format(*v) for v in self.vertices]
        lines += ["f " + " ".join(map(str, face)) for face in self.faces]
        path.write_text("\n".join(lines) + "\n")


def basis(knots, i, degree, t):
    """Cox and de Boor."""
    if degree == 0:
        return 1.0 if knots[i] <= t < knots[i + 1] else 0.0
    low = (t - knots[i]) / (knots[i + degree] - knots[i])
    high = (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1])
    return low * basis(knots, i, degree - 1, t) + high * basis(knots, i + 1, degree - 1, t)


class Star:
    """The surface by the formulas of sections 3, 4 and 6 of the paper, as the page corrects them."""

    def __init__(self, mesh, k, aperture):
        self.mesh, self.k, n = mesh, k, mesh.sides
        odd, self.h = k % 2, k // 2 + 1
        self.s, self.r = mesh.layers + odd, mesh.columns - odd
        bound = self.h / (2.0 * math.cos(math.pi / n))
        self.f = aperture or (self.r if self.r < bound else 0.8 * bound)
        self.alpha = 2.0 * math.pi / n
        self.fx = self.f * (1.0 + math.cos(self.alpha)) / 2.0
        self.fy = self.f * math.sin(self.alpha) / 2.0
        s, h, sine = self.s, self.h, math.sin(self.alpha)
        self.x = [float(i) for i in range(-h, s + h + 1)]
        self.y = [-self.fy - sine * i for i in range(s + h, 0, -1)]
        self.y += [self.fy * (2.0 * j / self.r - 1.0) for j in range(self.r + 1)]
        self.y += [self.fy + sine * i for i in range(1, s + h + 1)]
        # The charts that are not discarded, each with its control point; a point has one or two.
        places = [(m, i, j) for m in range(n) for i in range(s + 1 - odd)
                  for j in range(2 * s + self.r + 1 - odd) if self.kept(i, j)]
        keys = [tuple(np.round(mesh.place(*place), 9)) for place in places]
        self.charts = [(*place, mesh.point(*place), 1.0 / keys.count(key))
                       for place, key in zip(places, keys)]

    def mu(self, y):
        t = abs(y) / self.fy
        q = (0.0, (t**2 - 1) / 2, (-(t**4) + 6 * t**2 - 5) / 8, (t**6 - 5 * t**4 + 15 * t**2 - 11) / 16)
        cot = math.cos(self.alpha) / math.sin(self.alpha)
        return self.fx + self.fy * cot * (q[self.k] if t < 1.0 else t - 1.0)

    def turned(self, p, angle):
        c, s = math.cos(angle), math.sin(angle)
        return np.array([c * p[0] - s * p[1], s * p[0] + c * p[1]])

    def kept(self, i, j):
        odd = self.k % 2
        beyond = j >= self.s + self.r + self.h and i < self.h
        return not beyond and (j >= self.s - self.h if odd else j > self.s - self.h)

    def at(self, p):
        total, weight = np.zeros(3), 0.0
        sides = []
        for m in range(self.mesh.sides):
            x, y = self.turned(p, -self.alpha * m)
            x -= self.mu(y)
            sides.append([[basis(knots, i, self.k + 1, t) for i in range(len(knots) - self.k - 2)]
                          for knots, t in ((self.x, x), (self.y, y))])
        for m, i, j, point, share in self.charts:
            w = sides[m][0][i] * sides[m][1][j] * share
            total += w * point
            weight += w
        return total / weight

    def central_face(self):
        places = [self.turned((self.mu(y), y), self.alpha * m) for m in range(self.mesh.sides)
                  for y in np.linspace(-self.fy, self.fy, 9)[:-1]]
        points = [self.at(p) for p in places]
        return np.array(points + points[:1])


def draw(program, title, sides, layers, columns, k, aperture, bump):
    mesh = Mesh(sides, layers, columns, bump)
    options = ["--k", str(k)] + (["--exact"] if k < 2 else []) + (["--aperture", str(aperture)] if aperture else [])
    with tempfile.TemporaryDirectory() as folder:
        obj, out = Path(folder) / "star.obj", Path(folder) / "star.brep"
        mesh.write(obj)
        subprocess.run([program, "patch", obj, "-o", out, "--tolerance", "1e-4", *options],
                       check=True, stdout=subprocess.DEVNULL)
        shape = Part.Shape()
        shape.read(str(out))
    vertices = np.array(mesh.vertices)
    size = 0.82 * np.linalg.norm(np.ptp(vertices, axis=0))
    canvas = Canvas(PANE, PANE, np.array([0.3, -1.0, 1.3]), vertices.mean(axis=0), size, 10)
    for number, face in enumerate(shape.Faces):
        canvas.fill(*triangles(face, 0.02), OLD if number < sides else NEW, False)
    for face in shape.Faces[:sides]:
        for line in face.Edges:
            canvas.line(np.array([[p.x, p.y, p.z] for p in line.discretize(40)]))
    for face in mesh.faces:
        canvas.line(vertices[[v - 1 for v in face + face[:1]]], MESH)
    canvas.line(Star(mesh, k, aperture).central_face(), FACE)
    pane = Image.new("RGB", (PANE, PANE + TITLE), "white")
    pane.paste(canvas.image(), (0, TITLE))
    ImageDraw.Draw(pane).text((8, 6), title, fill=tuple(int(255 * c) for c in EDGE))
    return pane


def main():
    program, picture = sys.argv[1:]
    panes = [draw(program, *pane) for pane in PANES]
    sheet = Image.new("RGB", (3 * PANE, 3 * (PANE + TITLE)), "white")
    for k, pane in enumerate(panes):
        sheet.paste(pane, (k % 3 * PANE, k // 3 * (PANE + TITLE)))
    sheet.save(picture)


if __name__ == "__main__":
    main()
