# SPDX-License-Identifier: LGPL-2.1-or-later
"""File > Export with holes filled."""

import shutil
import tempfile
from pathlib import Path

import FreeCAD as App

from . import reports, tasks, waiting, words
from .compat import translate
from .errors import NothingToDo
from .options import FillOptions
from .said import in_users_words


def export(objects, filename):
    """Writes objects to a STEP or IGES file, holes filled. Result   one line about it.

    FreeCAD writes names, colours and the assembly; the program keeps them.
    """
    target = Path(filename)
    with tempfile.TemporaryDirectory(prefix="suture-") as folder:
        plain = Path(folder) / "plain.step"
        _write_step(objects, plain)
        try:
            document = waiting.run(tasks.ConvertFile(plain, target, FillOptions()))
        except NothingToDo:
            return _write_unfilled(plain, target)
    report = reports.fill(document)
    if not report.ok:
        App.Console.PrintWarning(f"{target.name}: {words.shortfall(report)}\n")
    lost = [in_users_words(sentence) for sentence in document.get("lost") or []]
    return " ".join([words.fill_summary(report).replace("\n", " "), *lost])


def _write_step(objects, path):
    if App.GuiUp:
        import ImportGui as writer  # with colours
    else:
        import Import as writer
    writer.export(list(objects), str(path))


def _write_unfilled(plain, target):
    """There was no hole: the file as it is, converted where it has to be."""
    if target.suffix.lower() in (".step", ".stp"):
        shutil.copyfile(plain, target)
    else:
        waiting.run(tasks.ConvertFile(plain, target))
    return translate("There is no hole.")
