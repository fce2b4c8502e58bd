# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert: files on disk into other files, with their holes filled, without opening them."""

from pathlib import Path

from .. import RESOURCES, reports, tasks, words
from ..compat import QtWidgets, translate
from ..options import FillOptions
from . import failures
from .forms import put
from .panel import Panel
from .progress import Watcher
from .widgets import Status

_FORMATS = [
    ("STEP", ".step"),
    ("IGES", ".iges"),
    ("BREP", ".brep"),
    ("STL", ".stl"),
    ("3MF", ".3mf"),
    ("OBJ", ".obj"),
    ("OFF", ".off"),
    ("glTF", ".glb"),
]
_MODELS = "*.step *.stp *.p21 *.iges *.igs *.brep *.brp"


class ConvertPanel(Panel):
    """Task panel of the command Convert files."""

    icon = str(RESOURCES / "icons" / "Suture_Convert.svg")

    def __init__(self):
        self.title = translate("Convert files")
        super().__init__("convert")
        self.files, self._waiting, self._problems = [], [], []
        self.child("SutureChooseFiles").clicked.connect(self._choose)
        self._format().addItems([name for name, _ in _FORMATS])
        self.child("SutureFillFiles").setChecked(True)
        self.child("SutureSewFiles").setChecked(True)
        self.child("SutureFillFiles").toggled.connect(
            lambda on: self.child("SutureSewFiles").setEnabled(not on)
        )
        self.child("SutureSewFiles").setEnabled(False)
        self.child("SutureRunConvert").clicked.connect(self.convert)
        self._watcher = Watcher(self._done, self._failed, self._advance)
        self.status = put(self.form, "statusPlace", Status(self._stop))
        self.set_files([])

    def _list(self):
        return self.child("SutureFiles", QtWidgets.QListWidget)

    def _format(self):
        return self.child("SutureFormat", QtWidgets.QComboBox)

    def set_files(self, files):
        self.files = [Path(path) for path in files]
        self._list().clear()
        self._list().addItems([path.name for path in self.files])
        self.child("SutureRunConvert").setEnabled(bool(files))

    def target(self, source):
        """Where the result goes: beside the file, under a name of its own."""
        suffix = _FORMATS[self._format().currentIndex()][1]
        ending = "_filled" if self.child("SutureFillFiles").isChecked() else ""
        target = source.with_name(source.stem + ending + suffix)
        return target if target != source else source.with_name(source.stem + "_converted" + suffix)

    def convert(self):
        """Converts all; files that are there already are replaced only if the user says so."""
        there = [path for path in map(self.target, self.files) if path.exists()]
        if there and not failures.confirm_replacing(there):
            return
        self._waiting, self._problems = list(self.files), []
        self.child("SutureRunConvert").setEnabled(False)
        self._next()

    def _choose(self):
        files, _ = QtWidgets.QFileDialog.getOpenFileNames(
            self.form, translate("Files to convert"), "", f"{translate('Models')} ({_MODELS})"
        )
        if files:
            self.set_files(files)

    def _next(self):
        if not self._waiting:
            self.child("SutureRunConvert").setEnabled(True)
            done = translate("{} of {} files written.").format(
                len(self.files) - len(self._problems), len(self.files)
            )
            say = self.status.bad if self._problems else self.status.good
            say("\n".join([done, *self._problems]))
            return
        source = self._waiting[0]
        options = FillOptions() if self.child("SutureFillFiles").isChecked() else None
        self._watcher.start(
            tasks.ConvertFile(source, self.target(source), options, self.child("SutureSewFiles").isChecked())
        )

    def _advance(self, fraction, stage):
        self.status.advance(fraction, f"{self._waiting[0].name}: {stage}")

    def _done(self, document):
        source = self._waiting.pop(0)
        row = self._list().item(self.files.index(source))
        row.setText(f"{source.name} → {self.target(source).name}")
        if "holes" in document:
            row.setToolTip(words.fill_summary(reports.fill(document)))
        if "holes" in document and not reports.fill(document).ok:
            row.setToolTip(words.shortfall(reports.fill(document)))
            row.setText(row.text() + " " + translate("(see tooltip)"))
        self._next()

    def _failed(self, error):
        source = self._waiting.pop(0)
        text = failures.text_of(error)
        self._problems.append(f"{source.name}: {text}")
        self._list().item(self.files.index(source)).setToolTip(text)
        self._next()

    def _stop(self):
        self._waiting = []
        self._watcher.cancel()
        self.child("SutureRunConvert").setEnabled(True)
        self.status.plain(translate("Stopped."))

    def leave(self):
        self._stop()
