"""What `suture check` writes for programs: JSON after its schema, CSV, JUnit XML, own profiles."""

import csv
import io
import json
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
import os

import jsonschema

from program import CAD, DONE, OUT_OF_TOLERANCE, USAGE, Case, example, run

SCHEMA = json.loads(
    (Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs/schema/check.schema.json").read_text()
)
# Planes and cylinders; splines that miss by little; splines in IGES; knots inside faces.
FILES = ["nacelle.stp", "ubend2.stp", "simple_wing.stp", "0044_bb_boxblend_03_colored.stp", "goteborg.iges"]


def check(file, *words):
    return run("check", file, "--json", *words)


class Schema(Case):
    def test_documents_of_public_files_follow_it(self):
        for name in FILES:
            document = check(CAD / "files" / name, "--certify").json
            jsonschema.validate(document, SCHEMA)
            self.assertEqual(len(document["edges"]), document["summary"]["edges"], name)

    def test_the_document_of_an_error_follows_it(self):
        jsonschema.validate(check(self.folder / "none.step").json, SCHEMA)

    def test_it_is_not_content_with_anything(self):
        document = check(example("box_without_lid")).json
        document["edges"][0]["class"] = "G7"
        with self.assertRaises(jsonschema.ValidationError):
            jsonschema.validate(document, SCHEMA)


class Exports(Case):
    file = CAD / "files" / "nacelle.stp"

    def written(self, ending, *words):
        target = self.folder / f"out.{ending}"
        document = check(self.file, "--report", target, *words).json
        return document, target.read_text()

    def test_csv_has_a_line_for_each_edge_with_the_same_figures(self):
        document, text = self.written("csv")
        rows = {int(row["edge"]): row for row in csv.DictReader(io.StringIO(text))}
        self.assertEqual(len(rows), len(document["edges"]))
        for edge in document["edges"]:
            row = rows[edge["edge"]]
            self.assertEqual(row["class"], edge["class"])
            self.assertEqual(float(row["max_angle_deg"]), edge["max_angle_deg"])
            self.assertEqual(float(row["max_gap_mm"]), edge["max_gap"])
            self.assertEqual(row["near_miss"] == "1", edge["near_miss"])
            self.assertEqual(row["note"], edge["note"])

    def test_junit_counts_near_misses_as_failures(self):
        document, text = self.written("xml", "--g1", "1e-7")
        suite = ElementTree.fromstring(text).find("testsuite")
        summary = document["summary"]
        self.assertEqual(int(suite.get("tests")), summary["edges"] + summary["knot_lines"])
        failures = summary["near_misses"] + summary["knot_near_misses"]
        self.assertGreater(failures, 0)
        self.assertEqual(int(suite.get("failures")), failures)
        self.assertEqual(len(suite.findall("testcase/failure")), failures)
        self.assertIn("deg", suite.find("testcase/failure").get("message"))

    def test_near_misses_come_first(self):
        target = self.folder / "out.csv"
        check(self.file, "--g1", "1e-7", "--report", target)
        flags = [row["near_miss"] for row in csv.DictReader(io.StringIO(target.read_text()))]
        self.assertEqual(flags, sorted(flags, reverse=True))

    def test_other_commands_write_no_csv(self):
        self.expect_refused(
            run("inspect", example("box_without_lid"), "--report", self.folder / "o.csv"), USAGE, ".html"
        )


class Profiles(Case):
    def write(self, **limits):
        file = self.folder / "mine.json"
        file.write_text(json.dumps(limits))
        return file

    def test_every_named_profile_is_taken_and_tells_its_source(self):
        for name in ("catia", "vda4955", "alias", "rhino", "occt"):
            profile = check(example("box_without_lid"), "--profile", name).json["profile"]
            self.assertEqual(profile["name"], name)
            self.assertTrue(profile["source"])

    def test_a_file_gives_limits_of_ones_own(self):
        mine = self.write(name="shop", g0_mm=0.05, g1_deg=0.5, g2_percent=20, g2_by="sum", sharp_deg=100)
        document = self.expect(check(example("box_without_lid"), "--profile", mine), OUT_OF_TOLERANCE).json
        self.assertEqual(document["profile"]["name"], "shop")
        self.assertAlmostEqual(document["profile"]["g1_deg"], 0.5)
        self.assertEqual(document["profile"]["g2_by"], "sum")
        self.assertEqual(document["summary"]["near_misses"], 8)  # 90 degrees are not sharp there

    def test_files_that_make_no_profile_are_refused_by_key(self):
        for limits, word in (({"g0_mm": 1, "g1_deg": 1}, "g2_percent"),
                             ({"g0_mm": 1, "g1_deg": 1, "g2_percent": 1, "g1_rad": 1}, "g1_rad"),
                             ({"g0_mm": "1", "g1_deg": 1, "g2_percent": 1}, "g0_mm"),
                             ({"g0_mm": -1, "g1_deg": 1, "g2_percent": 1}, "-1"),
                             ({"g0_mm": 1, "g1_deg": 1, "g2_percent": 1, "g2_by": "max"}, "g2_by")):
            finished = run("check", example("box_without_lid"), "--profile", self.write(**limits))
            self.expect_refused(finished, USAGE, word)
        missing = run("check", example("box_without_lid"), "--profile", self.folder / "none.json")
        self.expect_refused(missing, USAGE, "does not exist")

    def test_the_measure_of_the_profile_decides_the_class(self):
        # A sum-normalised mismatch is at most as large as the other: never a lower class.
        order = ["sharp", "G0", "G1", "G2", "G3"]
        file = CAD / "files" / "nacelle.stp"
        by = {}
        for measure in ("larger", "sum"):
            mine = self.write(g0_mm=0.001, g1_deg=0.01, g2_percent=2, g2_by=measure)
            by[measure] = [order.index(e["class"]) for e in check(file, "--profile", mine).json["edges"]]
        self.assertTrue(all(a <= b for a, b in zip(by["larger"], by["sum"])))


class Certify(Case):
    def test_bounds_are_never_below_what_was_measured(self):
        for name in FILES:
            document = check(CAD / "files" / name, "--certify").json
            for edge in document["edges"]:
                proven = edge["certificate"]
                if proven["certified"]:
                    self.assertGreaterEqual(proven["gap_bound"], edge["max_gap"], (name, edge["edge"]))
                    self.assertGreaterEqual(
                        proven["angle_bound_deg"] * (1 + 1e-15) + 1e-13, edge["max_angle_deg"],
                        (name, edge["edge"]))
                else:
                    self.assertTrue(proven["reason"])
            self.assertLessEqual(document["certificates"]["median_slack_percent"], 5, name)

    def test_a_box_is_proven_all_around(self):
        document = self.expect(check(example("box_without_lid"), "--certify"), DONE).json
        self.assertEqual(document["certificates"]["certified"], 8)
        for edge in document["edges"]:
            self.assertAlmostEqual(edge["certificate"]["angle_bound_deg"], 90, places=6)
            self.assertLess(edge["certificate"]["gap_bound"], 1e-11)


if __name__ == "__main__":
    unittest.main()
