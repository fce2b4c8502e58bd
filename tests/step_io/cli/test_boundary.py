"""Faces over chosen edges, through the program: closed forms, and words that make no face."""

import math
import subprocess
import sys
import unittest
from pathlib import Path

from program import CAD, DONE, NOTHING, OUT_OF_TOLERANCE, PROGRAM, USAGE, Case, example, run

try:
    import wounds
    from wounds import Part, Read, V
except ImportError as error:  # no FreeCAD
    wounds = error

BYTES = Path(__file__).resolve().parents[2] / "bench/border_bytes.py"
SQUARE = [(0, 0, 0), (40, 0, 0), (40, 40, 0), (0, 40, 0)]


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class Boundary(Case):
    def saved(self, shapes, name="in.step"):
        return wounds.save(Part.Compound(shapes), self.folder / name)

    def filled(self, file, *words, code=DONE):
        out = self.folder / "out.step"
        out.unlink(missing_ok=True)
        finished = run("fill", file, "-o", out, "--json", *words)
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE) if code is None else (code,), str(finished))
        return finished.json, Read(out)

    @staticmethod
    def of_length(file, length):
        edges = Part.read(str(file)).Edges
        return [n for n, e in enumerate(edges, 1) if abs(e.Length / length - 1) < 1e-6]

    def refused(self, file, *words):
        out = self.folder / "none.step"
        finished = run("fill", file, "-o", out, *words)
        self.expect_refused(finished, USAGE)
        self.assertFalse(out.exists())
        return finished.err

    def test_loose_lines_in_any_order_bound_their_square(self):
        for scale in (1e-3, 1.0, 1e3):
            with self.subTest(scale=scale):
                lines = wounds.polygon(SQUARE)
                lines[2].reverse()
                file = self.saved([wounds.placed(e, scale) for e in (lines[i] for i in (2, 0, 3, 1))])
                _, out = self.filled(file, "--boundary", "3,1,4,2")
                self.assertEqual((out.faces, out.valid), (1, True))
                self.assertAlmostEqual(out.area / scale**2, 1600.0, delta=1e-6)

    def test_closed_curve_bounds_a_disc_and_two_a_ring(self):
        circles = [Part.makeCircle(r, V(1, 2, 3), V(1, 1, 1)) for r in (10, 4)]
        file = self.saved(circles)
        _, disc = self.filled(file, "--boundary", "1")
        self.assertAlmostEqual(disc.area, math.pi * 100, delta=1e-6)
        _, ring = self.filled(file, "--boundary", "2,1")
        self.assertEqual((ring.faces, ring.valid), (1, True))
        self.assertAlmostEqual(ring.area, math.pi * 84, delta=1e-6)

    def test_sheets_are_sewn_to_the_new_face_and_turned_to_it(self):
        walls = [
            wounds.sheet([(0, 0, 0), (40, 0, 0), (40, 0, 9), (0, 0, 9)]),
            wounds.sheet([(40, 40, 0), (40, 0, 0), (40, 0, 9), (40, 40, 9)]),
            wounds.sheet([(0, 40, 0), (40, 40, 0), (40, 40, 9), (0, 40, 9)]),
            wounds.sheet([(0, 0, 0), (0, 40, 0), (0, 40, 9), (0, 0, 9)]),
        ]
        file = self.saved([wounds.placed(w) for w in walls])
        turn = wounds.placed(Part.Vertex(0, 0, 0)).Placement.inverse()
        for z in (0, 9):
            rim = wounds.edges_where(file, lambda p, z=z: abs((turn * p).z - z) < 1e-6)
            self.assertEqual(len(rim), 4)
            _, out = self.filled(file, "--no-sew", "--boundary", wounds.mixed(rim, 5))
            self.assertEqual((out.faces, out.shells, out.valid), (5, 1, True))
            self.assertAlmostEqual(out.area, 1600 + 4 * 40 * 9, delta=1e-6)

    def test_both_ends_of_a_tube_make_a_solid(self):
        tube = Part.makeCylinder(5, 20).Faces[0]
        file = self.saved([wounds.placed(tube)])
        ends = [n for n, e in enumerate(Part.read(str(file)).Edges, 1) if e.isClosed()]
        _, out = self.filled(file, "--boundary", ends[0], "--boundary", ends[1])
        self.assertEqual((out.faces, out.solids, out.valid), (3, 1, True))
        self.assertAlmostEqual(out.volume, math.pi * 25 * 20, delta=1e-6)

    def test_is_the_same_face_as_that_of_the_hole(self):
        for name in ("suitcase_corner", "bump_window"):
            with self.subTest(name):
                holes = self.expect(run("inspect", example(name), "--json"), DONE).json["holes"]
                hole = next(h for h in holes if h["kind"] == "hole")
                files = []
                for i, words in enumerate(
                    (("--hole", hole["id"]), ("--boundary", wounds.mixed(hole["edges"], 7)))
                ):
                    files.append(self.folder / f"{name}{i}.brep")
                    run("fill", example(name), "-o", files[-1], *words)
                self.assertEqual(files[0].read_bytes(), files[1].read_bytes())

    def test_is_the_same_to_the_byte_on_real_holes(self):
        """Two of them here; tests/bench/border_bytes.py does it for all."""
        if not CAD.exists():
            self.skipTest(f"needs {CAD}")
        for name in ("26_sphere_octant", "R01_sphere3"):
            words = [sys.executable, BYTES, PROGRAM, CAD / "reopened", "--only", name]
            ended = subprocess.run(words, capture_output=True, text=True, check=False)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            self.assertIn("1 holes the same, 0 not", ended.stdout)

    def test_small_gaps_close_and_wide_ones_are_bridged_on_demand(self):
        for gap, words in ((4e-4, ()), (2.0, ("--connect",))):
            lines = [
                Part.makeLine(V(0, 0, 0), V(20, 0, 0)),
                Part.makeLine(V(20 + gap, 0, 0), V(40, 0, 0)),
                Part.makeLine(V(40, 40, 0), V(40, 0, 0)),
                Part.makeLine(V(40, 40, 0), V(0, 40, 0)),
                Part.makeLine(V(0, 40, 0), V(0, 0, 0)),
            ]
            file = self.saved([wounds.placed(e) for e in lines])
            if words:
                error = self.refused(file, "--boundary", "1,2,3,4,5")
                self.assertIn("--connect", error)
                self.assertIn("gap of 2,", error)
            _, out = self.filled(file, "--boundary", "4,2,1,3,5", *words)
            self.assertEqual((out.faces, out.valid), (1, True))
            self.assertAlmostEqual(out.area, 1600.0, delta=1e-6)

    def test_curves_go_on_as_far_as_the_tension_says(self):
        """The side that is missing of a square bulges by 6/5 of the gap's square, times the tension."""
        lines = wounds.polygon([(0, 0, 0), (9, 0, 0), (9, 4, 0), (0, 4, 0)])[:3]
        file = self.saved([wounds.placed(e) for e in lines])
        for tension in (0.5, 1.0, 2.0):
            words = ("--boundary", "1,2,3", "--connect", "--tension", tension)
            _, out = self.filled(file, *words)
            self.assertAlmostEqual(out.area, 36 + tension * 16 / 5, delta=1e-6)
        self.assertIn("--tension is for", self.refused(file, "--boundary", "1,2,3", "--tension", 2))
        for wrong in (0, -1, "nan"):
            self.refused(file, "--boundary", "1,2,3", "--connect", "--tension", wrong)

    def test_a_loose_curve_leans_on_a_face(self):
        """A circle on a sphere: with the sphere as its support it bounds the cap, else a disc."""
        zone = Part.makeSphere(6, V(), V(0, 0, 1), -30, math.degrees(math.asin(3 / 6))).Faces[0]
        circle = Part.makeCircle(math.sqrt(36 - 16), V(0, 0, 4))
        wave = Part.makeCircle(3, V(0, 0, 9))
        for scale in (1.0, 1e-2):
            file = self.saved([wounds.placed(s, scale) for s in (zone, circle, wave)])
            (loose,) = self.of_length(file, 2 * math.pi * math.sqrt(20) * scale)
            (far,) = self.of_length(file, 6 * math.pi * scale)
            _, disc = self.filled(file, "--no-sew", "--boundary", loose)
            document, cap = self.filled(file, "--no-sew", "--boundary", loose, "--support", f"{loose}=Face1")
            self.assertEqual((disc.faces, cap.faces, cap.valid), (2, 2, True))
            areas = [made.area / scale**2 - 72 * math.pi for made in (disc, cap)]
            self.assertAlmostEqual(areas[0], 20 * math.pi, delta=1e-5)
            self.assertAlmostEqual(areas[1], 24 * math.pi, delta=1e-5)
            (hole,) = (h for h in document["holes"] if h["status"] == "filled")
            self.assertEqual((hole["continuity_reached"][:1], hole["edges"][0]["face"]), ("G", 1))
            self.assertLess(hole["max_angle_deg"], 0.01)
        for words, said in (
            ((loose, "--support", f"{loose}=9"), "there is no face 9"),
            ((far, "--support", f"{far}=1"), "does not lie on face 1: it is"),
            ((loose, "--support", f"{far}=1"), f"edge {far} is no edge of the border"),
            ((loose, "--support", f"{loose}=1,{loose}=2"), f"edge {loose} is given two supports"),
            ((loose, "--support", "x"), "names no support"),
        ):
            self.assertIn(said, self.refused(file, "--no-sew", "--boundary", *words))

    def test_the_new_face_goes_on_where_its_support_ends(self):
        """A circle at either end of a cylinder's wall, which stands across the opening: half balls."""
        pipe = Part.makeCylinder(5, 20).Faces[0]
        circles = [Part.makeCircle(5, V(0, 0, z)) for z in (0, 20, 10)]
        file = self.saved([wounds.placed(s) for s in (pipe, *circles)])
        turn = wounds.placed(Part.Vertex(0, 0, 0)).Placement.inverse()
        for z, outwards in ((0, -1), (20, 1)):
            number = max(wounds.edges_where(file, lambda p, z=z: abs((turn * p).z - z) < 1e-6))
            words = ("--no-sew", "--boundary", number, "--support", f"{number}=1")
            document, out = self.filled(file, *words)
            self.assertAlmostEqual(out.area, 200 * math.pi + 50 * math.pi, delta=1e-3)
            (dome,) = (f for f in out.shape.Faces if abs(f.Area - 50 * math.pi) < 1e-3)
            self.assertAlmostEqual((turn * dome.CenterOfMass).z, z + outwards * 2.5, delta=1e-3)
        (inside,) = wounds.edges_where(file, lambda p: abs((turn * p).z - 10) < 1e-6 and (turn * p).x < 0)
        words = ("--no-sew", "--boundary", inside, "--support", f"{inside}=1")
        self.assertIn("cannot be told", self.refused(file, *words))

    def test_a_support_counts_instead_of_the_edge_s_own_face(self):
        """A flat ring around a circle on a ball: tangent to the ring a disc, to the ball its cap."""
        radius = math.sqrt(20)
        outer, inner = (Part.Face(Part.Wire(Part.makeCircle(r, V(0, 0, 4)))) for r in (9, radius))
        (ring,) = outer.cut(inner).Faces
        zone = Part.makeSphere(6, V(), V(0, 0, 1), -30, math.degrees(math.asin(4 / 6))).Faces[0]
        file = self.saved([wounds.placed(s) for s in (ring, zone)])
        (ball,) = (n for n, f in enumerate(Part.read(str(file)).Faces, 1) if f.Area > 240)
        rim = min(self.of_length(file, 2 * math.pi * radius))
        for words, area in (((), 20 * math.pi), (("--support", f"{rim}={ball}"), 24 * math.pi)):
            document, out = self.filled(file, "--no-sew", "--boundary", rim, *words)
            self.assertEqual((out.faces, out.valid), (3, True))
            self.assertAlmostEqual(out.area - ring.Area - zone.Area, area, delta=1e-5)
            (hole,) = (h for h in document["holes"] if h["status"] == "filled")
            self.assertLess(hole["max_angle_deg"], 0.01)

    def test_bodies_become_one(self):
        """Two cups, whose rims face each other, and the tube between them."""
        def cup(z, closed):
            faces = Part.makeCylinder(5, 10, V(0, 0, z)).Faces
            return Part.makeShell([f for f in faces if abs(f.CenterOfMass.z - closed) > 1e-6])

        file = self.saved([wounds.placed(cup(0, 10)), wounds.placed(cup(20, 20))])
        turn = wounds.placed(Part.Vertex(0, 0, 0)).Placement.inverse()
        rims = [
            wounds.edges_where(file, lambda p, z=z: abs((turn * p).z - z) < 1e-6)[0] for z in (10, 20)
        ]
        _, out = self.filled(file, "--boundary", f"{rims[1]},{rims[0]}")
        self.assertEqual((out.solids, out.faces, out.valid), (1, 5, True))
        self.assertAlmostEqual(out.volume, math.pi * 25 * 30, delta=1e-6)

    def test_holes_are_chosen_by_kind_and_size(self):
        """A plate with two round windows and a square one."""
        plate = wounds.sheet([(0, 0, 0), (100, 0, 0), (100, 40, 0), (0, 40, 0)])
        for window in (
            Part.makeCylinder(2, 2, V(15, 20, -1)),
            Part.makeCylinder(6, 2, V(40, 20, -1)),
            Part.makeBox(10, 10, 2, V(70, 15, -1)),
        ):
            plate = plate.cut(window)
        file = self.saved([wounds.placed(plate)])
        for words, count in (
            (("--larger", 10), 2),
            (("--smaller", 10), 1),
            (("--larger", 10, "--sides", 4), 1),
            (("--planar", "--sides", 1), 2),
            (("--planar",), 3),
        ):
            with self.subTest(words=words):
                document, _ = self.filled(file, *words)
                filled = [h for h in document["holes"] if h["status"] == "filled"]
                self.assertEqual(len(filled), count)
        finished = run("fill", file, "-o", self.folder / "none.step", "--larger", 900)
        self.expect_refused(finished, NOTHING, "none of the model's 3 holes")
        self.assertIn("name none", self.refused(file, "--larger", 3, "--hole", 1))
        self.assertIn("--larger", self.refused(file, "--larger", -3))

    def test_says_what_makes_no_face(self):
        file = self.saved(wounds.polygon(SQUARE) + [Part.makeLine(V(0, 0, 50), V(9, 0, 50))])
        self.assertIn("named twice", self.refused(file, "--boundary", "1,2,3,4,1"))
        self.assertIn("there is no edge 77", self.refused(file, "--boundary", "1,2,77"))
        error = self.refused(file, "--boundary", "1,2,3,4,5")
        self.assertIn("edge 5 forms no closed chain", error)
        self.assertIn("1, 2 form no closed chain", self.refused(file, "--boundary", "1,2"))
        self.assertIn("one of these", self.refused(file, "--boundary", "1,2", "--hole", "1"))
        box = wounds.save(Part.makeBox(1, 2, 3), self.folder / "box.step")
        self.assertIn("between the faces", self.refused(box, "--boundary", "1,2,3,4"))


if __name__ == "__main__":
    unittest.main()
