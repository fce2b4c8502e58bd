#!/usr/bin/env python3
"""Compares a fill with FreeCAD's own Surface > Filling, and prints the table of docs/freecad.md.

    compare_filling.py [PROGRAM]    by default what ./suture has built; needs FreeCAD, no window

Both close the same hole of the same model, tangentially, as a user would: the steps that he takes are
listed with their clicks, and each is carried out. What came of it is measured by `suture check`.
"""

import os
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
os.environ.setdefault("SUTURE_SOURCE_DIR", str(ROOT))
default = ROOT / "build/release/bin/suture"
os.environ["SUTURE_PROGRAM"] = sys.argv[1] if len(sys.argv) > 1 else str(default)

from headless import example  # noqa: E402

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api, reports  # noqa: E402
from suture_workbench.errors import SutureError  # noqa: E402

EXAMPLES = ("suitcase_corner", "bump_window", "dome_window", "pipe_elbow")


def with_suture(base, hole):
    """Workbench, edge, command, OK."""
    clicks = 1 + 1 + 1 + 1
    return clicks, api.fill(base, edges=hole.edges[:1]).Shape


def with_surface_filling(base, hole):
    """Workbench; the command; Add edge; for each side the edge, its row, its face (two clicks), its
    continuity (two) and Accept; OK. Then the faces are sewn: workbench, both objects, Part > Shape
    builder, Shell from faces, all faces, Create, Solid from shell, Create, Close."""
    sides = len(hole.edges)
    clicks = 1 + 1 + 1 + 7 * sides + 1
    clicks += 1 + 2 + 1 + 1 + 1 + 1 + 1 + 1 + 1
    patch = base.Document.addObject("Surface::Filling", "Filling")
    patch.BoundaryEdges = [(base, tuple(f"Edge{edge}" for edge in hole.edges))]
    patch.BoundaryFaces = [f"Face{face}" for face in hole.faces]
    patch.BoundaryOrder = [1] * sides  # tangent
    base.Document.recompute()
    if "Invalid" in patch.State:
        raise SutureError(patch.getStatusString())
    shape = Part.Compound(base.Shape.Faces + patch.Shape.Faces)
    shape.sewShape(1e-3)
    shell = shape.Shells[0]
    return clicks, Part.makeSolid(shell) if shell.isClosed() else shell


def worst(shape, faces):
    """(largest gap, largest angle) along the edges between a new face and an old one."""
    obj = App.ActiveDocument.addObject("Part::Feature", "Result")
    obj.Shape = shape
    edges = [e for e in api.check(obj, sharp=89.0).edges if max(e.faces) > faces >= min(e.faces)]
    return max(edge.gap for edge in edges), max(edge.angle for edge in edges)


def compare(name):
    for title, way in (("Suture", with_suture), ("Surface > Filling", with_surface_filling)):
        document = App.newDocument()
        base = document.addObject("Part::Feature", "Base")
        base.Shape = example(name)
        holes = [h for h in api.find_holes(base).report.holes if h.kind == reports.FILLABLE]
        hole, cpu = holes[0], time.process_time() + sum(os.times()[2:4])
        try:
            clicks, shape = way(base, hole)
            seconds = time.process_time() + sum(os.times()[2:4]) - cpu
            gap, angle = worst(shape, len(base.Shape.Faces))
            outcome = f"{gap:.1g} mm | {angle:.2g}° | {shape.ShapeType.lower()}"
            outcome += "" if shape.isValid() else ", not valid"
        except Exception as error:  # what FreeCAD raises for what it cannot do
            clicks, seconds, outcome = "", 0.0, f"| | {str(error).splitlines()[0][:60]}"
        print(f"| {name} ({len(hole.edges)} sides) | {title} | {clicks} | {seconds:.2f} | {outcome} |")
        App.closeDocument(document.Name)


print("| hole | with | clicks | CPU s | largest gap | largest angle | what comes out |")
print("|---|---|---|---|---|---|---|")
for example_name in EXAMPLES:
    compare(example_name)
