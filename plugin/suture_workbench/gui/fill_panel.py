# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fill holes: choose, see the result before it is made, OK."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import RESOURCES, api, feature, meshes, places, reports, settings, tasks
from ..compat import QtCore, QtWidgets, translate
from ..errors import SutureError
from ..options import CONTINUITIES, FillOptions
from ..program import methods
from . import failures, overlay
from .holes_tree import HolesTree
from .method_options import MethodOptions
from .progress import Watcher, run_with_dialog
from .sides_table import SidesTable
from .through_list import ThroughList
from .widgets import Buttons, Panel, Status, heading, number_box

_PAUSE_MS = 350  # after the last change of an option, before the preview is computed anew


class FillPanel(Panel):
    """Task panel of the command Fill holes, and for editing a filled shape."""

    icon = str(RESOURCES / "icons" / "Suture_Fill.svg")
    buttons = (Buttons.Ok, Buttons.Cancel)

    def __init__(self, item, ticked=None, edited=None):
        self.title = translate("Fill holes")
        super().__init__()
        self.item, self.edited = item, edited
        self._ticked, self._all = ticked, ticked is None
        self._shown = None  # (key, request, Filled) of the preview
        self._build(places.shown_at(item))
        self.shape = places.local_shape(item.obj)
        self._finder = Watcher(self._found, self._failed, self.status.advance)
        self._filler = Watcher(self._previewed, self._failed, self.status.advance)
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._start_preview)
        self.status.plain(translate("Looking for holes…"))
        self._finder.start(tasks.FindHoles(self.shape))

    @classmethod
    def edit(cls, obj):
        """The panel with what an object has; OK changes it."""
        options = feature.Request.of(obj).options  # its points are set from the object below
        base = obj.Base[0]
        chosen = set(options.edges)
        ticked = (lambda hole: bool(chosen & set(hole.edges))) if chosen else None
        panel = cls(places.Selected(base, [], [], base, ""), ticked, edited=obj)
        obj.ViewObject.Visibility, base.ViewObject.Visibility = False, True
        panel._set(options, obj)
        return panel

    # -- what is shown

    def _build(self, placement):
        self.tree = HolesTree(self.item, placement)
        self.sides = SidesTable(self.tree, self.item)
        self.method = self._combo("SutureMethod", methods(), settings.method())
        self.continuity = self._combo("SutureContinuity", CONTINUITIES, "auto")
        self.own = MethodOptions()
        self.own.show_method(self.method.currentText())
        self.method.currentTextChanged.connect(self.own.show_method)
        self.gap = number_box(settings.gap(), "mm", translate("Largest gap"))
        self.angle = number_box(settings.angle(), "°", translate("Largest angle of tangent joins"))
        self.curvature = number_box(
            settings.curvature(), "%", translate("Largest curvature mismatch of G2 joins")
        )
        self.one_face = QtWidgets.QCheckBox(translate("The ticked loops bound one face (islands)"))
        self.through = ThroughList(self.item.obj)
        self.preview = QtWidgets.QCheckBox(translate("Preview"))
        self.preview.setObjectName("SuturePreview")
        self.preview.setChecked(settings.preview())
        self.status = Status(self._stop)
        self._drawing = overlay.Overlay(placement)
        choices, limits = QtWidgets.QHBoxLayout(), QtWidgets.QHBoxLayout()
        for text, combo in (
            (translate("Method"), self.method),
            (translate("Continuity"), self.continuity),
        ):
            choices.addWidget(QtWidgets.QLabel(text))
            choices.addWidget(combo, 1)
        for box in (self.gap, self.angle, self.curvature):
            limits.addWidget(box)
        self.layout.addWidget(heading(self.item.obj.Label))
        self.tree.setFixedHeight(130)
        self.sides.setFixedHeight(130)
        self.layout.addWidget(self.tree)
        self.layout.addLayout(choices)
        self.layout.addWidget(self.own)
        self.layout.addLayout(limits)
        for widget in (self.preview, self.status, self.sides, self.one_face, self.through):
            self.layout.addWidget(widget)
        self.tree.ticked_changed.connect(self._choose_sides)
        for signal in (
            self.method.currentTextChanged,
            self.continuity.currentTextChanged,
            self.gap.valueChanged,
            self.angle.valueChanged,
            self.curvature.valueChanged,
            self.one_face.toggled,
            self.preview.toggled,
            self.sides.changed,
            self.through.changed,
            self.own.changed,
        ):
            signal.connect(self._changed)

    def _combo(self, name, choices, value):
        combo = QtWidgets.QComboBox()
        combo.setObjectName(name)
        combo.addItems(choices if value in choices else [*choices, value])
        combo.setCurrentText(value)
        return combo

    def _set(self, options, obj):
        for combo, value in ((self.method, options.method), (self.continuity, options.continuity)):
            if combo.findText(value) < 0:
                combo.addItem(value)
            combo.setCurrentText(value)
        self.own.set(options.own)
        self.gap.setValue(options.gap)
        self.angle.setValue(options.angle)
        self.curvature.setValue(options.curvature)
        self.one_face.setChecked(options.one_face)
        self.sides.wanted = dict(options.sides)
        self.through.set(obj.Through, [tuple(point) for point in obj.Points])

    # -- what is asked for

    def options(self):
        """FillOptions as the panel stands, without the points of references."""
        holes = self.tree.ticked()
        if not holes:
            raise SutureError(translate("Tick a hole to fill."))
        ordinary = {hole.id for hole in self.tree.holes() if hole.kind == reports.FILLABLE}
        every = self._all and {hole.id for hole in holes} == ordinary
        edges = [] if every and not self.one_face.isChecked() else self._one_edge_each(holes)
        return FillOptions(
            edges,
            method=self.method.currentText(),
            continuity=self.continuity.currentText(),
            sides=self.sides.asked(),
            points=self.through.points,
            own=self.own.values(),
            gap=self.gap.value(),
            angle=self.angle.value(),
            curvature=self.curvature.value(),
            one_face=self.one_face.isChecked(),
            all_loops=any(hole.kind != reports.FILLABLE for hole in holes),
        )

    def _one_edge_each(self, holes):
        edges = []
        for hole in holes:
            numbers = [number for number in map(self.tree.number, hole.edges) if number]
            if not numbers:
                raise SutureError(translate("Hole {} has no edge of the object.").format(hole.id))
            edges.append(numbers[0])
        return edges

    def request(self):
        """What is to be computed, the points of references included."""
        points = places.points_through(self.through.references, self.item.obj)
        return feature.Request(self.item.obj, self.options().with_points(points), self.shape)

    # -- finding and preview

    def _found(self, found):
        ticked = self._ticked
        if ticked is None and (self.item.edges or self.item.faces):
            ticked = self._touches_selection(found)
            self._all = False
        self.tree.fill(found, ticked)
        self._choose_sides()
        if not self.tree.ticked():
            self.status.plain(translate("Tick a hole to fill."))

    def _touches_selection(self, found):
        def touches(hole):
            numbers = set(map(found.number, hole.edges))
            return bool(numbers & set(self.item.edges) or set(hole.faces) & set(self.item.faces))

        return touches

    def _choose_sides(self):
        self.sides.show_holes(self.tree.ticked())
        self._changed()

    def _changed(self, *_):
        self._shown = None
        self._filler.cancel()
        self._drawing.clear()
        self.sides.clear_measured()
        if not self.tree.ticked():
            self.status.plain(translate("Tick a hole to fill."))
        elif self.preview.isChecked():
            self._timer.start(_PAUSE_MS)
        else:
            self.status.plain(translate("No preview."))

    def _start_preview(self):
        try:
            request = self.request()
            self._pending = request
            self._filler.start(request.task())
        except SutureError as error:
            self._failed(error)

    def _stop(self):
        self._timer.stop()
        self._finder.cancel()
        self._filler.cancel()
        self.status.plain(translate("Stopped."))

    def _previewed(self, filled):
        self._shown = (self._pending.key(), self._pending, filled)
        self._drawing.clear()
        deflection = meshes.fineness(filled.shape)
        for number in filled.new_faces:
            face = filled.shape.Faces[number - 1]
            self._drawing.mesh(*meshes.mesh_of(face, deflection), overlay.ORANGE, 0.2)
        self.sides.measured(filled.report)
        if filled.report.ok:
            self.status.good(reports.summary(filled.report))
        else:
            self.status.bad(reports.shortfall(filled.report))

    def _failed(self, error):
        failures.report(self.status, error, self.item)

    # -- the end

    def accept(self):
        """OK: what the preview shows becomes an object, in one step of undo."""
        self._timer.stop()
        self._filler.cancel()
        try:
            request = self.request()
            if self._shown and self._shown[0] == request.key():
                filled = self._shown[2]
            else:
                filled = run_with_dialog(request.task())
            self._commit(request, filled)
        except Exception as error:  # the panel stays, so that something else can be tried
            failures.show(error, self.item)
            return False
        self.close()
        return True

    def _commit(self, request, filled):
        obj = api.keep(request, filled, self.options(), self.through.references, self.edited)
        obj.ViewObject.Visibility = True
        Gui.Selection.clearSelection()
        App.Console.PrintMessage(f"{obj.Label}: {filled.report.verdict}\n")

    def leave(self):
        self._timer.stop()
        self._finder.cancel()
        self._filler.cancel()
        self._drawing.close()
        self.tree.leave()
        self.sides.leave()
        if self.edited is not None and self.edited.Document is not None:
            self.edited.ViewObject.Visibility = True
            self.item.obj.ViewObject.Visibility = False
