"""Every command of the workbench as a function, on real shapes."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from headless import (
    CORNER,
    EXAMPLES,
    PROGRAM,
    TURNED,
    Case,
    example,
    open_box,
)  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api, program, reports  # noqa: E402
from suture_workbench.errors import SutureError  # noqa: E402


class Commands(Case):
    def test_find_holes_tells_edges_faces_and_size(self):
        found = api.find_holes(self.add(example()))
        (hole,) = found.report.holes
        self.assertEqual((hole.kind, hole.edges, hole.faces), ("hole", CORNER, [3, 7, 9]))
        # The corner's three points lie 8 mm apart in x, y and z.
        self.assertAlmostEqual(hole.diameter, 8 * 3**0.5, delta=2e-3)
        self.assertLess(max(corner.mismatch for corner in hole.corners), 1e-6)

    def test_find_holes_puts_rims_after_holes(self):
        disc = Part.makeCylinder(2, 1, App.Vector(5, 5, -0.5))
        plain = Part.makePlane(10, 10, App.Vector(50, 0, 0))
        shapes = [plain, Part.makePlane(10, 10).cut(disc), plain.translated(App.Vector(50, 0, 0))]
        holes = api.find_holes(self.add(Part.Compound(shapes))).report.holes
        self.assertEqual([hole.kind for hole in holes], ["hole", "rim", "rim", "rim"])
        self.assertGreater(holes[0].id, 1)

    def test_a_closed_solid_has_no_hole_and_that_is_no_failure(self):
        report = api.find_holes(self.add(Part.makeBox(1, 2, 3))).report
        self.assertTrue(report is None or not report.holes)

    def test_fill_makes_a_valid_solid_that_is_smooth(self):
        filled = api.fill(self.add(example()), method="mvs")
        self.assertEqual((filled.Shape.ShapeType, filled.Shape.isValid()), ("Solid", True))
        self.assertTrue(filled.Closed and filled.WithinTolerance)
        self.assertEqual(list(filled.NewFaces), [10])
        report = api.check(filled)
        self.assertEqual(report.near_misses, 0)
        smooth = [edge.angle for edge in report.edges if edge.kind != "sharp"]
        self.assertLess(max(smooth), 0.01)
        # The corner is an eighth of a ball of radius 8: what the box and its three fillets leave.
        face = filled.Shape.Faces[9]
        self.assertAlmostEqual(face.Area, 4 * 3.141592653589793 * 64 / 8, delta=1e-3)

    def test_fill_keeps_faces_edges_and_their_numbers(self):
        base = self.add(example())
        filled = api.fill(base)
        for before, after in zip(base.Shape.Faces, filled.Shape.Faces):
            self.assert_same_face(before, after)
        for before, after in zip(base.Shape.Edges, filled.Shape.Edges):
            self.assertLess((before.CenterOfMass - after.CenterOfMass).Length, 1e-9)

    def test_fill_takes_an_edge_or_a_face_for_a_hole(self):
        base = self.add(open_box())
        one, other = api.find_holes(base).report.holes
        filled = api.fill(base, edges=[other.edges[2]])
        self.assertEqual((len(filled.Shape.Faces), filled.Closed), (5, False))
        both = api.fill(base, faces=[1])
        self.assertEqual((len(both.Shape.Faces), both.Shape.ShapeType), (6, "Solid"))
        self.assertAlmostEqual(both.Shape.Volume, 6000, delta=1e-6)
        self.assertEqual(set(one.faces), {1, 2, 3, 4})

    def test_a_side_can_have_a_continuity_of_its_own(self):
        filled = api.fill(self.add(example()), sides={9: "G0", 19: "G1"}, method="mvs")
        sides = {
            side.edge: side.wanted
            for side in reports.fill(json.loads(filled.Report)).holes[0].sides
        }
        self.assertEqual(sides, {9: "G0", 19: "G1", 21: "G1"})
        self.assertEqual(filled.EdgesG0[1], ["Edge9"])

    def test_a_fill_passes_through_points_and_edges_of_other_objects(self):
        base = self.add(example("bump_window"))
        base.Placement = TURNED
        hole = api.find_holes(base).report.holes[0]
        point = TURNED.multVec(self.middle_of(base, hole) + App.Vector(0, 0, 0.3))
        vertex = self.add(Part.Vertex(point), "Probe")
        filled = api.fill(
            base, edges=[hole.edges[0]], method="mvs", through=[(vertex, ("Vertex1",))]
        )
        new = [filled.Shape.Faces[number - 1] for number in filled.NewFaces]
        distance = min(face.distToShape(Part.Vertex(point))[0] for face in new)
        self.assertLess(distance, 0.01)
        without = api.fill(base, edges=[hole.edges[0]], method="mvs")
        new = [without.Shape.Faces[number - 1] for number in without.NewFaces]
        self.assertGreater(min(face.distToShape(Part.Vertex(point))[0] for face in new), 0.05)

    def middle_of(self, base, hole):
        points = [base.Shape.Edges[edge - 1].CenterOfMass for edge in hole.edges]
        return base.Placement.inverse().multVec(sum(points, App.Vector()) * (1 / len(points)))

    def test_loops_of_one_face_are_filled_together(self):
        box, pillar = Part.makeBox(40, 40, 10), Part.makeCylinder(5, 10, App.Vector(20, 20, 10))
        solid = box.fuse(pillar).removeSplitter()
        ring = 1600 - 25 * 3.141592653589793
        kept = [face for face in solid.Faces if abs(face.Area - ring) > 1]
        base = self.add(Part.Compound(kept))
        found = api.find_holes(base)
        edges = [found.number(hole.edges[0]) for hole in found.report.holes]
        self.assertEqual(len(edges), 2)
        filled = api.fill(base, edges=edges, one_face=True)
        self.assertEqual((filled.Shape.ShapeType, len(filled.NewFaces)), ("Solid", 1))
        self.assertAlmostEqual(filled.Shape.Faces[filled.NewFaces[0] - 1].Area, ring, delta=1e-4)
        self.assertAlmostEqual(filled.Shape.Volume, solid.Volume, delta=1e-3)

    def test_loops_that_bound_no_common_face_are_not_filled_as_one(self):
        base = self.add(open_box())
        edges = [hole.edges[0] for hole in api.find_holes(base).report.holes]
        self.assertTrue(api.fill(base, edges=edges).Closed)
        self.assertRaises(SutureError, api.fill, base, edges=edges, one_face=True)

    def test_options_of_a_methods_own_reach_the_program_and_stay_with_the_object(self):
        self.misbehave("options")
        self.assertEqual([option["key"] for option in program.options_of("mvs")], ["bend"])
        filled = api.fill(self.add(example()), method="mvs", own={"bend": 0.5})
        self.assertEqual(filled.MethodOptions, ["bend=0.5"])
        filled.touch()
        self.document.recompute()
        self.assertEqual(filled.State, ["Up-to-date"])
        os.environ["SUTURE_EXE"] = PROGRAM
        with self.assertRaises(SutureError) as caught:
            api.fill(filled.Base[0], method="mvs", own={"no_such": 1})
        self.assertIn("no_such", str(caught.exception))

    def test_check_can_be_told_profile_limits_and_edges(self):
        solid = self.add(api.fill(self.add(example()), method="mvs").Shape)
        report = api.check(solid, profile="vda4955", edges=[21, 9])
        self.assertEqual(sorted(edge.edge for edge in report.edges), [9, 21])
        self.assertEqual(report.limits.angle, 0.1)
        strict = api.check(solid, gap=1e-9)
        self.assertGreater(strict.near_misses, 0)
        self.assertTrue(strict.edges[0].near_miss, "worst first")

    def test_the_report_of_a_check_can_be_written(self):
        solid = api.fill(self.add(example()))
        with tempfile.TemporaryDirectory() as folder:
            html = Path(folder) / "report.html"
            table = reports.check_as_csv(api.check(solid, html=html)).splitlines()
            self.assertIn("<html", html.read_text(encoding="utf-8")[:2000].lower())
        self.assertEqual(len(table), 22)
        self.assertEqual(len({line.count(",") for line in table}), 1)

    def test_convert_works_on_files_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "out.step"
            answer = api.convert(EXAMPLES / "suitcase_corner.step", target, fill_holes=True)
            self.assertTrue(answer["closed"] and answer["valid"])
            shape = Part.Shape()
            shape.read(str(target))
            self.assertEqual(shape.ShapeType, "Solid")
            api.convert(target, Path(folder) / "out.iges")
            self.assertGreater((Path(folder) / "out.iges").stat().st_size, 1000)
        self.assertEqual(self.document.Objects, [])

    def test_export_fills_holes_in_step_and_iges(self):
        base = self.add(example())
        closed = self.add(Part.makeBox(1, 1, 1), "Closed")
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.step", "a.iges"):
                api.export([base], Path(folder) / name)
                done = subprocess.run(
                    [PROGRAM, "check", Path(folder) / name, "--json"],
                    capture_output=True,
                    check=True,
                )
                report = json.loads(done.stdout)
                self.assertTrue(report["shape"]["closed"], name)
                self.assertLess(report["summary"]["max_angle_deg"], 0.01, name)
            self.assertEqual(api.export([closed], Path(folder) / "b.step"), "There is no hole.")
            api.export([closed], Path(folder) / "b.iges")
            self.assertTrue(
                (Path(folder) / "b.step").exists() and (Path(folder) / "b.iges").exists()
            )


if __name__ == "__main__":
    unittest.main()
