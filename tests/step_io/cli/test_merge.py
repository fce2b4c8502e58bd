"""New faces made one with neighbours on the same surface: fewer faces, the same shape."""

import math
import unittest

from program import DONE, Case, example, run

try:
    import wounds
    from wounds import Part, Read, V
except ImportError as error:  # no FreeCAD
    wounds = error


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class Merge(Case):
    def filled(self, file, *words, name="out.step"):
        out = self.folder / name
        out.unlink(missing_ok=True)
        document = self.expect(run("fill", file, "-o", out, "--json", *words), DONE).json
        return document, Read(out)

    def with_window(self, solid, tool, wall):
        """A solid one of whose faces has a window."""
        faces = [f for f in solid.Faces if not wall(f.CenterOfMass)]
        (cut,) = (f.cut(tool) for f in solid.Faces if wall(f.CenterOfMass))
        return wounds.placed(Part.makeShell([*faces, *cut.Faces]))

    def test_a_window_in_a_plane_leaves_no_trace(self):
        windows = {
            "in the middle": Part.makeBox(6, 5, 4, V(9, 8, 8)),
            "round": Part.makeCylinder(3, 4, V(9, 9, 8)),
        }
        for name, tool in windows.items():
            for file in ("out.step", "out.brep"):
                with self.subTest(name, file=file):
                    shape = self.with_window(Part.makeBox(30, 20, 10), tool, lambda p: abs(p.z - 10) < 1e-6)
                    model = wounds.save(shape, self.folder / "in.step")
                    _, plain = self.filled(model)
                    self.assertEqual((plain.faces, plain.solids), (7, 1))
                    document, made = self.filled(model, "--merge", name=file)
                    self.assertEqual((made.faces, len(made.shape.Edges), made.solids), (6, 12, 1))
                    self.assertTrue(made.valid)
                    self.assertAlmostEqual(made.volume, 6000, delta=1e-6)
                    self.assertIn("1 face fewer", document["changes"][-1])
                    (hole,) = (h for h in document["holes"] if h["status"] == "filled")
                    self.assertIn("one with 1 other", " ".join(hole["notes"]))

    def test_a_window_in_half_a_cylinder_leaves_no_trace(self):
        half = Part.makeCylinder(5, 20, V(), V(0, 0, 1), 180)
        (wall,) = (f for f in half.Faces if "Cylinder" in f.Surface.TypeId)
        sheet = wounds.placed(wall.cut(Part.makeBox(6, 9, 4, V(-3, 0, 8))))
        model = wounds.save(sheet, self.folder / "in.step")
        _, made = self.filled(model, "--merge")
        self.assertEqual((made.faces, len(made.shape.Edges), made.valid), (1, 4, True))
        self.assertAlmostEqual(made.area, 100 * math.pi, delta=1e-6)

    def test_a_window_in_a_face_with_a_seam_leaves_no_trace(self):
        """Beside the seam, across it, and two of them; of a cylinder, a ball and a ring."""
        def box(*sides):
            return Part.makeBox(*sides[:3], V(*sides[3:]))

        cylinder = Part.makeCylinder(5, 20)
        models = {
            "beside": (cylinder, [box(6, 9, 4, -3, 0, 8)], 2),
            "across": (cylinder, [box(9, 6, 4, 0, -3, 8)], 2),
            "round across": (cylinder, [Part.makeCylinder(2, 9, V(0, 0, 10), V(1, 0, 0))], 2),
            "two across": (cylinder, [box(9, 6, 4, 0, -3, 3), box(9, 6, 4, 0, -3, 12)], 2),
            "one of each": (cylinder, [box(9, 6, 4, 0, -3, 3), box(6, 9, 4, -3, 0, 12)], 2),
            "cone": (Part.makeCone(6, 3, 20), [box(9, 4, 4, 0, -2, 8)], 2),
            "ball": (Part.makeSphere(6), [box(4, 9, 4, -2, 0, 0)], 0),
            "ring": (Part.makeTorus(10, 3), [box(4, 9, 2, -2, 8, 1.5)], 0),
        }
        for name, (solid, tools, flat) in models.items():
            with self.subTest(name):
                planes = [f for f in solid.Faces if "Plane" in f.Surface.TypeId]
                (wall,) = (f for f in solid.Faces if "Plane" not in f.Surface.TypeId)
                self.assertEqual(len(planes), flat)
                for tool in tools:
                    wall = wall.cut(tool)
                shell = Part.makeShell([*planes, *wall.Faces])
                model = wounds.save(wounds.placed(shell), self.folder / "in.step")
                for file in ("out.step", "out.brep"):
                    document, made = self.filled(model, "--merge", name=file)
                    self.assertEqual((made.faces, made.solids, made.valid), (len(solid.Faces), 1, True))
                    self.assertEqual(len(made.shape.Edges), len(solid.Edges))
                    self.assertAlmostEqual(made.volume / solid.Volume, 1.0, delta=1e-9)
                    self.assertIn(f"{len(tools)} face", document["changes"][-1])

    def test_only_new_faces_are_merged(self):
        """Two faces of a split wall stay two: nobody has asked for them."""
        wall = Part.makeShell(
            [wounds.sheet([(x, y, 0), (x + 5, y, 0), (x + 5, y + 5, 0), (x, y + 5, 0)])
             for x in (0, 5, 10) for y in (0, 5, 10)]
        )
        nine = wall.Faces[0].multiFuse(wall.Faces[1:]) if hasattr(wall.Faces[0], "multiFuse") else wall
        shell = Part.makeShell([f for f in nine.Faces if (f.CenterOfMass - V(7.5, 7.5, 0)).Length > 1])
        model = wounds.save(wounds.placed(shell), self.folder / "in.step")
        _, made = self.filled(model, "--merge")
        self.assertEqual(made.shells, 1)
        self.assertLess(made.faces, 9)
        self.assertGreaterEqual(made.faces, 5)  # the four in the corners are no neighbours
        self.assertAlmostEqual(made.area, 225, delta=1e-6)

    def test_where_nothing_is_alike_nothing_changes_and_it_is_said(self):
        document, made = self.filled(example("suitcase_corner"), "--merge")
        self.assertIn("not merged: no new face lies on one surface", document["changes"][-1])
        _, plain = self.filled(example("suitcase_corner"))
        self.assertEqual(made.faces, plain.faces)


if __name__ == "__main__":
    unittest.main()
