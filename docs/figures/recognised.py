#!/usr/bin/python3
"""Draws the picture of docs/methods/recognise.md: a lost face, and what two methods give back.

    docs/figures/recognised.py SUTURE PICTURE.png

SUTURE is the program. A box with a rounded upright edge and a rounded rim loses the torus in its corner. The
colour is the distance from the lost face, over the hole's diameter: white 1e-8 and less, red 1e-3.
Needs what render.py needs.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

from render import OLD, Canvas, triangles
import FreeCAD
import numpy as np
import Part
from PIL import Image, ImageDraw

PANE, TITLE = 360, 24
WHITE, RED = 1e-8, 1e-3


def rounded_box():
    """The body, and the number of its torus."""
    box = Part.makeBox(30, 25, 20)
    upright = [e for e in box.Edges if e.CenterOfMass.x < 1e-6 and e.CenterOfMass.y < 1e-6]
    body = box.makeFillet(8, upright)
    rim = [e for e in body.Edges if abs(e.BoundBox.ZMin - 20) < 1e-6
           and (e.BoundBox.XMin < 1e-3 or e.BoundBox.YMin < 1e-3)
           and e.BoundBox.XMax < 30 + 1e-3 and not e.BoundBox.XMin > 29 and not e.BoundBox.YMin > 24]
    body = body.makeFillet(2.5, rim)
    return body, next(k for k, f in enumerate(body.Faces) if f.Surface.TypeId == "Part::GeomToroid")


def filled(program, model, folder, name, options):
    out = Path(folder) / f"{name}.step"
    subprocess.run([program, "fill", model, "-o", out, *options], check=True, stdout=subprocess.DEVNULL)
    return Part.read(str(out))


def near(shape, place):
    """The face of a shape around a place."""
    return min(shape.Faces, key=lambda face: face.CenterOfMass.distanceToPoint(place))


def colour_of(distance):
    share = (math.log10(max(distance, WHITE)) - math.log10(WHITE)) / math.log10(RED / WHITE)
    return np.array([1.0, 1.0, 1.0]) + min(share, 1.0) * (np.array([0.85, 0.1, 0.05]) - 1.0)


def draw(shape, face, lost, size, title):
    centre = lost.CenterOfMass
    canvas = Canvas(PANE, PANE, np.array([-1.2, -1.0, 1.1]), np.array([centre.x, centre.y, centre.z]), size, 10)
    for other in shape.Faces:
        if face is None or not other.isSame(face):
            canvas.fill(*triangles(other, size / 400), OLD, False)
    worst = 0.0
    if face is not None:
        points, normals, facets = triangles(face, size / 4000)
        diameter = lost.BoundBox.DiagonalLength
        off = [lost.Surface.projectPoint(FreeCAD.Vector(*p)).distanceToPoint(FreeCAD.Vector(*p)) / diameter
               for p in points]
        worst = max(off)
        for facet in facets:
            base = np.mean([colour_of(off[k]) for k in facet], axis=0)
            canvas.fill(points[facet], normals[facet], np.array([[0, 1, 2]]), base, False)
    for edge in shape.Edges:
        if not edge.Degenerated and edge.Length > 0:
            canvas.line(np.array([[p.x, p.y, p.z] for p in edge.discretize(40)]))
    pane = Image.new("RGB", (PANE, PANE + TITLE), "white")
    pane.paste(canvas.image(), (0, TITLE))
    text = title if face is None else f"{title}: off by {worst:.0e} at most" if worst > WHITE else f"{title}: exact"
    ImageDraw.Draw(pane).text((8, 6), text, fill="black")
    return pane


def main():
    program, picture = sys.argv[1:]
    body, number = rounded_box()
    lost = body.Faces[number]
    shell = Part.Shell([face for k, face in enumerate(body.Faces) if k != number])
    with tempfile.TemporaryDirectory() as folder:
        model = str(Path(folder) / "open.step")
        shell.exportStep(model)
        mvs = filled(program, model, folder, "mvs", ["--method", "mvs"])
        found = filled(program, model, folder, "auto", [])
    size = 2.2 * lost.BoundBox.DiagonalLength
    place = lost.CenterOfMass
    panes = [draw(shell, None, lost, size, "the face is lost"),
             draw(mvs, near(mvs, place), lost, size, "mvs"),
             draw(found, near(found, place), lost, size, "recognise, a torus again")]
    sheet = Image.new("RGB", (len(panes) * PANE, PANE + TITLE), "white")
    for k, pane in enumerate(panes):
        sheet.paste(pane, (k * PANE, 0))
    sheet.save(picture)


if __name__ == "__main__":
    main()
