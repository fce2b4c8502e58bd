# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric object: a shape whose holes are filled. Documents name its class: keep the name."""

import hashlib
import json

import FreeCAD as App

from . import exchange, marks, places, reports, tasks, waiting, words
from .compat import Stateless, element_of, translate, without_traceback
from .errors import ProgramMissing, SutureError
from .options import RECOGNISE, FillOptions
from .program import methods
from .properties import add_properties, set_choice

class FilledShape(Stateless):
    """Proxy of the object."""

    def __init__(self, obj):
        add_properties(obj)
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        add_properties(obj)

    def execute(self, obj):
        with without_traceback():
            self._execute(obj)

    def _execute(self, obj):
        request = Request.of(obj)
        if request.key() == obj.InputKey and not obj.Shape.isNull():
            _place(obj, request)
            return
        try:
            filled = waiting.run(request.task())
        except ProgramMissing as error:
            if obj.Shape.isNull():
                raise
            raise ProgramMissing(
                translate("The shape is the last one, not up to date: {}").format(error)
            ) from error
        store(obj, request, filled)


class Request:
    """What one fill of one object is made of; the same key, the same result."""

    def __init__(self, base, options, shape=None):
        self.base = base
        self.shape = shape or places.local_shape(base)
        self.options = options

    @classmethod
    def of(cls, obj):
        """As the object's properties have it."""
        if not obj.Base or obj.Base[0] is None:
            raise SutureError(
                translate("{} has no base: choose one in its property Base.").format(obj.Label)
            )
        base, subs = obj.Base
        shape = places.local_shape(base)
        now = _numbers_now(obj, shape)
        options = FillOptions(
            [now(edge) for edge in _numbers(subs)],
            method=obj.Method,
            continuity=obj.Continuity,
            sides={
                now(edge): wanted
                for wanted in ("G0", "G1", "G2")
                for edge in _edges_of(getattr(obj, "Edges" + wanted), base)
            },
            points=obj.Points,
            gap=obj.Gap.Value,
            angle=obj.Angle.Value,
            curvature=obj.Curvature,
            own=dict(entry.split("=", 1) for entry in obj.MethodOptions if "=" in entry),
            recognise=obj.Recognise,
            one_face=obj.OneFace,
            all_loops=obj.AllLoops,
            keep_bad=obj.KeepBad,
        )
        points = places.points_through(obj.Through, base)
        return cls(base, options.with_points(points), shape)

    def keeping_bad(self, keep):
        """The same, with bad fills kept or left out."""
        return Request(self.base, self.options.keeping_bad(keep), self.shape)

    def key(self):
        text = exchange.fingerprint(self.shape) + self.options.key()
        return hashlib.sha256(text.encode()).hexdigest()

    def task(self):
        return tasks.FillHoles(self.shape, self.options)


#: Takes the view of a new object.
view_provider = None


def show_with(provider):
    """Names the view provider of new objects. The window does, as it starts: it stands above this."""
    global view_provider
    view_provider = provider


def make(base):
    """A new object that fills all holes of `base`, beside it, not yet computed."""
    obj = base.Document.addObject("Part::FeaturePython", "Filled")
    FilledShape(obj)
    home = places.home_for_result(base)
    if home is not None:
        home.addObject(obj)
    obj.Base = (base, [])
    obj.Label = translate("{} filled").format(base.Label)
    if App.GuiUp:
        view_provider(obj.ViewObject)
    return obj


def set_options(obj, options, through=()):
    """Writes options into the properties; the points of `through` come on top of options.points."""
    base = obj.Base[0]
    obj.Base = (base, [f"Edge{edge}" for edge in options.edges])
    set_choice(obj, "Method", methods(), options.method)
    obj.MethodOptions = [f"{key}={value}" for key, value in options.own.items()]
    obj.Continuity = options.continuity
    set_choice(obj, "Recognise", RECOGNISE, options.recognise)
    for wanted in ("G0", "G1", "G2"):
        edges = [f"Edge{edge}" for edge, asked in options.sides.items() if asked == wanted]
        setattr(obj, "Edges" + wanted, (base, edges) if edges else None)
    shape = places.local_shape(base)
    obj.EdgeMarks = [marks.written(shape, edge) for edge in options.named_edges()]
    obj.KeepBad = options.keep_bad
    obj.OneFace, obj.AllLoops = options.one_face, options.all_loops
    obj.Gap, obj.Angle, obj.Curvature = options.gap, options.angle, options.curvature
    obj.Through = list(through)
    obj.Points = [App.Vector(*point) for point in options.points]


def store(obj, request, filled):
    """Makes the program's answer the object's shape."""
    obj.Shape = filled.shape
    _place(obj, request)
    report = filled.report
    obj.Report = json.dumps(report.document)
    obj.Verdict = words.fill_summary(report).replace("\n", " ")
    obj.Closed = report.closed
    obj.WithinTolerance = report.ok
    obj.NewFaces = filled.new_faces
    obj.InputKey = request.key()
    if not report.ok:
        App.Console.PrintWarning(f"{obj.Label}: {words.shortfall(report)}\n")


def stored(obj, request):
    """What an object has already, as FillHoles would give it; None if a request differs from it."""
    if obj is None or obj.Shape.isNull():
        return None
    if obj.InputKey != request.keeping_bad(obj.KeepBad).key():
        return None
    shape = exchange.without_placement(obj.Shape)
    new = list(obj.NewFaces)
    origins = exchange.face_origins(new, len(request.shape.Faces), len(shape.Faces))
    return tasks.Filled(shape, reports.fill(json.loads(obj.Report)), new, origins)


def _place(obj, request):
    """Where the base stands, seen from the container of the result."""
    obj.Placement = places.frame(obj).inverse().multiply(places.to_document(request.base))


def _numbers(subs):
    numbers = [element_of(sub) for sub in subs or ()]
    return [int(name[4:]) for name in numbers if name.startswith("Edge")]


def _numbers_now(obj, shape):
    """What an edge that the object names is called in the shape as it is now."""
    known = dict(marks.read(text) for text in obj.EdgeMarks)

    def number(edge):
        return marks.number_at(shape, edge, known[edge]) if edge in known else edge

    return number


def _edges_of(link, base):
    return _numbers(link[1]) if link and link[0] is base else []
