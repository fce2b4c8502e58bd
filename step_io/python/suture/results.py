# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program's JSON documents (docs/json.md) as typed objects; `document` has all of each."""

from __future__ import annotations

import dataclasses
import html
from dataclasses import dataclass, field
from typing import Any

Point = tuple[float, float, float]


def _typed(kind, document):
    """The fields that a class has, from a document that may have more."""
    names = {field.name for field in dataclasses.fields(kind)} - {"document"}
    return kind(document=document, **{key: value for key, value in document.items() if key in names})


@dataclass(frozen=True)
class Finding:
    """One thing that the judge found (docs/judge.md)."""

    kind: str
    severity: str  # good, near, poor, bad
    text: str
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    hole: int | None = None
    edge: int | None = None
    face: int | None = None
    at: list[float] | None = None
    document: dict[str, Any] = field(default_factory=dict, repr=False)


@dataclass(frozen=True)
class Hole:
    """A boundary loop. `id` is what `fill(holes=...)` takes; edges and faces are 1-based."""

    id: int
    kind: str  # hole, rim, seam, slit, ambiguous
    sides: int
    edges: list[int]
    faces: list[int]
    diameter: float
    length: float
    planar: bool
    reason: str = ""
    document: dict[str, Any] = field(default_factory=dict, repr=False)


@dataclass(frozen=True)
class FilledHole:
    """What became of a hole. Gap in millimetres, angle in degrees, as measured on the result."""

    id: int
    status: str  # filled, refused, skipped
    reason: str
    severity: str | None = None
    method_used: str | None = None
    continuity_requested: str | None = None
    continuity_reached: str | None = None
    max_gap: float | None = None
    max_angle_deg: float | None = None
    max_curvature_mismatch: float | None = None
    findings: list[Finding] = field(default_factory=list)
    document: dict[str, Any] = field(default_factory=dict, repr=False)


@dataclass(frozen=True)
class Edge:
    """An edge between two faces, as `check` measures it."""

    edge: int
    faces: list[int]
    max_gap: float | None = None
    max_angle_deg: float | None = None
    curvature_mismatch: float | None = None
    near_miss: bool = False
    fault: str = ""
    document: dict[str, Any] = field(default_factory=dict, repr=False)

    @property
    def continuity(self) -> str:
        """sharp, G0, G1, G2 or G3."""
        return self.document["class"]


class _Report:
    def __init__(self, document, page=None):
        self.document = document
        self.page = page  # the HTML report, if asked for

    @property
    def verdict(self) -> str:
        """One line."""
        return self.document["verdict"]

    @property
    def good(self) -> bool:
        """Nothing is out of tolerance."""
        return self.document["exit_code"] == 0

    def _repr_html_(self):
        """A notebook shows the report's page, with the model in 3D."""
        if not self.page:
            return f"<p>{html.escape(self.verdict)}</p>"
        return (
            f'<iframe srcdoc="{html.escape(self.page)}" width="100%" height="640" '
            'sandbox="allow-scripts" style="border:0"></iframe>'
        )

    def __repr__(self):
        return f"<{type(self).__name__}: {self.verdict}>"


class CheckReport(_Report):
    """What `check` measured."""

    @property
    def edges(self) -> list[Edge]:
        return [_typed(Edge, edge) for edge in self.document["edges"]]

    @property
    def summary(self) -> dict[str, Any]:
        return self.document["summary"]


class FillResult(_Report):
    """shape: the filled model, of the kind that was given; see `fill`."""

    def __init__(self, document, shape, page=None):
        super().__init__(document, page)
        self.shape = shape

    @property
    def report(self) -> dict[str, Any]:
        """The JSON document."""
        return self.document

    @property
    def holes(self) -> list[FilledHole]:
        return [
            dataclasses.replace(_typed(FilledHole, hole), findings=findings(hole))
            for hole in self.document["holes"]
        ]

    @property
    def findings(self) -> list[Finding]:
        """Of the whole run, the worst first."""
        return findings(self.document)

    @property
    def closed(self) -> bool:
        return self.document["closed"]

    @property
    def valid(self) -> bool:
        return self.document["valid"]


def findings(document):
    return [_typed(Finding, entry) for entry in document.get("findings", [])]


def holes(document):
    return [_typed(Hole, entry) for entry in document["holes"]]
