"""The HTML report in a real browser, opened from disk. With SUTURE_PICTURES=FOLDER the pictures of
the documentation are written there."""

import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, chromium
from time_limits import limit

PROGRAM = os.environ["SUTURE_PROGRAM"]
SOURCE = Path(os.environ["SUTURE_SOURCE_DIR"])
FILES = Path(os.environ["SUTURE_CAD_DIR"]) / "files"
PICTURES = os.environ.get("SUTURE_PICTURES")


def suture(*words, codes=(0, 4), cwd=FILES):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, timeout=limit(400), check=False,
                          cwd=cwd)
    if done.returncode not in codes:
        raise AssertionError(f"exit code {done.returncode}: {done.stderr.decode()}")
    return done


def with_freecad(code, folder):
    """A shape made with FreeCAD's Part module, as a BREP file."""
    sys.path.append("/usr/lib/freecad-python3/lib")
    import FreeCAD
    import Part

    file = folder / "made.brep"
    code(FreeCAD, Part).exportBrep(str(file))
    return file


@unittest.skipUnless(chromium(), "chromium is not installed")
class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="suture-report-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.page = self.folder / "r.html"

    def browser(self, *size):
        browser = Browser(*size)
        self.addCleanup(browser.close)
        return browser

    def report_of(self, name, *words):
        suture("check", name, "--report", self.page, *words)
        return self.page

    def keep(self, browser, name):
        browser.settle()
        data = browser.screenshot()
        if PICTURES:
            (Path(PICTURES) / name).write_bytes(data)
        return data

    def selected_edge(self, browser):
        return browser.value("document.querySelector('#plot h3')?.textContent ?? ''")

    def camera(self, browser):
        return browser.value("sutureReport.view.camera.position.toArray()")


class Page(Report):
    def test_it_opens_from_disk_and_asks_for_nothing_else(self):
        browser = self.browser()
        browser.open(self.report_of("nacelle.stp"))
        browser.settle()
        outside = [url for url in browser.requests if not url.startswith(("data:", "blob:"))]
        self.assertEqual(outside, [self.page.as_uri()])
        self.assertEqual(browser.errors, [])

    def test_the_model_is_visible(self):
        browser = self.browser()
        browser.open(self.report_of("nist_ctc_05_asme1_rd.stp"))
        browser.settle()
        hidden = "sutureReport.view.models[0].visible = false; sutureReport.view.draw();"
        self.assertGreater(browser.differing_pixels(lambda: browser.value(hidden)), 0.1)

    def test_a_click_on_a_row_moves_the_camera_and_shows_the_plot(self):
        browser = self.browser()
        browser.open(self.report_of("0044_bb_boxblend_03_colored.stp"))
        self.assertEqual(self.selected_edge(browser), "")
        before = self.camera(browser)
        browser.click_on("#table tbody tr[data-row='2']")
        edge = browser.value("document.querySelector(\"#table tr[data-row='2']\").dataset.edge")
        self.assertIn(f"Edge {edge} ", self.selected_edge(browser))
        self.assertEqual(browser.value("document.querySelectorAll('#plot path').length"), 4)
        self.assertNotEqual(self.camera(browser), before)
        self.keep(browser, "report_edge.png")

    def test_a_click_on_an_edge_of_the_model_selects_its_row(self):
        browser = self.browser()
        browser.open(self.report_of("0044_bb_boxblend_03_colored.stp"))
        browser.settle()
        # The middle of every edge on the screen; one that is in front answers to a click.
        points = browser.value("""(() => {
            const v = sutureReport.view, d = v.data, box = v.canvas.getBoundingClientRect(), found = [];
            for (let row = 0; row < d.rows; ++row) {
              const trace = d.trace(row), p = trace[Math.floor(trace.length / 2)].point;
              const q = v.camera.position.clone().set(p[0], p[1], p[2]).project(v.camera);
              found.push([box.x + (0.5 + q.x / 2) * box.width, box.y + (0.5 - q.y / 2) * box.height, d.edge(row)]);
            }
            return found; })()""")
        hits = 0
        for x, y, edge in points[:12]:
            picked = browser.value(f"(() => {{ const b = sutureReport.view.canvas.getBoundingClientRect();"
                                   f"return sutureReport.view.edgeAt({x} - b.x, {y} - b.y); }})()")
            if picked == edge:
                browser.click(x, y)
                self.assertIn(f"Edge {edge} ", self.selected_edge(browser))
                self.assertEqual(browser.value("document.querySelector(\"tr[aria-selected='true']\").dataset.edge"), str(edge))
                hits += 1
                break
        self.assertEqual(hits, 1)

    def test_zebra_and_curvature_change_the_picture(self):
        browser = self.browser()
        browser.open(self.report_of("0044_bb_boxblend_03_colored.stp"))
        browser.settle()
        self.assertGreater(browser.differing_pixels(lambda: browser.click_on("[data-mode='zebra']")), 0.05)
        self.keep(browser, "report_zebra.png")
        self.assertGreater(browser.differing_pixels(lambda: browser.click_on("[data-mode='curvature']")), 0.05)
        self.keep(browser, "report_curvature.png")

    def test_legend_filters_view_and_table(self):
        browser = self.browser()
        browser.open(self.report_of("nist_ctc_05_asme1_rd.stp"))
        browser.settle()
        rows = "sutureReport.table.shown.length"
        every = browser.value(rows)
        sharp = browser.value("sutureReport.scene.byCategory().sharp.length")
        self.assertGreater(sharp, 0)
        changed = browser.differing_pixels(lambda: browser.click_on("#legend input[data-category='sharp']"))
        self.assertGreater(changed, 0.001)
        self.assertEqual(browser.value(rows), every - sharp)

    def test_the_table_sorts_by_every_column(self):
        browser = self.browser()
        browser.open(self.report_of("nacelle.stp"))
        for column, figure in ((1, "edge"), (4, "gap"), (5, "angle"), (8, "length")):
            value = "sutureReport.scene.edge(r)" if figure == "edge" else f"sutureReport.scene.{figure}[r]"
            for direction in (-1, 1):
                browser.click_on(f"#table th:nth-child({column}) button")
                values = browser.value(f"sutureReport.table.shown.map(r => {value})")
                self.assertEqual(values, sorted(values, reverse=direction < 0), (figure, direction))

    def test_keys_do_what_buttons_do(self):
        browser = self.browser()
        browser.open(self.report_of("nacelle.stp"))
        browser.settle()
        browser.key("z")
        self.assertEqual(browser.value("document.querySelector('[data-mode=zebra]').ariaChecked"), "true")
        browser.value("document.querySelector('#table .scroll').focus()")
        browser.key("ArrowDown")
        first = self.selected_edge(browser)
        browser.key("ArrowDown")
        self.assertNotIn(self.selected_edge(browser), ("", first))
        browser.key("Escape")
        self.assertEqual(self.selected_edge(browser), "")

    def test_combs_stand_on_the_selected_edges(self):
        browser = self.browser()
        browser.open(self.report_of("0044_bb_boxblend_03_colored.stp"))
        browser.settle()
        count = "sutureReport.view.combs.children.length"
        self.assertEqual(browser.value(count), 0)
        row = browser.value("(() => { const d = sutureReport.scene; for (let r = 0; r < d.rows; ++r)"
                            "if (d.trace(r).some(p => Math.abs(p.curvature[0]) > 1e-6)) return r; return -1; })()")
        self.assertGreaterEqual(row, 0)
        browser.value(f"sutureReport.table.show({row}, false)")
        self.assertEqual(browser.value(count), 2)
        browser.settle()
        self.assertGreater(browser.differing_pixels(lambda: browser.key("h")), 0.0005)

    def test_light_and_dark_differ(self):
        browser = self.browser()
        browser.open(self.report_of("nacelle.stp"))
        colour = "getComputedStyle(document.body).backgroundColor"
        light = browser.value(colour)
        browser.key("t")
        self.assertNotEqual(browser.value(colour), light)

    def test_it_prints_with_the_whole_table(self):
        browser = self.browser()
        browser.open(self.report_of("nist_ctc_05_asme1_rd.stp"))
        pdf = browser.send("Page.printToPDF", printBackground=True)["data"]
        self.assertGreater(len(pdf), 20000)
        browser.send("Emulation.setEmulatedMedia", media="print")
        browser.value("window.dispatchEvent(new Event('beforeprint'))")
        rows = browser.value("document.querySelectorAll('#table tr[data-row]').length")
        self.assertEqual(rows, min(120, browser.value("sutureReport.scene.rows")))
        width = browser.value("document.documentElement.scrollWidth")
        self.assertEqual(browser.value("Array.from(document.querySelectorAll('table')).filter("
                                       f"t => t.getBoundingClientRect().right > {width} + 1).length"), 0)
        self.assertLessEqual(browser.value("document.body.scrollWidth"), width)
        self.assertEqual(browser.value("getComputedStyle(document.querySelector('#table thead')).display"),
                         "table-header-group")
        self.assertEqual(browser.value("getComputedStyle(document.querySelector('#table thead th')).position"), "static")
        self.assertEqual(browser.value("getComputedStyle(document.getElementById('toolbar')).display"), "none")

    def test_names_of_files_are_text_in_the_page(self):
        part = self.folder / "a<img src=x onerror='window.broken=1'>.stp"
        part.write_bytes((FILES / "ubend2.stp").read_bytes())
        suture("check", part, "--report", self.page)
        browser = self.browser()
        browser.open(self.page)
        self.assertIsNone(browser.value("window.broken"))
        self.assertIn("<img", browser.value("document.title"))


class Sizes(Report):
    def test_a_model_of_500_faces_is_small_and_soon_there(self):
        self.report_of("nist_ctc_04_asme1_rd.stp")
        self.assertLess(self.page.stat().st_size, 8e6)
        browser = self.browser()
        browser.count_cpu_seconds()
        browser.open(self.page)
        browser.click_on("#table tbody tr[data-row='0']")
        self.assertIn("Edge ", self.selected_edge(browser))
        # Of the page's thread, so that a busy machine does not count: until a click was answered.
        self.assertLess(browser.cpu_seconds(), 3.0)
        self.assertEqual(browser.value("sutureReport.scene.models[0].first.length - 1"), 518)
        self.keep(browser, "report.png")

    def test_fifty_thousand_faces_are_handled(self):
        boxes = with_freecad(
            lambda app, part: part.makeCompound(
                [part.makeBox(8, 9, 7, app.Vector(10 * (i % 92), 10 * (i // 92), 0)) for i in range(8400)]),
            self.folder)
        suture("check", boxes, "--no-sew", "--report", self.page)
        browser = self.browser()
        browser.count_cpu_seconds()
        browser.open(self.page, limit=400)
        self.assertEqual(browser.value("sutureReport.scene.models[0].first.length - 1"), 50400)
        self.assertEqual(browser.value("sutureReport.scene.rows"), 100800)
        begun = browser.cpu_seconds()
        browser.value("document.querySelector('#table .scroll').focus()")
        browser.key("End")
        self.assertEqual(browser.value("sutureReport.table.current"), 100799)
        self.assertIn("Edge ", browser.value("document.getElementById('plot').textContent"))
        # Of the page's thread, so that a busy machine does not count.
        self.assertLess(browser.cpu_seconds() - begun, 5.0)
        self.assertLess(browser.value("document.querySelectorAll('#table tr').length"), 100)

    def test_a_model_without_edges_between_faces_is_handled(self):
        plane = with_freecad(lambda app, part: part.makePlane(10, 10), self.folder)
        suture("check", plane, "--report", self.page)
        browser = self.browser()
        browser.open(self.page)
        browser.settle()
        self.assertEqual(browser.errors, [])
        self.assertIn("no edge", browser.value("document.querySelector('#table .count').textContent"))
        hidden = "sutureReport.view.models[0].visible = false; sutureReport.view.draw();"
        self.assertGreater(browser.differing_pixels(lambda: browser.value(hidden)), 0.1)


class Fills(Report):
    def test_before_and_after_can_be_compared(self):
        shutil.copy(SOURCE / "docs/examples/suitcase_corner.step", self.folder)
        suture("fill", "suitcase_corner.step", "-o", "filled.step", "--report", "r.html", cwd=self.folder)
        browser = self.browser()
        browser.open(self.page)
        browser.settle()
        self.keep(browser, "report_fill.png")
        self.assertEqual(browser.value("sutureReport.scene.newFaces.size"), 1)
        self.assertGreater(browser.differing_pixels(lambda: browser.key("n")), 0.003)
        self.assertGreater(browser.differing_pixels(lambda: browser.key("b")), 0.003)
        self.assertIn("<table>", self.page.read_text())  # the holes


class Pictures(Report):
    def shoot(self, *words):
        png = self.folder / "p.png"
        suture("check", FILES / "0044_bb_boxblend_03_colored.stp", "--picture", png, *words)
        data = png.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()), ["p.png"])
        return data, struct.unpack(">II", data[16:24])

    def test_pictures_have_the_size_and_the_view_that_were_asked_for(self):
        iso, size = self.shoot("--picture-size", "640x480")
        self.assertEqual(size, (640, 480))
        top, _ = self.shoot("--picture-size", "640x480", "--view", "top")
        zebra, _ = self.shoot("--picture-size", "640x480", "--shading", "zebra")
        self.assertEqual(len({iso, top, zebra}), 3)
        self.assertGreater(len(iso), 8000)  # more than a white sheet

    def test_words_that_make_no_picture_are_refused(self):
        for words in (["--picture", "p.jpg"], ["--picture", "p.png", "--view", "nowhere"],
                      ["--picture", "p.png", "--picture-size", "12"], ["--picture", "p.png", "--shading", "x"]):
            suture("check", FILES / "nacelle.stp", *words, codes=(1,))

    def test_a_browser_that_fails_is_named(self):
        done = subprocess.run(
            [PROGRAM, "check", str(FILES / "nacelle.stp"), "--picture", str(self.folder / "p.png")],
            env={**os.environ, "SUTURE_BROWSER": "/bin/false"}, capture_output=True, check=False)
        self.assertEqual(done.returncode, 5)
        self.assertIn(b"/bin/false", done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
