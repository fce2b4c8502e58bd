# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric object: a shape whose holes are filled. Documents name its class: keep the name."""

import hashlib
import json

import FreeCAD as App

from . import exchange, places, reports, tasks, waiting
from .compat import Stateless, element_of, mark, translate
from .errors import ProgramMissing, SutureError
from .options import CONTINUITIES, FillOptions
from .program import methods

# name, type, group, tooltip, editor mode (0 shown, 1 read-only, 2 hidden)
_PROPERTIES = [
    (
        "Base",
        "App::PropertyLinkSubGlobal",
        "Fill",
        mark("The shape, and an edge of each hole to fill; no edge: all holes"),
        0,
    ),
    (
        "Method",
        "App::PropertyEnumeration",
        "Fill",
        mark("The fill method; auto tries what applies and keeps the best"),
        0,
    ),
    (
        "MethodOptions",
        "App::PropertyStringList",
        "Fill",
        mark("Options of the method's own, key=value each"),
        0,
    ),
    (
        "Continuity",
        "App::PropertyEnumeration",
        "Fill",
        mark("How the new faces join: G0 position, G1 tangent, G2 curvature"),
        0,
    ),
    (
        "EdgesG0",
        "App::PropertyLinkSubGlobal",
        "Fill",
        mark("Edges that are to be met in position only"),
        0,
    ),
    (
        "EdgesG1",
        "App::PropertyLinkSubGlobal",
        "Fill",
        mark("Edges that are to be met tangentially"),
        0,
    ),
    (
        "EdgesG2",
        "App::PropertyLinkSubGlobal",
        "Fill",
        mark("Edges that are to be met with equal curvature"),
        0,
    ),
    (
        "OneFace",
        "App::PropertyBool",
        "Fill",
        mark("The chosen loops bound one face: the others are islands in the first"),
        0,
    ),
    (
        "AllLoops",
        "App::PropertyBool",
        "Fill",
        mark("Fill the rims of open sheets and doubtful loops too"),
        0,
    ),
    (
        "Through",
        "App::PropertyLinkSubListGlobal",
        "Fill",
        mark("Vertices and edges that the new face passes through"),
        0,
    ),
    (
        "Points",
        "App::PropertyVectorList",
        "Fill",
        mark("Points that the new face passes through, seen from the placement of the base"),
        0,
    ),
    (
        "Gap",
        "App::PropertyLength",
        "Tolerances",
        mark("Largest gap"),
        0,
    ),
    (
        "Angle",
        "App::PropertyAngle",
        "Tolerances",
        mark("Largest angle of tangent joins"),
        0,
    ),
    (
        "Curvature",
        "App::PropertyFloat",
        "Tolerances",
        mark("Largest curvature mismatch of G2 joins in percent"),
        0,
    ),
    (
        "Verdict",
        "App::PropertyString",
        "Result",
        mark("What came of it"),
        1,
    ),
    (
        "Closed",
        "App::PropertyBool",
        "Result",
        mark("No free edge is left"),
        1,
    ),
    (
        "WithinTolerance",
        "App::PropertyBool",
        "Result",
        mark("All holes are filled and meet the tolerances"),
        1,
    ),
    (
        "NewFaces",
        "App::PropertyIntegerList",
        "Result",
        mark("The numbers of the new faces"),
        1,
    ),
    (
        "Report",
        "App::PropertyString",
        "Result",
        mark("The whole report of the program (JSON)"),
        2,
    ),
    (
        "InputKey",
        "App::PropertyString",
        "Result",
        mark("Tells whether the shape is up to date"),
        2,
    ),
]


class FilledShape(Stateless):
    """Proxy of the object."""

    def __init__(self, obj):
        _add_properties(obj)
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        _add_properties(obj)

    def execute(self, obj):
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
        options = FillOptions(
            _numbers(subs),
            method=obj.Method,
            continuity=obj.Continuity,
            sides={
                edge: wanted
                for wanted in ("G0", "G1", "G2")
                for edge in _edges_of(getattr(obj, "Edges" + wanted), base)
            },
            points=obj.Points,
            gap=obj.Gap.Value,
            angle=obj.Angle.Value,
            curvature=obj.Curvature,
            own=dict(entry.split("=", 1) for entry in obj.MethodOptions if "=" in entry),
            one_face=obj.OneFace,
            all_loops=obj.AllLoops,
        )
        return cls(base, options.with_points(places.points_through(obj.Through, base)))

    def key(self):
        text = exchange.fingerprint(self.shape) + self.options.key()
        return hashlib.sha256(text.encode()).hexdigest()

    def task(self):
        return tasks.FillHoles(self.shape, self.options)


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
        from .gui.view_provider import FilledShapeView

        FilledShapeView(obj.ViewObject)
    return obj


def set_options(obj, options, through=()):
    """Writes options into the properties; the points of `through` come on top of options.points."""
    base = obj.Base[0]
    obj.Base = (base, [f"Edge{edge}" for edge in options.edges])
    _set_choice(obj, "Method", methods(), options.method)
    obj.MethodOptions = [f"{key}={value}" for key, value in options.own.items()]
    obj.Continuity = options.continuity
    for wanted in ("G0", "G1", "G2"):
        edges = [f"Edge{edge}" for edge, asked in options.sides.items() if asked == wanted]
        setattr(obj, "Edges" + wanted, (base, edges) if edges else None)
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
    obj.Verdict = report.verdict
    obj.Closed = report.closed
    obj.WithinTolerance = report.ok
    obj.NewFaces = filled.new_faces
    obj.InputKey = request.key()
    if not report.ok:
        App.Console.PrintWarning(f"{obj.Label}: {reports.shortfall(report)}\n")


def _place(obj, request):
    """Where the base stands, seen from the container of the result."""
    obj.Placement = places.frame(obj).inverse().multiply(places.to_document(request.base))


def _add_properties(obj):
    for name, kind, group, tip, mode in _PROPERTIES:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, group, translate(tip))
            if name == "Method":
                _set_choice(obj, name, methods(), "auto")
            elif name == "Continuity":
                _set_choice(obj, name, CONTINUITIES, "auto")
            elif name in ("Gap", "Angle", "Curvature"):
                setattr(obj, name, {"Gap": 0.001, "Angle": 0.01, "Curvature": 2.0}[name])
        obj.setEditorMode(name, mode)


def _set_choice(obj, name, choices, value):
    setattr(obj, name, choices if value in choices else [*choices, value])
    setattr(obj, name, value)


def _numbers(subs):
    numbers = [element_of(sub) for sub in subs or ()]
    return [int(name[4:]) for name in numbers if name.startswith("Edge")]


def _edges_of(link, base):
    return _numbers(link[1]) if link and link[0] is base else []
