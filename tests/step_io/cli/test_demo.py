"""`suture demo` works with nothing prepared."""

import json
import os
import sys
import time
import unittest
from pathlib import Path

from program import DONE, OUT_OF_TOLERANCE, USAGE, Case, example, run
from time_limits import limit

sys.path.append(str(Path(os.environ["SUTURE_SOURCE_DIR"]) / "tests/report"))
PICTURES = os.environ.get("SUTURE_PICTURES")


class Demo(Case):
    def test_fills_the_examples_with_every_method_and_shows_them(self):
        self.out = self.folder / "demo"
        start = time.monotonic()
        self.finished = run("demo", "--out", self.out, timeout=300)
        self.seconds = time.monotonic() - start
        self.fills = json.loads((self.out / "report.json").read_text())["fills"]
        self.look_at_files()
        self.look_at_page()

    def look_at_files(self):
        self.assertIn(self.finished.code, (DONE, OUT_OF_TOLERANCE), str(self.finished))
        self.assertLess(self.seconds, limit(300))
        for name in ("suitcase_corner", "box_without_lid", "pipe_elbow", "dome_window", "bump_window"):
            own = [f for f in self.fills if f["example"] == f"{name}.step"]
            self.assertTrue(any(f["status"] == "filled" and f["closed"] for f in own), name)
            self.assertIn(name, self.finished.out)
        methods = {f["method_requested"] for f in self.fills}
        self.assertEqual(methods, {m["id"] for m in run("methods", "--json").json["methods"]})
        files = {f["output"] for f in self.fills if f["output"]}
        self.assertEqual({str(p) for p in self.out.glob("*.step")}, files)
        self.assertIn("<table>", (self.out / "report.html").read_text())

    def look_at_page(self):
        """A picture of every fill; a click opens it."""
        from browser import Browser, chromium

        if not chromium():
            return
        filled = [fill for fill in self.fills if fill["status"] == "filled"]
        page = self.out / "report.html"
        self.assertLess(page.stat().st_size, 12e6)
        browser = Browser()
        self.addCleanup(browser.close)
        browser.open(page)
        self.assertEqual(browser.errors, [])
        if PICTURES:
            browser.screenshot(Path(PICTURES) / "demo.png")
        figures = "Array.from(document.querySelectorAll('#gallery figure'))"
        self.assertEqual(browser.value(f"{figures}.length"), len(filled))
        sources = browser.value(f"{figures}.flatMap(f => Array.from(f.querySelectorAll('img')).map(i => i.src))")
        self.assertEqual(len(sources), 2 * len(filled))
        self.assertGreater(min(map(len, sources)), 4000)  # more than an empty sheet
        self.assertGreater(len(set(sources)), len(filled))
        self.assertEqual(browser.value("Array.from(document.querySelectorAll('#gallery img, #gallery a')).filter("
                                       "e => !(e.alt || e.ariaLabel)).length"), 0)
        # Later, since the page that is asked goes away.
        browser.value("void setTimeout(() => document.querySelector(\"figure[data-scene='suitcase_corner.auto'] a\").click())")
        browser.wait_for("window.sutureReport")
        self.assertEqual(browser.value("sutureReport.scene.newFaces.size"), 1)
        self.assertEqual(browser.value("document.querySelectorAll('figure').length"), 0)
        browser.settle()
        if PICTURES:
            browser.screenshot(Path(PICTURES) / "demo_fill.png")
        browser.value("void setTimeout(() => document.querySelector('a[href=\"#\"]').click())")
        browser.wait_for(f"document.documentElement.dataset.ready && {figures}.length")
        self.assertEqual(browser.errors, [])

    def test_folder_that_cannot_be_made(self):
        self.expect_refused(run("demo", "--out", example("box_without_lid") / "x"), USAGE, "--out")


if __name__ == "__main__":
    unittest.main()
