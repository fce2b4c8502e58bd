"""The models that users have asked about, as they asked: read and measured by FreeCAD."""

import math
import unittest

from program import CAD, DONE, OUT_OF_TOLERANCE, USAGE, Case, run

CASES = CAD.parent / "cases" / "wound"

try:
    from wounds import Part, Read
except ImportError as error:  # no FreeCAD
    Part = error


def angle_between(shape, edge):
    """The largest angle between the two faces of an edge, in degrees."""
    faces = [f for f in shape.Faces if any(e.isSame(edge) for e in f.Edges)]
    first, last = edge.ParameterRange
    worst = 0.0
    for k in range(21):
        point = edge.valueAt(first + (last - first) * k / 20)
        one, other = (f.normalAt(*f.Surface.parameter(point)) for f in faces)
        worst = max(worst, math.degrees(math.atan2(one.cross(other).Length, abs(one.dot(other)))))
    return worst


@unittest.skipIf(isinstance(Part, ImportError), f"needs FreeCAD: {Part}")
class Named(Case):
    def made(self, name, *words, command="fill", code=DONE):
        file = CASES / name
        if not file.exists():
            self.skipTest(f"needs {file}")
        out = self.folder / "out.step"
        finished = run(command, file, "-o", out, "--json", *words)
        self.assertIn(finished.code, code if isinstance(code, tuple) else (code,), str(finished))
        made = Read(out)
        self.assertTrue(made.valid)
        return finished.json, made

    def new_face(self, document, made, index=0):
        holes = [hole for hole in document["holes"] if hole["status"] == "filled"]
        return made.shape.Faces[holes[index]["patches"][0]["face"] - 1]

    def test_a_fillet_that_was_lost_is_an_edge(self):
        _, made = self.made("sharp_edge_back.step", "--grow")
        self.assertEqual((made.faces, made.solids), (6, 1))
        self.assertAlmostEqual(made.volume, 72000, delta=1e-5)

    def test_two_plates_are_bridged_by_a_tangent_sheet(self):
        document, made = self.made("two_plates.step", "--edges", "2,8", command="bridge")
        self.assertEqual((made.faces, made.shells, made.solids), (3, 1, 0))
        face = self.new_face(document, made)
        shared = [e for e in face.Edges if sum(any(e.isSame(g) for g in f.Edges) for f in made.shape.Faces) == 2]
        self.assertEqual(len(shared), 2)
        for edge in shared:
            self.assertLess(angle_between(made.shape, edge), 0.01)

    def test_four_sheets_get_a_face_over_the_edges_that_face_each_other(self):
        document, made = self.made("four_sheets.step", "--boundary", "13,1,8,9")
        self.assertEqual((made.faces, made.shells, made.solids), (5, 1, 0))
        for edge in self.new_face(document, made).Edges:
            if "Line" in edge.Curve.TypeId:  # the cylinders'; the other two sheets are walls
                self.assertLess(angle_between(made.shape, edge), 0.01)

    def test_edges_that_lie_apart_are_named(self):
        file = CASES / "four_sheets.step"
        if not file.exists():
            self.skipTest(f"needs {file}")
        finished = run("fill", file, "-o", self.folder / "none.step", "--boundary", "1,5,9,13")
        self.expect_refused(finished, USAGE)
        self.assertIn("edges 1, 5, 9, 13 form no closed chain", finished.err)

    def test_loose_curves_bound_one_face(self):
        _, made = self.made("loose_curves.step", "--boundary", "3,1,2")
        curves = Part.read(str(CASES / "loose_curves.step"))
        face = Part.Face(Part.Wire(Part.__sortEdges__(curves.Edges)))
        self.assertEqual(made.faces, 1)
        self.assertAlmostEqual(made.area, face.Area, delta=1e-6)

    def test_a_hull_gets_a_deck_and_a_transom(self):
        for words in (("--all-loops", "--split", "auto"), ("--boundary", "1,4-6", "--split", "auto")):
            document, made = self.made("hull.igs", *words)
            self.assertEqual((made.faces, made.solids), (4, 1))
            deck, transom = sorted((self.new_face(document, made, i) for i in (0, 1)), key=lambda f: -f.Area)
            self.assertLess(abs(deck.BoundBox.ZLength), 1e-3)
            self.assertLess(abs(transom.BoundBox.XLength), 1e-3)

    def test_a_hull_is_split_between_the_vertices_that_are_named(self):
        file = CASES / "hull.igs"
        if not file.exists():
            self.skipTest(f"needs {file}")
        sewn = self.folder / "sewn.brep"
        self.expect(run("convert", file, sewn, "--sew"), DONE)
        shape = Part.read(str(sewn))
        tips = [n for n, v in enumerate(shape.Vertexes, 1) if abs(v.X) < 1e-3 and abs(abs(v.Y) - 12) < 1e-3]
        self.assertEqual(len(tips), 2)
        document, made = self.made("hull.igs", "--all-loops", "--split", f"Vertex{tips[1]},{tips[0]}")
        self.assertEqual((made.faces, made.solids), (4, 1))
        for vertices, said in (("1,99", "there is no vertex 99"), ("2,2", "no pair of vertices")):
            finished = run("fill", file, "-o", self.folder / "none.step", "--all-loops", "--split", vertices)
            self.expect_refused(finished, USAGE)
            self.assertIn(said, finished.err)

    def test_a_faceted_ball_stays_a_ball(self):
        _, made = self.made("faceted_ball.step", code=(DONE, OUT_OF_TOLERANCE))
        self.assertEqual(made.solids, 1)
        self.assertAlmostEqual(made.volume / 32227, 1, delta=0.002)


if __name__ == "__main__":
    unittest.main()
