"""What a fill can be told besides: merge, cut in two, grow, tension, supports, holes by kind and size."""

import json
import math
import tempfile
import unittest
from pathlib import Path

from headless import TURNED, Case, open_box  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api, extras, feature  # noqa: E402
from suture_workbench.errors import NothingToDo, SutureError  # noqa: E402
from suture_workbench.options import FillOptions  # noqa: E402

V = App.Vector


def sheet(*points):
    points = [V(*p) for p in points]
    return Part.Face(Part.makePolygon([*points, points[0]]))


def pierced(radius=2):
    """A plate with two round windows, one of this radius, and a square one."""
    plate = sheet((0, 0, 0), (100, 0, 0), (100, 40, 0), (0, 40, 0))
    for tool in (
        Part.makeCylinder(radius, 2, V(15, 20, -1)),
        Part.makeCylinder(6, 2, V(40, 20, -1)),
        Part.makeBox(10, 10, 2, V(70, 15, -1)),
    ):
        plate = plate.cut(tool)
    return plate


class Extras(Case):
    def test_holes_are_chosen_by_kind_and_size_again_at_every_recompute(self):
        plate = self.add(pierced())
        plate.Placement = TURNED
        large = api.fill(plate, larger=10)
        self.assertEqual(len(large.NewFaces), 2)
        self.assertEqual((large.LargerThan.Value, len(api.fill(plate, corners=4).NewFaces)), (10, 1))
        self.assertEqual(len(api.fill(plate, planar=True, smaller=10).NewFaces), 1)
        plate.Shape = pierced(8)
        self.document.recompute()
        self.assertEqual(len(large.NewFaces), 3)
        with self.assertRaises(NothingToDo):
            api.fill(plate, larger=900)

    def test_a_hole_that_is_named_is_chosen_in_one_way_only(self):
        plate = self.add(pierced())
        hole = api.find_holes(plate).report.holes[0]
        with self.assertRaises(SutureError) as caught:
            api.fill(plate, edges=[hole.edges[0]], larger=10)
        self.assertIn("name none", str(caught.exception))

    def test_what_is_merged_leaves_no_trace(self):
        plate = self.add(pierced())
        merged = api.fill(plate, merge=True)
        self.assertEqual((len(merged.Shape.Faces), len(merged.Shape.Edges)), (1, 4))
        self.assertAlmostEqual(merged.Shape.Area, 4000, delta=1e-6)
        self.assertTrue(merged.Merge)
        merged.Merge = False
        self.document.recompute()
        self.assertEqual(len(merged.Shape.Faces), 4)

    def test_a_rim_around_two_walls_is_cut_in_two(self):
        walls = [f for f in Part.makeBox(10, 20, 30).Faces if min(abs(f.CenterOfMass.x), abs(f.CenterOfMass.y)) > 1e-6]
        box = self.add(Part.Shell(walls))
        cut = api.fill(box, split="auto", all_loops=True)
        self.assertEqual((len(cut.Shape.Faces), cut.Shape.ShapeType), (6, "Solid"))
        self.assertAlmostEqual(cut.Shape.Volume, 6000, delta=1e-6)

    def test_the_neighbours_of_a_lost_fillet_grow_together(self):
        box = Part.makeBox(30, 20, 10)
        rounded = box.makeFillet(2, [box.Edges[0]])
        open_ = self.add(Part.Shell([f for f in rounded.Faces if "Cylinder" not in f.Surface.TypeId]))
        sharp = api.fill(open_, grow=True)
        self.assertAlmostEqual(sharp.Shape.Volume, 6000, delta=6e-6)
        self.assertIn("grown together", sharp.Verdict)

    def test_tension_says_how_far_a_curve_goes_on(self):
        """The side that is missing of a rectangle bulges by a fifth of the gap's square, times the tension."""
        wire = self.add(Part.makePolygon([V(0, 0, 0), V(9, 0, 0), V(9, 4, 0), V(0, 4, 0)]))
        face = api.fill_border([(wire, [1, 2, 3])], connect=True, tension=2.0)
        self.assertAlmostEqual(face.Shape.Area, 36 + 2 * 16 / 5, delta=1e-6)
        face.Tension = 0.5
        self.document.recompute()
        self.assertAlmostEqual(face.Shape.Area, 36 + 0.5 * 16 / 5, delta=1e-6)

    def leaning(self):
        """A circle on a ball, of which a zone below it is there; both are turned."""
        ball = self.add(Part.makeSphere(6, V(), V(0, 0, 1), -30, math.degrees(math.asin(3 / 6))).Faces[0], "Ball")
        circle = self.add(Part.makeCircle(math.sqrt(20), V(0, 0, 4)), "Circle")
        ball.Placement = circle.Placement = TURNED
        self.document.recompute()
        return ball, api.fill_border([(circle, [1]), (ball, [])], supports={1: 1})

    def test_a_curve_leans_on_a_face_of_another_object(self):
        ball, cap = self.leaning()
        for _ in range(2):
            self.assertEqual(cap.State, ["Up-to-date"])
            self.assertAlmostEqual(cap.Shape.Area - ball.Shape.Area, 24 * math.pi, delta=1e-4)
            self.assertEqual(list(cap.Supports), ["Edge1=Face1"])
            cap.touch()
            cap.InputKey = ""
            self.document.recompute()

    def test_a_face_is_tangent_to_another_one_along_an_edge_of_it(self):
        """Over a circle of a ball, through a smaller one: with the ball's tangency the ball's own cap."""
        height = lambda r: math.sqrt(400 - r * r)
        rim = self.add(Part.makeCircle(9, V(0, 0, height(9))), "Rim")
        inner = self.add(Part.makeCircle(5, V(0, 0, height(5))), "Inner")
        ball = self.add(Part.makeSphere(20), "Ball")
        for obj in (rim, inner, ball):
            obj.Placement = TURNED
        self.document.recompute()
        passed = [(inner, ("Edge1",)), (ball, ("Face1",))]
        cap = api.fill_border([(rim, [1])], passed)
        report = json.loads(cap.Report)
        (hole,) = (h for h in report["holes"] if h["status"] == "filled")
        self.assertLess(hole["max_angle_through_deg"], 0.1)
        top = TURNED.multVec(V(0, 0, 20))
        self.assertLess(cap.Shape.distToShape(Part.Vertex(top))[0], 0.02)
        self.assertEqual(cap.State, ["Up-to-date"])
        with self.assertRaises(SutureError) as caught:
            api.fill_border([(rim, [1])], passed[1:])
        self.assertIn("not faces", str(caught.exception))

    def test_it_is_saved_and_opened_with_all_that_it_is_made_of(self):
        _, cap = self.leaning()
        plate = api.fill(self.add(pierced()), larger=10, merge=True)
        keys = [feature.Request.of(obj).options.key() for obj in (cap, plate)]
        names = [obj.Name for obj in (cap, plate)]
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.FCStd")
            self.document.saveAs(path)
            App.closeDocument(self.document.Name)
            again = App.openDocument(path)
            self.assertEqual(
                [feature.Request.of(again.getObject(name)).options.key() for name in names], keys
            )

    def test_who_asks_for_none_has_the_key_of_older_documents(self):
        self.assertNotIn("extras", FillOptions().key())
        self.assertNotIn("extras", FillOptions(merge=False, larger=0, tension=1).key())
        self.assertIn("extras", FillOptions(merge=True).key())
        filled = api.fill(self.add(open_box()))
        self.assertEqual(feature.Request.of(filled).options.extras, {})

    def test_islands_are_sides_of_their_hole(self):
        class Loop:
            def __init__(self, id, islands, edges, length):
                self.id, self.islands, self.edges, self.length = id, islands, edges, length
                self.planar, self.diameter = True, length / 3

        loops = [Loop(1, [2], [1, 2, 3], 30), Loop(2, [1], [4], 9), Loop(3, [], [5], 9)]
        for wanted, ids in (({"corners": 4}, [1, 2]), ({"smaller": 5.0}, [3]), ({"larger": 5.0}, [1, 2])):
            self.assertEqual([loop.id for loop in loops if extras.fits(wanted, loop, loops)], ids)


if __name__ == "__main__":
    unittest.main()
