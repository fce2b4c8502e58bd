# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points and edges that a new face has to pass through."""

from pathlib import Path

import FreeCAD as App

from .. import places
from ..compat import QtCore, QtWidgets, translate
from ..errors import SutureError


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


class ThroughList(QtWidgets.QGroupBox):
    """`references` to vertices and edges of any object, and loose `points` of the base."""

    changed = QtCore.Signal()

    def __init__(self, base):
        super().__init__(translate("Pass through"))
        self.references, self.points = [], []
        self._base = base
        self.list = QtWidgets.QListWidget()
        self.list.setMaximumHeight(60)
        add = QtWidgets.QPushButton(translate("Add selected"))
        add.setObjectName("SutureAddThrough")
        add.setToolTip(
            translate("Select vertices or edges, of a sketch for example, then click here")
        )
        load = QtWidgets.QPushButton(translate("From file…"))
        load.setToolTip(translate("Points from a text file with x, y, z on each line"))
        clear = QtWidgets.QPushButton(translate("Clear"))
        row = QtWidgets.QHBoxLayout()
        for button, action in ((add, self._add), (load, self._load), (clear, self._clear)):
            button.clicked.connect(action)
            row.addWidget(button)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(self.list)
        layout.addLayout(row)
        self._show()

    def set(self, references, points):
        self.references = [(obj, tuple(subs)) for obj, subs in references or ()]
        self.points = list(points)
        self._show()

    def _add(self):
        import FreeCADGui as Gui

        for entry in Gui.Selection.getSelectionEx("", 0):
            for sub in entry.SubElementNames or ("",):
                obj, _, element = places.resolve(entry.Object, sub)
                if obj is self._base and not element:
                    continue
                self.references.append((obj, (element,)))
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
        from . import failures

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
        self.list.clear()
        for obj, subs in self.references:
            self.list.addItem(f"{obj.Label}  {', '.join(subs)}")
        if self.points:
            self.list.addItem(translate("{} points").format(len(self.points)))
        self.list.setVisible(self.list.count() > 0)
