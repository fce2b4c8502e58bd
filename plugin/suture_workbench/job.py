# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of the program, in a process group of its own, that never blocks.

What the program says goes to files rather than through pipes: nothing has to be emptied while it
runs, so that the same few lines serve FreeCAD's window, its console and plain Python.
"""

import atexit
import json
import os
import signal
import subprocess  # nosec B404: Audited: only the program itself is run, without a shell
import time
import weakref

from . import program
from .compat import translate
from .errors import Cancelled, NothingToDo, ProgramMissing, SutureError
from .said import failure, in_users_words

DONE, USAGE, UNREADABLE, NOTHING_TO_DO, OUT_OF_TOLERANCE = 0, 1, 2, 3, 4
# The program itself stops what it does by force after as long.
_GRACE_SECONDS = 1.5
_running = weakref.WeakSet()


class Job:
    """Runs the program with `arguments` as soon as it is made; files go to `folder`."""

    def __init__(self, arguments, folder):
        self._out = folder / "stdout.json"
        self._err = folder / "stderr.txt"
        self._cancelled_at = None
        self._progress = (0.0, "")
        self._read_to = 0
        command = [program.find(), *map(str, arguments), "--json"]
        if "--progress" not in command and arguments[0] != "methods":
            command += ["--progress", "json"]
        options = {"start_new_session": True}
        if os.name == "nt":
            flags = subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW
            options = {"creationflags": flags}
        try:
            with self._out.open("wb") as out, self._err.open("wb") as err:
                self._process = subprocess.Popen(  # nosec B603: Audited: no shell
                    command,
                    stdin=subprocess.DEVNULL,
                    stdout=out,
                    stderr=err,
                    env=program.environment(),
                    **options,
                )
        except OSError as error:
            raise ProgramMissing(
                translate("The program {} could not be started: {}.").format(
                    command[0], error.strerror
                )
            ) from error
        _running.add(self)

    @property
    def pid(self):
        return self._process.pid

    def running(self):
        """Whether it still runs; to be asked again and again, it also carries a cancel through."""
        if self._process.poll() is not None:
            _running.discard(self)
            return False
        if self._cancelled_at and time.monotonic() - self._cancelled_at > _GRACE_SECONDS:
            self._signal(force=True)
        return True

    def progress(self):
        """(fraction, stage) as the program last said."""
        with self._err.open("rb") as err:
            err.seek(self._read_to)
            whole, newline, _ = err.read().rpartition(b"\n")
        self._read_to += len(whole) + len(newline)
        for line in whole.splitlines():
            try:
                said = json.loads(line)
                self._progress = (float(said["progress"]), in_users_words(str(said["stage"])))
            except (ValueError, KeyError, TypeError):
                continue  # a message, not progress
        return self._progress

    def cancel(self):
        """Asks the program to stop and returns at once; `running` sees to it that it does."""
        if self._cancelled_at is None and self._process.poll() is None:
            self._cancelled_at = time.monotonic()
            self._signal(force=False)

    def kill(self):
        """Ends it here and now."""
        self._cancelled_at = self._cancelled_at or time.monotonic()
        if self._process.poll() is None:
            self._signal(force=True)
            self._process.wait(5)
        _running.discard(self)

    def document(self):
        """What the program answered, once it is done; what went wrong as an exception."""
        code = self._process.returncode
        if self._cancelled_at is not None or code in (130, 143):
            raise Cancelled(translate("Stopped."))
        if code < 0:
            raise SutureError(
                translate("The program crashed ({}). FreeCAD and your model are unharmed.").format(
                    _signal_name(-code)
                )
            )
        try:
            answer = json.loads(self._out.read_text(encoding="utf-8"))
            said = answer.get("error", {}).get("message", "")
        except (ValueError, AttributeError, UnicodeDecodeError) as error:
            raise SutureError(self._no_answer(code)) from error
        if code == NOTHING_TO_DO:
            said = said or answer.get("verdict", "")
            raise NothingToDo(in_users_words(said) or translate("There is no hole."))
        if code not in (DONE, OUT_OF_TOLERANCE):
            raise failure(said or self._no_answer(code))
        return answer

    def _no_answer(self, code):
        text = self._err.read_text(encoding="utf-8", errors="replace")
        errors = [line for line in text.splitlines() if not line.startswith('{"progress"')]
        said = errors[-1] if errors else translate("it said nothing")
        return translate(
            "The program's answer cannot be read (exit code {}: {}). Is {} really Suture?"
        ).format(code, said, self._process.args[0])

    def _signal(self, force):
        try:
            if os.name == "nt":
                subprocess.run(  # nosec B603 B607: Audited: no shell
                    ["taskkill", "/T", "/F", "/PID", str(self.pid)],
                    capture_output=True,
                    check=False,
                )
            else:
                os.killpg(self.pid, signal.SIGKILL if force else signal.SIGTERM)
        except ProcessLookupError:
            pass  # it has just ended


def _signal_name(number):
    try:
        return signal.Signals(number).name
    except ValueError:
        return str(number)


@atexit.register
def _end_all():
    for job in list(_running):
        job.kill()
