"""tests/run_tests.py counts what CTest says truthfully: the real CTest, on tests made for that."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["SUTURE_SOURCE_DIR"]) / "tests"))
import run_tests  # noqa: E402

GTEST_SKIP = r"printf '[ RUN      ] A.B\na.cpp:7: Skipped\nno such folder\n[  SKIPPED ] A.B\n'"


class RunTests(unittest.TestCase):
    def results(self, *tests):
        """tests: (name, shell command, properties of CTest)."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            lines = []
            for test, command, properties in tests:
                script = folder / f"{test}.sh"
                script.write_text(command + "\n", encoding="utf-8")
                lines.append(f'add_test({test} "/bin/sh" "{script}")')
                if properties:
                    lines.append(f"set_tests_properties({test} PROPERTIES {properties})")
            lines.append('add_test(Gone "/no/such/program")' if not tests else "")
            (folder / "CTestTestfile.cmake").write_text("\n".join(lines), encoding="utf-8")
            junit = folder / "junit.xml"
            subprocess.run(
                ["ctest", "--test-dir", name, "--output-junit", str(junit)],
                stdin=subprocess.DEVNULL,
                capture_output=True,
                check=False,
            )
            return run_tests.read_results(junit)

    def test_passed_and_failed_are_counted(self):
        counts, _, failures = self.results(
            ("Good", "true", ""), ("Fine", "true", ""), ("Bad", "exit 3", "")
        )
        self.assertEqual((counts["passed"], counts["failed"], counts["skipped"]), (2, 1, 0))
        self.assertEqual(failures, ["Bad"])
        self.assertEqual(run_tests.summary(counts), "2 passed, 1 failed")

    def test_a_crash_and_a_timeout_are_failures(self):
        counts, _, _ = self.results(
            ("Crash", "kill -SEGV $$", ""), ("Hang", "sleep 60", "TIMEOUT 1")
        )
        self.assertEqual((counts["passed"], counts["failed"]), (0, 2))

    def test_a_program_that_is_not_there_is_a_failure(self):
        counts, _, failures = self.results()
        self.assertEqual((counts["passed"], counts["failed"]), (0, 1))
        self.assertEqual(failures, ["Gone"])

    def test_a_skipped_google_test_is_skipped_with_its_reason(self):
        counts, reasons, _ = self.results(
            ("A.B", GTEST_SKIP, r'SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]"')
        )
        self.assertEqual((counts["passed"], counts["failed"], counts["skipped"]), (0, 0, 1))
        self.assertEqual(dict(reasons), {"no such folder": 1})

    def test_a_skipped_python_test_is_skipped_with_its_reason(self):
        counts, reasons, _ = self.results(
            ("P", "echo 'Skipped: no FreeCAD'; exit 77", "SKIP_RETURN_CODE 77")
        )
        self.assertEqual(counts["skipped"], 1)
        self.assertEqual(dict(reasons), {"no FreeCAD": 1})
        self.assertEqual(run_tests.summary(counts), "0 passed, 0 failed, 1 skipped")

    def test_a_disabled_test_is_skipped(self):
        counts, _, _ = self.results(("D", "true", "DISABLED TRUE"), ("Good", "true", ""))
        self.assertEqual((counts["passed"], counts["failed"], counts["skipped"]), (1, 0, 1))


class RunPythonTest(unittest.TestCase):
    """tests/support/run_python_test.py: what CTest calls for a unittest method."""

    RUNNER = Path(os.environ["SUTURE_SOURCE_DIR"]) / "tests/support/run_python_test.py"
    FILE = """
import unittest
class Case(unittest.TestCase):
    def test_good(self):
        pass
    def test_bad(self):
        self.assertEqual(1, 2)
    @unittest.skip("not today")
    def test_skipped(self):
        pass
    @unittest.expectedFailure
    def test_unexpectedly_good(self):
        pass
    def helper(self):
        pass
"""

    def run_file(self, *words):
        with tempfile.TemporaryDirectory() as name:
            file = Path(name) / "sample.py"
            file.write_text(self.FILE, encoding="utf-8")
            words = [str(file) if word == "FILE" else word for word in words]
            return subprocess.run(
                [sys.executable, "-B", str(self.RUNNER), *words],
                capture_output=True,
                text=True,
                check=False,
            )

    def test_it_lists_every_test_method(self):
        self.assertEqual(
            self.run_file("--list", "FILE").stdout.split(),
            ["Case.test_good", "Case.test_bad", "Case.test_skipped", "Case.test_unexpectedly_good"],
        )

    def test_its_exit_code_tells_passed_failed_and_skipped(self):
        self.assertEqual(self.run_file("FILE", "Case.test_good").returncode, 0)
        self.assertEqual(self.run_file("FILE", "Case.test_bad").returncode, 1)
        self.assertEqual(self.run_file("FILE", "Case.test_unexpectedly_good").returncode, 1)
        self.assertNotEqual(self.run_file("FILE", "Case.test_gone").returncode, 0)
        skipped = self.run_file("FILE", "Case.test_skipped")
        self.assertEqual(skipped.returncode, 77)
        self.assertIn("Skipped: not today", skipped.stdout)


if __name__ == "__main__":
    unittest.main()
