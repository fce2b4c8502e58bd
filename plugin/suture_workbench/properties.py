# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a filled shape. Documents name them: keep the names."""

from . import extras
from .compat import mark, translate
from .options import CONTINUITIES, EFFORTS, RECOGNISE, TASKS
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
        "Task",
        "App::PropertyEnumeration",
        "Fill",
        mark("What is filled: holes, a border of chosen edges, a bridge, faces that go"),
        1,
    ),
    (
        "MoreEdges",
        "App::PropertyLinkSubListGlobal",
        "Fill",
        mark("Edges of other objects that belong to the border or the bridge, and faces to be tangent to"),
        0,
    ),
    (
        "Connect",
        "App::PropertyBool",
        "Fill",
        mark("Bridge gaps between the edges of a border by curves"),
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
        "Recognise",
        "App::PropertyEnumeration",
        "Fill",
        mark("Where the very surface that was lost is looked for: all faces, the neighbours, nowhere"),
        0,
    ),
    (
        "Effort",
        "App::PropertyEnumeration",
        "Fill",
        mark("How much auto tries: what is quick, some seconds more, or all that may come nearer"),
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
        "KeepBad",
        "App::PropertyBool",
        "Fill",
        mark("Keep a fill that is bad: folded, clashing, far off"),
        0,
    ),
    (
        "Through",
        "App::PropertyLinkSubListGlobal",
        "Fill",
        mark("Vertices and edges that the new face passes through, and faces to be tangent to there"),
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
        "EdgeMarks",
        "App::PropertyStringList",
        "Result",
        mark("A point on each edge and face that is named, to know it by when numbers change"),
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


def add_properties(obj):
    """Gives an object the properties that it has not yet."""
    for name, kind, group, tip, mode in _PROPERTIES:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, group, translate(tip))
            if name == "Method":
                set_choice(obj, name, methods(), "auto")
            elif name == "Task":
                set_choice(obj, name, TASKS, "Holes")
            elif name == "Continuity":
                set_choice(obj, name, CONTINUITIES, "auto")
            elif name == "Recognise":
                set_choice(obj, name, RECOGNISE, "model")
            elif name == "Effort":
                set_choice(obj, name, EFFORTS, "normal")
            elif name in ("Gap", "Angle", "Curvature"):
                setattr(obj, name, {"Gap": 0.001, "Angle": 0.01, "Curvature": 2.0}[name])
        obj.setEditorMode(name, mode)
    for (name, kind, group, tip, mode), value in extras.property_rows():
        if not hasattr(obj, name):
            obj.addProperty(kind, name, group, translate(tip))
            if not isinstance(value, dict):
                setattr(obj, name, value)
        obj.setEditorMode(name, mode)


def set_choice(obj, name, choices, value):
    """Offers choices, and chooses one; one that is new is offered as well."""
    setattr(obj, name, choices if value in choices else [*choices, value])
    setattr(obj, name, value)
