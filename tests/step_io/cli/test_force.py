"""A run that is killed, crowded or starved leaves whole files and nothing else.

SUTURE_KILLS says how often a run is killed (12; for docs/reliability.md 100)."""

import os
import random
import resource
import signal
import subprocess
import threading
import time
import unittest

from program import (
    DONE,
    INTERNAL,
    NOTHING,
    OUT_OF_TOLERANCE,
    PROGRAM,
    UNREADABLE,
    USAGE,
    Case,
    example,
    run,
)
from test_interrupt import descendants
from time_limits import limit

KILLS = int(os.environ.get("SUTURE_KILLS", "12"))
WRITERS = 16


class Force(Case):
    def setUp(self):
        super().setUp()
        self.input = self.folder / "in.step"
        self.input.write_bytes(example("suitcase_corner").read_bytes())
        self.before = self.input.read_bytes()
        self.output = self.folder / "out.step"

    def fill(self, **options):
        return subprocess.Popen(
            [PROGRAM, "fill", self.input, "-o", self.output, "--force"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, **options)

    def expect_whole(self):
        """The input is what it was, and the output can be read."""
        self.assertEqual(self.input.read_bytes(), self.before)
        if self.output.exists():
            # No hole is left in it.
            self.expect(run("inspect", self.output), NOTHING)

    def test_killed_at_any_time_it_leaves_a_whole_output_or_none(self):
        start = time.monotonic()
        whole = self.fill()
        whole.communicate(timeout=limit(60))
        self.assertEqual(whole.returncode, DONE)
        lasts = time.monotonic() - start
        self.output.unlink()
        chance = random.Random(24)
        ended = 0
        for number in range(KILLS):
            process = self.fill()
            time.sleep(chance.uniform(0.0, 1.1 * lasts))
            below = descendants(process.pid)
            # By turns the one that was started, and those that work for it.
            for victim in [process.pid] if number % 2 or not below else below:
                try:
                    os.kill(victim, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            process.communicate(timeout=limit(30))
            ended += process.returncode == DONE
            self.assertIn(process.returncode, (DONE, INTERNAL, -signal.SIGKILL))
            self.expect_whole()
            self.assertLessEqual(set(os.listdir(self.folder)), {"in.step", "out.step"})
        self.assertLess(ended, KILLS, "none was killed in time")

    def test_sixteen_writers_of_one_output_leave_one_of_theirs(self):
        done = [None] * WRITERS

        def write(number):
            process = self.fill()
            err = process.communicate(timeout=limit(240))[1]
            done[number] = process.returncode, err

        threads = [threading.Thread(target=write, args=(number,)) for number in range(WRITERS)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for code, err in done:
            self.assertEqual(code, DONE, err)
        self.expect_whole()
        self.expect_files("in.step", "out.step")

    def test_a_folder_that_vanishes_is_one_line(self):
        inside = self.folder / "gone"
        inside.mkdir()
        process = subprocess.Popen(
            [PROGRAM, "fill", self.input, "-o", inside / "out.step", "--progress", "json"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        process.stderr.readline()
        inside.rmdir()
        rest = process.communicate(timeout=limit(60))[1].decode().splitlines()
        errors = [line for line in rest if line.startswith("error: ")]
        self.assertIn(process.returncode, (USAGE, INTERNAL), rest)
        self.assertEqual(len(errors), 1, rest)
        self.assertIn("gone", errors[0])
        self.assertFalse(inside.exists())
        self.expect_whole()

    def test_few_descriptors_are_one_line(self):
        for count in (3, 4, 6, 8, 12, 16, 24, 32):
            done = subprocess.run(
                [PROGRAM, "fill", self.input, "-o", self.output, "--force"],
                capture_output=True, check=False, timeout=limit(60),
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (count, count)))
            if done.returncode == 127:
                continue  # not even the libraries can be opened
            lines = done.stderr.decode().splitlines()
            self.assertIn(done.returncode, (DONE, USAGE, UNREADABLE, OUT_OF_TOLERANCE, INTERNAL), (count, lines))
            if done.returncode != DONE:
                self.assertEqual(sum(line.startswith("error: ") for line in lines), 1, (count, lines))
            self.expect_whole()
            self.assertLessEqual(set(os.listdir(self.folder)), {"in.step", "out.step"})

    @unittest.skipUnless(os.geteuid() == 0, "mounts a small disk")
    def test_a_full_disk_keeps_the_old_output(self):
        small = self.folder / "small"
        small.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", small],
                          check=False, capture_output=True).returncode:
            self.skipTest("mounting is not allowed here")
        try:
            output = small / "out.step"
            output.write_text("old")
            (small / "ballast").write_bytes(bytes(40000))
            finished = run("fill", self.input, "-o", output, "--force")
            self.expect(finished, INTERNAL)
            self.assertEqual(finished.err.count("error: "), 1, str(finished))
            self.assertEqual(output.read_text(), "old")
            self.assertEqual(sorted(os.listdir(small)), ["ballast", "out.step"])
        finally:
            subprocess.run(["umount", small], check=True)
