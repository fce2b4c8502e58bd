"""Faces over chosen edges, bridges, faces that go: parametric objects, against closed forms."""

import math
import tempfile
import unittest
from pathlib import Path

from headless import TURNED, Case  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api, feature, marks, places  # noqa: E402
from suture_workbench.errors import SutureError  # noqa: E402

V = App.Vector


def sheet(*points):
    points = [V(*p) for p in points]
    return Part.Face(Part.makePolygon([*points, points[0]]))


def edges_where(obj, wanted):
    """Numbers of the edges of an object whose middle is as wanted, in its own coordinates."""
    shape = places.local_shape(obj)
    middles = ((n, e.valueAt(sum(e.ParameterRange) / 2)) for n, e in enumerate(shape.Edges, 1))
    return [n for n, middle in middles if wanted(middle)]


class Elements(Case):
    def plates(self):
        left = self.add(sheet((0, 0, 0), (10, 0, 0), (10, 8, 0), (0, 8, 0)), "Left")
        right = self.add(sheet((20, 0, 0), (30, 0, 0), (30, 8, 0), (20, 8, 0)), "Right")
        return left, right

    def facing(self, left, right):
        (a,) = edges_where(left, lambda p: abs(p.x - 10) < 1e-6)
        (b,) = edges_where(right, lambda p: abs(p.x - 20) < 1e-6)
        return [(left, [a]), (right, [b])]

    def rounded(self):
        box = Part.makeBox(30, 20, 10)
        obj = self.add(box.makeFillet(2, [box.Edges[0]]))
        (fillet,) = (n for n, f in enumerate(obj.Shape.Faces, 1) if "Cylinder" in f.Surface.TypeId)
        return obj, fillet

    def test_a_sketch_bounds_a_face_and_the_face_follows_it(self):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        corners = [V(0, 0, 0), V(40, 0, 0), V(40, 30, 0), V(0, 30, 0)]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            sketch.addGeometry(Part.LineSegment(a, b))
        sketch.Placement = TURNED
        self.document.recompute()
        face = api.fill_border([(sketch, [3, 1, 4, 2])])
        self.assertEqual((face.Task, len(face.Shape.Faces)), ("Boundary", 1))
        self.assertAlmostEqual(face.Shape.Area, 1200, delta=1e-6)
        middle = TURNED.multVec(V(20, 15, 0))
        self.assertLess((face.Shape.CenterOfMass - middle).Length, 1e-6)
        sketch.Placement = App.Placement(V(1, 2, 3), App.Rotation())
        self.document.recompute()
        self.assertLess((face.Shape.CenterOfMass - V(21, 17, 3)).Length, 1e-6)

    def test_edges_of_several_objects_bound_a_face_where_they_stand(self):
        """A wire of Draft's kind, a moved sheet and a sheet in a Part close a rectangle."""
        wire = self.add(Part.makePolygon([V(0, 0, 0), V(0, 8, 0), V(10, 8, 0)]), "Wire")
        moved = self.add(sheet((0, 0, 0), (4, 0, 0), (4, 8, 0), (0, 8, 0)), "Moved")
        moved.Placement.Base = V(10, 0, 0)
        part = self.document.addObject("App::Part", "Part")
        part.Placement = App.Placement(V(0, 0, 0), App.Rotation(V(0, 0, 1), 180))
        below = self.add(sheet((0, 0, 0), (-10, 0, 0), (-10, 5, 0), (0, 5, 0)), "Below")
        part.addObject(below)
        self.document.recompute()
        chosen = [
            (wire, [1, 2]),
            (moved, edges_where(moved, lambda p: abs(p.x) < 1e-6)),
            (below, edges_where(below, lambda p: abs(p.y) < 1e-6)),
        ]
        for order in (chosen, chosen[::-1]):
            face = api.fill_border(order)
            self.assertEqual((len(face.Shape.Faces), len(face.Shape.Shells)), (3, 1))
            self.assertAlmostEqual(face.Shape.Area, 80 + 32 + 50, delta=1e-6)
            box = places.frame(face)
            self.assertTrue(face.Shape.isValid())
            middle = box.multVec(face.Shape.CenterOfMass)
            wanted = (V(5, 4, 0) * 80 + V(12, 4, 0) * 32 + V(5, -2.5, 0) * 50) / 162
            self.assertLess((middle - wanted).Length, 1e-6)
            self.assertEqual(face.Base[0], order[0][0])

    def test_a_bridge_of_two_objects_follows_both(self):
        left, right = self.plates()
        bridge = api.bridge(self.facing(left, right))
        self.assertAlmostEqual(bridge.Shape.Area, 240, delta=1e-6)
        self.assertEqual((bridge.MoreEdges[0][0], len(bridge.Shape.Shells)), (right, 1))
        right.Placement.Base = V(5, 0, 0)
        self.document.recompute()
        self.assertEqual(bridge.State, ["Up-to-date"])
        self.assertAlmostEqual(bridge.Shape.Area, 280, delta=1e-6)
        left.Shape = sheet((-2, 0, 0), (10, 0, 0), (10, 8, 0), (-2, 8, 0))
        self.document.recompute()
        self.assertAlmostEqual(bridge.Shape.Area, 296, delta=1e-6)

    def test_it_is_saved_and_opened_with_all_that_it_is_made_of(self):
        left, right = self.plates()
        bridge = api.bridge(self.facing(left, right), sides={self.facing(left, right)[0][1][0]: "G0"})
        options = feature.Request.of(bridge).options
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.FCStd")
            self.document.saveAs(path)
            App.closeDocument(self.document.Name)
            again = App.openDocument(path).getObject("Filled")
            self.assertEqual(feature.Request.of(again).options.key(), options.key())
            again.touch()
            self.misbehave("crash")  # nothing to compute: nothing to run
            again.Document.recompute()
            self.assertEqual(again.State, ["Up-to-date"])

    def test_a_wall_is_replaced_and_follows_its_box(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        replaced = api.replace_faces(box, [6])
        self.assertEqual((replaced.Shape.ShapeType, len(replaced.Shape.Faces)), ("Solid", 6))
        self.assertAlmostEqual(replaced.Shape.Volume, 1000, delta=1e-6)
        self.assertEqual((len(replaced.NewFaces), list(replaced.Base[1])), (1, ["Face6"]))
        box.Length = 25
        self.document.recompute()
        self.assertAlmostEqual(replaced.Shape.Volume, 2500, delta=1e-6)
        self.assertTrue(replaced.Closed)

    def test_a_removed_fillet_is_an_edge_again(self):
        obj, fillet = self.rounded()
        obj.Placement = TURNED
        sharp = api.remove_faces(obj, [fillet])
        self.assertAlmostEqual(sharp.Shape.Volume, 6000, delta=6e-6)
        self.assertIn(f"Face{fillet} removed", sharp.Verdict)
        self.assertEqual(len(sharp.Shape.Faces), 6)
        self.assertLess((sharp.Shape.CenterOfMass - TURNED.multVec(V(15, 10, 5))).Length, 1e-6)
        self.assertEqual(sharp.Label, "Base without faces")

    def test_what_cannot_grow_is_said_so(self):
        obj = self.add(Part.makeCylinder(5, 20))
        (wall,) = (n for n, f in enumerate(obj.Shape.Faces, 1) if "Cylinder" in f.Surface.TypeId)
        filled = api.remove_faces(obj, [wall])
        self.assertIn("filled instead of grown over", filled.Verdict)

    def test_a_face_is_known_by_its_place_when_numbers_change(self):
        obj, fillet = self.rounded()
        other = Part.makeBox(3, 4, 5).translated(V(60, 0, 0))
        rounded = obj.Shape.copy()
        obj.Shape = Part.Compound([rounded, other])
        sharp = api.remove_faces(obj, [fillet])
        obj.Shape = Part.Compound([other, rounded])
        self.document.recompute()
        self.assertEqual(feature.Request.of(sharp).options.faces, [fillet + 6])
        self.assertAlmostEqual(sharp.Shape.Volume, 6060, delta=6e-6)
        self.assertEqual(marks.read("9 1 2 3"), (("Edge", 9), V(1, 2, 3)))  # of older documents

    def test_a_ring_of_two_circles_is_one_step_of_undo(self):
        circles = self.add(Part.Compound([Part.makeCircle(r) for r in (10, 4)]))
        self.document.UndoMode = 1
        self.document.clearUndos()
        ring = api.fill_border([(circles, [1, 2])])
        self.assertAlmostEqual(ring.Shape.Area, 84 * math.pi, delta=1e-6)
        self.assertEqual(self.document.UndoCount, 1)
        self.document.undo()
        self.assertEqual(self.document.Objects, [circles])

    def test_failures_are_sentences_that_know_their_edges(self):
        left, right = self.plates()
        (near, (a,)), (_, (b,)) = self.facing(left, right)
        with self.assertRaises(SutureError) as caught:
            api.fill_border([(left, [a]), (right, [b])])
        self.assertIn(f"Edge{a}, Edge{b + 4} form no closed chain", str(caught.exception))
        self.assertEqual(caught.exception.edges, (a, b + 4))
        with self.assertRaises(SutureError):
            api.bridge([(left, [a])])
        with self.assertRaises(SutureError) as caught:
            api.replace_faces(left, [7])
        self.assertIn("there is no Face7", str(caught.exception))
        self.assertEqual(len(self.document.Objects), 2)


if __name__ == "__main__":
    unittest.main()
