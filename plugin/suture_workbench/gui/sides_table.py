# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sides of the ticked holes: what is asked for at each, and what was measured there."""

from ..compat import QtCore, QtWidgets, translate
from ..options import CONTINUITIES
from . import pick


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

    def asked(self):
        """{edge: continuity} of the sides that do not follow the whole."""
        return {edge: wanted for edge, wanted in self.wanted.items() if edge in self._combos}

    def measured(self, report):
        """Shows what the report says of each side."""
        for hole in report.holes:
            for side in hole.sides:
                row = self._row(side.edge)
                if row is None:
                    continue
                row.setText(2, _short(side.gap, "mm"))
                row.setText(3, _short(side.angle, "°"))
                percent = None if side.curvature is None else 100 * side.curvature
                row.setText(4, _short(percent, "%"))
                for column in range(5):
                    row.setToolTip(column, f"{side.wanted}: {side.reason}")
        self._fit()

    def clear_measured(self):
        for index in range(self.topLevelItemCount()):
            for column in (2, 3, 4):
                self.topLevelItem(index).setText(column, "")

    def leave(self):
        self._combos = {}

    def _add(self, edge):
        row = QtWidgets.QTreeWidgetItem([self._tree.name(edge)])
        row.setData(0, QtCore.Qt.UserRole, edge)
        self.addTopLevelItem(row)
        number = self._tree.number(edge)
        if number is None:
            return
        combo = QtWidgets.QComboBox()
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
        for column in range(5):
            self.resizeColumnToContents(column)

    def _row(self, edge):
        for index in range(self.topLevelItemCount()):
            row = self.topLevelItem(index)
            if row.data(0, QtCore.Qt.UserRole) == edge:
                return row
        return None

    def _select(self, row, column):
        number = self._tree.number(row.data(0, QtCore.Qt.UserRole))
        if number:
            pick.select_edges(self._item, [number])


def _short(value, unit):
    return "" if value is None else f"{value:.3g} {unit}"
