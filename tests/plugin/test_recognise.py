"""Faces that are recognised: their kind in FreeCAD, in words, and in a file."""

import json
import tempfile
import unittest
from pathlib import Path

from headless import Case, example  # first: it makes FreeCAD importable

import Part  # noqa: E402
from suture_workbench import api, reports, words  # noqa: E402


def box():
    """A box with a rounded upright edge and a rounded rim."""
    plain = Part.makeBox(30, 25, 20)
    upright = plain.makeFillet(
        8, [e for e in plain.Edges if e.CenterOfMass.x < 1e-6 and e.CenterOfMass.y < 1e-6]
    )
    top = [
        e for e in upright.Edges
        if abs(e.BoundBox.ZMin - 20) < 1e-6 and e.CenterOfMass.x < 29 and e.CenterOfMass.y < 24
    ]  # fmt: skip
    return upright.makeFillet(2.5, top)


class Recognised(Case):
    def lost(self, body, kind):
        """The body as an object without a face of that kind, and the face."""
        of_kind = [face for face in body.Faces if isinstance(face.Surface, kind)]
        face = of_kind[0]
        return self.add(Part.Shell([f for f in body.Faces if not f.isSame(face)])), face

    def filled(self, base, **options):
        filled = api.fill(base, **options)
        return filled, filled.Shape.Faces[filled.NewFaces[0] - 1].Surface

    def test_a_torus_is_one_again_and_said_so(self):
        base, face = self.lost(box(), Part.Toroid)
        filled, surface = self.filled(base)
        self.assertIsInstance(surface, Part.Toroid)
        self.assertAlmostEqual(surface.MajorRadius, 5.5, delta=1e-9)
        self.assertAlmostEqual(surface.MinorRadius, 2.5, delta=1e-9)
        self.assertLess((surface.Center - face.Surface.Center).Length, 1e-9)
        self.assertIn("recognised: torus R = 5.5, r = 2.5, tangent to Face", filled.Verdict)
        report = reports.fill(json.loads(filled.Report))
        self.assertIn(report.holes[0].recognised, words.fill_summary(report))

    def test_a_cylinder_is_one_again(self):
        base, _ = self.lost(box(), Part.Cylinder)
        _, surface = self.filled(base)
        self.assertIsInstance(surface, Part.Cylinder)

    def test_a_ball_is_one_again(self):
        filled, surface = self.filled(self.add(example()))
        self.assertIsInstance(surface, Part.Sphere)
        self.assertAlmostEqual(surface.Radius, 8.0, delta=1e-9)
        self.assertIn("recognised: sphere r = 8", filled.Verdict)

    def test_it_is_the_kind_in_a_file_as_well(self):
        base, _ = self.lost(box(), Part.Toroid)
        filled, _ = self.filled(base)
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "filled.step")
            filled.Shape.exportStep(path)
            self.assertIn("TOROIDAL_SURFACE", Path(path).read_text(encoding="utf-8"))
            again = Part.read(path)
        self.assertTrue(any(isinstance(f.Surface, Part.Toroid) for f in again.Faces))

    def test_it_can_be_left_out_and_stays_so(self):
        base, _ = self.lost(box(), Part.Toroid)
        filled, surface = self.filled(base, recognise="off")
        self.assertIsInstance(surface, Part.BSplineSurface)
        self.assertNotIn("recognised", filled.Verdict)
        self.assertEqual(filled.Recognise, "off")
        filled.Recognise = "neighbours"
        self.document.recompute()
        surface = filled.Shape.Faces[filled.NewFaces[0] - 1].Surface
        self.assertIsInstance(surface, Part.Toroid)

    def test_a_program_that_does_not_know_it_is_not_asked(self):
        from suture_workbench.options import FillOptions

        self.assertNotIn("--recognise", FillOptions().arguments(int))
        words_of = FillOptions(recognise="off").arguments(int)
        self.assertEqual(words_of[words_of.index("--recognise") + 1], "off")


if __name__ == "__main__":
    unittest.main()
