"""What `fill` calls good, near, poor and bad, and that its report and `check` agree."""

import json
import os
import unittest
from pathlib import Path

import jsonschema

from program import CAD, DONE, EXAMPLES, NOTHING, OUT_OF_TOLERANCE, Case, example, run

SCHEMA = json.loads(
    (Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs/schema/fill.schema.json").read_text()
)
CASES = CAD.parent / "cases"
METHODS = ("auto", "mvs", "tube", "concentric", "manifold", "algebraic", "occt")


class Judged(Case):
    def fill(self, file, *words, timeout=240):
        self.output = self.folder / "out.step"
        finished = run("fill", file, "-o", self.output, "--json", *words, timeout=timeout)
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE), str(finished))
        document = finished.json
        jsonschema.validate(document, SCHEMA)
        self.assertEqual(document["exit_code"], finished.code)
        return document

    def case(self, name):
        file = CASES / name
        if not file.exists():
            self.skipTest(f"needs {file}")
        return file

    def hole(self, document, index=0):
        return document["holes"][index]

    def kinds(self, hole):
        return {finding["kind"] for finding in hole["findings"] if not finding["before"]}


class Severity(Judged):
    def test_a_good_fill_has_no_finding(self):
        document = self.fill(example("suitcase_corner"))
        self.assertEqual((document["severity"], document["exit_code"]), ("good", DONE))
        self.assertEqual(document["findings"], [])

    def test_the_verdict_names_the_worst_figure_with_place_and_limit(self):
        document = self.fill(example("bump_window"), "--method", "occt", "--angle", "1e-6")
        worst = document["findings"][0]
        self.assertEqual(document["severity"], worst["severity"])
        self.assertIn(worst["text"], document["verdict"])
        self.assertIn(f"allowed {worst['limit']:.4g} deg", worst["text"])

    def test_a_bad_fill_stays_out_and_is_told(self):
        document = self.fill(self.case("trust/post_inside.brep"))
        hole = self.hole(document)
        self.assertEqual(document["exit_code"], OUT_OF_TOLERANCE)
        self.assertEqual((hole["status"], hole["severity"]), ("refused", "bad"))
        self.assertEqual(self.kinds(hole), {"clash"})
        self.assertFalse(document["closed"])
        kept = self.fill(self.case("trust/post_inside.brep"), "--method", "plane", "--keep-bad")
        self.assertEqual(self.hole(kept)["status"], "filled")
        self.assertEqual(kept["exit_code"], OUT_OF_TOLERANCE)

    def test_twisted_strips_are_tangent(self):
        # They were joined at 30.7 deg, and called good.
        document = self.fill(self.case("trust/strips_twist.step"))
        self.assertEqual((document["severity"], document["exit_code"]), ("good", DONE))
        for side in self.hole(document)["edges"]:
            self.assertLessEqual(side["max_angle_deg"], 0.01)

    def test_a_corner_of_five_metres_is_within_the_tolerance_that_was_asked_for(self):
        # Its edges say that they are good for 0.05 mm.
        document = self.fill(self.case("trust/corner_5000_tol.brep"))
        self.assertEqual((document["severity"], document["exit_code"]), ("good", DONE))
        self.assertLessEqual(self.hole(document)["max_gap"], 1e-3)

    def test_a_balloon_stays_out(self):
        points = self.case("trust/round_in_plate.points.csv")
        document = self.fill(
            self.case("trust/round_in_plate.brep"), "--method", "mvs", "--through", points
        )
        hole = self.hole(document)
        self.assertEqual((hole["status"], hole["severity"]), ("refused", "bad"))
        self.assertIn("balloon", self.kinds(hole))

    def test_a_lone_strip_is_no_hole(self):
        strip = self.case("detect/lone_strip.brep")
        self.expect(run("fill", strip, "-o", self.folder / "out.step"), NOTHING)
        forced = self.fill(strip, "--all-loops")
        self.assertEqual(self.hole(forced)["status"], "refused")

    def test_no_tolerance_grows_beyond_the_gap(self):
        document = self.fill(self.case("trust/loose_tol.brep"), "--method", "mvs", "--no-sew")
        self.assertNotIn("tolerance_grown", self.kinds(self.hole(document)))

    def test_a_far_off_fill_stays_out(self):
        file = CAD / "reopened" / "R13_bspl4s_nacelle.open.step"
        if not file.exists():
            self.skipTest(f"needs {file}")
        document = self.fill(file, "--recognise", "off")  # which knows the lost face again
        for hole in document["holes"]:
            if hole["status"] == "filled":
                self.assertNotEqual(hole["severity"], "bad")
            elif hole["severity"]:
                self.assertEqual(hole["severity"], "bad")
        self.assertFalse(document["closed"])

    def test_a_crease_inside_the_new_face_counts(self):
        file = CAD / "reopened" / "R04_bspl3_trigger.open.step"
        if not file.exists():
            self.skipTest(f"needs {file}")
        document = self.fill(file, "--method", "concentric")
        hole = self.hole(document)
        self.assertEqual((hole["status"], document["exit_code"]), ("filled", OUT_OF_TOLERANCE))
        creases = [f["value"] for f in hole["findings"] if f["kind"] == "crease"]
        knots = run("check", self.output, "--json").json["face_knots"]
        new = {patch["face"] for patch in hole["patches"]}
        found = [k["max_angle_deg"] for k in knots if k["face"] in new and k["max_angle_deg"] > 0.01]
        self.assertEqual(len(creases), len(found))
        self.assertAlmostEqual(max(creases), max(found), delta=1e-6)


class Agreement(Judged):
    """`check` on the written file and `fill`'s own report have the same figures."""

    def agree(self, file, method):
        document = self.fill(file, "--method", method)
        filled = [hole for hole in document["holes"] if hole["status"] == "filled"]
        if not filled:
            return 0
        check = run("check", self.output, "--json", timeout=240).json
        for hole in filled:
            faces = {patch["face"] for patch in hole["patches"]}
            around = [edge for edge in check["edges"] if faces & set(edge["faces"])]
            for key in ("max_gap", "max_angle_deg"):
                said = sorted(side[key] for side in hole["edges"])
                found = sorted(edge[key] for edge in around)
                # Every side is among the edges of the new faces, to the last digits that the
                # file has.
                for value in said:
                    self.assertTrue(
                        any(abs(value - other) <= 1e-9 + 1e-6 * abs(value) for other in found),
                        f"{file.name} {method}: {key} {value} is not in {found}",
                    )
            self.assertAlmostEqual(hole["max_gap"], max(e["max_gap"] for e in around), delta=1e-9)
            # Inside the new faces too, where what was asked for is a smooth face.
            if hole["continuity_requested"] != "G0":
                said = [f["value"] for f in hole["findings"] if f["kind"] == "crease"]
                found = [k["max_angle_deg"] for k in check["face_knots"] if k["face"] in faces]
                found = [angle for angle in found if angle > 0.01]
                self.assertEqual(len(said), len(found), f"{file.name} {method}: {said} {found}")
        return len(filled)

    def test_the_examples_by_every_method(self):
        filled = sum(
            self.agree(file, method)
            for file in sorted(EXAMPLES.glob("*.step"))
            for method in METHODS
        )
        self.assertGreater(filled, 12)

    def test_reopened_models_by_auto(self):
        files = sorted((CAD / "reopened").glob("*.open.step"))[::4]
        if not files:
            self.skipTest("needs cad/reopened")
        self.assertGreater(sum(self.agree(file, "auto") for file in files), len(files) // 2)


if __name__ == "__main__":
    unittest.main()
