# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that a file describes: choose it, see what comes of it, OK."""

from pathlib import Path

import FreeCAD as App

from .. import RESOURCES, api, exchange, tasks, words
from ..compat import QtWidgets, translate
from ..errors import SutureError
from ..options import SURFACES
from . import failures
from .forms import put
from .panel import Buttons, Panel
from .preview import Preview
from .progress import Watcher
from .widgets import Status

_ICONS = {"patch": "Suture_Patch", "algebraic": "Suture_Algebraic"}


class SurfacePanel(Panel):
    """Task panel of the commands Patch from a mesh and Algebraic surface."""

    buttons = (Buttons.Ok, Buttons.Cancel)

    def __init__(self, command):
        self.command = command
        self.title = words.surface_name(command)
        self.icon = str(RESOURCES / "icons" / f"{_ICONS[command]}.svg")
        super().__init__("surface_file")
        self._file, self._made = None, None
        self._drawing = Preview(App.Placement())
        self._watcher = Watcher(self._done, self._failed, self._advance)
        self.status = put(self.form, "statusPlace", Status(self._stop))
        explained = {
            "patch": translate(
                "The mesh: layers of quads around a hole of three or more sides, in an OBJ file. The "
                "surface follows it as a B-spline follows its control points."
            ),
            "algebraic": translate(
                "The problem: polynomials and planes around a hole, in a JSON file. The surface "
                "joins them, computed in exact arithmetic."
            ),
        }[command]
        self.child("SutureExplained").setText(f"<small>{explained}</small>")
        self.child("patchOptions").setVisible(command == "patch")
        middle = self.child("SutureMiddle", QtWidgets.QComboBox)
        for key, name in (
            (None, translate("quads, or exact where these do not do")),
            ("quads", translate("fitted quads")),
            ("exact", translate("exact cells")),
        ):
            middle.addItem(name, key)
        self.child("SutureChooseFile").clicked.connect(self._choose)
        self.child("SutureOrder").setValue(2)
        for signal in (
            self.child("SutureOrder").valueChanged,
            middle.currentIndexChanged,
            self.child("SutureAperture").valueChanged,
        ):
            signal.connect(self._start)
        self.status.plain(translate("Choose the file."))

    def own(self):
        """What the program is told besides the file."""
        if self.command != "patch":
            return {}
        said = {"k": self.child("SutureOrder").value()}
        aperture = self.child("SutureAperture").value()
        if aperture > 0.0:  # 0 is shown as "automatic"
            said["aperture"] = aperture
        middle = self.child("SutureMiddle").currentData()
        return said | ({middle: True} if middle else {})

    def set_file(self, path):
        """Takes a file, and makes its surface."""
        self._file = Path(path)
        button = self.child("SutureChooseFile")
        button.setText(self._file.name)
        button.setToolTip(str(path))
        self._start()

    def _choose(self):
        pattern = SURFACES[self.command]
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self.form, self.title, "", f"{pattern[2:].upper()} ({pattern})"
        )
        if path:
            self.set_file(path)

    def _start(self, *_):
        self._made = None
        self._drawing.clear()
        if self._file is not None:
            self.status.advance(0.0, translate("Working…"))
            self._watcher.start(tasks.MakeSurface(self.command, self._file, self.own()))

    def _advance(self, fraction, stage):
        self.status.advance(fraction, stage)

    def _done(self, made):
        self._made = shape, document = made
        every = range(1, len(shape.Faces) + 1)
        origins = exchange.face_origins(every, 0, len(shape.Faces))
        self._drawing.show(tasks.Filled(shape, None, list(every), origins), shape)
        text, well = words.surface_summary(document)
        (self.status.good if well else self.status.bad)(text)

    def _failed(self, error):
        if isinstance(error, SutureError):  # which folder it is in, the button says
            text = str(error).replace(str(self._file), self._file.name)
            error = type(error)(text, error.edges)
        failures.report(self.status, error, None)

    def _stop(self):
        self._watcher.cancel()
        self.status.plain(translate("Stopped."))

    def accept(self):
        """OK: what is shown becomes an object."""
        if self._made is None:
            wait = translate("Wait until the surface is there.")
            failures.show(SutureError(wait if self._watcher.busy() else self.status.label.text()))
            return False
        document = App.ActiveDocument
        obj = api.keep_surface(*self._made, self._file, document)
        self.close()
        App.setActiveDocument(obj.Document.Name)
        return True

    def leave(self):
        self._watcher.cancel()
        self._drawing.close()
