"""Caps planar ends with `concentric` and judges the written file with FreeCAD's Part module."""

import json
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
