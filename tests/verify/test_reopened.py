"""Fills a hole of ../shared/cad/reopened and measures the written file with FreeCAD's Part module.

The case is named by SUTURE_CASE. Nothing here shares code with the program but OCCT itself.
"""

import math
import os
import re
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parent / "bench"))

from cases import CAD, reopened_cases, with_holes  # noqa: E402
from program import BARE, BUILD, SUTURE, run  # noqa: E402
from time_limits import limit  # noqa: E402

FILL_LIMIT = limit(300)  # seconds
DONE, OUT_OF_TOLERANCE = 0, 4  # exit codes after which there is an output
# How well two measurements must agree.
RELATIVE, ABSOLUTE_MM, ABSOLUTE_RAD = 0.01, 1e-6, 1e-6
RESTORED = 1e-7  # of the hole's diameter: what `extend` owes to the truth


METHODS = {
    "auto": ["--method", "auto"],
    "occt": ["--method", "occt"],
    "tuned": ["--method", "occt", "--occt-setting", "tuned"],
}

UNCERTAINTY = re.compile(r"(UNCERTAINTY_MEASURE_WITH_UNIT\s*\(LENGTH_MEASURE\()([^)]*)")


class Filled:
    """A case, filled in one of the ways of METHODS."""

    def __init__(self, case, method):
        self.case = case
        folder = BUILD / "tests/verify"
        folder.mkdir(parents=True, exist_ok=True)
        self.out = folder / f"{case.name}-{method}.step"
        self.out.unlink(missing_ok=True)
        command = [SUTURE, "fill", case.model, "-o", self.out, "--hole", case.hole, "--keep-bad", "--json"]
        self.run = run([*command, *METHODS[method]], FILL_LIMIT)
        self.report = self.run.document()

    def reread(self):
        """The model, read and written by OCCT alone, with the accuracy that the output states."""
        file = self.out.with_suffix(".bare.step")
        done = run([BARE, self.case.model, file], FILL_LIMIT)
        assert done.code == 0, done.err
        stated = UNCERTAINTY.search(self.out.read_text(encoding="latin-1")).group(2)
        text = UNCERTAINTY.sub(lambda found: found.group(1) + stated, file.read_text(encoding="latin-1"))
        file.write_text(text, encoding="latin-1")
        return file

    def entry(self):
        """What the report says of the hole."""
        return next(hole for hole in self.report["holes"] if self.case.hole in hole["ids"])


def agree(ours, theirs, absolute):
    return abs(ours - theirs) <= max(absolute, RELATIVE * max(ours, theirs))


class Reopened(unittest.TestCase):
    def test_auto(self):
        self.fill_and_measure("auto")

    def test_occt(self):
        self.fill_and_measure("occt")

    def test_tuned(self):
        self.fill_and_measure("tuned")

    def setUp(self):
        if not (CAD / "reopened").is_dir():
            self.skipTest("no ../shared/cad")
        try:
            import shapes
        except ImportError as error:
            self.skipTest(f"no FreeCAD: {error}")
        self.shapes = shapes

    def fill_and_measure(self, method):
        case = next(case for case in reopened_cases() if case.name == os.environ["SUTURE_CASE"])
        self.filled = Filled(with_holes(case)[0], method)
        done = self.filled.run
        self.assertIn(done.code, (DONE, OUT_OF_TOLERANCE), done.err)
        self.assertIn(self.filled.report["measured_on"], ("new faces", "file"))
        entry = self.filled.entry()
        self.assertEqual(entry["status"], "filled", entry["reason"])
        self.before = self.shapes.read(self.filled.case.model)
        self.after = self.shapes.read(self.filled.out)
        reread = self.shapes.read(self.filled.reread())
        self.faces = self.shapes.Comparison(self.before, self.after, reread)
        for check in (
            self.check_closed, self.check_untouched, self.check_figures, self.check_restored,
        ):  # fmt: skip
            with self.subTest(check.__name__):
                check()

    def check_closed(self):
        """A closed valid solid where the model was one before the face was taken out."""
        if self.filled.case.truth is None:
            return
        open_edges = len(self.shapes.free_edges(self.before))
        left = len(self.shapes.free_edges(self.after))
        self.assertEqual(left, open_edges - self.filled.case.sides, "free edges")
        self.assertEqual(self.filled.report["free_edges"], left)
        if left > 0:
            return
        self.assertTrue(self.after.isValid(), "BRepCheck")
        self.assertTrue(self.filled.report["valid"] and self.filled.report["closed"])
        self.assertGreaterEqual(len(self.after.Solids), 1)
        for shell in self.after.Shells:
            self.assertTrue(shell.isClosed())
        for solid in self.after.Solids:
            self.assertGreater(solid.Volume, 0.0, "inside out")

    def check_untouched(self):
        """Surfaces, areas and tolerances of all other faces are what they were."""
        self.assertEqual(len(self.faces.lost), 0, "faces of the input that are not in the output")
        self.assertEqual(len(self.faces.added), len(self.filled.entry()["patches"]))
        bounding = [edge for facts in self.faces.added for edge in facts.face.Edges]
        neighbours = [
            facts
            for _, facts in self.faces.kept
            if any(vertex.isSame(other) for vertex in facts.face.Vertexes
                   for edge in bounding for other in edge.Vertexes)
        ]  # fmt: skip
        for references, facts in self.faces.kept:
            differences = [
                self.shapes.difference(was, facts, edges_too=facts not in neighbours)
                for was in references
            ]
            if all(differences):
                self.fail(f"face at {tuple(facts.centroid)}: {differences}")

    def check_figures(self):
        """Gap and angle are what an independent measurement finds."""
        entry = self.filled.entry()
        self.assertIsNotNone(entry["max_gap"], entry["notes"])
        gap, angle = self.shapes.largest_gap_and_angle(self.after, self.faces.added)
        # Of each side, also of those where only position was asked for.
        reported = max((side["max_angle_deg"] for side in entry["edges"]), default=0.0)
        reported = max(reported, entry["max_angle_deg"])
        with self.subTest("gap", suture=entry["max_gap"], freecad=gap):
            self.assertTrue(agree(entry["max_gap"], gap, ABSOLUTE_MM))
        with self.subTest("angle", suture=reported, freecad=angle):
            # Of a folded face the angle has peaks that samples alone do not find.
            narrow = entry["severity"] == "bad" and reported > angle
            self.assertTrue(narrow or agree(reported, angle, math.degrees(ABSOLUTE_RAD)))

    def check_restored(self):
        """Where the neighbours' common surface was continued, it is the lost one."""
        case = self.filled.case
        if self.filled.entry()["method_used"] != "extend" or case.truth is None:
            return
        truth = self.shapes.read(case.truth).Faces[0]
        distance = self.shapes.largest_distance(truth, self.faces.added)
        self.assertLessEqual(distance, RESTORED * case.diameter)


if __name__ == "__main__":
    unittest.main()
