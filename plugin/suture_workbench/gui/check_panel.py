# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check continuity: a table of edges, worst first, and the same in colours."""

import json
from pathlib import Path

import FreeCADGui as Gui

from .. import RESOURCES, meshes, places, readout, reports, tasks, words
from ..compat import QtCore, QtWidgets, translate
from ..errors import SutureError
from ..options import PROFILES, CheckOptions
from . import camera, failures, overlay, pick, reflection
from .choice import Choice
from .edges_table import COLORS, EdgesTable, class_name, class_of, swatch
from .forms import put
from .panel import Panel
from .progress import Watcher, run_with_dialog
from .surface_box import SurfaceBox
from .widgets import Status, limit_boxes, number_box, show_heading

_ROLE = QtCore.Qt.UserRole
_MARK = (1.0, 0.0, 0.6)
_OWN = "own"


class CheckPanel(Panel):
    """Task panel of the command Check continuity."""

    icon = str(RESOURCES / "icons" / "Suture_Check.svg")

    def __init__(self, item):
        self.title = translate("Check continuity")
        super().__init__("check")
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
        show_heading(self.child("SutureHeading"), self.item.obj.Label)
        self.profile = Choice(
            self.form,
            "SutureProfile",
            "SutureProfileExplained",
            [*PROFILES, _OWN],
            name=lambda key: translate("own limits") if key == _OWN else key,
            text=words.profile_text,
        )
        self.limits = limit_boxes(self.form)
        tip = translate("From this angle on an edge is meant to be sharp")
        self.limits.append(put(self.form, "sharpPlace", number_box(5.0, "°", tip)))
        for box in self.limits:
            box.setEnabled(False)
            box.valueChanged.connect(self._limit_changed)
        self.child("SutureSelectedOnly").setChecked(bool(self.item.edges))
        self.child("SutureSelectedOnly").setEnabled(bool(self.item.edges))
        self.status = put(self.form, "statusPlace", Status(self._watcher.cancel))
        self.table = put(self.form, "tablePlace", EdgesTable())
        self.table.itemSelectionChanged.connect(self._show_worst)
        self._legend_list().itemChanged.connect(self._tick_class)
        self.surface = put(self.form, "surfacePlace", SurfaceBox([self.item.obj]))
        self.surface.setVisible(False)
        self.child("SutureSurface").toggled.connect(self.surface.setVisible)
        self.child("SutureExportReport").setEnabled(False)
        self.profile.changed.connect(self._profile_changed)
        self.child("SutureSelectedOnly").toggled.connect(self.measure)
        self.child("SutureCertify").toggled.connect(self.measure)
        self.child("SutureCombsBox").toggled.connect(self._draw_extra)
        self.child("SutureExportReport").clicked.connect(self._ask_and_save)

    def _legend_list(self):
        return self.child("SutureLegend", QtWidgets.QListWidget)

    # -- measuring

    def options(self):
        """CheckOptions as the panel stands."""
        edges = self.item.edges if self.child("SutureSelectedOnly").isChecked() else []
        proven = self.child("SutureCertify").isChecked()
        if self.profile.key() != _OWN:
            return CheckOptions(self.profile.key(), edges=edges, certify=proven)
        values = [box.value() for box in self.limits]
        return CheckOptions("catia", *values, edges=edges, certify=proven)

    def measure(self, *_):
        self._clear()
        self._watcher.start(tasks.CheckContinuity(self.shape, self.options()))

    def _profile_changed(self, *_):
        own = self.profile.key() == _OWN
        for box in self.limits:
            box.setEnabled(own)
        if own:
            self.child("SutureLimits").setChecked(True)
        self.measure()

    def _limit_changed(self, *_):
        if self.profile.key() == _OWN:
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
        self.table.show(self.report.edges)
        text, well = words.check_summary(self.report)
        (self.status.good if well else self.status.bad)(text)
        self.child("SutureExportReport").setEnabled(True)
        self._show_legend()
        self._draw()

    # -- the table

    def picked(self, kind, number, point):
        """Reads off what is where the user has clicked, and shows the edge's row."""
        if self.measured is not self.shape:
            return  # the table's numbers are those of the sewn shape
        local = self.placement.inverse().multVec(point)
        self.child("SutureReadout").setText(readout.text(self.shape, kind, number, local))
        if kind == "Edge":
            self.table.show_edge(number)

    def chosen(self):
        return self.table.chosen()

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
            camera.look_at(
                [point],
                self.placement,
                max(edge.length / 6, 1e-3),
                readout.outward(self.measured, edge.edge, point),
            )
        self._draw_extra()

    # -- drawing

    def _clear(self):
        self.table.clear()
        self._legend_list().clear()
        for layer in (self._lines, self._mark, self._legend):
            layer.clear()

    def _groups(self):
        groups = {}
        for edge in self.report.edges:
            groups.setdefault(class_of(edge), []).append(edge.edge)
        if self.report.free_edges:
            groups["free"] = self.report.free_edges
        return {key: groups[key] for key in COLORS if key in groups}

    def _draw(self):
        deflection = meshes.fineness(self.measured)
        self._lines.clear()
        self._legend.clear()
        rows = []
        for key, numbers in self._groups().items():
            rows.append((f"{class_name(key)}: {len(numbers)}", COLORS[key]))
            if key not in self._hidden:
                edges = (self.measured.Edges[number - 1] for number in numbers)
                lines = [meshes.outline(edge, deflection) for edge in edges if not edge.Degenerated]
                self._lines.lines(lines, COLORS[key], 2.5 if key == "sharp" else 5.0)
        self._legend.legend(rows)

    def _show_legend(self):
        legend = self._legend_list()
        legend.blockSignals(True)
        for key, numbers in self._groups().items():
            entry = QtWidgets.QListWidgetItem(f"{class_name(key)}: {len(numbers)}")
            entry.setIcon(swatch(key))
            entry.setData(_ROLE, key)
            entry.setCheckState(QtCore.Qt.Unchecked if key in self._hidden else QtCore.Qt.Checked)
            legend.addItem(entry)
        legend.blockSignals(False)

    def _tick_class(self, entry):
        change = (
            self._hidden.discard if entry.checkState() == QtCore.Qt.Checked else self._hidden.add
        )
        change(entry.data(_ROLE))
        self._draw()

    def _draw_extra(self, *_):
        self._extra.clear()
        edge = self.chosen()
        if self.child("SutureCombsBox").isChecked() and edge is not None:
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
        self.surface.leave()
        for layer in (self._lines, self._extra, self._mark, self._legend):
            layer.close()

