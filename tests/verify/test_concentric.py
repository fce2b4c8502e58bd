"""Caps planar ends with `concentric` and judges the written file with FreeCAD's Part module."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from time_limits import limit

sys.path.insert(0, "/usr/lib/freecad-python3/lib")

try:
    import FreeCAD  # noqa: F401  (Part needs it loaded first)
    import Part
except ImportError:
    Part = None

SUTURE = os.environ["SUTURE_PROGRAM"]
EXAMPLES = Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs" / "examples"
CAD = Path(os.environ["SUTURE_CAD_DIR"]) / "files"


def polygon(*points):
    corners = [FreeCAD.Vector(x, y, 0) for x, y in points]
    return Part.makePolygon([*corners, corners[0]])


def arc(centre, radius, begin, end):
    circle = Part.Circle(FreeCAD.Vector(*centre, 0), FreeCAD.Vector(0, 0, 1), radius)
    return Part.ArcOfCircle(circle, begin, end).toShape()


def line(a, b):
    return Part.makeLine(FreeCAD.Vector(*a, 0), FreeCAD.Vector(*b, 0))


def star(rays, inner):
    angles = [math.pi * k / rays for k in range(2 * rays)]
    radii = [(inner if k % 2 else 8) for k in range(2 * rays)]
    return polygon(*((r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles)))


def outlines():
    """Wires by name: convex, concave, with arcs, with a single edge, with corners of all kinds."""
    mouth = math.asin(1 / 3)
    deep = -3 * math.cos(mouth)
    return {
        "rectangle": polygon((0, 0), (6, 0), (6, 4), (0, 4)),
        "L": polygon((0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)),
        "L from another corner": polygon((6, 2), (2, 2), (2, 5), (0, 5), (0, 0), (6, 0)),
        "U": polygon((0, 0), (7, 0), (7, 5), (5, 5), (5, 2), (2, 2), (2, 6), (0, 6)),
        "cross": polygon((2, 0), (4, 0), (4, 2), (6, 2), (6, 4), (4, 4), (4, 6), (2, 6), (2, 4), (0, 4), (0, 2), (2, 2)),
        "arrow": polygon((0, 0), (8, 0), (8, 4), (4, 1.5), (0, 4)),
        "star": star(5, 4),
        "ellipse": Part.Wire([Part.Ellipse(FreeCAD.Vector(), 5, 2).toShape()]),
        "slot": Part.Wire([line((0, -2), (8, -2)), arc((8, 0), 2, -math.pi / 2, math.pi / 2), line((8, 2), (0, 2)),
                           arc((0, 0), 2, math.pi / 2, 3 * math.pi / 2)]),
        "keyhole": Part.Wire([arc((0, 0), 3, mouth - math.pi / 2, 3 * math.pi / 2 - mouth), line((-1, deep), (-1, -9)),
                              line((-1, -9), (1, -9)), line((1, -9), (1, deep))]),
    }  # fmt: skip


@unittest.skipIf(Part is None, "needs Debian's freecad-python3")
class ConcentricArea(unittest.TestCase):
    """What FreeCAD says of the faces' area in the written file, against that of the plane outline."""

    def check(self, faces):
        for name, wire in outlines().items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                plane = Part.Face(wire)
                prism = plane.extrude(FreeCAD.Vector(0, 0, 4))
                source, out = Path(folder) / "open.step", Path(folder) / "capped.step"
                Part.Shell([face for face in prism.Faces if face.CenterOfMass.z < 4 - 1e-9]).exportStep(str(source))
                command = [SUTURE, "fill", source, "-o", out, "--method", "concentric", "--option", f"faces={faces}"]
                done = subprocess.run(
                    [*map(str, command)], capture_output=True, text=True, timeout=limit(120), check=False
                )
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                shape = Part.Shape()
                shape.read(str(out))
                self.assertTrue(shape.isValid())
                new = [face for face in shape.Faces if isinstance(face.Surface, Part.BSplineSurface)]
                self.assertEqual(len(new), 1 if faces == "one" else len(wire.Edges))
                self.assertAlmostEqual(sum(face.Area for face in new) / plane.Area, 1, delta=1e-7)

    def test_of_one_face_for_each_side(self):
        self.check("regions")

    def test_of_one_face_for_all_sides(self):
        self.check("one")


@unittest.skipIf(Part is None, "needs Debian's freecad-python3")
class Concentric(unittest.TestCase):
    def cap(self, model, faces, *more):
        """All planar ends capped: the written shape closes."""
        if not model.exists():
            self.skipTest(f"needs {model}")
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "capped.step"
            command = [SUTURE, "fill", model, "-o", out, "--method", "concentric", "--continuity", "G0", "--json"]
            done = subprocess.run(
                [*map(str, command), *more], capture_output=True, text=True, timeout=limit(120), check=False
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            shape = Part.Shape()
            shape.read(str(out))
        self.assertTrue(report["closed"] and report["valid"])
        self.assertEqual(report["free_edges"], 0)
        holes = [hole for hole in report["holes"] if hole["status"] == "filled"]
        self.assertTrue(holes)
        for hole in holes:
            self.assertEqual(len(hole["patches"]), faces or hole["sides"])
            self.assertLess(hole["max_gap"], 2e-7)
        self.assertTrue(shape.isValid())
        self.assertTrue(all(shell.isClosed() for shell in shape.Shells))

    def test_caps_a_box(self):
        self.cap(EXAMPLES / "box_without_lid.step", None)

    def test_caps_a_pipe_with_circles(self):
        self.cap(EXAMPLES / "pipe_elbow.step", None)

    def test_caps_with_one_face_for_all_sides(self):
        self.cap(EXAMPLES / "pipe_elbow.step", 1, "--option", "faces=one")

    def test_caps_the_nacelle(self):
        self.cap(CAD / "nacelle.stp", None)

    def test_caps_the_u_bend(self):
        self.cap(CAD / "ubend2.stp", None)

    def test_puts_no_cap_on_the_back_of_the_sheet_in_the_wing(self):
        model = CAD / "simple_wing.stp"
        if not model.exists():
            self.skipTest(f"needs {model}")
        with tempfile.TemporaryDirectory() as folder:
            command = [SUTURE, "fill", model, "-o", Path(folder) / "capped.step", "--method", "concentric",
                       "--continuity", "G0", "--all-loops", "--json"]  # fmt: skip
            done = subprocess.run(
                [*map(str, command)], capture_output=True, text=True, timeout=limit(120), check=False
            )
        self.assertEqual(done.returncode, 4, done.stderr)
        hole = json.loads(done.stdout)["holes"][0]
        self.assertEqual(hole["status"], "refused")
        self.assertIn("lies_on_face", {finding["kind"] for finding in hole["findings"]})


if __name__ == "__main__":
    unittest.main()
