# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric object: a shape that is filled in one of the ways of options.TASKS. Documents name its
class: keep the name."""

import hashlib
import json

import FreeCAD as App

from . import exchange, extras, marks, naming, places, reports, tasks, waiting, words
from .compat import Stateless, element_of, translate, without_traceback
from .errors import ProgramMissing, SutureError
from .options import EFFORTS, RECOGNISE, TASKS, FillOptions
from .program import methods
from .properties import add_properties, set_choice
from .sources import Sources


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

    def __init__(self, base, options, shape=None, others=()):
        self.base = base
        self.others = list(others)
        self.shape = shape or Sources([base, *others]).shape
        self.options = options

    @classmethod
    def of(cls, obj):
        """As the object's properties have it."""
        if not obj.Base or obj.Base[0] is None:
            raise SutureError(
                translate("{} has no base: choose one in its property Base.").format(obj.Label)
            )
        base, subs = obj.Base
        more = [(other, subs) for other, subs in obj.MoreEdges or () if other is not base]
        sources = Sources([base, *(other for other, _ in more)])
        shape = sources.shape
        now = _numbers_now(obj, shape)
        edges = _numbers(subs) + [
            sources.number(other, edge) for other, subs in more for edge in _numbers(subs)
        ]
        options = FillOptions(
            [now(edge) for edge in edges],
            task=obj.Task,
            faces=[now(face, "Face") for face in _numbers(subs, "Face")],
            connect=obj.Connect,
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
            effort=obj.Effort,
            one_face=obj.OneFace,
            all_loops=obj.AllLoops,
            keep_bad=obj.KeepBad,
            **extras.read(obj, now, lambda face: now(face, "Face")),
        )
        points = places.points_through(obj.Through, base)
        return cls(base, options.with_points(points), shape, sources.objects[1:])

    def keeping_bad(self, keep):
        """The same, with bad fills kept or left out."""
        return Request(self.base, self.options.keeping_bad(keep), self.shape, self.others)

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


def make(base, task="Holes"):
    """A new object that fills all holes of `base`, beside it, not yet computed."""
    obj = base.Document.addObject("Part::FeaturePython", "Filled")
    FilledShape(obj)
    home = places.home_for_result(base)
    if home is not None:
        home.addObject(obj)
    obj.Base = (base, [])
    obj.Label = {
        "Bridge": translate("{} bridged"),
        "Replace": translate("{} with new faces"),
        "Remove": translate("{} without faces"),
    }.get(task, translate("{} filled")).format(base.Label)
    if App.GuiUp:
        view_provider(obj.ViewObject)
    return obj


def set_options(obj, options, through=(), others=()):
    """Writes options into the properties; the points of `through` come on top of options.points.

    others   objects besides the base whose edges are among options.edges
    """
    base = obj.Base[0]
    sources = Sources([base, *others])
    (_, edges), *more = sources.by_object(options.edges)
    faces = [f"Face{face}" for face in options.faces]
    obj.Base = (base, [f"Edge{edge}" for edge in edges] + faces)
    leant = [sources.face_origin(face) for face in options.extras.get("supports", {}).values()]
    obj.MoreEdges = [
        (
            other,
            [f"Edge{edge}" for edge in numbers]
            + [f"Face{face}" for source, face in leant if source is other],
        )
        for other, numbers in more
    ]
    set_choice(obj, "Task", TASKS, options.task)
    obj.Connect = options.connect
    set_choice(obj, "Method", methods(), options.method)
    obj.MethodOptions = [f"{key}={value}" for key, value in options.own.items()]
    obj.Continuity = options.continuity
    set_choice(obj, "Recognise", RECOGNISE, options.recognise)
    set_choice(obj, "Effort", EFFORTS, options.effort)
    for wanted in ("G0", "G1", "G2"):
        edges = [f"Edge{edge}" for edge, asked in options.sides.items() if asked == wanted]
        setattr(obj, "Edges" + wanted, (base, edges) if edges else None)
    shape = sources.shape
    obj.EdgeMarks = [marks.written(shape, edge) for edge in options.named_edges()] + [
        marks.written(shape, face, "Face") for face in options.named_faces()
    ]
    extras.write(obj, options.extras)
    obj.KeepBad = options.keep_bad
    obj.OneFace, obj.AllLoops = options.one_face, options.all_loops
    obj.Gap, obj.Angle, obj.Curvature = options.gap, options.angle, options.curvature
    obj.Through = list(through)
    obj.Points = [App.Vector(*point) for point in options.points]


def store(obj, request, filled):
    """Makes the program's answer the object's shape."""
    naming.carry_over(filled.shape, request.shape, filled.origins, obj.ID)
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
    origins = exchange.face_origins(
        new, len(request.shape.Faces), len(shape.Faces), request.options.faces
    )
    return tasks.Filled(shape, reports.fill(json.loads(obj.Report)), new, origins)


def _place(obj, request):
    """Where the base stands, seen from the container of the result."""
    obj.Placement = places.frame(obj).inverse().multiply(places.to_document(request.base))


def _numbers(subs, kind="Edge"):
    numbers = [element_of(sub) for sub in subs or ()]
    return [int(name[4:]) for name in numbers if name.startswith(kind)]


def _numbers_now(obj, shape):
    """What an edge or face that the object names is called in the shape as it is now."""
    known = dict(marks.read(text) for text in obj.EdgeMarks)

    def number(old, kind="Edge"):
        point = known.get((kind, old))
        return old if point is None else marks.number_at(shape, old, point, kind)

    return number


def _edges_of(link, base):
    return _numbers(link[1]) if link and link[0] is base else []
