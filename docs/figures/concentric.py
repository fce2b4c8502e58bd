#!/usr/bin/python3
"""Draws the concentric maps that suture_concentric_maps prints as PNG pictures, one for each figure.

    BUILD/tests/kernel/core/concentric/suture_concentric_maps | docs/figures/concentric.py FOLDER

The figures are those of Martin & Cohen 2003 made again: 6 and 8 to 13. Boundary black, control
polygon grey, spokes and rings blue, medial or concentric axis red. Needs Debian's python3-pil.
"""

import json
import pathlib
import sys

from PIL import Image, ImageDraw

SIZE = 420
MARGIN = 26
CAPTION = 40
SUPERSAMPLING = 3
POLYGON, NET, AXIS, BORDER = (165, 165, 165), (90, 140, 210), (200, 30, 30), (20, 20, 20)


def caption_of(panel):
    if "nodes" not in panel:
        return panel["title"], ""
    return panel["title"], (
        f"{panel['nodes']} nodes, {panel['poles']} poles, {panel['folds']} folds, "
        f"{panel['outside']} edges outside"
    )


def draw(panel):
    image = Image.new("RGB", (SIZE * SUPERSAMPLING, SIZE * SUPERSAMPLING), "white")
    canvas = ImageDraw.Draw(image)
    points = panel["boundary"] + panel["polygon"]
    low = [min(p[c] for p in points) for c in (0, 1)]
    high = [max(p[c] for p in points) for c in (0, 1)]
    scale = (SIZE - 2 * MARGIN) / max(high[0] - low[0], high[1] - low[1])

    def at(p):
        x = SIZE / 2 + scale * (p[0] - (low[0] + high[0]) / 2)
        y = SIZE / 2 - scale * (p[1] - (low[1] + high[1]) / 2)
        return x * SUPERSAMPLING, y * SUPERSAMPLING

    def line(points, colour, width):
        canvas.line([at(p) for p in points], fill=colour, width=round(width * SUPERSAMPLING))

    line(panel["polygon"], POLYGON, 1)
    for points in panel["net"]:
        line(points, NET, 0.8)
    line(panel["boundary"], BORDER, 1.8)
    for points in panel["axis"]:
        line(points, AXIS, 1.8)
    return image.resize((SIZE, SIZE), Image.LANCZOS)


def picture(panels):
    image = Image.new("RGB", (SIZE * len(panels), SIZE + CAPTION), "white")
    canvas = ImageDraw.Draw(image)
    for k, panel in enumerate(panels):
        image.paste(draw(panel), (k * SIZE, 0))
        for row, text in enumerate(caption_of(panel)):
            canvas.text((k * SIZE + MARGIN, SIZE + 14 * row), text, fill=BORDER)
    return image


def main():
    folder = pathlib.Path(sys.argv[1])
    figures = {}
    for text in sys.stdin:
        panel = json.loads(text)
        figures.setdefault(panel["figure"], []).append(panel)
    for name, panels in figures.items():
        picture(panels).save(folder / f"concentric_{name}.png", optimize=True)


if __name__ == "__main__":
    main()
