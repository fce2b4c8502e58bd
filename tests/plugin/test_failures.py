"""What can go wrong, and that nothing worse comes of it."""

import os
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from headless import CORNER, PROGRAM, Case, example  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
from suture_workbench import api, program, tasks  # noqa: E402
from suture_workbench.errors import Cancelled, ProgramMissing, SutureError  # noqa: E402
from suture_workbench.options import FillOptions  # noqa: E402
from time_limits import limit  # noqa: E402


class Failures(Case):
    def assert_unharmed(self, base, kind=SutureError):
        """A fill fails as `kind`, and leaves nothing behind. Result   the error"""
        with self.assertRaises(kind) as caught:
            api.fill(base)
        self.assertEqual(self.document.Objects, [base])
        self.assertEqual(list(Path(tempfile.gettempdir()).glob("suture-*")), [])
        return caught.exception

    def test_a_missing_program_says_how_to_get_it(self):
        addon = Path(tempfile.mkdtemp()).resolve()
        with mock.patch.dict(os.environ, {"SUTURE_EXE": "/no", "PATH": str(addon)}):
            with mock.patch.object(program, "ADDON", addon):
                text = str(self.assert_unharmed(self.add(example()), ProgramMissing))
                self.assertIn("Get the program", text)
                self.assertIn("Preferences", text)
                (addon / "suture").touch(mode=0o755)  # the script that builds it: not to be run
                self.assertRaises(ProgramMissing, program.find)
                self.assertIn(f"{addon / 'suture'} --version", program.how_to_get_it())

    def test_a_crash_of_the_program_is_no_crash_of_freecad(self):
        self.misbehave("crash")
        self.assertIn("SIGSEGV", str(self.assert_unharmed(self.add(example()))))

    def test_damaged_answers_are_told_apart_from_good_ones(self):
        base = self.add(example())
        for behaviour, word in (
            ("garbage", "cannot be read"),
            ("empty", "not as expected"),
            ("damaged", "cannot be read"),
        ):
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
        self.assertLess(time.monotonic() - began, limit(2.0))
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
        self.assertLess(time.monotonic() - began, limit(2.0))
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


if __name__ == "__main__":
    unittest.main()
