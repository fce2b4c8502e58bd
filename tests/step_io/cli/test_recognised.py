"""What `recognise` gives back as a file holds it."""

import sys
import tempfile
import unittest
from pathlib import Path

from program import DONE, example, run


def write_windows(folder):
    """Sheets extruded, revolved and offset from a B-spline, each with a window cut into it.

    Result: file, what STEP calls the surface, its area with the window closed.
    """
    sys.path.append("/usr/lib/freecad-python3/lib")
    import FreeCAD  # noqa: F401 (before Part)
    import Part
    from FreeCAD import Vector

    x = [10.0, 13.0, 9.0, 12.0, 11.0]

    def profile(place):
        curve = Part.BSplineCurve()
        curve.interpolate([place(x[i], 4.0 * i) for i in range(5)])
        return curve

    upright = profile(lambda x, y: Vector(x, 0, y)).toShape()
    lying = profile(lambda x, y: Vector(x, y, 0)).toShape()
    turned = upright.revolve(Vector(0, 0, 0), Vector(0, 0, 1), 90)
    pushed = lying.extrude(Vector(0, 0, 14))
    offset = Part.OffsetSurface(turned.toNurbs().Faces[0].Surface, 0.7).toShape()
    across = Vector(1, 1, 0.1)
    for name, sheet, drill in (
        ("SURFACE_OF_LINEAR_EXTRUSION", pushed, Part.makeCylinder(3, 40, Vector(0, 8, 7), Vector(1, 0.1, 0.2))),
        ("SURFACE_OF_REVOLUTION", turned, Part.makeCylinder(3, 40, Vector(0, 0, 8), across)),
        ("OFFSET_SURFACE", offset, Part.makeCylinder(3, 40, Vector(0, 0, 8), across)),
    ):
        file = folder / f"{name}.step"
        sheet.cut(drill).exportStep(str(file))
        yield file, name, sheet.Area


def mesh_area(shape):
    """Of triangles: what OCCT integrates over a face with a window is off by up to 0.4 %."""
    points, triangles = shape.tessellate(0.01)
    return sum((points[b] - points[a]).cross(points[c] - points[a]).Length / 2 for a, b, c in triangles)


class Recognised(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def fill(self, model):
        out = self.folder / "out.step"
        finished = run("fill", model, "-o", out, "--json")
        self.assertEqual(finished.code, DONE, str(finished))
        return out, next(hole for hole in finished.json["holes"] if hole["status"] == "filled")

    def test_a_suitcase_corner_costs_two_kilobytes_at_most(self):
        model = example("suitcase_corner")
        out, hole = self.fill(model)
        self.assertEqual(hole["recognised"]["kind"], "sphere")
        self.assertLess(out.stat().st_size, model.stat().st_size + 2000)
        text = out.read_text()
        self.assertEqual(text.count("SPHERICAL_SURFACE"), 1)
        # Its border is lines of the sphere's domain; a pole in a corner costs no accuracy.
        before = model.read_text().count("B_SPLINE_CURVE")
        self.assertEqual(text.count("B_SPLINE_CURVE"), before)
        self.assertLess(hole["max_gap"], 1e-12)
        self.assertLess(hole["max_angle_deg"], 1e-9)

    def test_a_corner_turned_and_moved_costs_no_more(self):
        sys.path.append("/usr/lib/freecad-python3/lib")
        import FreeCAD
        import Part

        corner = Part.Shape()
        corner.read(str(example("suitcase_corner")))
        turn = FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 50)
        for name, place in (
            ("turned", FreeCAD.Placement(FreeCAD.Vector(), turn)),
            ("turned and moved", FreeCAD.Placement(FreeCAD.Vector(100, 200, -300), turn)),
            ("far away", FreeCAD.Placement(FreeCAD.Vector(1e6, 1e6, 1e6), FreeCAD.Rotation())),
        ):
            with self.subTest(name):
                model = self.folder / "turned.step"
                corner.transformed(place.toMatrix(), True).exportStep(str(model))
                out, hole = self.fill(model)
                self.assertEqual(hole["recognised"]["kind"], "sphere")
                self.assertLess(out.stat().st_size, model.stat().st_size + 2048)

    def test_windows_of_swept_and_offset_faces_keep_their_kind(self):
        models = list(write_windows(self.folder))
        import Part  # after FreeCAD

        for model, kind, area in models:
            with self.subTest(kind):
                self.assertEqual(model.read_text().count(kind + "("), 1)
                out, hole = self.fill(model)
                self.assertEqual(hole["method_used"], "recognise")
                self.assertEqual(out.read_text().count(kind + "("), 2)
                shape = Part.read(str(out))
                self.assertEqual(len(shape.Faces), 2)
                self.assertTrue(shape.isValid())
                self.assertEqual(shape.Faces[0].Surface.TypeId, shape.Faces[1].Surface.TypeId)
                self.assertLess(hole["max_gap"], 1e-9)
                self.assertAlmostEqual(mesh_area(shape), area, delta=1e-3 * area)


if __name__ == "__main__":
    unittest.main()
