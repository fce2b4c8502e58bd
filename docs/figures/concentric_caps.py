#!/usr/bin/python3
"""Draws models closed by `concentric`, with the parameter lines of the new faces.

    docs/figures/concentric_caps.py SUTURE PICTURE.png

SUTURE is the program. Needs what render.py needs.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from render import NEW, OLD, Canvas, key, triangles
import numpy as np
import Part
from PIL import Image, ImageDraw

PANE = 440
EXAMPLES = Path(__file__).resolve().parent.parent / "examples"

# title, example, options, view, centre, size (None: all of the model)
PANES = (
    ("a lid, one face for each side", "box_without_lid", ["--continuity", "G0"], (0.5, -0.9, 1.4), None, None),
    ("both ends of a pipe", "pipe_elbow", ["--continuity", "G0"], (0.9, -1.0, -0.9), None, None),
    ("tangent to three fillets", "suitcase_corner", ["--continuity", "G1"], (1.1, 0.9, 0.8), (54, 44, 34), 26),
)


def lines_of(face):
    """Spokes and rings of a new face."""
    u0, u1, v0, v1 = face.ParameterRange
    at = lambda u, v: tuple(face.Surface.value(u, v))  # noqa: E731
    for v in np.linspace(v0, v1, 6):
        yield np.array([at(u, v) for u in np.linspace(u0, u1, 120)])
    for u in np.linspace(u0, u1, 13):
        yield np.array([at(u, v) for v in np.linspace(v0, v1, 40)])


def pane(program, title, example, options, view, centre, size):
    before = EXAMPLES / f"{example}.step"
    with tempfile.TemporaryDirectory() as folder:
        after = Path(folder) / "closed.step"
        command = [program, "fill", before, "-o", after, "--method", "concentric", *options]
        subprocess.run([str(word) for word in command], check=True, capture_output=True)
        shape = Part.read(str(after))
    known = {key(face) for face in Part.read(str(before)).Faces}
    box = shape.BoundBox
    middle = np.array(centre if centre else tuple(box.Center), dtype=float)
    size = size or box.DiagonalLength
    canvas = Canvas(PANE, PANE, np.array(view, dtype=float), middle, size, 0)
    for face in shape.Faces:
        old = key(face) in known
        canvas.fill(*triangles(face, size / 800), OLD if old else NEW, False)
    for face in shape.Faces:
        if key(face) in known:
            for edge in face.Edges:
                canvas.line(np.array([tuple(p) for p in edge.discretize(60)]))
        else:
            for line in lines_of(face):
                canvas.line(line)
    image = canvas.image()
    ImageDraw.Draw(image).text((12, 10), title, fill="black")
    return image


def main():
    sheet = Image.new("RGB", (PANE * len(PANES), PANE), "white")
    for place, arguments in enumerate(PANES):
        sheet.paste(pane(sys.argv[1], *arguments), (place * PANE, 0))
    sheet.save(sys.argv[2], optimize=True)


if __name__ == "__main__":
    main()
