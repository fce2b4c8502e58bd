"""Sewing and finding through the program: on models made here, and on small ones of ../shared/cases."""

import struct
import unittest

from program import CAD, DONE, NOTHING, OUT_OF_TOLERANCE, UNREADABLE, Case, example, run

CASES = CAD.parent / "cases"


class Sewing(Case):
    def given(self, name):
        file = CASES / name
        if not file.exists():
            self.skipTest(f"needs {file}")
        return file

    def shape_of(self, file):
        finished = run("check", file, "--json")
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE), str(finished))
        return finished.json["shape"]

    def filled(self, name, *words, code=DONE):
        out = self.folder / "filled.step"
        document = self.expect(run("fill", self.given(name), "-o", out, "--json", *words), code).json
        return document, self.shape_of(out)

    def expect_solid(self, shape, volume, solids=1):
        self.assertEqual((shape["solids"], shape["free_edges"], shape["valid"]), (solids, 0, True))
        self.assertAlmostEqual(shape["volume"], volume, delta=1e-6 * volume)

    def test_shells_that_touch_and_cracks_become_one_solid(self):
        for name, volume in (("closed_by_two_shells", 180000), ("crack", 24000)):
            with self.subTest(name):
                _, shape = self.filled(f"sewing/{name}.step")
                self.expect_solid(shape, volume)

    def test_sewn_halves_make_a_watertight_mesh(self):
        mesh = self.folder / "mesh.stl"
        self.expect(run("convert", "--sew", self.given("sewing/closed_by_two_shells.step"), mesh), DONE)
        data = mesh.read_bytes()
        edges = {}
        for i in range(struct.unpack_from("<I", data, 80)[0]):
            corners = [struct.unpack_from("<3f", data, 84 + 50 * i + 12 * k) for k in (1, 2, 3)]
            for a, b in zip(corners, corners[1:] + corners[:1]):
                edges[a, b] = edges.get((a, b), 0) + 1
        self.assertTrue(edges)
        self.assertTrue(all(edges.get((b, a)) == n for (a, b), n in edges.items()))

    def test_shells_that_touch_have_one_hole_between_them(self):
        file = self.given("sewing/touching_shells.step")
        document = self.expect(run("inspect", file, "--json"), DONE).json
        self.assertEqual([(h["kind"], h["sides"]) for h in document["holes"]], [("hole", 6)])
        self.assertEqual(document["sewing"]["sewn_edges"], 4)
        _, shape = self.filled("sewing/touching_shells.step")
        self.assertEqual((shape["solids"], shape["free_edges"], shape["valid"]), (1, 0, True))

    def test_hole_across_two_shells_is_one_hole(self):
        document, shape = self.filled("sewing/hole_across_two_shells.step")
        self.assertEqual([h["sides"] for h in document["holes"]], [6])
        self.expect_solid(shape, 180000)

    def test_tiny_edges_do_not_pull_the_tolerance_down(self):
        document, shape = self.filled("sewing/wing_with_tiny_edges.iges")
        self.assertEqual((shape["solids"], shape["free_edges"], shape["valid"]), (1, 0, True))
        self.assertGreater(document["sewing"]["tolerance"], 1e-5)

    def test_bodies_with_a_common_edge_are_filled_each_by_itself(self):
        for name in ("touch_edge_away", "shared_edge_wall"):
            with self.subTest(name):
                document, shape = self.filled(f"detect/{name}.brep", "--hole", "1")
                self.assertEqual([h["sides"] for h in document["holes"]], [4])
                self.expect_solid(shape, 2000, solids=2)

    def test_face_beside_an_inner_wall_is_a_hole_of_four_sides(self):
        document, shape = self.filled("detect/beside_inner_wall.step")
        self.assertEqual([(h["sides"], h["status"]) for h in document["holes"]], [(4, "filled")])
        self.assertEqual((shape["free_edges"], shape["valid"]), (0, True))

    def test_lone_strip_is_a_sheet_with_a_rim(self):
        document = self.expect(run("inspect", self.given("detect/lone_strip.brep"), "--json"), NOTHING).json
        self.assertEqual([h["kind"] for h in document["holes"]], ["rim"])

    def test_band_between_two_coaxial_rims_is_a_cylinder(self):
        # Its cones meet it at 105 degrees, as in the lost body.
        document, shape = self.filled("detect/coaxial_band.step")
        (hole,) = [h for h in document["holes"] if h["status"] == "filled"]
        self.assertEqual(len(hole["ids"]), 2)
        self.assertEqual([p["kind"] for p in hole["patches"]], ["cylinder"])
        self.assertIn("r = 6;", hole["notes"][0])
        self.assertEqual((shape["solids"], shape["free_edges"], shape["valid"]), (1, 0, True))

    def test_flank_of_a_thread_is_ruled_between_its_edges(self):
        # Sharp along the thread, as the lost flank was: its border leaves the neighbours' planes.
        document, shape = self.filled("detect/helical_flank.brep", "--hole", "2")
        (hole,) = [h for h in document["holes"] if h["status"] == "filled"]
        self.assertEqual(hole["method_used"], "quad")
        self.assertLess(hole["max_gap"], 1e-5)
        self.assertEqual((shape["free_edges"], shape["valid"]), (8, True))

    def test_boss_and_its_plate_have_lost_one_face(self):
        document = self.expect(run("inspect", self.given("trust/boss_without_fillet.step"), "--json"), DONE).json
        self.assertEqual([h["islands_with"] for h in document["holes"]], [[2], [1]])

    def test_sew_writes_what_it_has_joined_or_nothing(self):
        out = self.folder / "sewn.step"
        document = self.expect(
            run("sew", self.given("sewing/crack.step"), "-o", out, "--json"), DONE
        ).json
        self.assertTrue(document["validity"]["closed"])
        self.assertEqual(document["sewing"]["sewn_edges"], 3)
        self.expect_solid(self.shape_of(out), 24000)
        again = self.folder / "again.step"
        self.expect_refused(run("sew", out, "-o", again), NOTHING, "nothing to sew")
        self.assertFalse(again.exists())

    def test_rim_of_sewn_sheets_comes_with_the_hint_how_to_fill_it(self):
        sheets = CAD / "files" / "goteborg.step"
        if not sheets.exists():
            self.skipTest(f"needs {sheets}")
        finished = self.expect(run("fill", sheets, "-o", self.folder / "out.step"), DONE)
        self.assertIn("--all-loops", finished.out)

    def test_no_sew_leaves_all_as_it_is(self):
        file = self.given("sewing/closed_by_two_shells.step")
        document = self.expect(run("inspect", file, "--no-sew", "--json"), NOTHING).json
        self.assertEqual([h["kind"] for h in document["holes"]], ["seam", "seam"])


class Reading(Case):
    given = Sewing.given

    def test_brep_that_draw_has_saved_is_read(self):
        saved = self.given("read/draw_save_ending.brep")
        self.assertEqual(run("inspect", saved, "--json").json["model"]["format"], "BREP")
        # the same ending on a file of our own; without the line before it is cut off all the same
        plain = self.folder / "plain.brep"
        self.expect(run("convert", example("box_without_lid"), plain), DONE)
        ended = self.folder / "ended.brep"
        ended.write_text(plain.read_text().rstrip() + "\n0\n\n")
        self.expect(run("inspect", ended), DONE)
        lines = plain.read_text().rstrip().splitlines()
        ended.write_text("\n".join([*lines[:-1], "0", ""]))
        self.expect_refused(run("inspect", ended), UNREADABLE, "cut off")

    def test_step_file_is_read_without_face_names_where_these_crash_the_reader(self):
        # OCCT makes nothing of this one without them either: it holds swept discs alone. OCCT 7.8
        # does not crash any more.
        finished = run("inspect", self.given("read/swept_disk.stp"))
        self.assertEqual(finished.code, UNREADABLE)
        self.assertRegex(finished.err, "names of faces are lost|holds no face")

    def test_faces_that_nothing_can_be_done_with_are_named_and_left_out(self):
        for name in ("edge_without_geometry.brep", "zero_area_face.stp"):
            for command in ("inspect", "check"):
                with self.subTest(name=name, command=command):
                    finished = run(command, self.given(f"read/{name}"), "--json")
                    self.assertIn(finished.code, (DONE, UNREADABLE, NOTHING), str(finished))
                    self.assertRegex(finished.err, "has an edge without a curve|has no area")

    def test_missing_parts_of_an_assembly_are_named(self):
        file = self.folder / "assembly.step"
        file.write_text(EXTERNAL)
        self.expect_refused(run("inspect", file), UNREADABLE, "elsewhere.stp")


EXTERNAL = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','2020-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=APPLICATION_PROTOCOL_DEFINITION('is','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('part','part','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('1','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=DOCUMENT_TYPE('geometry');
#8=DOCUMENT_FILE('elsewhere.stp','','',#7,'',$);
#9=PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS('design','',#5,#6,(#8));
#10=PRODUCT_DEFINITION_SHAPE('','',#9);
#11=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#12,#13,#14))REPRESENTATION_CONTEXT('',''));
#12=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#13=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#14=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#15=CARTESIAN_POINT('',(0.,0.,0.));
#16=AXIS2_PLACEMENT_3D('',#15,$,$);
#17=SHAPE_REPRESENTATION('',(#16),#11);
#18=SHAPE_DEFINITION_REPRESENTATION(#10,#17);
ENDSEC;
END-ISO-10303-21;
"""


if __name__ == "__main__":
    unittest.main()
