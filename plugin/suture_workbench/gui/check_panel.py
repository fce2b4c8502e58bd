# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check continuity: a table of edges, worst first, and the same in colours."""

import json
from pathlib import Path

import FreeCADGui as Gui

from .. import RESOURCES, meshes, places, reports, settings, tasks
from ..compat import QtCore, QtGui, QtWidgets, translate
from ..errors import SutureError
from ..options import PROFILES, CheckOptions
from . import failures, overlay, pick, reflection
from .progress import Watcher, run_with_dialog
from .widgets import Panel, Status, heading, number_box

_COLORS = {
    "miss": (0.90, 0.10, 0.10),
    "unmeasured": (0.80, 0.10, 0.80),
    "free": (1.00, 0.55, 0.00),
    "G1": (0.10, 0.65, 0.20),
    "G2": (0.10, 0.40, 0.95),
    "G3": (0.05, 0.20, 0.60),
    "sharp": (0.45, 0.45, 0.50),
}
_MARK = (1.0, 0.0, 0.6)
_ROLE = QtCore.Qt.UserRole


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
    """What an edge counts as: a key of _COLORS."""
    if not edge.measured:
        return "unmeasured"
    if edge.near_miss:
        return "miss"
    return "miss" if edge.kind == "G0" else edge.kind


class CheckPanel(Panel):
    """Task panel of the command Check continuity."""

    icon = str(RESOURCES / "icons" / "Suture_Check.svg")

    def __init__(self, item):
        self.title = translate("Check continuity")
        super().__init__()
        self.item = item
        self.shape = places.local_shape(item.obj)
        self.placement = places.shown_at(item)
        self.report = self.measured = None
        self._hidden = set()
        self._lines = overlay.Overlay(self.placement)
        self._extra = overlay.Overlay(self.placement)
        self._mark = overlay.Overlay(self.placement)
        self._legend = overlay.Overlay()
        self._watcher = Watcher(self._done, self._failed, self._advance)
        Gui.Selection.clearSelection()  # its colour would hide those of the classes
        self._build()
        self.measure()

    def _build(self):
        self.profile = QtWidgets.QComboBox()
        self.profile.setObjectName("SutureProfile")
        self.profile.addItems([*PROFILES, translate("own limits")])
        self.limits = [
            number_box(settings.gap(), "mm", translate("Largest gap between two faces")),
            number_box(settings.angle(), "°", translate("Largest angle of a tangent edge")),
            number_box(
                settings.curvature(), "%", translate("Largest curvature mismatch of a G2 edge")
            ),
            number_box(5.0, "°", translate("From this angle on an edge is meant to be sharp")),
        ]
        row = QtWidgets.QGridLayout()
        for index, box in enumerate(self.limits):
            box.setEnabled(False)
            box.valueChanged.connect(self._limit_changed)
            row.addWidget(box, index // 2, index % 2)
        self.only = QtWidgets.QCheckBox(translate("Selected edges only"))
        self.only.setChecked(bool(self.item.edges))
        self.only.setEnabled(bool(self.item.edges))
        self.table = QtWidgets.QTreeWidget()
        self.table.setObjectName("SutureEdges")
        self.table.setRootIsDecorated(False)
        self.table.setHeaderLabels(
            [
                translate("Edge"),
                translate("Class"),
                translate("Gap"),
                translate("Angle"),
                translate("Curvature"),
                translate("Faces"),
            ]
        )
        self.table.setMinimumHeight(200)
        self.table.itemSelectionChanged.connect(self._show_worst)
        self.legend = QtWidgets.QListWidget()
        self.legend.setObjectName("SutureLegend")
        self.legend.setMaximumHeight(80)
        self.legend.itemChanged.connect(self._tick_class)
        self.zebra = QtWidgets.QCheckBox(translate("Zebra stripes"))
        self.zebra.setObjectName("SutureZebraBox")
        self.combs = QtWidgets.QCheckBox(translate("Curvature combs at the chosen edge"))
        self.combs.setObjectName("SutureCombsBox")
        self.save = QtWidgets.QPushButton(translate("Export report…"))
        self.save.setObjectName("SutureExportReport")
        self.save.setEnabled(False)
        self.status = Status(self._watcher.cancel)
        form = QtWidgets.QFormLayout()
        form.addRow(translate("Profile"), self.profile)
        self.layout.addWidget(heading(self.item.obj.Label))
        self.layout.addLayout(form)
        self.layout.addLayout(row)
        for widget in (
            self.only,
            self.table,
            self.status,
            self.legend,
            self.zebra,
            self.combs,
            self.save,
        ):
            self.layout.addWidget(widget)
        self.profile.currentIndexChanged.connect(self._profile_changed)
        self.only.toggled.connect(self.measure)
        self.zebra.toggled.connect(self._draw_extra)
        self.combs.toggled.connect(self._draw_extra)
        self.save.clicked.connect(self._ask_and_save)

    # -- measuring

    def options(self):
        """CheckOptions as the panel stands."""
        edges = self.item.edges if self.only.isChecked() else []
        if self.profile.currentIndex() < len(PROFILES):
            return CheckOptions(self.profile.currentText(), edges=edges)
        values = [box.value() for box in self.limits]
        return CheckOptions("catia", *values, edges=edges)

    def measure(self, *_):
        self._clear()
        self._watcher.start(tasks.CheckContinuity(self.shape, self.options()))

    def _profile_changed(self, index):
        for box in self.limits:
            box.setEnabled(index >= len(PROFILES))
        self.measure()

    def _limit_changed(self, *_):
        if self.profile.currentIndex() >= len(PROFILES):
            self.measure()

    def _advance(self, fraction, stage):
        self.status.advance(fraction, stage)

    def _failed(self, error):
        self.status.bad(failures.text_of(error))
        failures.select(error, self.item)

    def _done(self, result):
        self.report, self.measured = result
        limits = self.report.limits
        for box, value in zip(
            self.limits, (limits.gap, limits.angle, limits.curvature, limits.sharp)
        ):
            box.blockSignals(True)
            box.setValue(value)
            box.blockSignals(False)
        for edge in self.report.edges:
            self._add(edge)
        for column in range(6):
            self.table.resizeColumnToContents(column)
        if self.report.near_misses or any(not edge.measured for edge in self.report.edges):
            self.status.bad(self.report.verdict)
        else:
            self.status.good(self.report.verdict)
        self.save.setEnabled(True)
        self._show_legend()
        self._draw()

    # -- the table

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
        row.setForeground(1, QtGui.QColor.fromRgbF(*_COLORS[kind]))
        row.setData(0, _ROLE, edge)
        if edge.note:
            row.setToolTip(0, edge.note)
        self.table.addTopLevelItem(row)

    def chosen(self):
        rows = self.table.selectedItems()
        return rows[0].data(0, _ROLE) if rows else None

    def _show_worst(self):
        edge = self.chosen()
        self._mark.clear()
        if edge is None:
            return
        if self.measured is self.shape:  # else the numbers are those of the sewn shape
            pick.select_edges(self.item, [edge.edge])
        point = reports.worst_point(edge, self.report.limits)
        if point:
            self._mark.markers([point], _MARK)
            pick.look_at([point], self.placement, max(edge.length / 6, 1e-3))
        self._draw_extra()

    # -- drawing

    def _clear(self):
        self.table.clear()
        self.legend.clear()
        for layer in (self._lines, self._mark, self._legend):
            layer.clear()

    def _groups(self):
        groups = {}
        for edge in self.report.edges:
            groups.setdefault(class_of(edge), []).append(edge.edge)
        if self.report.free_edges:
            groups["free"] = self.report.free_edges
        return {key: groups[key] for key in _COLORS if key in groups}

    def _draw(self):
        deflection = meshes.fineness(self.measured)
        self._lines.clear()
        self._legend.clear()
        rows = []
        for key, numbers in self._groups().items():
            rows.append((f"{class_name(key)}: {len(numbers)}", _COLORS[key]))
            if key not in self._hidden:
                edges = (self.measured.Edges[number - 1] for number in numbers)
                lines = [meshes.outline(edge, deflection) for edge in edges if not edge.Degenerated]
                self._lines.lines(lines, _COLORS[key], 2.5 if key == "sharp" else 5.0)
        self._legend.legend(rows)

    def _show_legend(self):
        self.legend.blockSignals(True)
        for key, numbers in self._groups().items():
            entry = QtWidgets.QListWidgetItem(f"{class_name(key)}: {len(numbers)}")
            swatch = QtGui.QPixmap(14, 14)
            swatch.fill(QtGui.QColor.fromRgbF(*_COLORS[key]))
            entry.setIcon(QtGui.QIcon(swatch))
            entry.setData(_ROLE, key)
            entry.setCheckState(QtCore.Qt.Unchecked if key in self._hidden else QtCore.Qt.Checked)
            self.legend.addItem(entry)
        self.legend.blockSignals(False)

    def _tick_class(self, entry):
        change = (
            self._hidden.discard if entry.checkState() == QtCore.Qt.Checked else self._hidden.add
        )
        change(entry.data(_ROLE))
        self._draw()

    def _draw_extra(self, *_):
        self._extra.clear()
        if self.zebra.isChecked():
            reflection.zebra_nodes(self._extra, self.measured or self.shape)
        edge = self.chosen()
        if self.combs.isChecked() and edge is not None:
            reflection.comb_nodes(self._extra, self.measured, [edge.edge])

    # -- the report

    def _ask_and_save(self):
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self.form,
            translate("Export report"),
            f"{self.item.obj.Label}.html",
            translate("Report to look at (*.html);;Table (*.csv);;For programs (*.json)"),
        )
        if path:
            try:
                self.export(path)
            except (SutureError, OSError) as error:
                failures.show(SutureError(str(error)))

    def export(self, path):
        """Writes the report as .html, .csv or .json."""
        suffix = Path(path).suffix.lower()
        if suffix == ".csv":
            Path(path).write_text(reports.check_as_csv(self.report), encoding="utf-8")
        elif suffix == ".json":
            Path(path).write_text(json.dumps(self.report.document, indent=2), encoding="utf-8")
        elif suffix in (".html", ".htm"):
            run_with_dialog(tasks.CheckContinuity(self.shape, self.options(), html=path))
        else:
            raise SutureError(
                translate("A report ends in .html, .csv or .json, not {}.").format(suffix)
            )

    def leave(self):
        self._watcher.cancel()
        for layer in (self._lines, self._extra, self._mark, self._legend):
            layer.close()


def _number(value, unit):
    return "" if value is None else f"{value:.3g} {unit}"
