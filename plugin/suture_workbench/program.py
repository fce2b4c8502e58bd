# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the program `suture` is, and how to get it."""

import json
import os
import shutil
import signal
import subprocess  # nosec B404: Audited: only the program itself is run, without a shell
from pathlib import Path

from . import ADDON, install, settings
from .compat import translate
from .errors import ProgramMissing

NAME = install.NAME
# Of FreeCAD's bundles (AppImage, conda): they make a foreign program load FreeCAD's libraries.
_BUNDLE_VARIABLES = (
    "LD_LIBRARY_PATH",
    "LD_PRELOAD",
    "DYLD_LIBRARY_PATH",
    "PYTHONHOME",
    "PYTHONPATH",
    "QT_PLUGIN_PATH",
)


def candidates():
    """Where the program may be unless the user says otherwise; an absolute path or None each."""
    yield os.environ.get("SUTURE_EXE")
    yield ADDON / "build" / "release" / "bin" / NAME  # what ./suture has built
    yield ADDON / "bin" / NAME
    yield install.installed()
    yield install.in_python()
    yield _on_path()


def _on_path():
    """FreeCAD puts an addon's folder on the PATH, and in ours `suture` is the script that installs
    packages and builds the program: nothing to be started unasked."""
    folders = [folder for folder in os.get_exec_path() if Path(folder).resolve() != ADDON]
    return shutil.which(NAME, path=os.pathsep.join(folders))


def find(chosen=None):
    """The program's path; ProgramMissing says how to get it.

    chosen   where the user says that it is, "" for the usual places; None: as in the preferences
    """
    chosen = settings.program() if chosen is None else chosen
    if chosen and _runs(chosen):
        return chosen
    if chosen:
        raise ProgramMissing(
            translate(
                "There is no program {}. Correct the path in Edit > Preferences > Suture, or clear "
                "it to have the usual places searched."
            ).format(chosen)
        )
    for path in candidates():
        if path and _runs(path):
            return str(path)
    raise ProgramMissing(how_to_get_it())


def how_to_get_it():
    script = ADDON / "suture"
    if script.is_file():
        way = translate(
            "Build it by running this in a terminal:\n    {} --version\nor install it, or say where "
            "it is: Edit > Preferences > Suture > Get the program."
        ).format(script)
    else:
        way = translate(
            "Install it, or say where it is: Edit > Preferences > Suture > Get the program."
        )
    return translate("The program 'suture', which does the work, was not found.") + " " + way


def environment():
    """The environment for the program: the user's, not that of FreeCAD's bundle."""
    return {key: value for key, value in os.environ.items() if key not in _BUNDLE_VARIABLES}


def end_children(pid):
    """Ends what a process that has a session of its own has started."""
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
            if int(fields[1]) == pid:
                os.killpg(int(folder.name), signal.SIGTERM)
        except (OSError, ValueError, IndexError):
            continue  # it has just ended


_USUAL = [{"id": name} for name in ("auto", "extend", "plane", "mvs", "occt")]
_tables, _schemas = {}, {}


def methods():
    """The names of the fill methods of the program that is there, `auto` first; the usual ones where
    there is none."""
    return [method["id"] for method in _table()]


def judges():
    """Whether the program leaves bad fills out unless it is told to keep them (since schema 3)."""
    _table()
    return any(schema >= 3 for schema in _schemas.values())


def title_of(method):
    """What the program itself says that a method does."""
    return next((row.get("title", "") for row in _table() if row["id"] == method), "")


def options_of(method):
    """The options of a method's own: [{"key", "value", "text"}, ...]."""
    return next((row.get("options", []) for row in _table() if row["id"] == method), [])


def _table():
    """What `suture methods` has, asked for once."""
    try:
        path = find()
        key = (path, Path(path).stat().st_mtime)
        if key not in _tables:
            _tables[key] = _ask_for_methods(path)
        return _tables[key]
    except (ProgramMissing, OSError, ValueError, KeyError, subprocess.SubprocessError):
        return _USUAL


def _ask_for_methods(path):
    done = subprocess.run(  # nosec B603: Audited: a list of arguments, no shell
        [path, "methods", "--json"],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        env=environment(),
        timeout=10,
        check=True,
    )
    answer = json.loads(done.stdout)
    _schemas.clear()
    _schemas[path] = answer.get("schema", 0)
    return answer["methods"]


def _runs(path):
    return os.path.isfile(path) and os.access(path, os.X_OK)
