# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points and edges that a new face has to pass through."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from .. import places
from ..compat import QtCore, QtWidgets, translate
from ..errors import SutureError
from . import failures
from .forms import find, load_form


def read_points(path):
    """Points of a text file: x, y, z on each line, separated by commas, semicolons or blanks."""
    points = []
    for number, line in enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1):
        words = line.replace(",", " ").replace(";", " ").split()
        if not words or words[0].startswith("#"):
            continue
        try:
            x, y, z = map(float, words)
        except ValueError as error:
            raise SutureError(
                translate("Line {} of {} is no point x, y, z: {}").format(number, path, line)
            ) from error
        points.append((x, y, z))
    if not points:
        raise SutureError(translate("{} holds no point x, y, z.").format(path))
    return points


class ThroughList(QtWidgets.QWidget):
    """`references` to vertices and edges of any object, and faces whose normals they take; and loose
    `points` of the base."""

    changed = QtCore.Signal()

    def __init__(self, base):
        super().__init__()
        self.references, self.points = [], []
        self._base = base
        self._form = form = load_form("through")
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(form)
        for name, action in (
            ("SutureAddThrough", self._add),
            ("SutureLoadThrough", self._load),
            ("SutureClearThrough", self._clear),
        ):
            find(form, name).clicked.connect(action)
        self._show()

    def set(self, references, points):
        self.references = [(obj, tuple(subs)) for obj, subs in references or ()]
        self.points = list(points)
        self._show()

    def _add(self):
        added = []
        for entry in Gui.Selection.getSelectionEx("", 0):
            for sub in entry.SubElementNames or ("",):
                obj, _, element = places.resolve(entry.Object, sub)
                if obj is not self._base or element[:4] in ("Edge", "Vert", "Face"):
                    added.append((obj, (element,)))
        if not added:
            failures.show(SutureError(translate("Select vertices or edges first.")))
            return
        self.references += added
        self._show()
        self.changed.emit()

    def _load(self):
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self,
            translate("Points to pass through"),
            "",
            translate("Text (*.csv *.txt *.xyz);;All files (*)"),
        )
        if path:
            self.load(path)

    def load(self, path):
        """Adds the points of a file; they are in the document's coordinates."""
        try:
            points = read_points(path)
        except (SutureError, OSError, UnicodeDecodeError) as error:
            failures.show(SutureError(str(error)))
            return
        back = places.to_document(self._base).inverse()
        self.points += [tuple(back.multVec(App.Vector(*point))) for point in points]
        self._show()
        self.changed.emit()

    def _clear(self):
        self.references, self.points = [], []
        self._show()
        self.changed.emit()

    def _show(self):
        shown = find(self._form, "SutureThrough", QtWidgets.QListWidget)
        shown.clear()
        for obj, subs in self.references:
            shown.addItem(f"{obj.Label}  {', '.join(subs)}")
        if self.points:
            shown.addItem(translate("{} points").format(len(self.points)))
        shown.setVisible(shown.count() > 0)
