#!/usr/bin/python3
"""Draws a model before and after a fill, or two fills of it, as a PNG picture.

    docs/figures/render.py BEFORE.step AFTER.step PICTURE.png [--zebra] [--view X,Y,Z] [--near X,Y,Z --size S]
    docs/figures/render.py BEFORE.step AFTER.step PICTURE.png --beside OTHER.step --names FIRST,SECOND ...

New faces (those of AFTER that BEFORE does not have) are orange; with --zebra the picture shows
reflection lines, which are smooth where the surface is: their tangents where the curvature is
continuous, the lines themselves where only the tangent plane is. Needs Debian's freecad-python3,
python3-numpy and python3-pil.
"""

import argparse
import sys

sys.path.insert(0, "/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402,F401  (Part needs it loaded first)
import numpy as np  # noqa: E402
import Part  # noqa: E402
from PIL import Image, ImageDraw  # noqa: E402

OLD, NEW, EDGE = (0.62, 0.68, 0.76), (0.98, 0.62, 0.16), (0.12, 0.14, 0.18)
SUPERSAMPLING = 2


def key(face):
    """A face's identity across files: where it is and how large."""
    c = face.CenterOfMass
    return tuple(round(x, 4) for x in (c.x, c.y, c.z, face.Area))


def triangles(face, deflection):
    """Points, unit normals and triangles of a face."""
    vertices, facets = face.tessellate(deflection)
    points = np.array([[v.x, v.y, v.z] for v in vertices])
    normals = []
    for k, v in enumerate(vertices):
        try:
            n = face.normalAt(*face.Surface.parameter(v))
            normals.append((n.x, n.y, n.z))
        except Part.OCCError:  # the tip of a cone: the mean of what meets there
            around = [points[list(facet)] for facet in facets if k in facet]
            normals.append(sum(np.cross(b - a, c - a) for a, b, c in around))
    return points, np.array(normals), np.array(facets)


class Canvas:
    """An orthographic z-buffer."""

    def __init__(self, width, height, view, centre, size, stripes):
        self.width, self.height = width * SUPERSAMPLING, height * SUPERSAMPLING
        self.towards = view / np.linalg.norm(view)
        up = np.array([0.0, 0.0, 1.0]) if abs(self.towards[2]) < 0.99 else np.array([0.0, 1.0, 0.0])
        self.right = np.cross(up, self.towards)
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(self.towards, self.right)
        self.stripes = stripes
        self.centre, self.scale = centre, 0.92 * min(self.width, self.height) / size
        self.size = size
        self.colour = np.ones((self.height, self.width, 3))
        self.depth = np.full((self.height, self.width), -np.inf)

    def project(self, points):
        d = points - self.centre
        return np.stack([self.width / 2 + self.scale * d @ self.right,
                         self.height / 2 - self.scale * d @ self.up, d @ self.towards], axis=1)

    def shade(self, normals, base, zebra):
        n = normals / np.linalg.norm(normals, axis=1, keepdims=True)
        facing = n @ self.towards
        n = n * np.sign(facing)[:, None]
        light = self.towards + 0.5 * self.up - 0.4 * self.right
        light /= np.linalg.norm(light)
        diffuse = 0.35 + 0.65 * np.clip(n @ light, 0, 1)
        colour = diffuse[:, None] * np.array(base)
        if zebra:
            reflected = 2 * (n @ self.towards)[:, None] * n - self.towards
            stripe = np.sin(self.stripes * (reflected @ self.up)) > 0
            colour = np.where(stripe[:, None], colour, 0.25 * colour)
        return colour

    def fill(self, points, normals, facets, base, zebra):
        screen = self.project(points)
        for facet in facets:
            p, n = screen[facet], normals[facet]
            x0, y0 = np.maximum(np.floor(p[:, :2].min(axis=0)).astype(int), 0)
            x1 = min(int(np.ceil(p[:, 0].max())), self.width - 1)
            y1 = min(int(np.ceil(p[:, 1].max())), self.height - 1)
            area = np.linalg.det(np.column_stack([p[:, :2], np.ones(3)]))
            if x0 > x1 or y0 > y1 or abs(area) < 1e-12:
                continue
            gx, gy = np.meshgrid(np.arange(x0, x1 + 1), np.arange(y0, y1 + 1))
            w = []
            for a, b in ((1, 2), (2, 0), (0, 1)):
                w.append(((p[a, 0] - gx) * (p[b, 1] - gy) - (p[b, 0] - gx) * (p[a, 1] - gy)) / area)
            w = np.stack(w)
            z = np.tensordot(p[:, 2], w, axes=1)
            inside = (w >= -1e-9).all(axis=0) & (z > self.depth[gy, gx])
            if inside.any():
                ys, xs = gy[inside], gx[inside]
                self.depth[ys, xs] = z[inside]
                self.colour[ys, xs] = self.shade(w[:, inside].T @ n, base, zebra)

    def line(self, points, colour=EDGE):
        screen = self.project(points)
        lift = 0.004 * self.size
        for a, b in zip(screen[:-1], screen[1:]):
            steps = max(2, int(np.hypot(*(b - a)[:2]) * 1.5))
            for t in np.linspace(0, 1, steps):
                x, y, z = a + t * (b - a)
                for dx in range(SUPERSAMPLING):
                    i, j = int(y), int(x) + dx
                    if 0 <= i < self.height and 0 <= j < self.width and z + lift > self.depth[i, j]:
                        self.colour[i, j] = colour

    def image(self):
        pixels = (255 * np.clip(self.colour, 0, 1)).astype(np.uint8)
        size = (self.width // SUPERSAMPLING, self.height // SUPERSAMPLING)
        return Image.fromarray(pixels).resize(size, Image.LANCZOS)


def draw(shape, known, canvas, zebra, deflection):
    for face in shape.Faces:
        base = OLD if known is None or key(face) in known else NEW
        canvas.fill(*triangles(face, deflection), base, zebra)
    for edge in shape.Edges:
        if not edge.Degenerated and edge.Length > 0:
            canvas.line(np.array([[p.x, p.y, p.z] for p in edge.discretize(40)]))
    return canvas.image()


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("before")
    arguments.add_argument("after")
    arguments.add_argument("picture")
    arguments.add_argument("--zebra", action="store_true")
    arguments.add_argument("--view", default="1,-1.3,0.9")
    arguments.add_argument("--near", help="centre of the picture, default the model's")
    arguments.add_argument("--size", type=float, help="what the picture shows, model units")
    arguments.add_argument("--stripes", type=float, default=14, help="per radian, about")
    arguments.add_argument("--beside", help="another fill, drawn in place of the model before it")
    arguments.add_argument("--names", default="before,after", help="what is written above each")
    options = arguments.parse_args()
    before, after = Part.read(options.before), Part.read(options.after)
    box = after.BoundBox
    vector = lambda text: np.array([float(x) for x in text.split(",")])  # noqa: E731
    centre = vector(options.near) if options.near else np.array(
        [box.Center.x, box.Center.y, box.Center.z])
    size = options.size or box.DiagonalLength
    known = {key(face) for face in before.Faces}
    width, height = 560, 520
    shown = [(after, known), (Part.read(options.beside), known)] if options.beside else [
        (before, None), (after, known)]
    sheet = Image.new("RGB", (2 * width, height), "white")
    pen = ImageDraw.Draw(sheet)
    for place, ((shape, faces), name) in enumerate(zip(shown, options.names.split(","))):
        canvas = Canvas(width, height, vector(options.view), centre, size, options.stripes)
        picture = draw(shape, faces, canvas, options.zebra and faces is not None, size / 800)
        sheet.paste(picture, (place * width, 0))
        pen.text((place * width + 12, 10), name, fill="black")
    sheet.save(options.picture)


if __name__ == "__main__":
    main()
