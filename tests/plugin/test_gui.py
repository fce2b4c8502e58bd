"""Drives FreeCAD's window on a screen of its own (Xvfb): what a user does, and what he sees.

The scenarios are in gui_walk.py, gui_slow.py and gui_cases.py, their pictures go to SUTURE_PICTURES or the build folder.
"""

import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from time_limits import limit

HERE = Path(__file__).resolve().parent
ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
BUILD = Path(os.environ["SUTURE_BINARY_DIR"])
PROGRAM = os.environ["SUTURE_PROGRAM"]
BAD = str(HERE / "bad_suture.py")
SCREEN = "-screen 0 1280x900x24 -dpi 96 +extension GLX"
SECONDS = limit(240)
TICKS = 10  # a second at least, while something runs
STOPPED = limit(2.0)  # seconds in which a run has to end with all its processes

# What makes FreeCAD start without its start page (a browser), splash screen and network.
USER_CFG = """<?xml version="1.0" encoding="UTF-8"?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText>
<FCText Name="Language">LANGUAGE</FCText><FCBool Name="ShowSplasher" Value="0"/></FCParamGroup>
<FCParamGroup Name="MainWindow"><FCText Name="StyleSheet">THEME</FCText></FCParamGroup>
<FCParamGroup Name="Addons"><FCBool Name="AutoCheck" Value="0"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


STYLES = Path("/usr/share/freecad/Gui/Stylesheets")
DARK = next((f.name for f in sorted(STYLES.glob("*ark*.qss"), reverse=True)), "")


def home_with_addon(folder, language, theme):
    """A home for FreeCAD in which the repository is linked as an addon, under another name."""
    (folder / "Mod").mkdir(parents=True)
    (folder / "Mod" / "SutureByLink").symlink_to(ROOT)
    text = USER_CFG.replace("LANGUAGE", language).replace("THEME", theme)
    (folder / "user.cfg").write_text(text, encoding="utf-8")
    return folder


def carry_out(scenario, language="English", theme="", **environment):
    """Runs a scenario. Result   what it said, and the folder with its pictures"""
    out = (
        Path(os.environ.get("SUTURE_PICTURES") or BUILD / "tests/plugin/pictures")
        / (scenario.split(".")[1] + ("_dark" if theme else ""))
    )
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    with tempfile.TemporaryDirectory(prefix="suture-home-") as folder:
        command = ["xvfb-run", "-a", "-s", SCREEN, "freecad", str(HERE / "gui_driver.py")]
        process = subprocess.Popen(
            command,
            env=os.environ
            | {
                "FREECAD_USER_HOME": str(home_with_addon(Path(folder) / "home", language, theme)),
                "SUTURE_SCENARIO": scenario,
                "SUTURE_OUT": str(out),
                "SUTURE_EXE": PROGRAM,
                "LIBGL_ALWAYS_SOFTWARE": "1",
                "QT_QPA_PLATFORM": "xcb",
                "LC_ALL": "C.UTF-8",
                "TMPDIR": folder,  # what a killed run leaves goes with it
            }
            | environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
        try:
            said, _ = process.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            said, _ = process.communicate()
    (out / "freecad.log").write_text(said, encoding="utf-8")
    result = out / "result.json"
    if not result.exists():
        raise AssertionError(f"FreeCAD ended before the scenario did:\n{said[-3000:]}")
    answer = json.loads(result.read_text(encoding="utf-8"))
    ours = [line for line in said.splitlines() if "suture_workbench/" in line and "line" in line]
    if ours and not answer["error"]:
        answer["error"] = "Python errors:\n" + said[-3000:]
    if answer["error"]:
        raise AssertionError(answer["error"])
    return answer["said"], out


@unittest.skipUnless(shutil.which("xvfb-run"), "xvfb-run is not installed")
@unittest.skipUnless(shutil.which("freecad"), "FreeCAD is not installed")
class Window(unittest.TestCase):
    def test_a_user_closes_a_suitcase_corner_from_step_to_step(self):
        said, out = carry_out("gui_walk.walk")
        self.assertEqual(said["row"], ["Hole 1", "3", "13.86 mm", "smooth at every corner"])
        self.assertEqual(sorted(said["selected"]), ["Edge19", "Edge21", "Edge9"])
        self.assertIn("closed and valid", said["preview"])
        self.assertEqual(said["objects_before"], 1, "the preview must not touch the document")
        self.assertEqual((said["solid"], said["valid"], said["undo"]), ("Solid", True, 1))
        self.assertIn("There is no program /no/suture", said["program"][0])
        self.assertIn("suture 0", said["program"][1])
        self.assertFalse(said["edited"], "Esc must leave it as it was")
        self.assertEqual(said["rows"], 21)
        self.assertIn("21 edges measured: all are smooth or sharp", said["check"])
        self.assertEqual(said["report"], "<!doctype html>")
        for name in ("filled.step", "exported.step", "exported.iges"):
            done = subprocess.run(
                [PROGRAM, "check", out / name, "--json"], capture_output=True, text=True, check=True
            )
            report = json.loads(done.stdout)
            self.assertTrue(report["shape"]["closed"] and report["shape"]["valid"], name)
            self.assertEqual(report["shape"]["solids"], 1)
            self.assertLess(report["summary"]["max_angle_deg"], 0.01, name)
        for name in ("1_open", "2_holes", "3_preview", "4_filled", "5_check", "6_combs", "7_zebra"):
            self.assertGreater((out / f"{name}.png").stat().st_size, 10_000, name)

    def assert_alive(self, said):
        # Where the machine is busy with other things, half of what the idle window reaches.
        self.assertGreaterEqual(said["ticks_per_second"], min(TICKS, said["ticks_idle"] / 2))

    def test_the_panel_lives_while_a_slow_fill_runs_and_stops_it(self):
        said, _ = carry_out("gui_slow.slow", SUTURE_EXE=BAD, SUTURE_BEHAVIOUR="slow")
        self.assert_alive(said)
        self.assertGreaterEqual(said["processes_while_running"], 2)
        self.assertLess(said["seconds_to_stop"], STOPPED)
        self.assertEqual(said["objects"], 1)

    def test_ok_waits_in_a_dialog_that_lives_and_stops(self):
        said, _ = carry_out("gui_slow.slow_ok", SUTURE_EXE=BAD, SUTURE_BEHAVIOUR="slow")
        self.assert_alive(said)
        self.assertLess(said["seconds_to_stop"], STOPPED)
        self.assertEqual((said["left"], said["panel_open"], said["objects"]), (0, True, 1))

    def test_failures_are_sentences_and_select_their_edges(self):
        said, _ = carry_out("gui_cases.failures")
        self.assertIn("Face3 (cylinder) and Face7 (cylinder)", said["refusal"])
        self.assertEqual(sorted(said["selected"]), ["Edge19", "Edge21", "Edge9"])
        self.assertIn("Preferences > Suture", said["missing"])
        self.assertIn("/no/suture", said["box"])
        self.assertEqual(said["objects"], 1)

    def test_a_fill_from_a_picked_edge_is_edited_undone_and_redone(self):
        said, _ = carry_out("gui_cases.edit")
        self.assertEqual(said["picked"], ["Edge9"])
        self.assertEqual(said["edges"], ["Edge9"])
        self.assertTrue(said["hidden"] and said["visible"])
        self.assertEqual((said["sides"], said["objects"]), (["Edge9"], 2))
        self.assertIn(said["sides_undone"], (True, []))
        self.assertEqual((said["objects_undone"], said["objects_redone"]), (1, 2))
        self.assertTrue(said["base_back"])

    def test_preferences_are_kept_and_files_converted_on_disk(self):
        said, out = carry_out("gui_cases.files")
        self.assertIn(PROGRAM, said["found"])
        self.assertIn("/no/suture", said["not_found"])
        self.assertEqual((said["method"], said["program"]), ("mvs", PROGRAM))
        self.assertIn("2 of 3 files written", said["converted"])
        self.assertIn("broken.step:", said["converted"])
        self.assertEqual(said["documents"], 0)
        for name in ("suitcase_corner_filled.step", "box_without_lid_filled.step"):
            done = subprocess.run(
                [PROGRAM, "check", out / name, "--json"], capture_output=True, text=True, check=True
            )
            self.assertTrue(json.loads(done.stdout)["shape"]["closed"], name)

    def test_colours_and_containers_are_kept(self):
        said, _ = carry_out("gui_cases.containers")
        self.assertEqual(said["parent"], "Part")
        self.assertEqual(said["colors"], [*said["wanted"], said["plain"]])

    def test_a_slow_recompute_can_be_stopped(self):
        said, _ = carry_out("gui_slow.recompute")
        self.assert_alive(said)
        self.assertLess(said["seconds_to_stop"], STOPPED)
        self.assertIn("Invalid", said["state"])
        self.assertTrue(said["kept"])

    def test_closing_the_document_ends_its_run(self):
        said, _ = carry_out("gui_slow.closing", SUTURE_EXE=BAD, SUTURE_BEHAVIOUR="slow")
        self.assertGreaterEqual(said["processes"], 2)
        self.assertEqual(said["row"], "Hole 1")

    def test_a_face_goes_through_a_point_that_was_added_and_follows_it(self):
        said, _ = carry_out("gui_cases.through")
        self.assertLess(said["distance"], 0.002)
        self.assertLess(said["followed"], 0.002)

    def test_a_methods_own_option_is_shown_and_used(self):
        said, _ = carry_out("gui_cases.own_option", SUTURE_EXE=BAD, SUTURE_BEHAVIOUR="options")
        self.assertEqual((said["before"], said["tip"]), (False, "how much it bends"))
        self.assertEqual(said["kept"], ["bend=0.5"])

    def test_near_misses_come_first_and_follow_the_profile(self):
        said, _ = carry_out("gui_cases.near_misses")
        self.assertEqual(
            (said["first"][1], said["legend"]),
            ("near miss", ["near miss: 3", "G1 tangent: 6", "sharp: 12"]),
        )
        self.assertEqual(said["selected"], [said["first"][0]])
        self.assertEqual(said["loose"], ["G1 tangent: 9", "sharp: 12"])
        self.assertEqual(said["one"], 1)

    def test_combs_are_switched_and_go_with_the_shape(self):
        said, _ = carry_out("gui_cases.overlays")
        self.assertEqual(said["counts"], [0, 1, 0, 1, 0])

    def test_it_speaks_german_where_freecad_does(self):
        said, _ = carry_out("gui_cases.german", language="German")
        self.assertEqual(said["button"], "Löcher finden…")
        self.assertEqual(said["row"], ["Loch 1", "3"])
        self.assertEqual(said["gap"], "0.001 mm")


@unittest.skipUnless(shutil.which("xvfb-run"), "xvfb-run is not installed")
class Faults(unittest.TestCase):
    """Each was there once; a Python error in the report view fails every one of them."""

    def test_escape_in_the_view_ends_an_edit_and_leaves_no_trace(self):
        said, _ = carry_out("gui_faults.escape_edit")
        self.assertEqual(said["while"], [True, False, True])
        self.assertEqual(said["after"], [False, True, 0])
        self.assertEqual(said["after_cancel"], [False, True, 0])
        self.assertEqual(said["undo_after_escape"], said["undo"])
        self.assertEqual(said["undo_after_cancel"], said["undo"])

    def test_editing_another_or_deleting_ends_an_edit(self):
        said, _ = carry_out("gui_faults.edit_another")
        self.assertEqual(said["first"], [False, True])
        self.assertEqual((said["drawn"], said["base"]), (0, True))

    def test_escape_in_the_view_cancels_a_new_fill(self):
        said, _ = carry_out("gui_faults.escape_new")
        self.assertEqual(said["after"], [True, 0, 1])

    def test_a_group_is_filled_whatever_is_shown_of_it(self):
        said, _ = carry_out("gui_faults.groups")
        self.assertIn("Group", said["heading"])
        self.assertEqual(said["state"], ["Up-to-date"])
        self.assertEqual(said["solids"], [2, 2, 2, 2])
        self.assertTrue(said["same"])

    def test_what_cannot_be_worked_on_is_named_with_the_next_step(self):
        said, _ = carry_out("gui_faults.targets")
        mesh, wire, several, none = said["messages"]
        self.assertIn("Triangles is a mesh", mesh)
        self.assertIn("Create shape from mesh", mesh)
        self.assertIn("Outline has lines only", wire)
        self.assertIn("suitcase corner, Second", several)
        self.assertIn("suitcase corner, Second", none)
        self.assertFalse(said["open"])

    def test_clicks_in_the_view_show_rows_and_rows_turn_the_camera(self):
        said, _ = carry_out("gui_faults.picking")
        self.assertEqual(said["side"], "Edge19")
        self.assertLess(said["before"], 0)
        self.assertGreater(said["facing"], 0.5)
        self.assertEqual(said["hole"], "Hole 1")

    def test_no_shortcut_clashes_with_freecads(self):
        said, _ = carry_out("gui_faults.shortcuts")
        self.assertGreaterEqual(len(said["ours"]), 6)
        self.assertEqual(said["clashes"], [])

    def test_commands_and_verdicts_follow_the_language(self):
        said, _ = carry_out("gui_faults.language")
        self.assertEqual(said["texts"], ["Find holes…", "Löcher finden…"])
        self.assertIn("1 Loch gefüllt", said["status"])
        self.assertIn("die Nachbarn liegen auf verschiedenen Flächen", said["refusal"])

    def test_a_bad_fill_is_kept_only_if_the_user_says_so(self):
        said, _ = carry_out("gui_faults.bad_fill")
        self.assertEqual(said["state"], "bad")
        self.assertIn("angle 0.2", said["question"])
        self.assertEqual(said["objects"], [1, 1, 2])

    def test_nothing_is_computed_twice(self):
        said, _ = carry_out("gui_faults.no_run_twice", SUTURE_EXE=BAD, SUTURE_BEHAVIOUR="count")
        self.assertEqual(said["runs"], [1, 1, 1])
        self.assertEqual(said["state"], ["Up-to-date"])

    def test_a_refusal_at_a_recompute_is_a_sentence(self):
        said, _ = carry_out("gui_faults.failed_recompute")
        self.assertIn("Invalid", said["state"])
        self.assertIn("refused", said["why"])


@unittest.skipUnless(shutil.which("xvfb-run"), "xvfb-run is not installed")
class Elements(unittest.TestCase):
    def test_edges_clicked_in_the_view_become_a_bridge_and_a_border(self):
        said, _ = carry_out("gui_elements.edges")
        self.assertEqual((said["first"], len(said["both"])), (["Edge2"], 2))
        self.assertIn("Right: Edge", said["both"][1])
        self.assertIn("two chains", said["not_yet"])
        self.assertEqual((said["untouched"], said["bridge"]), (2, [3, 1, ["Edge2"]]))
        self.assertEqual((said["hidden"], said["again"]), ([False, False], said["both"]))
        self.assertEqual(said["shown"], [True, True, False])
        self.assertEqual(said["after"], [False, False, True])
        self.assertIn("gap of 10", said["gap"])
        self.assertAlmostEqual(said["area"], 200 + 20, delta=1e-6)  # and the bulge of the curve
        self.assertEqual((said["drawn"], any(said["cut_off"].values())), (0, False), said["cut_off"])

    def test_faces_clicked_in_the_view_are_removed_and_replaced(self):
        said, _ = carry_out("gui_elements.faces")
        self.assertIn("Click the faces", said["hint"])
        self.assertIn("grown together", said["removed"])
        self.assertAlmostEqual(said["volume"], 6000, delta=6e-6)
        self.assertEqual((said["sides"], said["replaced"][0]), (4, 6))
        self.assertAlmostEqual(said["replaced"][1], 6000, delta=6e-6)
        self.assertEqual(said["replaced"][2], ["Face2"])
        self.assertEqual((said["drawn"], any(said["cut_off"].values())), (0, False), said["cut_off"])


    def test_holes_are_chosen_by_size_and_a_curve_leans_on_a_clicked_face(self):
        said, _ = carry_out("gui_elements.extras")
        self.assertEqual((said["fields"], said["ticked"]), (False, [False, True]))
        self.assertEqual(said["filled"], [1, 5, True, []])
        self.assertEqual(said["again"], [False, True])
        self.assertEqual(said["leaning"], ["Edge1, tangent to Ball: Face1"])
        self.assertEqual(said["leaning_again"], said["leaning"])
        self.assertAlmostEqual(said["area"], 24 * math.pi, delta=1e-3)
        self.assertFalse(any(said["cut_off"].values()), said["cut_off"])


@unittest.skipUnless(shutil.which("xvfb-run"), "xvfb-run is not installed")
class Surfaces(unittest.TestCase):
    def test_files_become_surfaces_and_cancel_leaves_nothing(self):
        said, _ = carry_out("gui_surfaces.surfaces")
        self.assertIn("Choose the file", said["hint"])
        self.assertEqual((said["patch"][0], said["algebraic"][0]), ("good", "good"))
        self.assertIn("5 sides, 5 layers", said["patch"][1])
        self.assertIn("degree 3 in 3 cells", said["algebraic"][1])
        self.assertEqual((said["objects"], said["undo"]), ([0, 1, 1], 1))
        self.assertEqual((said["label"], said["drawn"], said["folded"]), ("star", [1, 0], False))
        self.assertEqual(said["bad"][0], "bad")
        self.assertIn("bad.json", said["bad"][1])


@unittest.skipUnless(shutil.which("xvfb-run"), "xvfb-run is not installed")
class Looks(unittest.TestCase):
    """Pictures of all of this lie in the folder of the pictures: look at them after a change."""

    def assert_fits(self, said):
        self.assertEqual({name: out for name, out in said["cut_off"].items() if out}, {})
        self.assertLess(max(said["widths"].values()), 280)

    def test_every_panel_fits_freecads_usual_width(self):
        self.assert_fits(carry_out("gui_look.narrow")[0])

    def test_every_panel_fits_in_a_dark_theme(self):
        self.assert_fits(carry_out("gui_look.narrow", theme=DARK)[0])

    def test_every_panel_fits_in_german(self):
        self.assert_fits(carry_out("gui_look.narrow", language="German")[0])

    def test_stripes_are_instant_and_follow_the_object(self):
        said, _ = carry_out("gui_look.zebra")
        self.assertGreaterEqual(said["faces"], 500)
        self.assertLess(min(said["seconds_on"]), 1.0)
        self.assertLess(min(said["seconds_a_turn"]), 0.1)
        plain, striped, kept, hidden, off = said["black"]
        self.assertGreater(striped, plain + 0.03)
        self.assertGreater(kept, plain + 0.03)
        self.assertLess(hidden, plain + 0.01)
        self.assertLess(abs(off - plain), 0.02)
        self.assertGreater(said["turned"], 100)

    def test_the_map_of_curvature_shows_the_radius_of_a_ball(self):
        said, _ = carry_out("gui_look.curvature")
        self.assertEqual((said["shown"], said["off"]), ("curvature", "none"))
        red, green, blue = said["colors"]
        for r, g, b in red:
            self.assertGreater(r, 2 * max(g, b))
        for r, g, b in green:
            self.assertGreater(g, 1.5 * max(r, b))
        for r, g, b in blue:
            self.assertGreater(b, 2 * max(r, g))

    def test_the_preview_is_striped_too(self):
        said, _ = carry_out("gui_look.preview_with_stripes")
        self.assertEqual(said["kinds"], ["zebra", "none"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
