# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sides of the ticked holes: what is asked for at each, and what was measured there."""

from .. import words
from ..compat import QtCore, QtGui, QtWidgets, translate
from ..options import CONTINUITIES
from . import pick

_MISSED = QtGui.QColor("#7a2a08"), QtGui.QColor("#fadfd2")  # letters and ground, in any theme
_EDGE = QtCore.Qt.UserRole


class SidesTable(QtWidgets.QTreeWidget):
    """One row for each edge; a click selects it in the view."""

    changed = QtCore.Signal()

    def __init__(self, tree, item):
        super().__init__()
        self.setObjectName("SutureSides")
        self.wanted = {}  # by FreeCAD's number of the edge
        self._tree, self._item, self._combos = tree, item, {}
        self.setRootIsDecorated(False)
        self.setHeaderLabels(
            [
                translate("Side"),
                translate("Joins"),
                translate("Reached"),
                translate("Gap"),
                translate("Angle"),
                translate("Curvature"),
            ]
        )
        self.itemClicked.connect(self._select)

    def show_holes(self, holes):
        self.clear()
        self._combos = {}
        for hole in holes:
            for edge in hole.edges:
                self._add(edge)
        self._fit()

    def show_edge(self, number):
        """Brings the row of an edge of the object into view. Result   whether there is one"""
        for row in self._rows():
            if self._tree.number(row.data(0, _EDGE)) == number:
                self.setCurrentItem(row)
                self.scrollToItem(row)
                return True
        return False

    def asked(self):
        """{edge: continuity} of the sides that do not follow the whole."""
        return {edge: wanted for edge, wanted in self.wanted.items() if edge in self._combos}

    def measured(self, report):
        """Shows what the report says of each side."""
        sides = {side.edge: side for hole in report.holes for side in hole.sides}
        for row in self._rows():
            side = sides.get(row.data(0, _EDGE))
            if side is not None:
                self._show(row, side, report.limits)
        self._fit()

    def clear_measured(self):
        for row in self._rows():
            for column in (2, 3, 4, 5):
                row.setText(column, "")
                row.setData(column, QtCore.Qt.ForegroundRole, None)
                row.setData(column, QtCore.Qt.BackgroundRole, None)

    def leave(self):
        self._combos = {}

    def _show(self, row, side, limits):
        row.setText(2, words.side_reached(side, limits) or "–")
        row.setText(3, _short(side.gap, "mm"))
        percent = None if side.curvature is None else 100 * side.curvature
        row.setText(4, _unless_free(_short(side.angle, "°"), side.wanted in ("G1", "G2")))
        row.setText(5, _unless_free(_short(percent, "%"), side.wanted == "G2"))
        combo = self._combos.get(self._tree.number(side.edge))
        if combo is not None:
            combo.setItemText(0, translate("as above: {}").format(side.wanted))
        faults = words.side_faults(side, limits)
        for kind, column in (("gap", 3), ("angle", 4), ("curvature", 5)):
            missed = any(fault[0] == kind for fault in faults)
            row.setData(column, QtCore.Qt.ForegroundRole, _MISSED[0] if missed else None)
            row.setData(column, QtCore.Qt.BackgroundRole, _MISSED[1] if missed else None)
        tip = [translate("Asked for {}: {}").format(side.wanted, side.reason)]
        if side.wanted == "G0":
            tip.append(translate("In brackets: not asked for, so no fault."))
        for column in range(6):
            row.setToolTip(column, "\n".join([*tip, *map(words.fault_text, faults)]))

    def _add(self, edge):
        row = QtWidgets.QTreeWidgetItem([self._tree.name(edge)])
        row.setData(0, _EDGE, edge)
        self.addTopLevelItem(row)
        number = self._tree.number(edge)
        if number is None:
            return
        combo = QtWidgets.QComboBox()
        combo.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToContents)
        combo.addItems([translate("as above"), *CONTINUITIES[1:]])
        combo.setObjectName(f"SutureSide{number}")
        combo.setToolTip(translate("How the new face joins at this edge"))
        if number in self.wanted:
            combo.setCurrentText(self.wanted[number])
        combo.currentIndexChanged.connect(lambda index: self._want(number, index))
        self._combos[number] = combo
        self.setItemWidget(row, 1, combo)

    def _want(self, number, index):
        if index == 0:
            self.wanted.pop(number, None)
        else:
            self.wanted[number] = CONTINUITIES[index]
        self.changed.emit()

    def _fit(self):
        for column in range(self.columnCount()):
            self.resizeColumnToContents(column)

    def _rows(self):
        return [self.topLevelItem(index) for index in range(self.topLevelItemCount())]

    def _select(self, row, column):
        number = self._tree.number(row.data(0, _EDGE))
        if number:
            pick.select_edges(self._item, [number])


def _short(value, unit):
    return "" if value is None else f"{value:.3g} {unit}"


def _unless_free(text, asked):
    """A figure that nobody asked for stands in brackets."""
    return text if asked or not text else f"({text})"
