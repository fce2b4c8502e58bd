# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the program, from a downloaded bundle or wheel, where the workbench finds it. Needs no window."""

import importlib.util
import os
import shutil
import stat
import subprocess  # nosec B404: Audited: only the program that the user has chosen, without a shell
import tarfile
import tempfile
import zipfile
from pathlib import Path

import FreeCAD as App

from .compat import translate
from .errors import SutureError

NAME = "suture.exe" if os.name == "nt" else "suture"
_ENDINGS = (".tar.xz", ".tar.gz", ".tgz", ".zip", ".whl")


def home():
    """The folder of the installed program, in the user's own folder of FreeCAD."""
    return Path(App.getUserAppDataDir()) / "Suture" / "program"


def installed():
    """The program that `install` has put there, or None."""
    return _program_in(home())


def in_python():
    """The program within a wheel that FreeCAD's Python has, or None."""
    try:
        spec = importlib.util.find_spec("suture")
    except (ImportError, ValueError):
        return None
    places = (spec.submodule_search_locations or []) if spec else []
    return next(filter(None, (_program_in(Path(place)) for place in places)), None)


def install(archive):
    """Installs a bundle or wheel in place of what was installed before. Result   the program's path

    Refuses   files that are no archive, hold no program, or one that does not run here; what was
              installed stays then
    """
    archive = Path(archive)
    if not archive.name.endswith(_ENDINGS):
        raise SutureError(
            translate("{} is neither a bundle (.tar.xz) nor a wheel (.whl).").format(archive.name)
        )
    home().parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=home().parent, prefix="new-") as folder:
        folder = Path(folder) / "program"
        try:
            _unpack(archive, folder)
        except (tarfile.TarError, zipfile.BadZipFile, OSError, EOFError) as error:
            raise SutureError(
                translate("{} cannot be unpacked: {}").format(archive.name, error)
            ) from error
        program = _program_in(folder)
        if program is None:
            raise SutureError(
                translate("{} holds no program bin/{}.").format(archive.name, NAME)
            )
        version(program)
        shutil.rmtree(home(), ignore_errors=True)
        folder.rename(home())
    return installed()


def version(program):
    """What a program says of its version; SutureError if it does not run or is not Suture."""
    try:
        done = subprocess.run(  # nosec B603: Audited: a list of arguments, no shell
            [str(program), "--version"],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=20,
            check=False,
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise SutureError(translate("{} does not run: {}").format(program, error)) from error
    said = (done.stdout or done.stderr).strip()
    if done.returncode != 0 or "suture" not in said.lower():
        raise SutureError(
            translate("{} is not Suture, or does not run here: {}").format(program, said[:300])
        )
    return said.splitlines()[0]


def _program_in(folder):
    found = sorted(folder.glob(f"**/bin/{NAME}")) if folder.is_dir() else []
    return next((path for path in found if os.access(path, os.X_OK)), None)


def _unpack(archive, folder):
    """Nothing of an archive may come to lie outside of the folder."""
    root = folder.resolve()

    def inside(path):
        path = Path(os.path.normpath(root / path))
        if path != root and root not in path.parents:
            raise OSError(f"{path} lies outside of the archive")
        return path

    if archive.suffix in (".zip", ".whl"):
        with zipfile.ZipFile(archive) as file:
            for entry in file.infolist():
                path = inside(entry.filename)
                file.extract(entry, root)
                mode = entry.external_attr >> 16
                if mode and not entry.is_dir():
                    path.chmod(stat.S_IMODE(mode))
        return
    with tarfile.open(archive) as file:
        for entry in file.getmembers():
            path = inside(entry.name)
            if entry.issym():
                inside(path.parent / entry.linkname)
            elif entry.islnk():
                inside(entry.linkname)
            elif not (entry.isfile() or entry.isdir()):
                raise OSError(f"{entry.name} is neither file nor folder")
        filtered = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}
        file.extractall(root, **filtered)  # nosec B202: Audited: every member was looked at above
