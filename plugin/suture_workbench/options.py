# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user can ask of a fill and of a check."""

import copy
import json

from . import extras, program, settings

CONTINUITIES = ["auto", "G0", "G1", "G2"]
RECOGNISE = ["model", "neighbours", "off"]
EFFORTS = ["quick", "normal", "thorough"]
# What is filled: holes of a shape; a border of chosen edges; what lies between two edges or chains of
# them; what chosen faces leave; or these go, and their neighbours grow together.
TASKS = ["Holes", "Boundary", "Bridge", "Replace", "Remove"]
# Surfaces that a file describes: a control mesh (OBJ), polynomials (JSON).
SURFACES = {"patch": "*.obj", "algebraic": "*.json"}
PROFILES = ["catia", "vda4955", "alias", "rhino", "occt"]


class FillOptions:
    """All that `suture fill` is told; edge numbers are FreeCAD's, points those of the shape.

    task         one of TASKS
    edges        one edge of each hole to fill, or none for all holes; Boundary, Bridge: all edges
    faces        Replace, Remove: the faces that go
    connect      Boundary: gaps between the edges are bridged by curves
    one_face     the loops bound one face: the others are islands in the first
    all_loops    rims and doubtful loops too
    sides        {edge: "G2"}: the continuity of single sides
    points       to pass through, as (x, y, z), or (x, y, z, nx, ny, nz) with the normal there
    recognise    where `auto` looks for the very surface that was lost: "model", "neighbours", "off"
    effort       how much `auto` tries: one of EFFORTS
    own          {key: value}: the method's own options (program.options_of)
    keep_bad     put in what is bad (docs/judge.md) as well: the user has seen it
    extras       {name: value} of those of extras.EXTRAS that were given and say something
    """

    def __init__(self, edges=(), method=None, continuity="auto", sides=None, points=(), **more):
        self.edges = list(edges)
        self.task = more.pop("task", "Holes")
        self.faces = list(more.pop("faces", ()))
        self.connect = more.pop("connect", False)
        self.method = method or settings.method()
        self.continuity = continuity
        self.sides = dict(sides or {})
        self.points = [tuple(float(x) for x in point) for point in points]
        self.gap = more.pop("gap", None) or settings.gap()
        self.angle = more.pop("angle", None) or settings.angle()
        self.curvature = more.pop("curvature", None) or settings.curvature()
        self.own = {key: str(value) for key, value in (more.pop("own", None) or {}).items()}
        self.recognise = more.pop("recognise", None) or "model"
        self.effort = more.pop("effort", None) or "normal"
        self.one_face = more.pop("one_face", False)
        self.all_loops = more.pop("all_loops", False)
        self.keep_bad = more.pop("keep_bad", False)
        self.extras = extras.taken(more)
        if more:
            raise TypeError(f"no such option: {', '.join(more)}")
        if self.task not in TASKS:
            raise TypeError(f"no such task: {self.task}")

    def with_points(self, points):
        """The same with more points to pass through."""
        more = copy.copy(self)
        more.points = [*self.points, *(tuple(float(x) for x in point) for point in points)]
        return more

    def keeping_bad(self, keep):
        """The same, with bad fills kept or left out."""
        other = copy.copy(self)
        other.keep_bad = bool(keep)
        return other

    def named_edges(self):
        return list(dict.fromkeys([*self.edges, *self.sides, *self.extras.get("supports", ())]))

    def named_faces(self):
        return list(dict.fromkeys([*self.faces, *self.extras.get("supports", {}).values()]))

    def arguments(self, number):
        """For the command line, without the choice of holes and the points."""
        words = ["--method", self.method, "--continuity", self.continuity]
        words += ["--tolerance", repr(self.gap), "--angle", repr(self.angle)]
        words += ["--curvature", repr(self.curvature)]
        if self.sides:
            sides = (f"{number(edge)}={wanted}" for edge, wanted in sorted(self.sides.items()))
            words += ["--edge-continuity", ",".join(sides)]
        for key, value in self.own.items():
            words += ["--option", f"{key}={value}"]
        if self.recognise != "model":
            words += ["--recognise", self.recognise]
        if self.effort != "normal":
            words += ["--effort", self.effort]
        words += extras.arguments(self.extras, self.task, number)
        if self.all_loops:
            words.append("--all-loops")
        if self.keep_bad and program.judges():
            words.append("--keep-bad")
        return words

    def key(self):
        """A text that is the same for the same options."""
        said = vars(self).copy()
        if self.effort == "normal":
            del said["effort"]  # documents of before it was there stay up to date
        if not self.extras:
            del said["extras"]  # documents of before there were any stay up to date
        return json.dumps(said, sort_keys=True)


class CheckOptions:
    """What `suture check` is told; a limit that is None is the profile's."""

    def __init__(self, profile="catia", gap=None, angle=None, curvature=None, sharp=None, edges=(), certify=False):
        self.profile = profile
        self.certify = certify
        self.limits = {"--g0": gap, "--g1": angle, "--g2": curvature, "--sharp": sharp}
        self.edges = list(edges)

    def arguments(self, number):
        words = ["--profile", self.profile]
        for option, limit in self.limits.items():
            if limit is not None:
                words += [option, repr(float(limit))]
        if self.certify:
            words.append("--certify")
        if self.edges:
            words += ["--edges", ",".join(str(number(edge)) for edge in self.edges)]
        return words
