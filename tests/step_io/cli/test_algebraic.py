"""The method `algebraic` on models, and the command that takes polynomials."""

import json
import math
import re
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

from program import CAD, DONE, EXAMPLES, OUT_OF_TOLERANCE, UNREADABLE, USAGE, Case, example, run

TABLE = EXAMPLES / "table_corner.json"


def problem(folder, **changes):
    file = Path(folder) / "problem.json"
    file.write_text(json.dumps({**json.loads(TABLE.read_text()), **changes}))
    return file


class Problems(Case):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def solve(self, **changes):
        return self.expect(run("algebraic", problem(self.folder.name, **changes), "--json"), DONE).json

    def test_ranks_are_those_of_exact_arithmetic(self):
        for degree, cells, rank, dimension in ((4, "axis", 77, 13), (3, "axis", 35, 1)):
            found = self.solve(degree=degree, cells=cells, sphere=1)
            self.assertEqual((found["rank"], found["dimension"]), (rank, dimension))

    def test_a_member_has_the_neighbours_planes_and_curves_exactly(self):
        """On the circle at z = 1, in the cell at that side, at a rational point."""
        cell = self.solve(degree=3, cells="axis", sphere=1)["cells"][2]["exact"]
        t = Fraction(-2)
        at = {"x": (1 + t) ** 2 / (1 + t * t), "y": 2 / (1 + t * t), "z": Fraction(1)}
        text = re.sub(r"\d+/\d+|\b\d+\b(?=\*)", lambda number: f"F('{number[0]}')", cell)
        self.assertEqual(eval(text.replace("^", "**"), {"F": Fraction, **at}), 0)

    def test_mesh_and_value(self):
        mesh = Path(self.folder.name) / "m.obj"
        done = self.expect(
            run("algebraic", TABLE, "--json", "--mesh", mesh, "--divisions", 8, "--at", "0.5,0.5,0.5"), DONE
        )
        self.assertTrue(done.json["at"]["inside"])
        points = [list(map(float, line.split()[1:])) for line in mesh.read_text().splitlines() if line[:2] == "v "]
        distances = [math.dist(p, (1, 1, 1)) for p in points]
        self.assertGreater(min(distances), 0.95)
        self.assertLess(max(distances), 1.03)

    def test_default_is_the_cubic_in_three_cells(self):
        found = self.expect(run("algebraic", TABLE, "--json"), DONE).json
        self.assertEqual((found["degree"], len(found["cells"]), found["rank"]), (3, 3, 35))

    def test_the_papers_cubic_has_seven_cells(self):
        found = self.solve(cells="inner")
        self.assertEqual((found["degree"], len(found["cells"]), found["rank"]), (3, 7, 54))

    def test_position_only_takes_quadrics(self):
        self.assertEqual(self.solve(k=0)["degree"], 2)

    def test_curvatures_that_differ_at_a_corner_are_refused(self):
        done = run("algebraic", problem(self.folder.name, k=2), "--json")
        refused = self.expect(done, OUT_OF_TOLERANCE).json["refused"]
        self.assertRegex(refused, r"corner of sides 3 and 1 is G\^2 .*curvatures differ")

    def test_curvature_is_kept_where_the_neighbours_agree(self):
        """A ball with an octant missing: G^2 and G^3 with the ball itself, by a linear factor more."""
        sides = [{"surface": "x^2 + y^2 + z^2 - 1", "plane": plane, "from": corner}
                 for plane, corner in (("z", [1, 0, 0]), ("x", [0, 1, 0]), ("y", [0, 0, 1]))]  # fmt: skip
        mesh = Path(self.folder.name) / "m.obj"
        for k in (2, 3):
            file = problem(self.folder.name, k=k, centre=[0, 0, 0], sides=sides)
            found = self.expect(run("algebraic", file, "--mesh", mesh, "--json"), DONE).json
            self.assertEqual(found["k"], k)
            points = [list(map(float, line.split()[1:])) for line in mesh.read_text().splitlines() if line[:2] == "v "]
            self.assertLess(max(abs(math.dist(p, (0, 0, 0)) - 1) for p in points), 1e-9)

    def test_faces_are_written_sewn_and_near_their_polynomials(self):
        for name in ("t.step", "t.igs"):
            out = Path(self.folder.name) / name
            done = self.expect(run("algebraic", TABLE, "-o", out, "--json"), DONE).json
            faces = done["faces"]
            self.assertLess(faces["fit_error"], 1e-7)
            self.assertLess(faces["max_angle_deg"], 0.01)
            self.assertTrue(faces["shape"]["valid"])
            check = run("check", out, "--g1", "0.01", "--json").json
            inner = [edge for edge in check["edges"] if edge["class"] != "sharp"]
            self.assertEqual(check["shape"]["free_edges"], 3)
            self.assertEqual(len(inner), 3)
            self.assertLess(max(edge["max_angle_deg"] for edge in inner), 0.01)
            self.assertLess(max(edge["max_gap"] for edge in inner), 1e-6)

    def test_refusals(self):
        self.expect_refused(run("algebraic", "no_such.json"), UNREADABLE, "no_such.json")
        for changes, text in (
            ({"centre": [1, 1, 2]}, "plane 3 does not go through the centre"),
            ({"k": -1}, "from 0 to 8"),
            ({"cells": "many"}, '"many"'),
            ({"sides": []}, "at least 3"),
        ):
            self.expect_refused(run("algebraic", problem(self.folder.name, **changes)), USAGE, text)


class Models(Case):
    def fill(self, model, *words):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out.step"
            return run("fill", model, "-o", out, "--method", "algebraic", "--json", *words, timeout=280)

    def test_suitcase_corner_becomes_a_closed_solid(self):
        done = self.expect(self.fill(example("suitcase_corner")), DONE).json
        self.assertTrue(done["closed"] and done["valid"])
        for hole in done["holes"]:
            self.assertEqual(hole["status"], "filled")
            self.assertLess(hole["max_gap"], 1e-6 * 20)
            self.assertLess(hole["max_angle_deg"], 0.01)
            self.assertEqual(len(hole["patches"]), 3)
            form = hole["polynomials"]
            self.assertEqual([len(cell["cones"]) for cell in form["cells"]], [1, 1, 1])
            cell = form["cells"][0]
            origin, size, centre = form["origin"], form["size"], form["centre"]
            # A corner of the hole is on the first cone's first ray: near where it meets g = 0.
            g = re.sub(r"\^", "**", cell["polynomial"])
            ray = cell["cones"][0][0]
            values = [eval(g, dict(zip("xyz", (c + t * r for c, r in zip(centre, ray))))) for t in (0.9, 1.0, 1.1)]
            self.assertLess(values[0] * values[2], 0.0)
            self.assertLess(abs(values[1]), 1e-9)
            self.assertTrue(size > 0 and len(origin) == 3)

    def test_a_refusal_says_how_near_each_degree_came(self):
        file = CAD / "reopened" / "12_freeform_smoothstar.open.step"
        if not file.exists():
            self.skipTest(f"{file} is not there")
        done = self.fill(file)
        self.assertEqual(done.code, OUT_OF_TOLERANCE, str(done))
        self.assertRegex(done.json["holes"][0]["reason"], r"degree 2 in \d+ cells: no member nearer to the sides than")


if __name__ == "__main__":
    unittest.main()
