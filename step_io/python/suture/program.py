# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program: progress, cancelling, and its failures as exceptions."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import threading
from pathlib import Path

from . import errors

# exit codes, as docs/cli.md has them
_DONE, _USAGE, _UNREADABLE, _NOTHING, _OUT_OF_TOLERANCE = range(5)
_ERRORS = {
    _USAGE: errors.UsageError,
    _UNREADABLE: errors.Unreadable,
    _NOTHING: errors.NothingToDo,
    130: errors.Cancelled,
    143: errors.Cancelled,
}
# Of applications that come with libraries of their own: they are not for another program.
_FOREIGN = ("LD_LIBRARY_PATH", "LD_PRELOAD", "PYTHONHOME", "PYTHONPATH")
_POLL = 0.1  # seconds within which `cancel` is noticed


def find_program() -> str:
    """SUTURE_EXE, or the program of this package, or the one on the PATH."""
    own = Path(__file__).parent / "bundle/bin/suture"
    for place in (os.environ.get("SUTURE_EXE"), own if own.exists() else None, _on_path()):
        if place:
            return str(place)
    raise errors.ProgramMissing(
        "there is no program suture: neither in this package nor on the PATH nor in SUTURE_EXE"
    )


def _on_path():
    """The script that comes with this package has the same name, and would call itself."""
    found = shutil.which("suture")
    if found is None:
        return None
    with open(found, "rb") as file:
        return found if file.read(4) == b"\x7fELF" else None


def environment():
    return {key: value for key, value in os.environ.items() if key not in _FOREIGN}


def version() -> str:
    """The program's version."""
    done = subprocess.run(
        [find_program(), "--version"], check=True, capture_output=True, text=True, env=environment()
    )
    return done.stdout.split()[-1]


def run(words, progress=None, cancel=None):
    """Runs `suture WORDS --json`. Result   its JSON document

    progress   called with the fraction done and what is being done
    cancel     a threading.Event, or anything with is_set()
    Refuses    everything that ends with another exit code than 0 or 4, by an exception of `errors`
    """
    command = [find_program(), *map(str, words), "--json"]
    command.append("--progress=json" if progress else "--progress=none")
    process = subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        env=environment(),
    )
    said, broken = [], []

    def listen():
        try:
            _listen(process.stderr, said, progress)
        except BaseException as error:  # of the caller's `progress`: it is raised below
            broken.append(error)
            process.terminate()
            process.stderr.read()

    listener = threading.Thread(target=listen, daemon=True)
    listener.start()
    printed = _output(process, cancel)
    listener.join()
    process.stderr.close()
    if broken:
        raise broken[0]
    if process.returncode in (_DONE, _OUT_OF_TOLERANCE):
        return json.loads(printed)
    raise _failure(process.returncode, printed, said)


def _output(process, cancel):
    """What it prints. However this is left, the program has ended."""
    try:
        return _read_all(process, cancel)
    except BaseException:
        process.terminate()
        process.wait()
        raise


def _read_all(process, cancel):
    text = []
    reader = threading.Thread(target=lambda: text.append(process.stdout.read()), daemon=True)
    reader.start()
    while reader.is_alive():
        reader.join(_POLL)
        if cancel is not None and cancel.is_set() and process.poll() is None:
            process.terminate()
            cancel = None
    process.wait()
    process.stdout.close()
    return text[0]


def _listen(file, said, progress):
    for line in file:
        if progress and line.startswith('{"progress"'):
            step = json.loads(line)
            progress(step["progress"], step["stage"])
        else:
            said.append(line.rstrip("\n"))


def _failure(code, printed, said):
    try:
        document = json.loads(printed)
        message = document["error"]["message"]
    except (ValueError, KeyError):
        document, message = {}, "\n".join(said[-3:]) or f"suture ended with {code}"
    return _ERRORS.get(code, errors.SutureError)(message, document)
