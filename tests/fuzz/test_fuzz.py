"""Damaged files for a few seconds; and that the fuzzer would notice what it is there for."""

import os
import stat
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import fuzz  # noqa: E402
from mutate import mutate  # noqa: E402

PROGRAM = os.environ["SUTURE_PROGRAM"]
CORPUS = Path(__file__).resolve().parent / "corpus"


class Fuzz(unittest.TestCase):
    def test_damaged_files_break_nothing(self):
        tallies, faults = fuzz.fuzz(PROGRAM, fuzz.KINDS, 1000, seed="test", jobs=2, seconds=20)
        self.assertEqual(faults, [])
        self.assertTrue(all(tally.inputs > 0 for tally in tallies.values()))

    def test_what_once_broke_something_breaks_nothing(self):
        for file in sorted(path for path in CORPUS.iterdir() if path.is_file()):
            command, kind = file.name.split("-")[0], file.suffix[1:]
            number = ["inspect", "check", "convert", "fill"].index(command) if kind not in ("obj", "csv", "json") else 0
            with self.subTest(file.name):
                *_, fault = fuzz.run_one(PROGRAM, kind, file.read_bytes(), number)
                self.assertEqual(fault, "")

    def test_the_same_seed_does_the_same_damage(self):
        data = bytes(range(256)) * 4
        self.assertEqual(mutate(data, "a"), mutate(data, "a"))
        self.assertGreater(len({mutate(data, str(seed)) for seed in range(50)}), 40)

    def test_every_broken_promise_is_noticed(self):
        cases = {
            "exit 7": "exit code 7",
            "kill -SEGV $$": "exit code -11",
            "echo 'error: x: the program crashed (Segmentation fault)' >&2; exit 5": "crashed",
            "echo \"error: $(printf 'a%.0s' $(seq 400))\" >&2; exit 2": "300 letters",
            "printf 'error: \\377\\n' >&2; exit 2": "UTF-8",
            "printf 'error: a\\nerror: b\\n' >&2; exit 2": "more than one",
            "exit 2": "no word",
            "touch \"$(dirname \"$2\")/.left\"": "left ['.left']",
            "echo x > \"$2\"": "the input is changed",
            "exec sleep 100": "still running",
        }
        grace, fuzz.GRACE = fuzz.GRACE, 0.5
        self.addCleanup(setattr, fuzz, "GRACE", grace)
        with tempfile.TemporaryDirectory() as folder:
            for script, said in cases.items():
                program = Path(folder) / "program"
                program.write_text(f"#!/bin/sh\n{script}\n")
                program.chmod(program.stat().st_mode | stat.S_IEXEC)
                *_, fault = fuzz.run_one(program, "step", b"data", 0, seconds=1)
                self.assertIn(said, fault, script)


if __name__ == "__main__":
    unittest.main()
