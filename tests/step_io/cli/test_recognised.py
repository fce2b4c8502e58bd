"""What `recognise` gives back as a file holds it."""

import tempfile
import unittest
from pathlib import Path

from program import DONE, example, run


class Recognised(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def fill(self, model):
        out = self.folder / "out.step"
        finished = run("fill", model, "-o", out, "--json")
        self.assertEqual(finished.code, DONE, str(finished))
        return out, finished.json["holes"][0]

    def test_a_suitcase_corner_costs_two_kilobytes_at_most(self):
        model = example("suitcase_corner")
        out, hole = self.fill(model)
        self.assertEqual(hole["recognised"]["kind"], "sphere")
        self.assertLess(out.stat().st_size, model.stat().st_size + 2000)
        text = out.read_text()
        self.assertEqual(text.count("SPHERICAL_SURFACE"), 1)
        # Its border is lines of the sphere's domain; a pole in a corner costs no accuracy.
        before = model.read_text().count("B_SPLINE_CURVE")
        self.assertEqual(text.count("B_SPLINE_CURVE"), before)
        self.assertLess(hole["max_gap"], 1e-12)
        self.assertLess(hole["max_angle_deg"], 1e-9)


if __name__ == "__main__":
    unittest.main()
