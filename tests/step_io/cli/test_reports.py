"""What inspect, fill and check say: JSON documents, tables, HTML reports, progress."""

import json
import math
import os
import pty
import re
import subprocess
import sys

from program import (
    CAD,
    DONE,
    NOTHING,
    OUT_OF_TOLERANCE,
    PROGRAM,
    USAGE,
    Case,
    example,
    run,
    write_many_holes,
)
from time_limits import limit

HOLES = {
    "box_without_lid": [4],
    "suitcase_corner": [3],
    "pipe_elbow": [1, 1],
    "dome_window": [11],  # the sphere's seam cuts one side of the star in two
    "bump_window": [12],
}


class Inspect(Case):
    def test_holes_of_the_examples(self):
        for name, sides in HOLES.items():
            document = self.expect(run("inspect", example(name), "--json"), DONE).json
            holes = [h for h in document["holes"] if h["kind"] == "hole"]
            self.assertEqual([h["sides"] for h in holes], sides, name)
            self.assertEqual(document["hole_count"], len(sides))

    def test_loops_around_one_missing_face_are_named_together(self):
        # The lid of a box with a hole bored through it: its outline, and the bore's end.
        sys.path.append("/usr/lib/freecad-python3/lib")
        import FreeCAD
        import Part

        bore = Part.makeCylinder(3, 40, FreeCAD.Vector(5, 10, -5))
        faces = Part.makeBox(10, 20, 30).cut(bore).Faces
        box = self.folder / "box.brep"
        Part.Shell([face for face in faces if face.CenterOfMass.z < 29]).exportBrep(str(box))
        self.assertIn("bound one missing face", self.expect(run("inspect", box), DONE).out)
        holes = self.expect(run("inspect", box, "--json"), DONE).json
        self.assertEqual([h["islands_with"] for h in holes["holes"]], [[2], [1]])
        self.assertEqual(len(holes["notes"]), 1)

    def test_byte_order_mark_in_front_of_a_step_file_is_no_damage(self):
        marked = self.folder / "marked.step"
        marked.write_bytes(b"\xef\xbb\xbf" + example("pipe_elbow").read_bytes())
        self.assertEqual(self.expect(run("inspect", marked, "--json"), DONE).json["hole_count"], 2)
        self.expect(run("fill", marked, "-o", self.folder / "filled.step"), DONE)

    def test_groups_of_loose_faces_are_sewn_each_by_itself(self):
        # Wings and fin are closed; the sheets in their middle, one or two faces each, have rims.
        aircraft = CAD / "files" / "777-200LR.stp"
        if not aircraft.exists():
            self.skipTest(f"needs {aircraft}")
        document = self.expect(run("inspect", aircraft, "--json"), NOTHING).json
        self.assertEqual(
            sorted((h["kind"], h["sides"]) for h in document["holes"]), [("rim", 4), ("rim", 6), ("rim", 6)]
        )

    def test_document_has_every_promised_key(self):
        document = run("inspect", example("suitcase_corner"), "--json").json
        self.assertEqual(document["schema"], 3)
        self.assertEqual(document["command"], "inspect")
        hole = document["holes"][0]
        for key in ("id", "kind", "sides", "edges", "faces", "diameter", "length", "planar", "corners"):
            self.assertIn(key, hole)
        self.assertEqual(len(hole["edges"]), hole["sides"])
        self.assertEqual(len(hole["faces"]), hole["sides"])
        self.assertEqual(len(hole["corners"]), hole["sides"])
        for corner in hole["corners"]:
            self.assertEqual(set(corner) & {"point", "angle_deg", "normal_mismatch_deg"},
                             {"point", "angle_deg", "normal_mismatch_deg"})

    def test_figures_of_the_suitcase_corner_are_those_of_an_eighth_of_a_sphere(self):
        hole = run("inspect", example("suitcase_corner"), "--json").json["holes"][0]
        radius = 8
        self.assertAlmostEqual(hole["length"], 3 * radius * math.pi / 2, places=6)
        self.assertAlmostEqual(hole["diameter"], radius * math.sqrt(3), delta=0.01)
        self.assertFalse(hole["planar"])
        for corner in hole["corners"]:
            self.assertAlmostEqual(corner["angle_deg"], 90, places=4)
            self.assertAlmostEqual(corner["normal_mismatch_deg"], 0, places=4)

    def test_corners_of_a_box_disagree_by_90_degrees(self):
        hole = run("inspect", example("box_without_lid"), "--json").json["holes"][0]
        self.assertTrue(hole["planar"])
        self.assertAlmostEqual(hole["diameter"], math.hypot(60, 40), places=6)
        for corner in hole["corners"]:
            self.assertAlmostEqual(corner["normal_mismatch_deg"], 90, places=4)
            self.assertAlmostEqual(corner["point"][2], 25, places=6)

    def test_table_for_readers_ends_with_the_verdict(self):
        finished = self.expect(run("inspect", example("pipe_elbow")), DONE)
        self.assertEqual(finished.out.splitlines()[-1], "2 holes")
        self.assertEqual(finished.err, "")

    def test_closed_model_has_no_hole(self):
        closed = self.folder / "closed.step"
        run("fill", example("box_without_lid"), "-o", closed)
        finished = self.expect(run("inspect", closed, "--json"), NOTHING)
        self.assertEqual(finished.json["holes"], [])


class Fill(Case):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "out.step"

    def fill(self, name, *words, code=DONE):
        finished = run("fill", example(name), "-o", self.output, "--json", *words)
        return self.expect(finished, code).json

    def test_document_has_every_promised_key(self):
        document = self.fill("suitcase_corner")
        for key in ("closed", "valid", "free_edges", "seconds", "holes", "measured_on"):
            self.assertIn(key, document)
        self.assertLessEqual({"read", "detect", "fill", "sew", "check", "write"},
                             set(document["seconds"]))
        hole = document["holes"][0]
        for key in ("id", "sides", "status", "method_requested", "method_used",
                    "continuity_requested", "continuity_reached", "max_gap", "max_angle_deg",
                    "max_curvature_mismatch", "patches", "seconds", "reason"):
            self.assertIn(key, hole)
        for key in ("degree_u", "degree_v", "poles_u", "poles_v", "rational", "exact", "fit_error"):
            self.assertIn(key, hole["patches"][0])

    def test_every_example_is_closed_by_auto(self):
        for name in HOLES:
            finished = run("fill", example(name), "-o", self.output, "--json")
            self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE), str(finished))
            document = finished.json
            self.assertTrue(document["closed"], name)
            self.assertTrue(document["valid"], name)
            self.assertEqual(document["free_edges"], 0)
            self.assertEqual(document["solids"], 1)
            self.assertGreater(run("check", self.output, "--json").json["shape"]["volume"], 0)
            self.assertEqual(document["measured_on"], "new faces")

    def test_lid_of_the_box_is_a_plane_and_the_volume_is_exact(self):
        document = self.fill("box_without_lid")
        volume = run("check", self.output, "--json").json["shape"]["volume"]
        self.assertAlmostEqual(volume, 60 * 40 * 25, delta=1e-6)
        self.assertEqual(document["holes"][0]["method_used"], "plane")

    def test_figures_are_those_that_check_measures_on_the_written_file(self):
        hole = self.fill("suitcase_corner")["holes"][0]
        edges = run("check", self.output, "--json").json["edges"]
        new_face = hole["patches"][0]["face"]
        around = [e for e in edges if new_face in e["faces"]]
        self.assertEqual(len(around), 3)
        self.assertAlmostEqual(hole["max_gap"], max(e["max_gap"] for e in around), delta=1e-9)
        self.assertAlmostEqual(hole["max_angle_deg"], max(e["max_angle_deg"] for e in around),
                               delta=1e-9)
        sides = {round(s["max_gap"], 12) for s in hole["edges"]}
        self.assertEqual(sides, {round(e["max_gap"], 12) for e in around})

    def test_only_the_named_hole_is_filled(self):
        document = self.fill("pipe_elbow", "--hole", "2")
        status = {hole["id"]: hole["status"] for hole in document["holes"]}
        self.assertEqual(status, {1: "skipped", 2: "filled"})
        self.assertFalse(document["closed"])
        self.assertEqual(document["free_edges"], 1)

    def test_hole_named_by_an_edge_is_filled(self):
        holes = run("inspect", example("pipe_elbow"), "--json").json["holes"]
        document = self.fill("pipe_elbow", "--edges", holes[1]["edges"][0])
        filled = [h["id"] for h in document["holes"] if h["status"] == "filled"]
        self.assertEqual(filled, [holes[1]["id"]])

    def test_refused_hole_is_written_open_and_told(self):
        document = self.fill("bump_window", "--method", "plane", code=OUT_OF_TOLERANCE)
        hole = document["holes"][0]
        self.assertEqual(hole["status"], "refused")
        self.assertTrue(hole["reason"])
        self.assertIsNone(hole["max_gap"])
        self.assertEqual(hole["sides"], 12)
        self.assertFalse(document["closed"])
        self.assertEqual(run("inspect", self.output, "--json").json["hole_count"], 1)

    def test_fill_out_of_tolerance_is_written_and_told(self):
        document = self.fill("bump_window", "--method", "occt", "--angle", "1e-9", "--occt-timeout", limit(60),
                             code=OUT_OF_TOLERANCE)
        self.assertEqual(document["holes"][0]["status"], "filled")
        self.assertFalse(document["holes"][0]["within_tolerance"])
        self.assertTrue(self.output.exists())

    def test_a_cap_that_lies_on_the_sheet_that_it_closes_stays_out(self):
        # The outline of a flat sheet, two sides of which lie on edges of the body around it.
        wing = CAD / "files" / "simple_wing.stp"
        if not wing.exists():
            self.skipTest(f"needs {wing}")
        words = ["-o", self.output, "--method", "plane", "--all-loops", "--continuity", "G0", "--json"]
        hole = self.expect(run("fill", wing, *words), OUT_OF_TOLERANCE).json["holes"][0]
        self.assertEqual([side["max_angle_deg"] for side in hole["edges"]], [180.0] * 4)
        self.assertEqual((hole["status"], hole["severity"]), ("refused", "bad"))
        self.assertEqual(hole["findings"][0]["kind"], "lies_on_face")
        kept = self.expect(run("fill", wing, *words, "--keep-bad"), OUT_OF_TOLERANCE).json["holes"][0]
        self.assertEqual(kept["status"], "filled")
        # Not the edges of the body, which are in the same place.
        self.assertEqual([side["max_angle_deg"] for side in kept["edges"]], [180.0] * 4)

    def test_g0_judges_the_gap_only(self):
        document = self.fill("box_without_lid", "--continuity", "G0")
        self.assertEqual(document["holes"][0]["continuity_requested"], "G0")
        self.assertTrue(document["holes"][0]["within_tolerance"])

    def test_the_new_face_passes_through_given_points_and_edges(self):
        points = self.folder / "points.csv"
        points.write_text("x,y,z\n# the middle of the lid\n30, 20; 28\n")
        document = self.fill("box_without_lid", "--continuity", "G0", "--through", points)
        hole = document["holes"][0]
        self.assertEqual(hole["method_used"], "mvs")
        self.assertEqual(hole["points_through"], 1)
        self.assertLess(hole["max_distance_through"], 1e-3)
        self.assertTrue(document["valid"])
        # A lid alone misses the point by its height.
        flat = self.fill("box_without_lid", "--continuity", "G0", "--through", points, "--method",
                         "plane", code=OUT_OF_TOLERANCE)["holes"][0]
        self.assertAlmostEqual(flat["max_distance_through"], 3.0, places=9)
        along = self.fill("box_without_lid", "--continuity", "G0", "--through-edges", 4)["holes"][0]
        self.assertEqual(along["points_through"], 25)

    def test_points_to_pass_are_refused_by_line_file_and_edge(self):
        points = self.folder / "points.csv"
        points.write_text("1,2,3\n1,2\n")
        for words, text in ((("--through", points), "line 2 of"),
                            (("--through", self.folder / "none.csv"), "does not exist"),
                            (("--through-edges", 999), "there is no edge 999")):
            finished = run("fill", example("box_without_lid"), "-o", self.output, *words)
            self.assertEqual(finished.code, USAGE, str(finished))
            self.assertIn(text, finished.err)
            self.assertFalse(self.output.exists())

    def test_mesh_output_is_measured_in_memory_and_says_so(self):
        self.output = self.folder / "out.stl"
        document = self.fill("box_without_lid")
        self.assertEqual(document["measured_on"], "memory")
        self.assertTrue(document["closed"])
        # 84 bytes of head, 50 per triangle; a box has 12 triangles.
        self.assertEqual(self.output.stat().st_size, 84 + 12 * 50)

    def test_reports_are_written_beside_the_output(self):
        html, js = self.folder / "r.html", self.folder / "r.json"
        document = self.fill("suitcase_corner", "--report", html, "--report", js)
        self.assertEqual(json.loads(js.read_text()), document)
        page = html.read_text()
        self.assertIn("<table>", page)
        self.assertIn("suitcase_corner.step", page)
        self.assertNotRegex(page, r"(src|href)=")  # self-contained
        self.expect_files("out.step", "r.html", "r.json")

    def test_table_for_readers(self):
        finished = self.expect(run("fill", example("pipe_elbow"), "-o", self.output), DONE)
        self.assertIn("filled 2 of 2 holes", finished.out.splitlines()[-1])
        self.assertEqual(finished.err, "")


class ManyParts(Case):
    def test_hole_numbers_count_through_the_whole_model(self):
        many = write_many_holes(self.folder, 3)
        holes = self.expect(run("inspect", many, "--json"), DONE).json["holes"]
        self.assertEqual([h["id"] for h in holes], [1, 2, 3])
        edges = [edge for h in holes for edge in h["edges"]]
        self.assertEqual(len(set(edges)), 9)
        for i, hole in enumerate(holes):
            for corner in hole["corners"]:
                self.assertAlmostEqual(corner["point"][0], 100 * i + 56, delta=4.001)

    def test_one_hole_of_many_parts_is_filled(self):
        many = write_many_holes(self.folder, 3)
        output = self.folder / "out.step"
        finished = run("fill", many, "-o", output, "--hole", "2", "--json")
        document = self.expect(finished, DONE).json
        status = {hole["id"]: hole["status"] for hole in document["holes"]}
        self.assertEqual(status, {1: "skipped", 2: "filled", 3: "skipped"})
        self.assertEqual(document["free_edges"], 6)
        left = run("inspect", output, "--json").json["holes"]
        for hole in left:
            self.assertTrue(all(not 100 <= c["point"][0] <= 160 for c in hole["corners"]), hole)


class Check(Case):
    def test_box_has_sharp_edges_only_and_passes(self):
        document = self.expect(run("check", example("box_without_lid"), "--json"), DONE).json
        self.assertEqual({e["class"] for e in document["edges"]}, {"sharp"})
        self.assertEqual(len(document["summary"]["free_edges"]), 4)
        for key in ("edge", "faces", "class", "max_gap", "max_angle_deg", "curvature_mismatch", "at"):
            self.assertIn(key, document["edges"][0])
        for edge in document["edges"]:
            self.assertAlmostEqual(edge["max_angle_deg"], 90, places=6)

    def test_near_miss_is_exit_code_4(self):
        sharp = self.expect(run("check", example("box_without_lid")), DONE)
        self.assertIn("8 sharp", sharp.out)
        finished = self.expect(
            run("check", example("box_without_lid"), "--sharp", "100", "--json"), OUT_OF_TOLERANCE
        )
        self.assertEqual(finished.json["summary"]["near_misses"], 8)

    def test_only_the_named_edges_are_measured(self):
        edges = [e["edge"] for e in run("check", example("suitcase_corner"), "--json").json["edges"]]
        wanted = edges[1:3]
        document = run("check", example("suitcase_corner"), "--json", "--edges", *wanted).json
        self.assertEqual([e["edge"] for e in document["edges"]], wanted)

    def test_edge_that_does_not_exist(self):
        self.expect_refused(run("check", example("box_without_lid"), "--edges", "999"), 1, "999")

    def test_limits_come_from_profile_and_flags(self):
        document = run("check", example("box_without_lid"), "--profile", "vda4955", "--g1", "0.5",
                       "--json").json
        self.assertAlmostEqual(document["profile"]["g0_mm"], 0.02)
        self.assertAlmostEqual(document["profile"]["g1_deg"], 0.5)
        self.assertAlmostEqual(document["profile"]["g2_percent"], 10)


class Convert(Case):
    def test_round_trip_through_every_format_keeps_the_faces(self):
        source = example("suitcase_corner")
        for ending in ("step", "brep", "iges"):
            target = self.folder / f"out.{ending}"
            self.expect(run("convert", source, target), DONE)
            back = self.folder / f"back-{ending}.step"
            self.expect(run("convert", target, back, "--sew"), DONE)
            holes = self.expect(run("inspect", back, "--json"), DONE).json["holes"]
            self.assertEqual([h["sides"] for h in holes if h["kind"] == "hole"], [3], ending)

    def test_loose_faces_that_close_become_a_solid(self):
        loose = CAD / "files" / "ANC101-ill.stp"
        if not loose.exists():
            self.skipTest(f"needs {loose}")
        for words in (["convert", loose, "", "--sew"], ["fill", loose, "-o", ""]):
            for ending in ("step", "brep"):
                target = self.folder / f"{words[0]}.{ending}"
                self.expect(run(*(word or target for word in words)), DONE)
                shape = run("check", target, "--json").json["shape"]
                self.assertEqual((shape["solids"], shape["free_edges"]), (1, 0), target.name)
                self.assertTrue(shape["valid"], target.name)
                self.assertGreater(shape["volume"], 0, target.name)

    def test_finer_deflection_gives_more_triangles(self):
        sizes = []
        for deflection in ("1", "0.1", "0.01"):
            target = self.folder / "out.stl"
            self.expect(run("convert", example("suitcase_corner"), target, "--deflection", deflection,
                            "--angular-deflection", "60", "--open-ok"), DONE)
            sizes.append(target.stat().st_size)
        self.assertLess(sizes[0], sizes[1])
        self.assertLess(sizes[1], sizes[2])

    def test_input_as_output_needs_force(self):
        part = self.folder / "part.step"
        part.write_bytes(example("box_without_lid").read_bytes())
        self.expect_refused(run("convert", part, part), 1, "--force")
        self.expect(run("convert", part, part, "--force"), DONE)


class Progress(Case):
    def test_json_progress_is_lines_that_grow(self):
        finished = self.expect(
            run("fill", example("pipe_elbow"), "-o", self.folder / "o.step", "--progress", "json"), DONE
        )
        lines = [json.loads(line) for line in finished.err.splitlines()]
        self.assertGreater(len(lines), 4)
        values = [line["progress"] for line in lines]
        self.assertEqual(values, sorted(values))
        self.assertTrue(all(0 <= value <= 1 for value in values))
        stages = " ".join(line["stage"] for line in lines)
        for word in ("reading", "finding", "filling hole", "writing", "measuring"):
            self.assertIn(word, stages)

    def test_bar_on_a_terminal_is_gone_at_the_end(self):
        master, slave = pty.openpty()
        self.addCleanup(os.close, master)
        process = subprocess.run(
            [PROGRAM, "inspect", str(example("bump_window"))],
            stdout=subprocess.PIPE, stderr=slave, timeout=limit(60), check=False,
        )
        os.close(slave)
        seen = b""
        try:
            while chunk := os.read(master, 65536):
                seen += chunk
        except OSError:
            pass  # Linux's way to say that the terminal has been closed
        self.assertEqual(process.returncode, DONE)
        self.assertIn(b" %  reading", seen)
        self.assertTrue(seen.endswith(b"\r\x1b[K"), seen[-80:])

    def test_nothing_but_the_document_is_on_stdout(self):
        finished = run("fill", example("bump_window"), "-o", self.folder / "o.igs", "--json", "-v",
                       "--method", "extend")
        json.loads(finished.out)

    def test_names_from_the_file_are_escaped_in_the_page(self):
        text = example("box_without_lid").read_text()
        # OCCT joins continued strings, so the product's name may be any one-line text.
        changed = re.sub(r"PRODUCT\('[^']*',\s*'[^']*'", "PRODUCT('<b>x</b>','<b>x</b>'", text, count=1)
        self.assertNotEqual(text, changed)
        part = self.folder / "<i>part.step"
        part.write_text(changed)
        page = self.folder / "r.html"
        self.expect(run("inspect", part, "--report", page), DONE)
        html = page.read_text()
        self.assertNotIn("<i>part", html)
        self.assertNotIn("<b>x", html)
        self.assertIn("&lt;b&gt;x&lt;/b&gt;", html)
