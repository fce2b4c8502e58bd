# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a check: every edge, worst first, and what class it is of."""

from ..compat import QtCore, QtGui, QtWidgets, translate

COLORS = {
    "miss": (0.90, 0.10, 0.10),
    "unmeasured": (0.80, 0.10, 0.80),
    "free": (1.00, 0.55, 0.00),
    "G1": (0.10, 0.65, 0.20),
    "G2": (0.10, 0.40, 0.95),
    "G3": (0.05, 0.20, 0.60),
    "sharp": (0.45, 0.45, 0.50),
}
_EDGE = QtCore.Qt.UserRole


def class_name(key):
    return {
        "miss": translate("near miss"),
        "unmeasured": translate("not measured"),
        "free": translate("free edge"),
        "G1": translate("G1 tangent"),
        "G2": translate("G2 curvature"),
        "G3": translate("G3 change of curvature"),
        "sharp": translate("sharp"),
    }[key]


def class_of(edge):
    """What an edge counts as: a key of COLORS."""
    if not edge.measured:
        return "unmeasured"
    if edge.near_miss:
        return "miss"
    return "miss" if edge.kind == "G0" else edge.kind


def swatch(key):
    """A small square in the colour of a class."""
    square = QtGui.QPixmap(14, 14)
    square.fill(QtGui.QColor.fromRgbF(*COLORS[key]))
    return QtGui.QIcon(square)


class EdgesTable(QtWidgets.QTreeWidget):
    """One row for each edge."""

    def __init__(self):
        super().__init__()
        self.setObjectName("SutureEdges")
        self.setRootIsDecorated(False)
        self.setHeaderLabels(
            [
                translate("Edge"),
                translate("Class"),
                translate("Gap"),
                translate("Angle"),
                translate("Curvature"),
                translate("Faces"),
            ]
        )
        self.setMinimumHeight(170)

    def show(self, edges):
        for edge in edges:
            self._add(edge)
        for column in range(self.columnCount()):
            self.resizeColumnToContents(column)

    def chosen(self):
        """The edge whose row is chosen, or None."""
        rows = self.selectedItems()
        return rows[0].data(0, _EDGE) if rows else None

    def show_edge(self, number):
        """Chooses the row of an edge, without telling anybody."""
        for index in range(self.topLevelItemCount()):
            row = self.topLevelItem(index)
            if row.data(0, _EDGE).edge == number:
                self.blockSignals(True)
                self.setCurrentItem(row)
                self.blockSignals(False)
                self.scrollToItem(row)

    def _add(self, edge):
        kind = class_of(edge)
        row = QtWidgets.QTreeWidgetItem(
            [
                f"Edge{edge.edge}",
                class_name(kind),
                _number(edge.gap, "mm"),
                _number(edge.angle, "°"),
                _number(None if edge.curvature is None else 100 * edge.curvature, "%"),
                ", ".join(f"Face{face}" for face in edge.faces),
            ]
        )
        row.setIcon(1, swatch(kind))
        row.setData(0, _EDGE, edge)
        for column, tip in ((0, edge.note), (2, edge.bound_text("gap")), (3, edge.bound_text("angle"))):
            if tip:
                row.setToolTip(column, tip)
        if edge.proven:
            row.setText(2, row.text(2) + " ✓")
            row.setText(3, row.text(3) + " ✓")
        self.addTopLevelItem(row)


def _number(value, unit):
    return "" if value is None else f"{value:.3g} {unit}"
