"""Faces replaced, removed and grown over, and bridges, through the program: closed forms."""

import math
import unittest

from program import DONE, OUT_OF_TOLERANCE, USAGE, Case, run

try:
    import wounds
    from wounds import Part, Read, V
except ImportError as error:  # no FreeCAD
    wounds = error


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class Wounds(Case):
    def run_on(self, command, file, *words, code=DONE):
        out = self.folder / "out.step"
        out.unlink(missing_ok=True)
        finished = run(command, file, "-o", out, "--json", *words)
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE) if code is None else (code,), str(finished))
        return finished.json, Read(out)

    def refused(self, command, file, *words):
        out = self.folder / "none.step"
        finished = run(command, file, "-o", out, *words)
        self.expect_refused(finished, USAGE)
        self.assertFalse(out.exists())
        return finished.err

    def rounded_box(self, radius=2.0, corner=False, scale=1.0):
        """A box with one edge, or all at a corner, rounded: its file, the volume with and without."""
        box = Part.makeBox(30 * scale, 20 * scale, 10 * scale)
        edges = [e for e in box.Edges if any(v.Point.Length < 1e-9 for v in e.Vertexes)]
        rounded = box.makeFillet(radius * scale, edges if corner else edges[:1])
        file = wounds.save(wounds.placed(rounded), self.folder / "rounded.step")
        return file, box.Volume, rounded.Volume

    def kinds(self, file, kind):
        shape = Part.read(str(file))
        return [n for n, f in enumerate(shape.Faces, 1) if type(f.Surface).__name__ == kind]

    def test_replaced_wall_comes_back(self):
        box = wounds.save(wounds.placed(Part.makeBox(30, 20, 10)), self.folder / "box.step")
        for faces in ("1", "Face2", "6", "1,2"):  # 1 and 2 lie opposite: two wounds
            with self.subTest(faces=faces):
                _, out = self.run_on("fill", box, "--replace-faces", faces)
                self.assertEqual((out.faces, out.solids, out.valid), (6, 1, True))
                self.assertAlmostEqual(out.volume, 6000, delta=1e-6)

    def test_replaced_end_of_a_cylinder_comes_back(self):
        file = wounds.save(wounds.placed(Part.makeCylinder(5, 20)), self.folder / "cylinder.step")
        for face in self.kinds(file, "Plane"):
            _, out = self.run_on("fill", file, "--replace-faces", face)
            self.assertEqual((out.faces, out.solids, out.valid), (3, 1, True))
            self.assertAlmostEqual(out.volume, 500 * math.pi, delta=1e-6)

    def test_replaced_corner_of_three_fillets_is_the_sphere(self):
        file, _, volume = self.rounded_box(3.0, corner=True)
        sphere = self.kinds(file, "Sphere")
        self.assertEqual(len(sphere), 1)
        _, out = self.run_on("fill", file, "--replace-faces", sphere[0], code=None)
        self.assertEqual((out.solids, out.valid), (1, True))
        self.assertAlmostEqual(out.volume, volume, delta=1e-3)  # a gap over its area

    def test_a_face_beside_a_hole_is_replaced_together_with_it(self):
        """Four by three squares in a plane, one of the inner two missing, the other replaced."""
        cells = [
            wounds.sheet([(x, y, 0), (x + 5, y, 0), (x + 5, y + 5, 0), (x, y + 5, 0)])
            for x in (0, 5, 10, 15) for y in (0, 5, 10) if (x, y) != (5, 5)
        ]
        whole = Part.makeShell(list(cells[0].multiFuse(cells[1:]).Faces))
        file = wounds.save(wounds.placed(whole), self.folder / "cells.step")
        turn = wounds.placed(Part.Vertex(0, 0, 0)).Placement.inverse()
        (face,) = wounds.faces_where(file, lambda p: (turn * p - V(12.5, 7.5, 0)).Length < 1e-6)
        _, out = self.run_on("fill", file, "--replace-faces", face)
        self.assertEqual((out.faces, out.shells, out.valid), (11, 1, True))
        self.assertAlmostEqual(out.area, 300, delta=1e-6)

    def test_removed_fillets_leave_the_box(self):
        for scale in (1e-2, 1.0, 1e2):
            with self.subTest(scale=scale):
                file, whole, _ = self.rounded_box(scale=scale)
                fillet = self.kinds(file, "Cylinder")
                document, out = self.run_on("fill", file, "--remove-faces", fillet[0])
                self.assertIn("grown together", document["changes"][0])
                self.assertEqual((out.faces, out.solids, out.valid), (6, 1, True))
                self.assertAlmostEqual(out.volume / whole, 1.0, delta=1e-9)

    def test_removed_round_corner_leaves_the_box(self):
        file, whole, _ = self.rounded_box(3.0, corner=True)
        faces = self.kinds(file, "Cylinder") + self.kinds(file, "Sphere")
        self.assertEqual(len(faces), 4)
        _, out = self.run_on("fill", file, "--remove-faces", wounds.mixed(faces, 1))
        self.assertEqual((out.faces, out.valid), (6, True))
        self.assertAlmostEqual(out.volume / whole, 1.0, delta=1e-9)

    def test_removed_bore_leaves_the_block(self):
        block = Part.makeBox(30, 20, 10).cut(Part.makeCylinder(3, 10, V(9, 9, 0)))
        file = wounds.save(wounds.placed(block), self.folder / "bore.step")
        _, out = self.run_on("fill", file, "--remove-faces", self.kinds(file, "Cylinder")[0])
        self.assertEqual((out.faces, out.solids, out.valid), (6, 1, True))
        self.assertAlmostEqual(out.volume, 6000, delta=1e-6)

    def test_what_cannot_grow_is_filled_and_said_so(self):
        """The wall of a cylinder between its ends: planes that never meet."""
        file = wounds.save(Part.makeCylinder(5, 20), self.folder / "cylinder.step")
        wall = self.kinds(file, "Cylinder")[0]
        document, out = self.run_on("fill", file, "--remove-faces", wall, code=None)
        self.assertIn("filled instead of grown over", document["changes"][0])
        self.assertEqual(out.faces, 3)

    def test_says_which_faces_cannot_go(self):
        file, _, _ = self.rounded_box()
        for option in ("--replace-faces", "--remove-faces"):
            self.assertIn("there is no face 99", self.refused("fill", file, option, "1,99"))
            self.assertIn("face 2 is named twice", self.refused("fill", file, option, "2,1,2"))
        self.assertIn("all faces", self.refused("fill", file, "--replace-faces", "1-7"))
        self.assertIn("one of these", self.refused("fill", file, "--replace-faces", "1", "--hole", "1"))

    def plates(self, *points):
        shapes = [wounds.placed(wounds.sheet(p)) for p in points]
        return wounds.save(Part.Compound(shapes), self.folder / "plates.step")

    def rim(self, file, wanted):
        turn = wounds.placed(Part.Vertex(0, 0, 0)).Placement.inverse()
        return wounds.edges_where(file, lambda p: wanted(turn * p))

    def test_bridge_between_plates_in_one_plane_is_the_plane(self):
        for second in (
            [(20, 0, 0), (30, 0, 0), (30, 8, 0), (20, 8, 0)],
            [(20, 0, 0), (20, 8, 0), (30, 8, 0), (30, 0, 0)],  # faces the other way
        ):
            file = self.plates([(0, 0, 0), (10, 0, 0), (10, 8, 0), (0, 8, 0)], second)
            edges = self.rim(file, lambda p: abs(p.x - 10) < 1e-6 or abs(p.x - 20) < 1e-6)
            _, out = self.run_on("bridge", file, "--edges", wounds.mixed(edges, 2))
            self.assertEqual((out.faces, out.shells, out.valid), (3, 1, True))
            self.assertAlmostEqual(out.area, 240, delta=1e-6)

    def test_bridge_between_steps_is_tangent_to_both(self):
        file = self.plates(
            [(0, 0, 0), (40, 0, 0), (40, 30, 0), (0, 30, 0)],
            [(70, 0, 20), (110, 0, 20), (110, 30, 20), (70, 30, 20)],
        )
        edges = self.rim(file, lambda p: abs(p.x - 40) < 1e-6 or abs(p.x - 70) < 1e-6)
        document, out = self.run_on("bridge", file, "--edges", wounds.mixed(edges, 2))
        self.assertEqual((out.faces, out.shells, out.valid), (3, 1, True))
        hole = next(h for h in document["holes"] if h["status"] == "filled")
        self.assertLess(hole["max_angle_deg"], 0.01)

    def test_bridge_between_pipes_of_one_axis_is_the_cylinder(self):
        pipes = [Part.makeCylinder(5, 10, V(0, 0, z)).Faces[0] for z in (0, 25)]
        file = wounds.save(Part.Compound(pipes), self.folder / "pipes.step")
        rims = wounds.edges_where(file, lambda p: min(abs(p.z - 10), abs(p.z - 25)) < 1e-6)
        self.assertEqual(len(rims), 2)
        _, out = self.run_on("bridge", file, "--edges", wounds.mixed(rims, 2))
        self.assertEqual((out.faces, out.shells, out.valid), (3, 1, True))
        self.assertAlmostEqual(out.area, 2 * math.pi * 5 * 35, delta=1e-5)

    def test_bridge_between_curves_is_ruled_and_leans_on_supports(self):
        """Two lines that lie on plates, a step apart: straight across, or tangent to the plates."""
        plates = [
            wounds.sheet([(x, 0, z), (x + 10, 0, z), (x + 10, 8, z), (x, 8, z)]) for x, z in ((0, 0), (20, 5))
        ]
        lines = [Part.makeLine(V(x, 0, z), V(x, 8, z)) for x, z in ((8, 0), (22, 5))]
        shape = Part.Compound([wounds.placed(s) for s in (*plates, *lines)])
        file = wounds.save(shape, self.folder / "plates.step")
        first, second = self.rim(file, lambda p: min(abs(p.x - 8), abs(p.x - 22)) < 1e-6)
        ruled = 8 * math.hypot(14, 5)
        _, out = self.run_on("bridge", file, "--no-sew", "--edges", f"{second},{first}")
        self.assertAlmostEqual(out.area - 160, ruled, delta=1e-6)
        document, out = self.run_on(
            "bridge", file, "--no-sew", "--edges", f"{second},{first}", "--support", f"{first}=1,{second}=2"
        )
        self.assertEqual((out.faces, out.valid), (3, True))
        self.assertGreater(out.area - 160, ruled + 0.1)
        (hole,) = (h for h in document["holes"] if h["status"] == "filled")
        self.assertLess(hole["max_angle_deg"], 0.01)

    def test_says_why_edges_make_no_bridge(self):
        file = self.plates([(0, 0, 0), (10, 0, 0), (10, 8, 0), (0, 8, 0)])
        self.assertIn("two chains", self.refused("bridge", file, "--edges", "1,2"))
        self.assertIn("two chains", self.refused("bridge", file, "--edges", "1,2,3,4"))


if __name__ == "__main__":
    unittest.main()
