"""`suture demo` works with nothing prepared."""

import json
import time

from program import DONE, OUT_OF_TOLERANCE, USAGE, Case, example, run
from time_limits import limit


class Demo(Case):
    def test_fills_the_examples_with_every_method(self):
        out = self.folder / "demo"
        start = time.monotonic()
        finished = run("demo", "--out", out, timeout=300)
        seconds = time.monotonic() - start
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE), str(finished))
        self.assertLess(seconds, limit(300))
        report = json.loads((out / "report.json").read_text())
        fills = report["fills"]
        for name in ("suitcase_corner", "box_without_lid", "pipe_elbow", "dome_window", "bump_window"):
            own = [f for f in fills if f["example"] == f"{name}.step"]
            self.assertTrue(any(f["status"] == "filled" and f["closed"] for f in own), name)
            self.assertIn(name, finished.out)
        methods = {f["method_requested"] for f in fills}
        self.assertEqual(methods, {m["id"] for m in run("methods", "--json").json["methods"]})
        files = {f["output"] for f in fills if f["output"]}
        self.assertEqual({str(p) for p in out.glob("*.step")}, files)
        self.assertIn("<table>", (out / "report.html").read_text())

    def test_folder_that_cannot_be_made(self):
        self.expect_refused(run("demo", "--out", example("box_without_lid") / "x"), USAGE, "--out")
