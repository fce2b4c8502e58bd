"""Runs a program and says what it took: used by the benchmark and by the measurement of overhead."""

import json
import os
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent.parent
BUILD = Path(os.environ.get("SUTURE_BINARY_DIR", SOURCE / "build/release"))
SUTURE = Path(os.environ.get("SUTURE_PROGRAM", BUILD / "bin/suture"))
REFEREE = BUILD / "tests/bench/suture_referee"
BARE = BUILD / "tests/bench/suture_bare_read_write"
BARE_NAMES = BUILD / "tests/bench/suture_bare_read_write_names"


@dataclass
class Run:
    """One run of a program, with all processes that it started and waited for."""

    code: int  # negative: ended by that signal
    seconds: float  # by the clock
    cpu_seconds: float
    peak_bytes: int  # of its largest process
    out: str
    err: str
    timed_out: bool

    def document(self):
        """The JSON document on stdout, or nothing."""
        try:
            return json.loads(self.out)
        except ValueError:
            return None


def run(arguments, limit):
    """Runs a program, at most `limit` seconds: then its whole process group is killed."""
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
        start = time.perf_counter()
        child = subprocess.Popen(
            [str(word) for word in arguments],
            stdin=subprocess.DEVNULL, stdout=out, stderr=err, start_new_session=True,
        )  # fmt: skip
        timed_out = threading.Event()

        def stop():
            timed_out.set()
            child.terminate()  # the program stops its own children

        timer = threading.Timer(limit, stop)
        timer.start()
        _, status, usage = os.wait4(child.pid, 0)
        seconds = time.perf_counter() - start
        timer.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        for stream in (out, err):
            stream.seek(0)
        return Run(
            code=child.returncode,
            seconds=seconds,
            cpu_seconds=usage.ru_utime + usage.ru_stime,
            peak_bytes=usage.ru_maxrss * 1024,
            out=out.read(),
            err=err.read(),
            timed_out=timed_out.is_set(),
        )
