"""Ctrl-C, kill and crashes: everything ends within two seconds, no process and no file is left."""

import os
import signal
import subprocess
import time
from pathlib import Path

from program import PROGRAM, Case, example, write_many_holes, write_slow_brep
from time_limits import limit

GRACE = limit(2.0)


def descendants(pid):
    """All living processes below a process."""
    children = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue
        if fields[0] != "Z":
            children.setdefault(int(fields[1]), []).append(int(stat.parent.name))
    found, waiting = [], [pid]
    while waiting:
        below = children.get(waiting.pop(), [])
        found += below
        waiting += below
    return found


def alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Interrupt(Case):
    def start(self, *words):
        process = subprocess.Popen(
            [PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def wait_for_stage(self, process, word):
        """Reads progress lines until a stage; the process is then in it."""
        seen = ""
        while word not in seen:
            line = process.stderr.readline().decode()
            self.assertTrue(line, f"ended before it came to '{word}': {seen}")
            seen += line

    def expect_end(self, process, sent, code):
        below = descendants(process.pid)
        self.assertTrue(below, "there is a supervised process")
        start = time.monotonic()
        process.send_signal(sent)
        try:
            out, err = process.communicate(timeout=limit(10))
        except subprocess.TimeoutExpired:
            self.fail("still running long after that")
        self.assertLess(time.monotonic() - start, GRACE)
        self.assertEqual(process.returncode, code, err)
        self.assertEqual(out, b"")
        self.assertEqual([pid for pid in below if alive(pid)], [])
        return err.decode()

    def long_fill(self):
        """Sixty holes, each of which keeps OCCT's filling busy for more than a second."""
        return self.start(
            "fill", write_many_holes(self.folder), "-o", self.folder / "out.step",
            "--method", "occt", "--occt-setting", "tuned", "--progress", "json",
        )

    def test_ctrl_c_during_a_fill(self):
        process = self.long_fill()
        self.wait_for_stage(process, "filling")
        time.sleep(0.2)
        said = self.expect_end(process, signal.SIGINT, 130)
        self.assertIn("interrupted while filling hole", said.splitlines()[-1])
        self.expect_files("many.step")

    def test_terminate_during_a_fill(self):
        process = self.long_fill()
        self.wait_for_stage(process, "filling")
        self.expect_end(process, signal.SIGTERM, 143)
        self.expect_files("many.step")

    def test_ctrl_c_during_a_read(self):
        slow = write_slow_brep(self.folder)
        process = self.start("fill", slow, "-o", self.folder / "out.step", "--progress", "json")
        self.wait_for_stage(process, "reading")
        time.sleep(0.3)
        said = self.expect_end(process, signal.SIGINT, 130)
        self.assertIn("error: interrupted while reading", said.splitlines()[-1])
        self.expect_files("slow.brep")

    def test_killed_supervisor_takes_the_job_with_it(self):
        process = self.long_fill()
        self.wait_for_stage(process, "filling")
        below = descendants(process.pid)
        self.assertTrue(below)
        process.kill()
        process.communicate(timeout=limit(10))
        deadline = time.monotonic() + GRACE
        while any(map(alive, below)) and time.monotonic() < deadline:
            time.sleep(0.02)
        self.assertEqual([pid for pid in below if alive(pid)], [])

    def test_crash_during_a_fill_names_the_stage(self):
        process = self.long_fill()
        self.wait_for_stage(process, "filling")
        job = int(Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()[0])
        os.kill(job, signal.SIGSEGV)
        out, err = process.communicate(timeout=limit(10))
        self.assertEqual(process.returncode, 5, err)
        self.assertEqual(out, b"")
        last = err.decode().splitlines()[-1]
        self.assertIn("error: ", last)
        self.assertIn("filling", last)
        self.assertIn("nothing was written", last)
        self.expect_files("many.step")

    def test_crash_during_a_read_is_the_file_s_fault(self):
        process = self.start("inspect", write_slow_brep(self.folder), "--progress", "json")
        self.wait_for_stage(process, "reading")
        job = int(Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()[0])
        os.kill(job, signal.SIGSEGV)
        _, err = process.communicate(timeout=limit(10))
        self.assertEqual(process.returncode, 2, err)
        self.assertIn("OCCT's reader crashed (Segmentation fault)", err.decode().splitlines()[-1])

    def test_stop_and_go_on(self):
        process = self.start(
            "fill", example("suitcase_corner"), "-o", self.folder / "out.step", "--progress", "json"
        )
        self.wait_for_stage(process, "reading")
        process.send_signal(signal.SIGTSTP)
        time.sleep(0.5)
        stat = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
        self.assertEqual(stat, "T")
        process.send_signal(signal.SIGCONT)
        _, err = process.communicate(timeout=limit(60))
        self.assertIn(process.returncode, (0, 4), err)
