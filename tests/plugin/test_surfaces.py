"""Surfaces that files describe (patch, algebraic), and how much `auto` is to try."""

import json
import unittest
from pathlib import Path

from headless import EXAMPLES, HOME, Case, example  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
from star_mesh import star  # noqa: E402
from suture_workbench import api, words  # noqa: E402
from suture_workbench.errors import SutureError  # noqa: E402
from suture_workbench.options import FillOptions  # noqa: E402


class Surfaces(Case):
    def test_a_flat_mesh_becomes_a_flat_patch_in_one_step_of_undo(self):
        self.document.UndoMode = 1
        made = api.patch(star(Path(HOME.name) / "star.obj"))
        self.assertEqual((made.Label, len(made.Shape.Faces)), ("star", 10))
        self.assertTrue(made.Shape.isValid())
        box = made.Shape.BoundBox
        self.assertLess(max(abs(box.ZMin), abs(box.ZMax)), 1e-6)
        self.assertGreater(box.XLength, 5.0)
        self.document.undo()
        self.assertEqual(self.document.Objects, [])

    def test_options_of_the_patch_reach_the_program(self):
        mesh = star(Path(HOME.name) / "star.obj", sides=3)
        cells = api.patch(mesh, k=0, exact=True)
        quads = api.patch(mesh, k=0, quads=True)
        self.assertGreater(len(cells.Shape.Faces), len(quads.Shape.Faces))
        with self.assertRaises(SutureError) as caught:
            api.patch(star(mesh), aperture=50.0)
        self.assertIn("aperture 50", str(caught.exception))

    def test_polynomials_become_a_surface_between_their_neighbours(self):
        made = api.algebraic(EXAMPLES / "table_corner.json")
        self.assertEqual(len(made.Shape.Faces), 3)
        # Its corners are where the problem has them.
        for corner in ((0, 1, 1), (1, 1, 0), (1, 0, 1)):
            near = min((vertex.Point - App.Vector(*corner)).Length for vertex in made.Shape.Vertexes)
            self.assertLess(near, 1e-6)

    def test_a_file_that_is_no_mesh_is_a_sentence(self):
        path = Path(HOME.name) / "none.obj"
        path.write_text("v 0 0 0\n", encoding="ascii")
        with self.assertRaises(SutureError) as caught:
            api.patch(path)
        self.assertIn("none.obj", str(caught.exception))
        self.assertEqual(self.document.Objects, [])

    def test_what_is_out_of_tolerance_is_said(self):
        answer = {
            "command": "patch", "sides": 5, "layers": 5, "k": 2, "exact": False, "fit_error": 0.2,
            "diameter": 10.0, "max_gap": 1e-9, "max_angle_deg": 0.1, "exit_code": 4,
            "shape": {"faces": 10, "valid": True},
        }
        text, well = words.surface_summary(answer)
        self.assertFalse(well)
        self.assertIn("within 0.02 of the mesh", text)
        self.assertIn("not met", text)
        self.assertTrue(words.surface_summary(answer | {"exit_code": 0})[1])


class Effort(Case):
    def test_it_reaches_the_program_and_the_object(self):
        self.assertNotIn("--effort", FillOptions().arguments(int))
        said = FillOptions(effort="thorough").arguments(int)
        self.assertEqual(said[said.index("--effort") + 1], "thorough")
        filled = api.fill(self.add(example()), effort="quick")
        self.assertEqual(filled.Effort, "quick")
        self.assertTrue(filled.WithinTolerance)
        filled.Effort = "thorough"
        self.document.recompute()
        self.assertEqual(filled.State, ["Up-to-date"])

    def test_documents_of_before_stay_up_to_date(self):
        self.assertNotIn("effort", json.loads(FillOptions().key()))
        self.assertIn("effort", json.loads(FillOptions(effort="quick").key()))


if __name__ == "__main__":
    unittest.main()
