"""Holes that are hard by their shape or size, made here, filled through a written file."""

import math
import unittest

from program import DONE, Case, run

try:
    import wounds
    from wounds import FreeCAD, Part, Read, V
except ImportError as error:  # no FreeCAD
    wounds = error

PI = math.pi

RADIUS, TUBE, NOSE, TAIL = 5.0, 40.0, 6.0, 10.0

# Fifteen sides, two of their corners of 270 degrees: along the cylinder's circles and along its axis.
REFLEX = [(-12, 8), (-4, 8), (-4, 14), (2, 14), (2, 8), (8, 6), (12, 10), (13, 16), (12, 22),
          (8, 28), (4, 30), (0, 31), (-4, 30), (-9, 26), (-12, 18)]  # fmt: skip


def open_nose():
    """A tube with half an ellipsoid as its nose and a tail, of which a quarter lacks but the tail's."""
    tip = Part.Ellipse(V(TUBE + NOSE, 0, 0), V(TUBE, RADIUS, 0), V(TUBE, 0, 0))
    profile = [
        Part.makeLine(V(0, RADIUS, 0), V(TUBE, RADIUS, 0)),
        Part.Arc(tip, 0, PI / 2).toShape(),
    ]
    tail = Part.makeLine(V(-TAIL, RADIUS, 0), V(0, RADIUS, 0))
    faces = [tail.revolve(V(), V(1, 0, 0), 360)]
    for start in (90, 180, 270):
        for line in profile:
            turned = line.copy()
            turned.rotate(V(), V(1, 0, 0), start)
            faces.append(turned.revolve(V(), V(1, 0, 0), 90))
    return Part.makeShell([shape.Faces[0] for shape in faces])


def open_cylinder(radius, height, corners):
    """The wall of a cylinder without the polygon between corners: (arc length, height)."""
    wall = next(f for f in Part.makeCylinder(radius, height).Faces if "Cylinder" in f.Surface.TypeId)
    at = [FreeCAD.Base.Vector2d(a / radius + PI, z) for a, z in corners]
    sides = [
        Part.Geom2d.Line2dSegment(a, b).toShape(wall.Surface) for a, b in zip(at, at[1:] + at[:1])
    ]
    window = Part.Face(wall.Surface, Part.Wire(sides))
    window.validate()
    return Part.Shell(wall.cut(window).Faces)


def filleted_box(radii):
    """A box of 20 with fillets along the three edges at one corner."""
    box = Part.makeBox(20, 20, 20)
    numbers = [
        i for i, e in enumerate(box.Edges, 1) if any(v.Point.Length < 1e-9 for v in e.Vertexes)
    ]
    document = FreeCAD.newDocument("box", hidden=True)
    base = document.addObject("Part::Feature", "Box")
    base.Shape = box
    fillet = document.addObject("Part::Fillet", "Fillet")
    fillet.Base = base
    fillet.Edges = [(number, radius, radius) for number, radius in zip(numbers, radii)]
    document.recompute()
    shape = fillet.Shape.copy()
    FreeCAD.closeDocument(document.Name)
    return shape


def without_corner(shape):
    return Part.makeShell(sorted(shape.Faces, key=lambda f: f.CenterOfMass.Length)[1:])


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class HardShapes(Case):
    def fill(self, shape, *words):
        """Fills every hole: what the report says of the one with the most sides, and the result."""
        file, out = self.folder / "in.step", self.folder / "out.step"
        wounds.save(shape, file)
        done = self.expect(run("fill", file, "-o", out, "--force", "--json", *words), DONE)
        document = done.json
        self.assertEqual(document["severity"], "good", str(done))
        made = Read(out)
        self.assertTrue(made.valid)
        self.assertEqual(made.solids, 1)
        return max(document["holes"], key=lambda hole: hole["sides"]), made

    def test_a_quarter_of_a_slender_tube_with_its_nose(self):
        whole = PI * RADIUS**2 * (TUBE + TAIL + 2 / 3 * NOSE)
        for scale in (1e-2, 1e3):
            with self.subTest(scale=scale):
                hole, made = self.fill(wounds.placed(open_nose(), scale))
                self.assertEqual(hole["sides"], 5)
                self.assertAlmostEqual(made.volume / scale**3 / whole, 1, delta=1e-3)

    def test_fifteen_sides_with_corners_of_270_degrees_on_a_cylinder(self):
        radius, height = 10, 40
        opened, whole = open_cylinder(radius, height, REFLEX), PI * radius**2 * height
        for method, scale, within in (("auto", 1, 1e-9), ("mvs", 1e-2, 1e-6), ("mvs", 1e3, 1e-6)):
            with self.subTest(scale=scale, method=method):
                hole, made = self.fill(wounds.placed(opened, scale), "--method", method)
                self.assertEqual(hole["sides"], 15)
                self.assertEqual(hole["method_used"], "extend" if method == "auto" else method)
                self.assertAlmostEqual(made.volume / scale**3 / whole, 1, delta=within)

    def test_corners_of_boxes_from_a_thousandth_to_a_hundred_thousand(self):
        """The gap scales with the box: at most 1e-7 of the largest radius."""
        for radii, within in (((2, 2, 2), 1e-9), ((2, 3, 4), 1e-4)):
            whole = filleted_box(radii)
            opened = without_corner(whole)
            for size in (1e-3, 5e3, 1e5):
                with self.subTest(radii=radii, size=size):
                    scale = size / 20
                    small = opened.copy()
                    small.scale(scale)
                    hole, made = self.fill(small)
                    self.assertLess(hole["max_gap"], 1e-7 * max(radii) * scale)
                    self.assertLess(hole["max_angle_deg"], 0.01)
                    self.assertAlmostEqual(made.volume / scale**3 / whole.Volume, 1, delta=within)


if __name__ == "__main__":
    unittest.main()
