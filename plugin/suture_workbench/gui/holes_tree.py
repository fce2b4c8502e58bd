# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of holes with tick boxes that both panels show, and its drawing in the view."""

from .. import facing, meshes
from ..compat import QtCore, QtWidgets, translate
from ..reports import FILLABLE
from . import camera, overlay, pick
from .widgets import length

_SMOOTH_DEGREES = 1.0  # corners whose neighbours' normals differ by less count as smooth
_GREEN, _GREY = (0.10, 0.85, 0.25), (0.45, 0.45, 0.50)
_ROLE = QtCore.Qt.UserRole


def kind_name(kind):
    return {
        "hole": translate("Hole"),
        "rim": translate("Rim"),
        "seam": translate("Seam"),
        "slit": translate("Slit"),
        "ambiguous": translate("Doubtful"),
    }.get(kind, kind)


def neighbours(hole):
    """The state of a hole's neighbours in a few words."""
    worst = max(hole.corners, key=lambda corner: corner.mismatch or 0.0, default=None)
    if worst is None or (worst.mismatch or 0.0) <= _SMOOTH_DEGREES:
        return translate("smooth at every corner")
    before, after = worst.faces
    return translate("Face{} and Face{} meet at {:.3g}°").format(before, after, worst.mismatch)


class HolesTree(QtWidgets.QTreeWidget):
    """Holes first and ticked; rims, seams and the like apart and not ticked."""

    ticked_changed = QtCore.Signal()

    def __init__(self, item, placement):
        super().__init__()
        self.setObjectName("SutureHoles")
        self._item, self._found = item, None
        self._overlay = overlay.Overlay(placement)
        self._placement = placement
        self.setHeaderLabels(
            [
                translate("Hole"),
                translate("Sides"),
                translate("Size"),
                translate("Neighbours"),
            ]
        )
        self.setAlternatingRowColors(True)
        self.setIndentation(10)
        self.setMinimumHeight(110)
        self.itemSelectionChanged.connect(self._show_selected)
        self.itemChanged.connect(lambda row, column: self.ticked_changed.emit())

    def fill(self, found, ticked=None):
        """Shows what FindHoles has found. ticked   predicate on holes; all holes without one"""
        self.blockSignals(True)
        self.clear()
        self._found = found
        self._groups = {}
        for hole in found.report.holes if found.report else []:
            tick = hole.kind == FILLABLE if ticked is None else ticked(hole)
            self._add(hole, tick)
        self.blockSignals(False)
        for column in range(self.columnCount()):
            self.resizeColumnToContents(column)
        self._draw([])

    def tick(self, wanted):
        """Ticks the holes that a predicate is true of, and no other."""
        self.blockSignals(True)
        for row in self.rows():
            if row.data(0, QtCore.Qt.CheckStateRole) is not None:
                on = wanted(row.data(0, _ROLE))
                row.setCheckState(0, QtCore.Qt.Checked if on else QtCore.Qt.Unchecked)
        self.blockSignals(False)
        self.ticked_changed.emit()

    def rows(self):
        return [
            self.topLevelItem(g).child(i)
            for g in range(self.topLevelItemCount())
            for i in range(self.topLevelItem(g).childCount())
        ]

    def holes(self):
        return self._found.report.holes if self._found and self._found.report else []

    def ticked(self):
        """The holes with a tick."""
        return [row.data(0, _ROLE) for row in self.rows() if row.checkState(0) == QtCore.Qt.Checked]

    def number(self, edge):
        """FreeCAD's number of an edge of the report; None for one that faces sewn have lost."""
        return self._found.number(edge)

    def name(self, edge):
        number = self.number(edge)
        return f"Edge{number}" if number else translate("edge {} (sewn)").format(edge)

    def choose(self, hole_id):
        """Selects the row of a hole."""
        for row in self.rows():
            if row.data(0, _ROLE).id == hole_id:
                self.setCurrentItem(row)

    def show_element(self, kind, number):
        """Shows the row of the hole that an edge bounds or a face lies beside; the camera stays."""
        for row in self.rows():
            hole = row.data(0, _ROLE)
            numbers = map(self.number, hole.edges) if kind == "Edge" else hole.faces
            if number in numbers:
                self.blockSignals(True)
                self.setCurrentItem(row)
                self.blockSignals(False)
                self.scrollToItem(row)
                self._draw([hole])
                return

    def leave(self):
        self._overlay.close()

    def _add(self, hole, tick):
        fillable = hole.kind == FILLABLE
        title = translate("Holes") if fillable else translate("Rims, seams and others: no holes")
        if title not in self._groups:
            group = QtWidgets.QTreeWidgetItem([title])
            self.addTopLevelItem(group)
            group.setFirstColumnSpanned(True)
            group.setExpanded(True)
            self._groups[title] = group
        row = QtWidgets.QTreeWidgetItem(
            [
                f"{kind_name(hole.kind)} {hole.id}",
                str(len(hole.edges)),
                length(hole.diameter),
                neighbours(hole),
            ]
        )
        row.setData(0, _ROLE, hole)
        if hole.kind != "seam":  # seams are sewn, not filled
            row.setCheckState(0, QtCore.Qt.Checked if tick else QtCore.Qt.Unchecked)
        edges = ", ".join(self.name(edge) for edge in hole.edges)
        for column in range(self.columnCount()):
            row.setToolTip(column, f"{edges}\n{hole.reason}")
        self._groups[title].addChild(row)

    def _show_selected(self):
        rows = [row for row in self.selectedItems() if row.data(0, _ROLE)]
        holes = [row.data(0, _ROLE) for row in rows]
        self._draw(holes)
        if not holes:
            return
        edges = [self.number(edge) for hole in holes for edge in hole.edges]
        pick.select_edges(self._item, [edge for edge in edges if edge])
        points = [corner for hole in holes for edge in hole.edges for corner in self._line(edge)]
        camera.look_at(
            points,
            self._placement,
            max(hole.diameter for hole in holes) * 0.4,
            facing.outward(self._found.shape, holes[0].edges, holes[0].faces),
        )

    def _line(self, edge):
        shape = self._found.shape
        return meshes.outline(shape.Edges[edge - 1], meshes.fineness(shape))

    def _draw(self, chosen):
        self._overlay.clear()
        for hole in self.holes():
            lines = [self._line(edge) for edge in hole.edges]
            if hole in chosen:
                self._overlay.lines(lines, _GREEN, 6.0)
            else:
                color = overlay.ORANGE if hole.kind == FILLABLE else _GREY
                self._overlay.lines(lines, color, 3.0)
