"""A small run of the benchmark, and its tables on made-up results."""

import json
import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import bench  # noqa: E402
import judge_cost  # noqa: E402
import overhead  # noqa: E402
import tables  # noqa: E402
from cases import Case, reopened_cases  # noqa: E402
from program import Run as Ended  # noqa: E402
from program import run  # noqa: E402

FILLED = {
    "case": "lid", "sides": 4, "diameter": 10.0, "method": "plane", "status": "filled", "reason": "as asked",
    "method_used": "plane", "within_tolerance": True, "valid": True, "closed": True, "notes": [],
    "seconds_fill": 0.001, "seconds_process": 0.2, "peak_bytes": 2**25, "max_gap": 1e-9,
    "max_angle_deg": 0.0, "max_curvature_mismatch": None,
    "patches": [{"kind": "plane", "poles_u": 0, "poles_v": 0, "degree_u": 0, "degree_v": 0}],
    "judge": {"valid": True, "free_edges": 0, "changed_faces": 0, "lost_faces": 0, "fidelity": 1e-12},
}  # fmt: skip
REFUSED = {
    "case": "lid", "sides": 4, "diameter": 10.0, "method": "extend", "status": "refused",
    "reason": "Face1 and Face2 lie on different planes", "seconds_fill": None, "seconds_process": 0.2,
    "peak_bytes": 2**25,
}  # fmt: skip
RESULT = {
    "program": "suture", "date": "", "machine": {"processor": "", "cores": 2}, "runs": 1,
    "methods": ["plane", "extend"], "rows": [FILLED, REFUSED], "cases_without_hole": [],
}  # fmt: skip


class Run(unittest.TestCase):
    def test_what_a_program_took_is_that_of_its_whole_family(self):
        child = "import time; block = bytearray(100_000_000); time.sleep(0.2)"
        parent = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {child!r}])"
        done = run([sys.executable, "-c", parent], 60)
        self.assertEqual(done.code, 0)
        self.assertGreater(done.peak_bytes, 100_000_000)
        self.assertGreater(done.seconds, 0.2)

    def test_a_program_that_hangs_is_stopped(self):
        done = run([sys.executable, "-c", "import time; time.sleep(60)"], 0.3)
        self.assertTrue(done.timed_out)
        self.assertLess(done.seconds, 30)


class Tables(unittest.TestCase):
    def test_a_refusal_is_listed_with_its_reason(self):
        text = tables.benchmark(RESULT, None)
        self.assertIn("refused: Face1 and Face2 lie on different planes", text)
        self.assertIn("| extend | 0 of 1 |", text)

    def test_an_invalid_result_is_not_hidden(self):
        bad = FILLED | {"judge": FILLED["judge"] | {"valid": False}}
        text = tables.benchmark(RESULT | {"rows": [bad]}, None)
        self.assertIn("NOT VALID", text)

    def test_a_changed_face_is_not_hidden(self):
        bad = FILLED | {"judge": FILLED["judge"] | {"lost_faces": 2}}
        self.assertIn("2 FACES CHANGED", tables.benchmark(RESULT | {"rows": [bad]}, None))

    def test_a_face_with_a_new_border_is_not_hidden(self):
        moved = FILLED | {"judge": FILLED["judge"] | {"changed_faces": 2}}
        self.assertIn("closed, 2 re-trimmed", tables.benchmark(RESULT | {"rows": [moved]}, None))

    def test_fairness_stands_beside_the_lost_face_s(self):
        fair = {"fairness": {"variation": 0.02, "sign_changes": 1}}
        lost = {"truth_fairness": {"variation": 0.05, "sign_changes": 3}}
        alone = FILLED | {"judge": FILLED["judge"] | fair}
        both = FILLED | {"judge": FILLED["judge"] | fair | lost}
        self.assertIn("| 2 | 1 |", tables.benchmark(RESULT | {"rows": [alone]}, None))
        self.assertIn("| 2 (5) | 1 (3) |", tables.benchmark(RESULT | {"rows": [both]}, None))

    def test_what_auto_misses_is_listed_with_its_reason(self):
        auto = FILLED | {"method": "auto"}
        noisy = {"fidelity": 1.4e-3, "border_noise": 1e-2}  # the noise in mm, of a hole of 10 mm
        within = auto | {"judge": FILLED["judge"] | noisy}
        far = auto | {"case": "far", "judge": FILLED["judge"] | noisy | {"fidelity": 1.6e-3}, "reason": "mvs: why"}
        poor = auto | {"case": "poor", "within_tolerance": False, "findings": ["angle 1 deg"]}
        result = RESULT | {"methods": ["auto"], "rows": [within, far, poor]}
        text = tables.benchmark(result, None).split("## What")[1].split("## Hole by hole")[0]
        self.assertNotIn("| lid |", text)
        self.assertIn("| far | 0.0016 | 0.001 | plane; within tolerance | mvs: why |", text)
        self.assertIn("out of tolerance: angle 1 deg", text)
        self.assertIn("| 1 of 2 |", tables.benchmark(result, None))

    def test_a_judge_that_fails_is_not_hidden(self):
        bad = FILLED | {"judge": {"judge_error": "crashed"}}
        self.assertIn("judge failed: crashed", tables.benchmark(RESULT | {"rows": [bad]}, None))


class Overhead(unittest.TestCase):
    def seconds_of(self, method):
        document = {
            "holes": [
                {"method_requested": method, "status": "filled"},
                {"method_requested": "", "status": "skipped"},
            ],
            "seconds": {"fill": 1.0, "choose": 3.0, "fill_step": 4.0},
        }
        return overhead.method_seconds(Ended(0, 9.0, 9.0, 1, json.dumps(document), "", False))

    def test_trying_and_measuring_is_what_auto_does(self):
        self.assertEqual(self.seconds_of("auto"), 3.0)

    def test_measuring_the_trial_of_one_method_is_overhead(self):
        self.assertEqual(self.seconds_of("mvs"), 1.0)

    def test_the_median_of_whole_runs_is_that_of_large_files(self):
        def row(size, ratio):
            return {
                "case": "c", "bytes": size, "method": "mvs", "ratio": 1.0, "names_ratio": 1.0, "cpu_ratio": 1.0,
                "whole_ratio": ratio, "bare_seconds": 1.0, "names_seconds": 1.0, "seconds": 1.0, "stages": {},
                "peak_bytes": 1, "bare_peak_bytes": 1,
            }  # fmt: skip

        rows = [row(9e5, 1.5), row(4e5, 9.0), row(6e5, 1.25), row(2e6, 1.0)]
        text = tables.overhead_section({"runs": 1, "rows": rows})
        self.assertIn("of files above 0.5 MB 1.25 in the median of 3.", text)
        refused = {"case": "c", "bytes": 1, "method": None, "reason": "none fills it"}
        lines = tables.overhead_section({"runs": 1, "rows": [rows[0], refused]}).splitlines()
        self.assertEqual(len({line.count("|") for line in lines if line.startswith("|")}), 1)


class JudgeCost(unittest.TestCase):
    def test_the_share_of_a_function_is_that_of_its_name_alone(self):
        report = (
            "    37.16%  [.] suture::choose_fill\n"
            "     4.18%  [.] suture::find_clashes\n"
            "     9.00%  [.] std::_Function_handler<void (), suture::find_clashes::{lambda()#1}>\n"
        )
        self.assertAlmostEqual(judge_cost.share_of("suture::find_clashes", report), 0.0418)
        self.assertEqual(judge_cost.share_of("suture::find_folds", report), 0.0)


class Bench(unittest.TestCase):
    def bench(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "bench.json"
            self.assertEqual(bench.main(["-o", str(output), "--runs", "1", *arguments]), 0)
            return json.loads(output.read_text(encoding="utf-8"))

    def row(self, result, case, method):
        return next(r for r in result["rows"] if r["case"] == case and r["method"] == method)

    def test_examples_are_filled_and_judged(self):
        result = self.bench("--examples-only", "--cases", "lid", "suitcase", "--methods", "plane", "extend")
        self.assertEqual(len(result["rows"]), 4)
        lid = self.row(result, "box_without_lid", "plane")
        self.assertEqual((lid["status"], lid["judge"]["new_faces"]), ("filled", 1))
        self.assertEqual((lid["judge"]["free_edges"], lid["judge"]["lost_faces"]), (0, 0))
        self.assertTrue(lid["judge"]["valid"])
        corner = self.row(result, "suitcase_corner", "plane")
        self.assertEqual(corner["status"], "refused")
        self.assertTrue(corner["reason"])
        text = tables.benchmark(result, None)
        self.assertEqual(text.count("### "), 2)

    def test_a_lost_face_that_is_restored_has_no_deviation(self):
        if not reopened_cases():
            self.skipTest("no ../shared/cad")
        result = self.bench("--cases", "26_sphere", "--methods", "extend")
        row = self.row(result, "26_sphere_octant", "extend")
        self.assertEqual(row["status"], "filled", row["reason"])
        self.assertLessEqual(row["judge"]["fidelity"], 1e-7)

    def test_every_method_of_the_program_has_its_row(self):
        listed = run([os.environ["SUTURE_PROGRAM"], "methods", "--json"], 60).document()["methods"]
        names = [name for name, _ in bench.settings_of(None)]
        self.assertEqual({name.split()[0] for name in names}, {method["id"] for method in listed})
        self.assertLess(set(["occt default", "occt tuned"]), set(names))

    def test_a_judge_without_a_file_says_so(self):
        case = Case("none", Path("none.step"), None, None)
        self.assertIn("none.step", bench.judged(case, Path("none.step"))["judge_error"])


if __name__ == "__main__":
    unittest.main()
