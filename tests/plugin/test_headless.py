"""The workbench without a window: every command as a function, on real shapes."""

import json
import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
PROGRAM = os.environ["SUTURE_PROGRAM"]
EXAMPLES = ROOT / "docs/examples"
HOME = tempfile.TemporaryDirectory(prefix="suture-home-")
os.environ["FREECAD_USER_HOME"] = HOME.name
os.environ["SUTURE_EXE"] = PROGRAM
# Plain Python does not know FreeCAD's home: Bodies need PartDesign's Python part.
sys.path[:0] = ["/usr/lib/freecad-python3/lib", "/usr/share/freecad/Mod"]
sys.path[:0] = [str(ROOT / "plugin"), str(HERE)]

try:
    import FreeCAD as App
    import Import
    import Part
except ImportError as missing:
    raise unittest.SkipTest(f"FreeCAD is not installed: {missing}") from missing

from suture_workbench import api, exchange, feature, job, places, reports, tasks  # noqa: E402
from suture_workbench.errors import (  # noqa: E402
    Cancelled,
    ProgramMissing,
    SutureError,
    failure,
    in_freecads_words,
)
from suture_workbench.options import FillOptions  # noqa: E402

CORNER = [9, 19, 21]  # the edges of the open suitcase corner
TURNED = App.Placement(App.Vector(5, -7, 11), App.Rotation(20, 30, 40))


def example(name="suitcase_corner"):
    shape = Part.Shape()
    shape.read(str(EXAMPLES / f"{name}.step"))
    return shape


def open_box():
    """A box without two opposite sides: two planar holes."""
    box = Part.makeBox(10, 20, 30)
    return Part.Shell([face for index, face in enumerate(box.Faces) if index not in (0, 1)])


class Case(unittest.TestCase):
    """A new document for every test."""

    def setUp(self):
        os.environ["SUTURE_EXE"] = PROGRAM
        os.environ.pop("SUTURE_BEHAVIOUR", None)
        self.document = App.newDocument()

    def tearDown(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)

    def add(self, shape, name="Base"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        return obj

    def misbehave(self, behaviour):
        os.environ["SUTURE_EXE"] = str(HERE / "bad_suture.py")
        os.environ["SUTURE_BEHAVIOUR"] = behaviour

    def assert_same_face(self, face, other):
        self.assertLess((face.CenterOfMass - other.CenterOfMass).Length, 1e-7)
        self.assertAlmostEqual(face.Area, other.Area, delta=1e-6 * face.Area)


class Commands(Case):
    def test_find_holes_tells_edges_faces_and_size(self):
        found = api.find_holes(self.add(example()))
        (hole,) = found.report.holes
        self.assertEqual((hole.kind, hole.edges, hole.faces), ("hole", CORNER, [3, 7, 9]))
        # The corner's three points lie 8 mm apart in x, y and z.
        self.assertAlmostEqual(hole.diameter, 8 * 3**0.5, delta=2e-3)
        self.assertLess(max(corner.mismatch for corner in hole.corners), 1e-6)

    def test_find_holes_puts_rims_after_holes(self):
        sheet = Part.makePlane(10, 10).cut(Part.makeCylinder(2, 1, App.Vector(5, 5, -0.5)))
        kinds = [hole.kind for hole in api.find_holes(self.add(sheet)).report.holes]
        self.assertIn("rim", kinds)
        self.assertEqual(kinds, sorted(kinds, key=lambda kind: kind != "hole"))

    def test_a_closed_solid_has_no_hole_and_that_is_no_failure(self):
        report = api.find_holes(self.add(Part.makeBox(1, 2, 3))).report
        self.assertTrue(report is None or not report.holes)

    def test_fill_makes_a_valid_solid_that_is_smooth(self):
        filled = api.fill(self.add(example()), method="mvs")
        self.assertEqual((filled.Shape.ShapeType, filled.Shape.isValid()), ("Solid", True))
        self.assertTrue(filled.Closed and filled.WithinTolerance)
        self.assertEqual(list(filled.NewFaces), [10])
        report = api.check(filled)
        self.assertEqual(report.near_misses, 0)
        smooth = [edge.angle for edge in report.edges if edge.kind != "sharp"]
        self.assertLess(max(smooth), 0.01)
        # The corner is an eighth of a ball of radius 8: what the box and its three fillets leave.
        face = filled.Shape.Faces[9]
        self.assertAlmostEqual(face.Area, 4 * 3.141592653589793 * 64 / 8, delta=1e-3)

    def test_fill_keeps_faces_edges_and_their_numbers(self):
        base = self.add(example())
        filled = api.fill(base)
        for before, after in zip(base.Shape.Faces, filled.Shape.Faces):
            self.assert_same_face(before, after)
        for before, after in zip(base.Shape.Edges, filled.Shape.Edges):
            self.assertLess((before.CenterOfMass - after.CenterOfMass).Length, 1e-9)

    def test_fill_takes_an_edge_or_a_face_for_a_hole(self):
        base = self.add(open_box())
        one, other = api.find_holes(base).report.holes
        filled = api.fill(base, edges=[other.edges[2]])
        self.assertEqual((len(filled.Shape.Faces), filled.Closed), (5, False))
        both = api.fill(base, faces=[1])
        self.assertEqual((len(both.Shape.Faces), both.Shape.ShapeType), (6, "Solid"))
        self.assertAlmostEqual(both.Shape.Volume, 6000, delta=1e-6)
        self.assertEqual(set(one.faces), {1, 2, 3, 4})

    def test_a_side_can_have_a_continuity_of_its_own(self):
        filled = api.fill(self.add(example()), sides={9: "G0", 19: "G1"}, method="mvs")
        sides = {side.edge: side.wanted for side in reports.fill(json.loads(filled.Report)).holes[0].sides}
        self.assertEqual(sides, {9: "G0", 19: "G1", 21: "G1"})
        self.assertEqual(filled.EdgesG0[1], ["Edge9"])

    def test_a_fill_passes_through_points_and_edges_of_other_objects(self):
        base = self.add(example("bump_window"))
        base.Placement = TURNED
        hole = api.find_holes(base).report.holes[0]
        point = TURNED.multVec(self.middle_of(base, hole) + App.Vector(0, 0, 0.3))
        vertex = self.add(Part.Vertex(point), "Probe")
        filled = api.fill(base, edges=[hole.edges[0]], method="mvs", through=[(vertex, ("Vertex1",))])
        new = [filled.Shape.Faces[number - 1] for number in filled.NewFaces]
        distance = min(face.distToShape(Part.Vertex(point))[0] for face in new)
        self.assertLess(distance, 0.01)
        without = api.fill(base, edges=[hole.edges[0]], method="mvs")
        new = [without.Shape.Faces[number - 1] for number in without.NewFaces]
        self.assertGreater(min(face.distToShape(Part.Vertex(point))[0] for face in new), 0.05)

    def middle_of(self, base, hole):
        points = [base.Shape.Edges[edge - 1].CenterOfMass for edge in hole.edges]
        return base.Placement.inverse().multVec(sum(points, App.Vector()) * (1 / len(points)))

    def test_loops_of_one_face_are_filled_together(self):
        box, pillar = Part.makeBox(40, 40, 10), Part.makeCylinder(5, 10, App.Vector(20, 20, 10))
        solid = box.fuse(pillar).removeSplitter()
        ring = 1600 - 25 * 3.141592653589793
        kept = [face for face in solid.Faces if abs(face.Area - ring) > 1]
        base = self.add(Part.makeCompound(kept))
        found = api.find_holes(base)
        edges = [found.number(hole.edges[0]) for hole in found.report.holes]
        self.assertEqual(len(edges), 2)
        filled = api.fill(base, edges=edges, one_face=True)
        self.assertEqual((filled.Shape.ShapeType, len(filled.NewFaces)), ("Solid", 1))
        self.assertAlmostEqual(filled.Shape.Faces[filled.NewFaces[0] - 1].Area, ring, delta=1e-4)
        self.assertAlmostEqual(filled.Shape.Volume, solid.Volume, delta=1e-3)

    def test_check_can_be_told_profile_limits_and_edges(self):
        solid = self.add(api.fill(self.add(example())).Shape)
        report = api.check(solid, profile="vda4955", edges=[21, 9])
        self.assertEqual(sorted(edge.edge for edge in report.edges), [9, 21])
        self.assertEqual(report.limits.angle, 0.1)
        strict = api.check(solid, gap=1e-9)
        self.assertGreater(strict.near_misses, 0)
        self.assertTrue(strict.edges[0].near_miss, "worst first")

    def test_the_report_of_a_check_can_be_written(self):
        solid = api.fill(self.add(example()))
        with tempfile.TemporaryDirectory() as folder:
            html = Path(folder) / "report.html"
            table = reports.check_as_csv(api.check(solid, html=html)).splitlines()
            self.assertIn("<html", html.read_text(encoding="utf-8")[:2000].lower())
        self.assertEqual(len(table), 22)
        self.assertEqual(len({line.count(",") for line in table}), 1)

    def test_convert_works_on_files_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "out.step"
            answer = api.convert(EXAMPLES / "suitcase_corner.step", target, fill_holes=True)
            self.assertTrue(answer["closed"] and answer["valid"])
            shape = Part.Shape()
            shape.read(str(target))
            self.assertEqual(shape.ShapeType, "Solid")
            api.convert(target, Path(folder) / "out.iges")
            self.assertGreater((Path(folder) / "out.iges").stat().st_size, 1000)
        self.assertEqual(self.document.Objects, [])

    def test_export_fills_holes_in_step_and_iges(self):
        base = self.add(example())
        closed = self.add(Part.makeBox(1, 1, 1), "Closed")
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.step", "a.iges"):
                api.export([base], Path(folder) / name)
                done = subprocess.run(
                    [PROGRAM, "check", Path(folder) / name, "--json"], capture_output=True, check=True
                )
                report = json.loads(done.stdout)
                self.assertTrue(report["shape"]["closed"], name)
                self.assertLess(report["summary"]["max_angle_deg"], 0.01, name)
            self.assertEqual(api.export([closed], Path(folder) / "b.step"), "no hole")
            api.export([closed], Path(folder) / "b.iges")
            self.assertTrue((Path(folder) / "b.step").exists() and (Path(folder) / "b.iges").exists())


class Objects(Case):
    def test_a_filled_shape_follows_its_base(self):
        base = self.add(example())
        filled = api.fill(base, method="mvs")
        volume = filled.Shape.Volume
        larger = example()
        larger.scale(2)
        base.Shape = larger
        self.document.recompute()
        self.assertAlmostEqual(filled.Shape.Volume, 8 * volume, delta=0.01 * volume)
        self.assertTrue(filled.Closed)

    def test_it_is_saved_opened_and_recomputed(self):
        filled = api.fill(self.add(example()))
        key, volume = filled.InputKey, filled.Shape.Volume
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.FCStd")
            self.document.saveAs(path)
            App.closeDocument(self.document.Name)
            os.environ["SUTURE_EXE"] = "/no/suture"  # nothing to compute: nothing to run
            os.environ["PATH"], old = "", os.environ["PATH"]
            again = App.openDocument(path).getObject("Filled")
            again.touch()
            again.Document.recompute()
            os.environ["PATH"] = old
            self.assertEqual(again.State, ["Up-to-date"])
            self.assertEqual((again.InputKey, again.Shape.Volume), (key, volume))
            os.environ["SUTURE_EXE"] = PROGRAM
            again.Method = "mvs"
            again.Document.recompute()
            self.assertNotEqual(again.InputKey, key)
            self.assertTrue(again.Closed)

    def test_moving_the_base_moves_the_result_without_a_run(self):
        base = self.add(example())
        filled = api.fill(base)
        self.misbehave("crash")
        base.Placement = TURNED
        self.document.recompute()
        self.assertEqual(filled.State, ["Up-to-date"])
        self.assert_same_face(base.Shape.Faces[2], filled.Shape.Faces[2])

    def test_placed_shapes_have_the_same_numbers(self):
        base = self.add(example())
        base.Placement = TURNED
        self.assertEqual(api.find_holes(base).report.holes[0].edges, CORNER)
        filled = api.fill(base, edges=[19], method="mvs")
        self.assert_same_face(base.Shape.Faces[0], filled.Shape.Faces[0])
        self.assertTrue(filled.Closed)

    def test_the_result_stands_in_the_part_of_its_base(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = TURNED
        base = self.add(example())
        part.addObject(base)
        base.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(0, 0, 90))
        filled = api.fill(base)
        self.assertEqual(filled.getParentGeoFeatureGroup(), part)
        self.assert_same_face(base.Shape.Faces[4], filled.Shape.Faces[4])

    def test_a_body_is_filled_beside_it(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        body.Placement = TURNED
        inside = self.document.addObject("PartDesign::Feature", "Imported")
        body.addObject(inside)
        inside.Shape = example()
        body.Tip = inside
        self.document.recompute()
        filled = api.fill(inside)
        self.assertEqual(filled.Base[0], body)
        self.assertIsNone(filled.getParentGeoFeatureGroup())
        self.assert_same_face(Part.getShape(body).Faces[4], filled.Shape.Faces[4])
        self.assertTrue(filled.Closed)

    def test_a_link_is_filled_where_it_stands(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.add(example())
        link.Placement = TURNED
        self.document.recompute()
        filled = api.fill(link)
        self.assert_same_face(Part.getShape(link).Faces[4], filled.Shape.Faces[4])

    def test_the_result_is_one_step_of_undo(self):
        self.document.UndoMode = 1
        base = self.add(example())
        self.document.clearUndos()
        api.fill(base)
        self.assertEqual(self.document.UndoCount, 1)
        self.document.undo()
        self.assertEqual(self.document.Objects, [base])

    def test_loose_faces_are_sewn_and_edges_still_found(self):
        base = self.add(Part.makeCompound([face.copy() for face in example().Faces]))
        found = api.find_holes(base)
        self.assertTrue(found.report.sewn)
        (hole,) = found.report.holes
        for number in hole.edges:
            sewn, loose = found.shape.Edges[number - 1], base.Shape.Edges[found.edges[number] - 1]
            self.assertLess((sewn.CenterOfMass - loose.CenterOfMass).Length, 1e-6)
        filled = api.fill(base, edges=[found.edges[hole.edges[0]]], method="mvs")
        self.assertEqual((filled.Shape.ShapeType, filled.Closed), ("Solid", True))


class Failures(Case):
    def assert_unharmed(self, base, kind=SutureError):
        """A fill fails as `kind`, and leaves nothing behind. Result   the error"""
        before = set(Path(tempfile.gettempdir()).glob("suture-*"))
        with self.assertRaises(kind) as caught:
            api.fill(base)
        self.assertEqual(self.document.Objects, [base])
        self.assertEqual(set(Path(tempfile.gettempdir()).glob("suture-????????")) - before, set())
        return caught.exception

    def test_a_missing_program_says_how_to_get_it(self):
        os.environ["SUTURE_EXE"], os.environ["PATH"], old = "/no", "", os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", old)
        if (ROOT / "build/release/bin/suture").exists():
            self.skipTest("the program is built where the addon looks for it")
        text = str(self.assert_unharmed(self.add(example()), ProgramMissing))
        self.assertIn("--version", text)
        self.assertIn("Preferences", text)

    def test_a_crash_of_the_program_is_no_crash_of_freecad(self):
        self.misbehave("crash")
        self.assertIn("SIGSEGV", str(self.assert_unharmed(self.add(example()))))

    def test_damaged_answers_are_told_apart_from_good_ones(self):
        base = self.add(example())
        for behaviour, word in (("garbage", "cannot be read"), ("empty", "not as expected"), ("damaged", "cannot be read")):
            self.misbehave(behaviour)
            self.assertIn(word, str(self.assert_unharmed(base)), behaviour)

    def test_a_failed_recompute_keeps_the_last_shape(self):
        filled = api.fill(self.add(example()))
        volume = filled.Shape.Volume
        self.misbehave("crash")
        filled.Method = "mvs"
        self.document.recompute()
        self.assertIn("Invalid", filled.State)
        self.assertEqual(filled.Shape.Volume, volume)
        os.environ["SUTURE_EXE"] = PROGRAM
        filled.touch()
        self.document.recompute()
        self.assertEqual(filled.State, ["Up-to-date"])

    def test_a_cancelled_run_is_gone_within_two_seconds(self):
        self.misbehave("slow")
        task = tasks.FillHoles(example(), FillOptions()).start()
        while task.progress()[1] != "filling hole 1":
            self.assertTrue(task.running())
            time.sleep(0.02)
        group = os.getpgid(task.pid)
        self.assertEqual(len(self.members(group)), 2)
        began = time.monotonic()
        task.cancel()
        self.assertLess(time.monotonic() - began, 0.1, "cancel must not wait")
        while task.running():
            time.sleep(0.02)
        self.assertLess(time.monotonic() - began, 2.0)
        self.assertEqual(self.members(group), [])
        self.assertRaises(Cancelled, task.result)
        self.assertFalse(task.folder.exists())

    def members(self, group):
        """The living processes of a group."""
        found = []
        for stat in Path("/proc").glob("[0-9]*/stat"):
            try:
                state, _, number = stat.read_text().rpartition(")")[2].split()[:3]
            except OSError:
                continue  # it has just ended
            if int(number) == group and state != "Z":
                found.append(stat)
        return found

    def test_the_program_itself_stops_at_once(self):
        task = tasks.FillHoles(example("bump_window"), FillOptions()).start()
        self.assertTrue(task.running())
        began = time.monotonic()
        task.cancel()
        while task.running():
            time.sleep(0.01)
        self.assertLess(time.monotonic() - began, 2.0)
        self.assertRaises(Cancelled, task.result)

    def test_a_time_limit_of_the_preferences_ends_a_run(self):
        self.misbehave("slow")
        group = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Suture")
        group.SetInt("TimeLimit", 1)
        self.addCleanup(group.SetInt, "TimeLimit", 0)
        self.assertIn("1 s", str(self.assert_unharmed(self.add(example()))))

    def test_a_refused_hole_names_its_edges(self):
        base = self.add(example())
        with self.assertRaises(SutureError) as caught:
            api.fill(base, method="extend")
        self.assertEqual(caught.exception.edges, tuple(CORNER))
        self.assertIn("Face3 (cylinder)", str(caught.exception))
        with self.assertRaises(SutureError) as caught:
            api.fill(base, edges=[1])
        self.assertEqual(caught.exception.edges, (1,))
        self.assertIn("Edge1 bounds no hole", str(caught.exception))

    def test_an_object_without_a_shape_is_refused_by_name(self):
        group = self.document.addObject("App::DocumentObjectGroup", "Empty")
        with self.assertRaises(SutureError) as caught:
            api.find_holes(group)
        self.assertIn("Empty", str(caught.exception))


class Words(Case):
    def test_numbers_are_written_as_freecad_does(self):
        self.assertEqual(
            in_freecads_words("edge 9 (face 3) and edges 12, 13 and 14"),
            "Edge9 (Face3) and Edge12, Edge13 and Edge14",
        )
        self.assertEqual(failure("edge 9 of faces 3 and 4, edge 9, edge 2").edges, (9, 2))

    def test_a_fingerprint_changes_with_the_shape_alone(self):
        shape = example()
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.brep")
            shape.exportBrep(path)
            again = Part.Shape()
            again.importBrep(path)
        self.assertEqual(exchange.fingerprint(shape), exchange.fingerprint(again))
        moved = shape.translated(App.Vector(0, 0, 1e-3))
        self.assertNotEqual(exchange.fingerprint(shape), exchange.fingerprint(moved))
        other = example()
        other.reverse()
        self.assertNotEqual(exchange.fingerprint(shape), exchange.fingerprint(other))

    def test_faces_are_traced_back_or_not_at_all(self):
        self.assertEqual(exchange.face_origins([3], 3, 4), [0, 1, None, 2])
        self.assertIsNone(exchange.face_origins([3], 3, 5))

    def test_options_that_do_not_exist_are_refused(self):
        self.assertRaises(TypeError, FillOptions, colour="red")


class Addon(Case):
    def run_freecadcmd(self, script):
        """Runs a script in FreeCADCmd with the repository linked into Mod. Result   what it wrote"""
        with tempfile.TemporaryDirectory(prefix="suture-home-") as folder:
            folder = Path(folder)
            (folder / "Mod").mkdir()
            (folder / "Mod" / "AnyName").symlink_to(ROOT)
            out, file = folder / "out.json", folder / "script.py"
            file.write_text(
                "import json, sys, traceback\n"
                "def said(value):\n"
                f"    open({str(out)!r}, 'w').write(json.dumps(value))\n"
                "try:\n"
                + "".join(f"    {line}\n" for line in script.splitlines())
                + "except Exception:\n    traceback.print_exc()\n    sys.exit(1)\nsys.exit(0)\n"
            )
            done = subprocess.run(
                ["freecadcmd", str(file)],
                env=os.environ | {"FREECAD_USER_HOME": str(folder)},
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                timeout=120,
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(out.read_text(encoding="utf-8"))

    def test_the_repository_linked_into_mod_is_an_addon(self):
        types = self.run_freecadcmd(
            "import FreeCAD, suture_workbench\n"
            "said(FreeCAD.getExportType())"
        )
        self.assertIn("suture_workbench.export_step", json.dumps(types))
        self.assertIn("suture_workbench.export_iges", json.dumps(types))

    def test_every_command_works_in_freecadcmd(self):
        example_file = str(EXAMPLES / "suitcase_corner.step")
        said = self.run_freecadcmd(
            "import FreeCAD, Import\n"
            "from suture_workbench import api\n"
            "d = FreeCAD.newDocument()\n"
            f"Import.insert({example_file!r}, d.Name)\n"
            "base = d.Objects[-1]\n"
            "hole = api.find_holes(base).report.holes[0]\n"
            "filled = api.fill(base, edges=hole.edges[:1], method='mvs')\n"
            "said([hole.edges, filled.Shape.ShapeType, api.check(filled).near_misses])"
        )
        self.assertEqual(said, [CORNER, "Solid", 0])

    def test_the_manifest_names_what_is_there(self):
        meta = App.Metadata(str(ROOT / "package.xml"))
        workbench = meta.Content["workbench"][0]
        folder = ROOT / workbench.Subdirectory
        self.assertTrue((folder / "InitGui.py").is_file())
        self.assertIn(f"class {workbench.Classname}", (folder / "InitGui.py").read_text(encoding="utf-8"))
        self.assertTrue((folder / workbench.Icon).is_file())
        self.assertTrue((ROOT / meta.Icon).is_file())
        self.assertTrue(meta.supportsCurrentFreeCAD())


if __name__ == "__main__":
    unittest.main()
