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
            lambda app, part: part.Compound(
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


class Holes(Report):
    """The page of inspect, and of a fill: where is my hole?"""

    TABLE = "document.querySelectorAll('#holes tr[data-hole]')"

    def page_of_two_holes(self):
        """A plate with two square holes in its top, which is a shell of nine faces without two."""
        made = with_freecad(
            lambda app, part: part.makeShell(
                part.makeBox(100, 40, 10).cut(part.makeBox(20, 20, 4, app.Vector(10, 10, 6)))
                .cut(part.makeBox(12, 12, 4, app.Vector(70, 14, 6))).Faces), self.folder)
        holed = with_freecad(
            lambda app, part: part.makeShell(
                [f for f in part.read(str(made)).Faces
                 if not (abs(f.CenterOfMass.z - 6) < 1e-6 and f.Area < 500)]), self.folder)
        suture("inspect", holed, "--report", self.page)
        return self.page

    def test_inspect_numbers_the_holes_in_3d_and_opens_at_them(self):
        browser = self.browser()
        browser.open(self.page_of_two_holes())
        browser.settle()
        self.keep(browser, "report_inspect.png")
        self.assertEqual(browser.errors, [])
        self.assertEqual(browser.value(f"{self.TABLE}.length"), 2)
        pins = browser.value("Array.from(document.querySelectorAll('.pin.hole:not([hidden])')).map(p => p.textContent)")
        self.assertEqual(sorted(pins), ["1", "2"])
        for hole in browser.value("sutureReport.holes.map(h => [h.diameter, h.centre, h.edges.length, h.out])"):
            side = 20 if hole[1][0] < 50 else 12
            self.assertAlmostEqual(hole[0], side * 2 ** 0.5, places=4)
            self.assertAlmostEqual(hole[1][2], 6, places=5)
            self.assertEqual(hole[2], 4)
            self.assertAlmostEqual(abs(hole[3][2]), 1, places=6)
        self.assertEqual(browser.value("sutureReport.view.borders.children.length"), 2)
        self.assertGreater(browser.differing_pixels(lambda: browser.value(
            "sutureReport.view.borders.visible = false; sutureReport.view.draw();")), 0.001)

    def test_a_hole_is_seen_from_the_side_to_which_its_neighbours_look(self):
        def pocket(app, part):  # deep, with a round edge at the bottom, whose floor is gone
            body = part.makeBox(60, 60, 100).cut(part.makeBox(40, 40, 80, app.Vector(10, 10, 20)))
            low = [e for e in body.Edges if all(abs(v.Z - 20) < 1e-6 for v in e.Vertexes)]
            faces = body.makeFillet(5, low).Faces
            return part.makeShell([f for f in faces if abs(f.CenterOfMass.z - 20) > 1e-6])

        suture("inspect", with_freecad(pocket, self.folder), "--report", self.page)
        browser = self.browser()
        browser.open(self.page)
        out = browser.value("sutureReport.holes[0].out")
        self.assertGreater(out[2], 0.99)  # away from the middle of the body would be downwards

    def test_a_click_on_a_hole_anywhere_moves_to_it(self):
        browser = self.browser()
        browser.open(self.page_of_two_holes())
        browser.settle()
        chosen = "Array.from(document.querySelectorAll('#holes tr')).findIndex(r => r.ariaSelected === 'true')"
        target = "sutureReport.view.controls.target.toArray()"
        for click, row in (("#holes tr[data-hole='2']", 2), (".pin.hole", 1)):
            browser.key("f")
            browser.settle()
            before = browser.value(target)
            browser.click_on(click)
            browser.settle()
            self.assertEqual(browser.value(chosen), row)
            self.assertNotEqual(browser.value(target), before)
            centre = browser.value(f"sutureReport.holes[{row - 1}].centre")
            for have, want in zip(browser.value(target), centre):
                self.assertAlmostEqual(have, want, places=3)
        browser.value("document.querySelector('#report tbody td button').click()")  # of the table below
        self.assertEqual(browser.value(chosen), 1)
        browser.key("o")
        self.assertEqual(browser.value(chosen), 2)

    def test_a_fill_opens_at_the_new_face_and_lists_its_edges(self):
        shutil.copy(SOURCE / "docs/examples/suitcase_corner.step", self.folder)
        suture("fill", "suitcase_corner.step", "-o", "filled.step", "--report", "r.html", cwd=self.folder)
        browser = self.browser()
        browser.open(self.page)
        browser.settle()
        self.assertEqual(browser.value("sutureReport.table.shown.length"), 3)
        self.assertTrue(browser.value("sutureReport.table.shown.every(row => sutureReport.scene.isNew(row))"))
        distance = browser.value("sutureReport.view.camera.position.distanceTo(sutureReport.view.controls.target)")
        browser.key("f")
        browser.settle()
        self.assertGreater(browser.value(
            "sutureReport.view.camera.position.distanceTo(sutureReport.view.controls.target)"), 2 * distance)
        self.assertEqual(browser.value("document.getElementById('before').textContent"), "Show before")
        browser.key("b")
        self.assertEqual(browser.value("document.getElementById('before').textContent"), "Show after")
        self.assertEqual(browser.value("sutureReport.view.borders.children.length"), 2)
        self.keep(browser, "report_before.png")
        browser.key("b")
        browser.value("sutureReport.table.show(sutureReport.table.shown[0], false)")
        self.assertEqual(browser.value("document.querySelector('#holes tr[aria-selected=true]').dataset.hole"), "1")

    def test_a_fill_marks_the_worst_points_of_its_new_face_alone(self):
        suture("fill", FILES.parent / "reopened/R31_cyl9_basemount.open.step", "-o", self.folder / "filled.step",
               "--report", self.page)
        browser = self.browser()
        browser.open(self.page)
        near = "Array.from(sutureReport.scene.near).filter((near, row) => near === 1 && {}).length"
        new = browser.value(near.format("sutureReport.scene.isNew(row)"))
        self.assertGreater(browser.value(near.format("true")), new)
        self.assertEqual(browser.value("sutureReport.view.markers.geometry.attributes.position.count"), new)


class Tools(Report):
    def open(self, name="nist_ctc_05_asme1_rd.stp", *words):
        browser = self.browser()
        browser.open(self.report_of(name, *words))
        browser.settle()
        return browser

    def choose(self, browser, selector, value):
        browser.value(f"(() => {{ const e = document.querySelector({selector!r}); e.value = {value!r};"
                      "e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); })()")
        browser.settle()

    def test_edges_are_found_and_filtered(self):
        browser = self.open()
        shown = "sutureReport.table.shown.map(r => sutureReport.scene.edge(r))"
        near = browser.value("sutureReport.scene.near.reduce((n, x) => n + (x > 0), 0)")
        self.choose(browser, "#table .which", "failing")
        self.assertEqual(len(browser.value(shown)), near)
        self.choose(browser, "#table .which", "all")
        self.choose(browser, "#table .find", "101")
        self.assertEqual(browser.value(shown), [101])
        self.choose(browser, "#table .find", "f16")
        found = browser.value("sutureReport.table.shown.map(r => sutureReport.scene.faces(r))")
        self.assertGreater(len(found), 1)
        self.assertTrue(all(16 in faces for faces in found))
        row = browser.value("sutureReport.scene.rows") - 1
        browser.value(f"sutureReport.table.show({row}, false)")  # chosen in the view: the filter must not hide it
        browser.settle()
        self.assertTrue(browser.value("(() => { const r = document.querySelector('#table tr[aria-selected=true]').getBoundingClientRect();"
                                      "return r.top > 0 && r.bottom <= innerHeight; })()"))

    def test_other_limits_give_the_classes_that_the_program_gives(self):
        for limits in ({"g0": 1e-5, "g1": 1e-3, "g2": 0.5, "sharp": 20}, {"g0": 0.1, "g1": 1, "g2": 50, "sharp": 4}):
            words = [f"--{key}={value}" for key, value in limits.items()]
            asked = self.open("nist_ctc_05_asme1_rd.stp", *words)
            by_edge = ("Object.fromEntries(Array.from({length: sutureReport.scene.rows}, (_, r) => "
                       "[sutureReport.scene.edge(r), [sutureReport.scene.className(r), sutureReport.scene.near[r]]]))")
            expected = asked.value(by_edge)
            browser = self.open("nist_ctc_05_asme1_rd.stp")
            self.assertNotEqual(browser.value(by_edge), expected)
            for key, value in limits.items():
                self.choose(browser, f"#limits [name={key}]", str(value))
            self.assertEqual(browser.value(by_edge), expected, limits)
            counts = browser.value("Object.fromEntries(Array.from(document.querySelectorAll('#legend input')).map("
                                   "i => [i.dataset.category, Number(i.parentElement.querySelector('b').textContent)]))")
            for category, count in counts.items():
                self.assertEqual(browser.value(f"sutureReport.scene.byCategory().{category}.length"), count)
            browser.click_on("#limits button")
            browser.settle()
            self.assertEqual(browser.value("sutureReport.scene.limits.g1"), 0.01)

    def test_the_legend_adds_up_to_the_verdict(self):
        browser = self.open()
        verdict = browser.value("document.querySelector('.verdict').textContent")
        sharp = browser.value("document.querySelector('[data-category=sharp]').parentElement.textContent")
        numbers = [int(word) for word in sharp.replace("+", " ").split() if word.isdigit()]
        self.assertEqual(len(numbers), 2)
        self.assertIn(f"{sum(numbers)} sharp", verdict)

    def test_deviation_is_drawn_with_its_figures(self):
        browser = self.open()
        pins = "document.querySelectorAll('.pin.deviation')"
        self.assertEqual(browser.value(f"{pins}.length"), 0)
        self.assertGreater(browser.differing_pixels(lambda: self.choose(browser, "#deviation", "angle")), 0.0005)
        texts = browser.value(f"Array.from({pins}).map(p => [p.textContent, p.className])")
        self.assertEqual(len(texts), 12)
        values = [float(text.rstrip("°")) for text, _ in texts]
        self.assertEqual(values, sorted(values, reverse=True))
        for value, (_, name) in zip(values, texts):
            self.assertIn("bad" if value > 0.01 else "good", name)
        segments = browser.value("sutureReport.view.hairs.children.map(c => c.geometry.instanceCount)")
        self.assertEqual(len(segments), 2)
        self.keep(browser, "report_deviation.png")
        places = browser.value(
            f"Array.from({pins}).filter(p => !p.hidden).map(p => p.getBoundingClientRect())"
            ".map(b => [b.x + b.width / 2, b.y + b.height / 2])")
        self.assertGreater(len(places), 0)
        for i, (x, y) in enumerate(places):
            for a, b in places[:i]:
                self.assertFalse(abs(a - x) < 79 and abs(b - y) < 19, "two figures lie on each other")
        browser.key("d")
        self.assertEqual(browser.value(f"{pins}.length"), 0)

    def test_a_section_cuts_faces_and_edges(self):
        browser = self.open()
        changed = browser.differing_pixels(lambda: self.choose(browser, "#section", "x"))
        self.assertGreater(changed, 0.01)
        self.keep(browser, "report_section.png")
        half = browser.value("(() => { const v = sutureReport.view, d = v.data; let n = 0; for (let r = 0; r < d.rows; ++r) {"
                             "const p = d.trace(r)[0]?.point; if (p && v.isCut({x: p[0], y: p[1], z: p[2]})) ++n; } return n; })()")
        self.assertGreater(half, 100)
        self.choose(browser, "#section-at", "100")
        self.assertLess(browser.value("sutureReport.view.box.max.x - sutureReport.view.plane.constant"), 1e-4)
        browser.click_on("#section-flip")
        self.assertFalse(browser.value("sutureReport.view.isCut(sutureReport.view.box.max)"))
        browser.key("x")
        self.assertFalse(browser.value("sutureReport.view.cutting"))

    def test_the_range_of_the_map_goes_by_area(self):
        def rounded(app, part):  # a large cylinder, and a tiny fillet with many points
            cylinder = part.makeCylinder(50, 100)
            return cylinder.makeFillet(0.05, [cylinder.Edges[0]])

        made = with_freecad(rounded, self.folder)
        browser = self.open(made)
        browser.click_on("[data-mode='curvature']")
        browser.settle()
        self.choose(browser, "#measure", "largest")
        self.assertAlmostEqual(browser.value("sutureReport.view.material.uniforms.range.value"), 1 / 50, places=5)
        self.choose(browser, "#range", "100")
        self.assertAlmostEqual(browser.value("sutureReport.view.material.uniforms.range.value"), 1 / 0.05, places=2)

    def test_a_singular_point_does_not_flatten_the_plot(self):
        browser = self.open("0044_bb_boxblend_03_colored.stp")
        browser.value("sutureReport.table.show(0, false)")
        height = ("(() => { const ys = (document.querySelectorAll('#plot path.one')[0].getAttribute('d')"
                  ".match(/ -?[\\d.]+/g) ?? []).map(Number); return Math.max(...ys) - Math.min(...ys); })()")
        # The course of a smooth edge, and the same with one point that is singular.
        browser.value("(() => { const s = sutureReport.scene, old = s.trace.bind(s); s.trace = (row) => old(row).map((p, i) => "
                      "({ ...p, curvature: [0.1 + 0.01 * i, 0.2] })); sutureReport.table.show(0, false); })()")
        smooth = browser.value(height)
        self.assertGreater(smooth, 20)
        browser.value("(() => { const s = sutureReport.scene, old = s.trace; s.trace = (row) => old(row).map((p, i) => "
                      "(i === 5 ? { ...p, curvature: [3.4e15, 0.2] } : p)); sutureReport.table.show(0, false); })()")
        self.assertGreater(browser.value(height), 0.5 * smooth)
        self.assertIn("reaches 3.40e15", browser.value("document.querySelector('#plot .clipped').textContent"))

    def test_parts_can_be_hidden(self):
        made = with_freecad(
            lambda app, part: part.Compound([part.makeBox(10, 10, 10), part.makeCylinder(5, 20, app.Vector(30, 0, 0))]),
            self.folder)
        step = self.folder / "two.step"
        sys.path.append("/usr/lib/freecad-python3/lib")
        import FreeCAD
        import Import

        document = FreeCAD.newDocument("two")
        import Part
        for i, solid in enumerate(Part.read(str(made)).Solids):
            document.addObject("Part::Feature", f"Body{i}").Shape = solid
        Import.export(document.Objects, str(step))
        browser = self.open(step)
        boxes = browser.value("document.querySelectorAll('#parts input').length")
        self.assertGreaterEqual(boxes, 2)
        triangles = "sutureReport.view.models[0].geometry.index.count"
        every = browser.value(triangles)
        self.assertGreater(browser.differing_pixels(lambda: browser.value(
            "Array.from(document.querySelectorAll('#parts label')).find(l => l.textContent.includes('Body0')).querySelector('input').click()")), 0.01)
        self.assertEqual(browser.value(triangles), every - 36)  # a box has 12 triangles
        self.assertEqual(browser.value("sutureReport.view.hiddenEdges.size"), 12)

    def test_everything_that_can_be_used_has_a_name(self):
        browser = self.open("nacelle.stp")
        self.assertEqual(browser.value(
            "Array.from(document.querySelectorAll('button, input, select, canvas, [role=region], section[aria-label]')).filter(e => "
            "!(e.ariaLabel || e.textContent.trim() || e.labels?.length || e.title)).map(e => e.outerHTML)"), [])


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
