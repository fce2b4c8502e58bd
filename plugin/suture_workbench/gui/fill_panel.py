# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fill holes: choose, see the result before it is made, OK."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import RESOURCES, api, extras, feature, places, reports, settings, tasks, words
from ..compat import QtCore, QtWidgets, translate
from ..errors import SutureError
from ..options import CONTINUITIES, EFFORTS, RECOGNISE, FillOptions
from ..program import methods, title_of
from . import failures
from .choice import Choice
from .extras_box import ExtrasBox
from .holes_tree import HolesTree
from .method_options import MethodOptions
from .forms import put
from .panel import Buttons, Panel
from .preview import Preview
from .progress import Watcher, run_with_dialog
from .sides_table import SidesTable
from .surface_box import SurfaceBox
from .through_list import ThroughList
from .widgets import Status, limit_boxes, show_heading

_PAUSE_MS = 350  # after the last change of an option, before the preview is computed anew


class FillPanel(Panel):
    """Task panel of the command Fill holes, and for editing a filled shape."""

    icon = str(RESOURCES / "icons" / "Suture_Fill.svg")
    buttons = (Buttons.Ok, Buttons.Cancel)
    task = "Holes"

    def __init__(self, item, ticked=None, edited=None):
        self.title = words.task_name(self.task)
        super().__init__("fill")
        self.item, self.edited = item, edited
        self._ticked, self._all = ticked, ticked is None
        self._preferred = set(item.edges)  # of the edges of a hole, those that name it
        self._filter = {}  # of the extras, those that choose holes
        self._shown = None  # (key, request, Filled) of the preview
        self._pending = None
        self._before = {}  # what was visible before an edit
        self.shape = places.local_shape(item.obj)
        self._build(places.shown_at(item))
        self._finder = Watcher(self._found, self._failed, self.status.advance)
        self._filler = Watcher(self._previewed, self._failed, self.status.advance)
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._start_preview)
        self._begin()

    def _begin(self):
        """Finds what can be filled."""
        self.status.advance(0.0, translate("Looking for holes…"))
        self._finder.start(tasks.FindHoles(self.shape))

    @classmethod
    def edit(cls, obj):
        """The panel with what an object has; OK changes it."""
        options = feature.Request.of(obj).options  # its points are set from the object below
        base = obj.Base[0]
        chosen = set(options.edges)
        ticked = (lambda hole: bool(chosen & set(hole.edges))) if chosen else None
        panel = cls(places.Selected(base, [], [], base, ""), ticked, edited=obj)
        panel._preferred = chosen
        panel._show_instead(obj, [base])
        panel._set(options, obj)
        return panel

    def _show_instead(self, obj, sources):
        """While an object is edited, what it was made from is shown in its place."""
        for shown, visible in ((obj, False), *((source, True) for source in sources)):
            self._before[shown] = shown.ViewObject.Visibility
            shown.ViewObject.Visibility = visible

    def watched(self):
        return [self.item.obj] + ([self.edited] if self.edited is not None else [])

    # -- what is shown

    def _build(self, placement):
        show_heading(self.child("SutureHeading"), self.item.obj.Label)
        self.tree = put(self.form, "holesPlace", self._make_list(placement))
        self.sides = put(self.form, "sidesPlace", SidesTable(self.tree, self.item))
        self.status = put(self.form, "statusPlace", Status(self._stop))
        self.through = put(self.form, "throughPlace", ThroughList(self.item.obj))
        self.own = put(self.form, "ownPlace", MethodOptions(self._show_heading_of_own))
        self.extras = put(self.form, "extrasPlace", ExtrasBox(self.task))
        self._drawing = Preview(placement)
        self.surface = put(
            self.form, "surfacePlace", SurfaceBox([self.item.obj], self._drawing.shade)
        )
        self.surface.setVisible(False)
        self.child("SutureSurface").toggled.connect(self.surface.setVisible)
        self.method = Choice(
            self.form,
            "SutureMethod",
            "SutureMethodExplained",
            methods(),
            text=lambda method: words.method_text(method, title_of(method)),
        )
        self.method.choose(settings.method())
        self.continuity = Choice(
            self.form,
            "SutureContinuity",
            "SutureContinuityExplained",
            CONTINUITIES,
            text=words.continuity_text,
        )
        self.recognise = Choice(
            self.form,
            "SutureRecognise",
            None,
            RECOGNISE,
            name=words.recognise_name,
            text=words.recognise_text,
        )
        self.effort = Choice(
            self.form,
            "SutureEffort",
            None,
            EFFORTS,
            name=words.effort_name,
            text=words.effort_text,
        )
        self.effort.choose("normal")
        self.own.show_method(self.method.key())
        self.method.changed.connect(lambda: self.own.show_method(self.method.key()))
        self.gap, self.angle, self.curvature = limit_boxes(self.form)
        self.child("SuturePreview").setChecked(settings.preview())
        self.sides.setFixedHeight(120)
        self.tree.ticked_changed.connect(self._choose_sides)
        self.extras.changed.connect(self._choose_by_extras)
        for signal in (
            self.method.changed,
            self.continuity.changed,
            self.recognise.changed,
            self.effort.changed,
            self.gap.valueChanged,
            self.angle.valueChanged,
            self.curvature.valueChanged,
            self.child("SutureOneFace").toggled,
            self.child("SuturePreview").toggled,
            self.sides.changed,
            self.through.changed,
            self.own.changed,
        ):
            signal.connect(self._changed)

    def _make_list(self, placement):
        """The list of what can be filled."""
        tree = HolesTree(self.item, placement)
        tree.setFixedHeight(120)
        return tree

    def _show_heading_of_own(self, on):
        self.child("ownLabel").setVisible(on)

    def _set(self, options, obj):
        self.method.choose(options.method)
        self.continuity.choose(options.continuity)
        self.own.set(options.own)
        self.extras.set(options.extras)
        self._filter = extras.choice(options.extras)
        self.recognise.choose(options.recognise)
        self.effort.choose(options.effort)
        self.gap.setValue(options.gap)
        self.angle.setValue(options.angle)
        self.curvature.setValue(options.curvature)
        self.child("SutureOneFace").setChecked(options.one_face)
        self.sides.wanted = dict(options.sides)
        self.through.set(obj.Through, [tuple(point) for point in obj.Points])
        changed = options.one_face or options.own or options.extras
        changed = changed or options.recognise != "model" or options.effort != "normal"
        if changed or obj.Through or obj.Points:
            self.child("SutureMore", QtWidgets.QToolButton).setChecked(True)

    # -- what is asked for

    def options(self):
        """FillOptions as the panel stands, without the points of references."""
        chosen, given = self._chosen(), self.extras.values()
        return FillOptions(
            **chosen,
            method=self.method.key(),
            continuity=self.continuity.key(),
            sides=self.sides.asked(),
            points=self.through.points,
            own=self.own.values(),
            recognise=self.recognise.key(),
            effort=self.effort.key(),
            gap=self.gap.value(),
            angle=self.angle.value(),
            curvature=self.curvature.value(),
            keep_bad=True,  # to be seen; whether it stays is asked in the end
            **(extras.without_choice(given) if chosen.get("edges") else given),
        )

    def _chosen(self):
        """What is to be filled, as FillOptions has it."""
        holes = self.tree.ticked()
        if not holes:
            raise SutureError(self._hint())
        ordinary = {hole.id for hole in self.tree.holes() if self._is_chosen(hole)}
        every = self._all and {hole.id for hole in holes} == ordinary
        return {
            "edges": [] if every and not self._one_face() else self._one_edge_each(holes),
            "one_face": self._one_face(),
            "all_loops": any(hole.kind != reports.FILLABLE for hole in holes),
        }

    def _choose_by_extras(self):
        """Ticks the holes that they choose."""
        given = self.extras.values()
        if self._filter != extras.choice(given):
            self._filter = extras.choice(given)
            self._all = True
            self.tree.tick(self._is_chosen)
        self._changed()

    def _is_chosen(self, hole):
        return hole.kind == reports.FILLABLE and extras.fits(self._filter, hole, self.tree.holes())

    def _hint(self):
        """What to do where nothing is chosen."""
        return translate("Tick a hole to fill.")

    def _one_face(self):
        return self.child("SutureOneFace").isChecked()

    def _one_edge_each(self, holes):
        edges = []
        for hole in holes:
            numbers = [number for number in map(self.tree.number, hole.edges) if number]
            if not numbers:
                raise SutureError(translate("Hole {} has no edge of the object.").format(hole.id))
            edges.append(next((n for n in numbers if n in self._preferred), numbers[0]))
        return edges

    def request(self):
        """What is to be computed, the points of references included."""
        points = places.points_through(self.through.references, self.item.obj)
        return feature.Request(self.item.obj, self.options().with_points(points), self.shape)

    # -- finding and preview

    def picked(self, kind, number, point):
        """An edge clicked in the view shows its row; a face, the hole beside it."""
        if kind == "Edge" and self.sides.show_edge(number):
            return
        self.tree.show_element(kind, number)

    def _found(self, found):
        ticked = self._ticked
        if ticked is None and (self.item.edges or self.item.faces):
            ticked = self._touches_selection(found)
            self._all = False
        self.tree.fill(found, ticked if ticked or not self._filter else self._is_chosen)
        self._choose_sides()

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
        if self._finder.busy():
            return
        if not self.tree.ticked():
            self.status.plain(self._hint())
        elif self.child("SuturePreview").isChecked():
            self.status.advance(0.0, translate("Working…"))
            self._timer.start(_PAUSE_MS)
        else:
            self.status.plain(translate("No preview."))

    def _start_preview(self):
        try:
            self._pending = request = self.request()
            known = feature.stored(self.edited, request)
            if known is not None:
                self._previewed(known)
            else:
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
        self._drawing.show(filled, self._pending.shape)
        self.sides.measured(filled.report)
        if filled.report.ok:
            self.status.good(words.fill_summary(filled.report))
        else:
            self.status.bad(words.shortfall(filled.report))

    def _failed(self, error):
        failures.report(self.status, error, self.item)

    # -- the end

    def accept(self):
        """OK: what the preview shows becomes an object, in one step of undo."""
        self._timer.stop()
        try:
            request = self.request()
            filled = self._result(request)
            doubts = words.doubts(filled.report)
            if not failures.confirm(doubts):
                return False
            self._commit(request, filled, keep_bad=bool(doubts))
        except Exception as error:  # the panel stays, so that something else can be tried
            failures.show(error, self.item)
            return False
        self.close()
        return True

    def _result(self, request):
        """The preview where it is what is asked for; one that still runs is waited for."""
        if self._shown and self._shown[0] == request.key():
            return self._shown[2]
        if self._filler.busy() and self._pending.key() == request.key():
            task = self._filler.release()
        else:
            self._filler.cancel()
            task = request.task()
        filled = run_with_dialog(task)
        self._pending = request
        self._previewed(filled)
        return filled

    def _commit(self, request, filled, keep_bad):
        self._restore()  # what was shown for the edit is no change of the document
        obj = api.keep(
            request.keeping_bad(keep_bad),
            filled,
            self.options().keeping_bad(keep_bad),
            self.through.references,
            self.edited,
        )
        obj.ViewObject.Visibility = True
        Gui.Selection.clearSelection()
        App.Console.PrintMessage(f"{obj.Label}: {obj.Verdict}\n")

    def _restore(self):
        if self.edited is not None and not places.exists(self.edited):
            self._before = {}  # it is being deleted: what it was made from stays in view
        for obj, visible in self._before.items():
            if places.exists(obj) and places.in_window(obj):
                obj.ViewObject.Visibility = visible
                obj.Document.abortTransaction()  # FreeCAD's own, of the menu entry Edit
        self._before = {}

    def leave(self):
        self._timer.stop()
        self._finder.cancel()
        self._filler.cancel()
        self._drawing.close()
        self.surface.leave()
        self.tree.leave()
        self.sides.leave()
        self._restore()
