"""What says how far a new face bulges: points with normals, edges to follow tangentially, tension."""

import math
import unittest

from program import DONE, OUT_OF_TOLERANCE, USAGE, Case, run

try:
    import wounds
    from wounds import Part, Read, V
except ImportError as error:  # no FreeCAD
    wounds = error

RADIUS = 20.0


def height(x, y):
    return math.sqrt(RADIUS**2 - x * x - y * y)


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class ShapeHandles(Case):
    def circle(self, *more):
        """A circle of radius 9 on a ball, with nothing around it."""
        ring = Part.makeCircle(9, V(0, 0, height(9, 0)))
        shape = Part.Compound([ring, *more])
        return wounds.save(shape, self.folder / "in.step")

    def filled(self, file, *words, code=DONE):
        out = self.folder / "out.step"
        out.unlink(missing_ok=True)
        finished = run("fill", file, "-o", out, "--json", "--no-sew", *words)
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE) if code is None else (code,), str(finished))
        (hole,) = (h for h in finished.json["holes"] if h["status"] == "filled")
        return hole, Read(out).shape.Faces[-1]

    def refused(self, file, *words):
        out = self.folder / "none.step"
        finished = run("fill", file, "-o", out, *words)
        self.expect_refused(finished, USAGE)
        self.assertFalse(out.exists())
        return finished.err

    def points(self, *lines):
        file = self.folder / "points.csv"
        file.write_text("x;y;z;nx;ny;nz\n" + "".join(";".join(map(repr, line)) + "\n" for line in lines))
        return file

    def test_points_have_their_normals(self):
        """Tilted at the middle of a disc: measured with Part, either way round and in any length."""
        for scale in (1.0, -3.0):
            z = height(9, 0)
            wanted = V(0.1, 0.05, 1)
            file = self.points((0.0, 0.0, z + 0.5, *(scale * wanted)), (4.0, -2.0, z))
            hole, face = self.filled(self.circle(), "--boundary", 1, "--through", file)
            self.assertEqual((hole["points_through"], hole["method_used"]), (2, "mvs"))
            self.assertLess(hole["max_angle_through_deg"], 0.01)
            self.assertLess(hole["max_distance_through"], 1e-3)
            u, v = face.Surface.parameter(V(0, 0, z + 0.5))
            angle = math.degrees(face.normalAt(u, v).getAngle(wanted))
            self.assertLess(min(angle, 180 - angle), 0.01)
            self.assertLess((face.valueAt(u, v) - V(0, 0, z + 0.5)).Length, 1e-3)

    def test_without_normals_there_is_no_angle(self):
        hole, _ = self.filled(self.circle(), "--boundary", 1, "--through", self.points((0.0, 0.0, height(9, 0) + 1)))
        self.assertIsNone(hole["max_angle_through_deg"])

    def test_a_face_follows_an_edge_and_is_tangent_to_its_face(self):
        """A ring on the ball within the circle: with the ball's tangency the face is the ball's cap."""
        inner = Part.Face(Part.Wire(Part.makeCircle(5, V(0, 0, height(5, 0)))))  # has the edge, and is flat
        zone = Part.makeSphere(RADIUS, V(), V(0, 0, 1), -20, 0).Faces[0]
        file = self.circle(inner, zone)
        edges = Part.read(str(file)).Edges
        of_length = lambda r: next(n for n, e in enumerate(edges, 1) if abs(e.Length - 2 * math.pi * r) < 1e-6)
        (ball,) = (n for n, f in enumerate(Part.read(str(file)).Faces, 1) if f.Area > 300)
        follow = f"{of_length(5)}={ball}"
        hole, _ = self.filled(file, "--boundary", of_length(9), "--through-edges", follow, code=None)
        self.assertLess(hole["max_angle_through_deg"], 0.1)
        self.assertLess(hole["max_distance_through"], 1e-2)
        shape = Read(self.folder / "out.step").shape
        (made,) = (f for f in shape.Faces if any(abs(e.Length - 18 * math.pi) < 1e-3 for e in f.Edges))
        for x, y in ((0, 0), (2, 1), (-6, 3), (0, -8)):
            u, v = made.Surface.parameter(V(x, y, height(x, y)))
            self.assertLess((made.valueAt(u, v) - V(x, y, height(x, y))).Length, 0.02)

    def test_says_what_cannot_be_followed(self):
        file = self.circle(wounds.sheet([(0, 0, 0), (9, 0, 0), (9, 9, 0)]))
        (ring,) = (n for n, e in enumerate(Part.read(str(file)).Edges, 1) if e.isClosed())
        for words, said in (
            (("--through-edges", "2=7"), "there is no face 7"),
            (("--through-edges", "77"), "there is no edge 77"),
            (("--through-edges", f"{ring}=1"), f"edge {ring} does not lie on face 1: it is"),
            (("--through-edges", "1="), "is no number of a face"),
            (("--through", self.points((1.0, 2.0, 3.0, 4.0))), "is no point x, y, z, nor one with a normal"),
            (("--through", self.points((1.0, 2.0, 3.0, 0.0, 0.0, 0.0))), "is no point x, y, z"),
        ):
            error = self.refused(file, "--no-sew", "--boundary", ring, *words)
            self.assertIn(said, error)

    def test_tension_is_refused_where_it_means_nothing(self):
        error = self.refused(self.circle(), "--boundary", 1, "--tension", 2)
        self.assertIn("--tension is for bridges", error)
        self.assertIn("method auto finds", error)


if __name__ == "__main__":
    unittest.main()
