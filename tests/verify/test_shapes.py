"""The measuring tools of shapes.py on shapes whose figures are known."""

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

try:
    import shapes
    from shapes import Part
except ImportError as error:
    shapes = None
    REASON = f"no FreeCAD: {error}"


def box_without(*numbers):
    box = Part.makeBox(10, 20, 30)
    return Part.Compound([face for i, face in enumerate(box.Faces) if i not in numbers])


class Shapes(unittest.TestCase):
    def setUp(self):
        if shapes is None:
            self.skipTest(REASON)

    def test_free_edges_are_those_of_the_missing_face(self):
        self.assertEqual(len(shapes.free_edges(Part.makeBox(1, 2, 3))), 0)
        self.assertEqual(len(shapes.free_edges(box_without(0))), 4)
        self.assertEqual(len(shapes.free_edges(box_without(0, 1))), 8)

    def test_seams_and_poles_are_no_free_edges(self):
        self.assertEqual(len(shapes.free_edges(Part.makeSphere(3))), 0)
        self.assertEqual(len(shapes.free_edges(Part.makeCylinder(3, 5))), 0)
        self.assertEqual(len(shapes.free_edges(Part.makeTorus(5, 2))), 0)
        tube = [f for f in Part.makeCylinder(3, 5).Faces if not isinstance(f.Surface, Part.Plane)]
        self.assertEqual(len(shapes.free_edges(Part.Compound(tube))), 2)

    def test_an_added_face_is_told_from_the_old_ones(self):
        faces = shapes.Comparison(box_without(2), Part.makeBox(10, 20, 30))
        self.assertEqual((len(faces.kept), len(faces.added), len(faces.lost)), (5, 1, 0))
        self.assertAlmostEqual(faces.added[0].area, 10 * 30)

    def test_a_lost_face_and_a_moved_one_are_found(self):
        before, after = Part.makeBox(10, 20, 30), Part.makeBox(10, 20, 30.001)
        faces = shapes.Comparison(before, after)
        self.assertEqual((len(faces.kept), len(faces.added), len(faces.lost)), (1, 5, 5))

    def test_gap_and_angle_of_a_folded_sheet_are_known(self):
        """Two squares that meet at 40 degrees."""
        x, y = shapes.FreeCAD.Vector(1, 0, 0), shapes.FreeCAD.Vector(0, 1, 0)
        origin = shapes.FreeCAD.Vector(0, 0, 0)
        turned = -x * math.cos(math.radians(40)) + shapes.FreeCAD.Vector(0, 0, math.sin(math.radians(40)))
        first = Part.Face(Part.makePolygon([origin, x, x + y, y, origin]))
        second = Part.Face(Part.makePolygon([origin, y, y + turned, turned, origin]))
        sheet = Part.Shell([first, second])
        sheet.sewShape()
        faces = [shapes.FaceFacts(sheet.Faces[1])]
        gap, angle = shapes.largest_gap_and_angle(sheet, faces)
        self.assertAlmostEqual(gap, 0.0, 9)
        self.assertAlmostEqual(angle, 40.0, 6)

    def test_the_distance_of_a_face_is_that_to_the_nearest_new_one(self):
        lost = Part.makePlane(4, 4, shapes.FreeCAD.Vector(1, 1, 0))
        near = Part.makePlane(10, 10, shapes.FreeCAD.Vector(0, 0, 0.25))
        far = Part.makePlane(10, 10, shapes.FreeCAD.Vector(0, 0, 3))
        added = [shapes.FaceFacts(face.Faces[0]) for face in (far, near)]
        self.assertAlmostEqual(shapes.largest_distance(lost, added), 0.25, 9)


if __name__ == "__main__":
    unittest.main()
