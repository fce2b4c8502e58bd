# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert: files on disk into other files, with their holes filled, without opening them."""

from pathlib import Path

from .. import RESOURCES, reports, tasks
from ..compat import QtWidgets, translate
from ..options import FillOptions
from . import failures
from .progress import Watcher
from .widgets import Panel, Status

_FORMATS = [
    ("STEP", ".step"),
    ("IGES", ".iges"),
    ("BREP", ".brep"),
    ("STL", ".stl"),
    ("3MF", ".3mf"),
    ("OBJ", ".obj"),
    ("OFF", ".off"),
]
_MODELS = "*.step *.stp *.p21 *.iges *.igs *.brep *.brp"


class ConvertPanel(Panel):
    """Task panel of the command Convert files."""

    icon = str(RESOURCES / "icons" / "Suture_Convert.svg")

    def __init__(self):
        self.title = translate("Convert files")
        super().__init__()
        self.files, self._waiting, self._problems = [], [], []
        self.list = QtWidgets.QListWidget()
        self.list.setObjectName("SutureFiles")
        choose = QtWidgets.QPushButton(translate("Choose files…"))
        choose.clicked.connect(self._choose)
        self.format = QtWidgets.QComboBox()
        self.format.setObjectName("SutureFormat")
        self.format.addItems([name for name, _ in _FORMATS])
        self.fill = QtWidgets.QCheckBox(translate("Fill holes"))
        self.fill.setChecked(True)
        self.sew = QtWidgets.QCheckBox(translate("Sew loose faces"))
        self.sew.setChecked(True)
        self.fill.toggled.connect(lambda on: self.sew.setEnabled(not on))
        self.sew.setEnabled(False)
        self.run = QtWidgets.QPushButton(translate("Convert"))
        self.run.setObjectName("SutureRunConvert")
        self.run.clicked.connect(self.convert)
        self._watcher = Watcher(self._done, self._failed, self._advance)
        self.status = Status(self._stop)
        form = QtWidgets.QFormLayout()
        form.addRow(translate("To"), self.format)
        for widget in (choose, self.list):
            self.layout.addWidget(widget)
        self.layout.addLayout(form)
        for widget in (self.fill, self.sew, self.run, self.status):
            self.layout.addWidget(widget)
        self.set_files([])

    def set_files(self, files):
        self.files = [Path(path) for path in files]
        self.list.clear()
        self.list.addItems([path.name for path in self.files])
        self.run.setEnabled(bool(files))

    def target(self, source):
        """Where the result goes: beside the file, under a name of its own."""
        suffix = _FORMATS[self.format.currentIndex()][1]
        ending = "_filled" if self.fill.isChecked() else ""
        target = source.with_name(source.stem + ending + suffix)
        return target if target != source else source.with_name(source.stem + "_converted" + suffix)

    def convert(self):
        self._waiting, self._problems = list(self.files), []
        self.run.setEnabled(False)
        self._next()

    def _choose(self):
        files, _ = QtWidgets.QFileDialog.getOpenFileNames(
            self.form, translate("Files to convert"), "", f"{translate('Models')} ({_MODELS})"
        )
        if files:
            self.set_files(files)

    def _next(self):
        if not self._waiting:
            self.run.setEnabled(True)
            done = translate("{} of {} files written.").format(
                len(self.files) - len(self._problems), len(self.files)
            )
            say = self.status.bad if self._problems else self.status.good
            say("\n".join([done, *self._problems]))
            return
        source = self._waiting[0]
        options = FillOptions() if self.fill.isChecked() else None
        self._watcher.start(
            tasks.ConvertFile(source, self.target(source), options, self.sew.isChecked())
        )

    def _advance(self, fraction, stage):
        self.status.advance(fraction, f"{self._waiting[0].name}: {stage}")

    def _done(self, document):
        source = self._waiting.pop(0)
        row = self.list.item(self.files.index(source))
        row.setText(f"{source.name} → {self.target(source).name}")
        row.setToolTip(document["verdict"])
        if "holes" in document and not reports.fill(document).ok:
            row.setToolTip(reports.shortfall(reports.fill(document)))
            row.setText(row.text() + " " + translate("(see tooltip)"))
        self._next()

    def _failed(self, error):
        source = self._waiting.pop(0)
        text = failures.text_of(error)
        self._problems.append(f"{source.name}: {text}")
        self.list.item(self.files.index(source)).setToolTip(text)
        self._next()

    def _stop(self):
        self._waiting = []
        self._watcher.cancel()
        self.run.setEnabled(True)
        self.status.plain(translate("Stopped."))

    def leave(self):
        self._stop()
