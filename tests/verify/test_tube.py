"""Closes holes with `tube` and judges the written files with FreeCAD's Part module."""

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
CORNER = Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs" / "examples" / "suitcase_corner.step"
# A box of 60 x 50 x 40 with edges of radius 8: its corner's middle, and outwards from there.
CENTRE, RADIUS = (52.0, 42.0, 32.0), 8.0


def run(*words):
    return subprocess.run(
        [SUTURE, *map(str, words)], capture_output=True, text=True, timeout=limit(120), check=False
    )


@unittest.skipIf(Part is None, "needs Debian's freecad-python3")
class Tube(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def fill(self, *options, ending="step"):
        """The report of the corner's fill, and the file."""
        out = Path(self.folder.name) / f"filled.{ending}"
        words = [word for option in options for word in ("--option", option)]
        done = run("fill", CORNER, "-o", out, "--method", "tube", "--angle", 0.1, "--force", "--json", *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout), out

    def tube_of(self, file):
        """The new face: the one of degrees 3 and 2."""
        shape = Part.Shape()
        shape.read(str(file))
        splines = [f for f in shape.Faces if isinstance(f.Surface, Part.BSplineSurface)]
        tubes = [f for f in splines if {f.Surface.UDegree, f.Surface.VDegree} == {2, 3}]
        self.assertEqual(len(tubes), 1)
        return shape, tubes[0]

    def pole_of(self, face):
        """The point to which a whole row of control points shrinks."""
        poles = face.Surface.getPoles()
        rows = [poles[0], poles[-1], [row[0] for row in poles], [row[-1] for row in poles]]
        single = [row for row in rows if all(p.distanceToPoint(row[0]) < 1e-12 for p in row)]
        self.assertEqual(len(single), 1)
        return single[0][0]

    def expect_whole(self, shape, face):
        """Valid and closed, with a degenerated edge at the pole and a seam."""
        self.assertTrue(shape.isValid())
        free = [e for e in shape.Edges if not e.Degenerated and len(shape.ancestorsOfType(e, Part.Face)) == 1
                and not any(e.isSeam(f) for f in shape.ancestorsOfType(e, Part.Face))]
        self.assertEqual(free, [])
        self.assertEqual(sum(1 for e in face.Edges if e.Degenerated), 1)
        self.assertEqual(sum(1 for e in face.Edges if not e.Degenerated and e.isSeam(face)), 1)

    def test_step_keeps_pole_and_seam(self):
        report, out = self.fill()
        self.assertTrue(report["closed"] and report["valid"])
        self.expect_whole(*self.tube_of(out))

    def test_step_written_again_keeps_pole_and_seam(self):
        _, out = self.fill()
        again = Path(self.folder.name) / "again.step"
        self.assertEqual(run("convert", out, again).returncode, 0)
        self.expect_whole(*self.tube_of(again))

    def test_iges_keeps_the_face(self):
        report, out = self.fill(ending="iges")
        self.assertTrue(report["valid"])
        sewn = Path(self.folder.name) / "sewn.step"
        self.assertEqual(run("convert", out, sewn, "--sew").returncode, 0)
        self.expect_whole(*self.tube_of(sewn))

    def test_point_and_normal_given_are_met(self):
        wanted = [c + 0.58 * RADIUS for c in CENTRE]
        _, out = self.fill("pole=" + ",".join(map(str, wanted)), "normal=1,1,1")
        _, face = self.tube_of(out)
        pole = self.pole_of(face)
        self.assertLess(math.dist((pole.x, pole.y, pole.z), wanted), 1e-9)

    def test_every_functional_and_magnitude_gives_another_surface(self):
        areas = set()
        for options in (["energy=plate"], ["energy=F1"], ["energy=F2"], ["energy=F3"], ["magnitude=2"],
                        ["energy=F2", "move-pole=1"], ["layers=11"]):
            report, out = self.fill(*options)
            self.assertTrue(report["closed"] and report["valid"], options)
            _, face = self.tube_of(out)
            areas.add(round(face.Area, 6))
        self.assertEqual(len(areas), 7)

    def test_what_makes_no_sense_is_wrong_usage(self):
        out = Path(self.folder.name) / "none.step"
        for option in ("energy=F4", "magnitude=-1", "pole=1,2", "normal=0,0,0", "layers=1.5", "colour=red"):
            done = run("fill", CORNER, "-o", out, "--method", "tube", "--option", option)
            self.assertEqual(done.returncode, 1, option)
            self.assertFalse(out.exists())

    def test_too_many_curvatures_are_refused_by_their_number(self):
        out = Path(self.folder.name) / "none.step"
        done = run("fill", CORNER, "-o", out, "--method", "tube", "--option", "curvature=0,0", "--json")
        self.assertEqual(done.returncode, 4)
        self.assertIn("2 curvatures were given for 3 sides", done.stdout)


if __name__ == "__main__":
    unittest.main()
