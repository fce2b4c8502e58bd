"""The program under test, run as a user runs it, and what the tests of the command line share."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from time_limits import limit

PROGRAM = os.environ["SUTURE_PROGRAM"]
EXAMPLES = Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs" / "examples"
CAD = Path(os.environ["SUTURE_CAD_DIR"])

DONE, USAGE, UNREADABLE, NOTHING, OUT_OF_TOLERANCE, INTERNAL = range(6)


class Finished:
    """A run that has ended: its exit code and what it said."""

    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    @property
    def json(self):
        return json.loads(self.out)

    def __str__(self):
        return f"exit code {self.code}\nstdout: {self.out[-2000:]}\nstderr: {self.err[-2000:]}"


def run(*words, timeout=120, **options):
    """timeout: seconds, for a release build"""
    process = subprocess.run(
        [PROGRAM, *map(str, words)], capture_output=True, timeout=limit(timeout), check=False, **options
    )
    return Finished(process.returncode, process.stdout.decode(), process.stderr.decode())


def example(name):
    return EXAMPLES / f"{name}.step"


def write_slow_brep(folder, copies=3000):
    """A valid text BREP with so many unused curves that OCCT takes seconds to read it."""
    plain = folder / "plain.brep"
    finished = run("convert", example("bump_window"), plain)
    assert finished.code == DONE, str(finished)
    text = plain.read_text()
    plain.unlink()
    curves = re.search(r"\nCurves (\d+)\n(.*?\n)(?=Polygon3D)", text, re.DOTALL)
    slow = folder / "slow.brep"
    with slow.open("w") as file:
        file.write(text[: curves.start()])
        file.write(f"\nCurves {int(curves[1]) * copies}\n")
        for _ in range(copies):
            file.write(curves[2])
        file.write(text[curves.end() :])
    return slow


def write_many_holes(folder, count=60):
    """A model of many parts with a hole each: the first hole of part i lies at 100 i along x."""
    sys.path.append("/usr/lib/freecad-python3/lib")
    import FreeCAD
    import Part

    part = Part.read(str(example("suitcase_corner")))
    copies = []
    for i in range(count):
        copy = part.copy()
        copy.translate(FreeCAD.Vector(100 * i, 0, 0))
        copies.append(copy)
    file = folder / "many.step"
    Part.Compound(copies).exportStep(str(file))
    return file


class Case(unittest.TestCase):
    """Every test has a folder of its own, and leaves no temporary file in it."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="suture-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def expect(self, finished, code):
        self.assertEqual(finished.code, code, str(finished))
        return finished

    def expect_refused(self, finished, code, *words):
        """One line on stderr that says what is wrong, and nothing on stdout."""
        self.expect(finished, code)
        self.assertEqual(finished.out, "", str(finished))
        lines = finished.err.splitlines()
        self.assertEqual(len(lines), 1, str(finished))
        self.assertTrue(lines[0].startswith("error: "), str(finished))
        for word in words:
            self.assertIn(str(word), lines[0])

    def expect_files(self, *names):
        """The folder holds these files and no other, hidden ones included."""
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(names))
