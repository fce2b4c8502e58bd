# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a fill can be told besides, and mostly is not: what is merged or cut in two, how far it reaches,
which holes by kind and size, which faces it leans on."""

from collections import namedtuple

from .compat import mark

# name         of the option, with the value that says nothing: `default`
# tasks        those of options.TASKS that have it
# prop, kind, tip   of the object's property
Extra = namedtuple("Extra", "name option default tasks prop kind tip")

_FILLS = ("Holes", "Boundary", "Bridge", "Replace")
EXTRAS = [
    Extra(
        "merge",
        "--merge",
        False,
        _FILLS,
        "Merge",
        "App::PropertyBool",
        mark("Make new faces one with neighbours on the same surface"),
    ),
    Extra(
        "grow",
        "--grow",
        False,
        ("Holes",),
        "Grow",
        "App::PropertyBool",
        mark("Let the neighbours of the holes grow together, where they can, instead of a fill"),
    ),
    Extra(
        "split",
        "--split",
        "",
        ("Holes", "Boundary", "Replace"),
        "Split",
        "App::PropertyString",
        mark("Cut a hole in two: auto, or pairs of vertices as 3,7 with blanks between them"),
    ),
    Extra(
        "tension",
        "--tension",
        1.0,
        ("Boundary", "Bridge"),
        "Tension",
        "App::PropertyFloat",
        mark("How far a bridge, and curves over gaps, go on straight: 1 as the gap is wide"),
    ),
    Extra(
        "planar",
        "--planar",
        False,
        ("Holes",),
        "Planar",
        "App::PropertyBool",
        mark("Where no edge names a hole: only holes whose border lies in a plane"),
    ),
    Extra(
        "larger",
        "--larger",
        0.0,
        ("Holes",),
        "LargerThan",
        "App::PropertyLength",
        mark("Where no edge names a hole: only holes of a larger diameter; 0: all"),
    ),
    Extra(
        "smaller",
        "--smaller",
        0.0,
        ("Holes",),
        "SmallerThan",
        "App::PropertyLength",
        mark("Where no edge names a hole: only holes of a smaller diameter; 0: all"),
    ),
    Extra(
        "corners",
        "--sides",
        0,
        ("Holes",),
        "NumberOfSides",
        "App::PropertyInteger",
        mark("Where no edge names a hole: only holes with so many sides; 0: all"),
    ),
    Extra(
        "supports",
        "--support",
        {},
        ("Boundary", "Bridge"),
        "Supports",
        "App::PropertyStringList",
        mark("Edges, and the face to be tangent to there: Edge3=Face7"),
    ),
]
_FILTERS = ("planar", "larger", "smaller", "corners")


def taken(given):
    """Takes the extras out of options. Result   {name: value} of those that say something"""
    found = {}
    for extra in EXTRAS:
        value = given.pop(extra.name, extra.default)
        if value != extra.default and value is not None:
            found[extra.name] = type(extra.default)(value)
    return found


def arguments(extras, task, number):
    """For the command line."""
    words = []
    for extra in EXTRAS:
        if extra.name not in extras or task not in extra.tasks:
            continue
        value = extras[extra.name]
        if value is True:
            words.append(extra.option)
        elif extra.name == "split":
            for pair in value.split():
                words += [extra.option, pair]
        elif extra.name == "supports":
            pairs = (f"{number(edge)}={face}" for edge, face in sorted(value.items()))
            words += [extra.option, ",".join(pairs)]
        else:
            words += [extra.option, repr(value)]
    return words


def choice(extras):
    """Those that choose among the holes."""
    return {name: value for name, value in extras.items() if name in _FILTERS}


def without_choice(extras):
    """The others."""
    return {name: value for name, value in extras.items() if name not in _FILTERS}


def fits(extras, hole, holes):
    """Whether a hole is one of those of reports.holes that they choose; the longest of the loops that
    bound one face speaks for all of them."""
    group = [other for other in holes if other.id == hole.id or other.id in hole.islands]
    longest = max(group, key=lambda loop: loop.length)
    sides = sum(len(loop.edges) for loop in group)
    return (
        (longest.planar or not extras.get("planar"))
        and longest.diameter > extras.get("larger", 0.0)
        and longest.diameter < extras.get("smaller", float("inf"))
        and sides == extras.get("corners", sides)
    )


# -- as properties of an object


def property_rows():
    """Those of `properties`, with the value that a new object has."""
    return [
        ((extra.prop, extra.kind, "More", extra.tip, 0), extra.default) for extra in EXTRAS
    ]


def read(obj, edge_now, face_now):
    """{name: value} of an object; the numbers of edges and faces as they are now."""
    found = {}
    for extra in EXTRAS:
        value = getattr(obj, extra.prop)
        if extra.name == "supports":
            pairs = (map(_number, text.split("=", 1)) for text in value if "=" in text)
            value = {edge_now(edge): face_now(face) for edge, face in pairs}
        else:
            value = getattr(value, "Value", value)
        found[extra.name] = value
    return found


def write(obj, extras):
    """Writes {name: value} into the properties."""
    for extra in EXTRAS:
        value = extras.get(extra.name, extra.default)
        if extra.name == "supports":
            value = [f"Edge{edge}=Face{face}" for edge, face in sorted(value.items())]
        setattr(obj, extra.prop, value)


def _number(name):
    return int(name.strip().lstrip("EdgeFac"))
