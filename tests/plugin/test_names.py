"""Faces and edges of a filled shape keep their names where those of the base do (FreeCAD 1.x)."""

import unittest

from headless import Case, example  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api  # noqa: E402

V = App.Vector


@unittest.skipUnless(hasattr(Part.Shape, "ElementMap"), "this FreeCAD has no names of elements")
class Names(Case):
    def tube(self, corners):
        """A parametric prism without lids over a polygon; its faces have names."""
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        self.draw(sketch, corners)
        prism = self.document.addObject("Part::Extrusion", "Prism")
        prism.Base, prism.DirMode, prism.LengthFwd, prism.Solid = sketch, "Normal", 5, False
        self.document.recompute()
        return sketch, prism

    def draw(self, sketch, corners):
        for a, b in zip(corners, corners[1:] + corners[:1]):
            sketch.addGeometry(Part.LineSegment(V(*a, 0), V(*b, 0)))

    def test_what_was_there_has_the_name_of_before_and_each_name_is_used_once(self):
        _, prism = self.tube([(0, 0), (10, 0), (10, 8), (0, 8)])
        filled = api.fill(prism, all_loops=True)
        names = filled.Shape.ElementReverseMap
        count = len(filled.Shape.Faces) + len(filled.Shape.Edges) + len(filled.Shape.Vertexes)
        self.assertEqual(len(names), count)
        self.assertEqual(len(set(map(str, names.values()))), count)
        before = prism.Shape.ElementMap
        for element, name in names.items():
            old = [known for known in before if str(name).startswith(known + ";:H")]
            if element[4:] and element.startswith("Face") and int(element[4:]) in filled.NewFaces:
                self.assertTrue(str(name).startswith("SUT;"), name)
            else:
                self.assertTrue(old, (element, name))
                kind = {"F": "Faces", "E": "Edges", "V": "Vertexes"}[element[0]]
                there = getattr(filled.Shape, kind)[int(element.strip("FaceEdgVrtx")) - 1]
                was = [
                    getattr(prism.Shape, kind)[int(before[known].strip("FaceEdgVrtx")) - 1]
                    for known in old
                ]
                self.assertLess(min(there.distToShape(one)[0] for one in was), 1e-7)

    def test_a_reference_to_an_edge_follows_it_when_the_numbers_change(self):
        sketch, prism = self.tube([(0, 0), (10, 0), (10, 8), (0, 8)])
        filled = api.fill(prism, all_loops=True)
        user = self.document.addObject("App::FeaturePython", "User")
        user.addProperty("App::PropertyLinkSub", "Edge")
        user.addProperty("App::PropertyLinkSub", "Face")

        def stands(edge):
            return (edge.CenterOfMass - V(10, 8, 2.5)).Length < 1e-6

        (number,) = [n for n, edge in enumerate(filled.Shape.Edges, 1) if stands(edge)]
        lid = [n for n in filled.NewFaces if abs(filled.Shape.Faces[n - 1].CenterOfMass.z - 5) < 1e-6]
        user.Edge = (filled, [f"Edge{number}"])
        user.Face = (filled, [f"Face{lid[0]}"])
        self.document.recompute()
        # A corner more, between the first two: the wall with the corner gets another number.
        sketch.delGeometries([0])
        self.draw_open(sketch, [(0, 0), (5, -2), (10, 0)])
        self.document.recompute()
        self.assertEqual(len(prism.Shape.Faces), 5)
        self.assertEqual(len(filled.Shape.Faces), 7)
        named = int(user.Edge[1][0].rsplit(".")[-1][4:])
        self.assertTrue(stands(filled.Shape.Edges[named - 1]), user.Edge)
        self.assertNotEqual(named, number, "the numbers have not changed: the test shows nothing")

    def draw_open(self, sketch, corners):
        for a, b in zip(corners, corners[1:]):
            sketch.addGeometry(Part.LineSegment(V(*a, 0), V(*b, 0)))

    def test_names_are_the_same_after_each_computation_and_after_opening_again(self):
        filled = api.fill(self.add(example()))
        names = dict(filled.Shape.ElementReverseMap)
        self.assertIn("SUT;Face3", str(names["Face3"]))
        filled.Angle = 0.02
        self.document.recompute()
        self.assertEqual(dict(filled.Shape.ElementReverseMap), names)


if __name__ == "__main__":
    unittest.main()
