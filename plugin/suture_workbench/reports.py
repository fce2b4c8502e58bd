# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program's answers (docs/json.md) as objects."""

import csv
import io
from collections import namedtuple

from . import words
from .compat import translate
from .errors import SutureError
from .said import in_users_words

FILLABLE = "hole"

Hole = namedtuple("Hole", "id kind reason edges faces diameter length planar corners islands")
Corner = namedtuple("Corner", "point angle mismatch faces")
Holes = namedtuple("Holes", "verdict holes sewn sewing_tolerance document")

Side = namedtuple("Side", "edge face wanted reason gap angle curvature")

class HoleFill(
    namedtuple(
        "HoleFill",
        "id ids status method wanted reached ok gap angle reason sides new_faces notes edges points "
        "distance findings",
    )
):
    """What became of a hole."""

    @property
    def recognised(self):
        """The surface that was found again, in words: "torus R = 12, r = 3, tangent to Face4"; else ""."""
        start = "recognised: "
        found = (note[len(start) :] for note in self.notes if note.startswith(start))
        return in_users_words(next(found, ""))


# What is not as it should be: severity "near", "poor", "bad" ("good" is left out), figures in `unit`.
Finding = namedtuple("Finding", "kind severity value limit unit edge text")
Fill = namedtuple("Fill", "verdict holes closed valid free_edges ok limits document")

class EdgeCheck(
    namedtuple(
        "EdgeCheck",
        "edge faces kind near_miss gap gap_at angle at curvature curvature_at length measured note "
        "certificate",
    )
):
    """What was measured at one edge; `certificate` (docs/json.md) if it was to be proven, else {}."""

    @property
    def proven(self):
        return bool(self.certificate.get("certified"))

    def bound_text(self, figure):
        """The proven bound of "gap" or "angle" in words; why there is none; "" if none was asked for."""
        if self.proven:
            key, unit = {"gap": ("gap_bound", "mm"), "angle": ("angle_bound_deg", "°")}[figure]
            return translate("proven: nowhere above {:.3g} {}").format(self.certificate[key], unit)
        reason = in_users_words(self.certificate.get("reason", ""))
        return translate("not proven: {}").format(reason) if reason else ""


Check = namedtuple("Check", "verdict edges limits near_misses free_edges document")
Limits = namedtuple("Limits", "name gap angle curvature sharp")


def _checked(parse):
    """A missing or odd key is a damaged answer, and said so."""

    def wrapped(document):
        try:
            return parse(document)
        except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
            raise SutureError(
                translate(
                    "The program's answer is not as expected ({}: {}). Is it too old?"
                ).format(type(error).__name__, error)
            ) from error

    return wrapped


@_checked
def holes(document):
    """`inspect`: every boundary loop, holes first."""
    found = [
        Hole(
            entry["id"],
            entry["kind"],
            in_users_words(entry["reason"]),
            list(entry["edges"]),
            list(entry["faces"]),
            float(entry["diameter"]),
            float(entry["length"]),
            bool(entry["planar"]),
            [
                Corner(c["point"], c["angle_deg"], c["normal_mismatch_deg"], c["faces"])
                for c in entry["corners"]
            ],
            list(entry["islands_with"]),
        )
        for entry in document["holes"]
    ]
    found.sort(key=lambda hole: (hole.kind != FILLABLE, hole.id))
    sewing = document.get("sewing") or {}
    return Holes(
        document["verdict"],
        found,
        bool(sewing.get("changed")),
        float(sewing.get("tolerance") or 0.0),
        document,
    )


@_checked
def fill(document):
    """`fill`: what became of every hole."""
    filled = [
        HoleFill(
            entry["id"],
            list(entry["ids"]),
            entry["status"],
            entry["method_used"],
            entry["continuity_requested"],
            entry["continuity_reached"],
            entry["within_tolerance"],
            entry["max_gap"],
            entry["max_angle_deg"],
            in_users_words(entry["reason"]),
            [
                Side(
                    side["edge"],
                    side["face"],
                    side["continuity_requested"],
                    in_users_words(side["reason"]),
                    side["max_gap"],
                    side["max_angle_deg"],
                    side["max_curvature_mismatch"],
                )
                for side in entry["edges"]
            ],
            [patch["face"] for patch in entry["patches"]],
            list(entry["notes"]),
            [side["edge"] for side in entry["edges"]],
            entry.get("points_through") or 0,
            entry.get("max_distance_through"),
            _findings(entry),
        )
        for entry in document["holes"]
    ]
    return Fill(
        document["verdict"].split("; wrote ")[0],
        filled,
        bool(document["closed"]),
        bool(document["valid"]),
        int(document["free_edges"]),
        document["exit_code"] == 0,
        document["tolerance"],
        document,
    )


def _findings(entry):
    """The findings of a hole that count: not what was wrong before."""
    return [
        Finding(
            found["kind"],
            found["severity"],
            found["value"],
            found["limit"],
            found["unit"],
            found["edge"],
            in_users_words(found["text"]),
        )
        for found in entry.get("findings") or []
        if not found["before"] and found["severity"] != "good"
    ]


def refusal(report):
    """The error for a fill that filled nothing; it knows the edges."""
    edges = [edge for hole in report.holes if hole.status == "refused" for edge in hole.edges]
    return SutureError(words.shortfall(report), edges)


def with_edges(report, loops, chosen=()):
    """The report with the edges of holes that were refused, whose sides the program leaves out.

    loops    {id: edges} of the shape's own loops; those of a border are the `chosen` ones
    """
    known = [
        hole
        if hole.edges
        else hole._replace(edges=[e for id in hole.ids for e in loops.get(id, chosen)])
        for hole in report.holes
    ]
    return report._replace(holes=known)


@_checked
def check(document):
    """`check`: every edge between two faces, worst first."""
    profile = document["profile"]
    limits = Limits(
        profile["name"],
        profile["g0_mm"],
        profile["g1_deg"],
        profile["g2_percent"],
        profile["sharp_deg"],
    )
    edges = [
        EdgeCheck(
            entry["edge"],
            list(entry["faces"]),
            entry["class"],
            bool(entry["near_miss"]),
            entry["max_gap"],
            entry["gap_at"],
            entry["max_angle_deg"],
            entry["at"],
            entry["curvature_mismatch"],
            entry["curvature_at"],
            entry["length"],
            entry["samples"] > 0,
            in_users_words(entry["note"]),
            entry.get("certificate") or {},
        )
        for entry in document["edges"]
    ]
    edges.sort(key=lambda edge: badness(edge, limits), reverse=True)
    summary = document["summary"]
    return Check(
        document["verdict"],
        edges,
        limits,
        int(summary["near_misses"]),
        list(summary["free_edges"]),
        document,
    )


def badness(edge, limits):
    """Sorts edges: unmeasured, near misses by how far they miss, tangent ones, sharp ones."""
    if not edge.measured:
        return (3, 0.0, 0.0)
    gap = (edge.gap or 0.0) / limits.gap
    angle = (edge.angle or 0.0) / limits.angle
    curvature = 100.0 * (edge.curvature or 0.0) / limits.curvature
    if edge.near_miss:
        return (2, max(gap, angle if edge.kind != "sharp" else 0.0), curvature)
    if edge.kind == "sharp":
        return (0, gap, 0.0)
    return (1, max(gap, angle), curvature)


def worst_point(edge, limits):
    """Where an edge is at its worst, judged by the limit that it misses most."""
    ranked = [((edge.gap or 0.0) / limits.gap, edge.gap_at)]
    if edge.kind != "sharp":
        ranked.append(((edge.angle or 0.0) / limits.angle, edge.at))
        ranked.append((100.0 * (edge.curvature or 0.0) / limits.curvature, edge.curvature_at))
        if max(ratio for ratio, _ in ranked[:2]) > 1.0:
            ranked = ranked[:2]  # position and tangency come before curvature
    placed = [(ratio, point) for ratio, point in ranked if point]
    return max(placed, key=lambda pair: pair[0])[1] if placed else None


def check_as_csv(report):
    """The table of `check` as text for spreadsheets."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(
        "edge face1 face2 class near_miss length_mm gap_mm angle_deg curvature_mismatch x y z".split()
    )
    for edge in report.edges:
        writer.writerow(
            [f"Edge{edge.edge}", *(f"Face{face}" for face in edge.faces)]
            + [edge.kind, int(edge.near_miss), edge.length, edge.gap, edge.angle, edge.curvature]
            + list(worst_point(edge, report.limits) or ("", "", ""))
        )
    return out.getvalue()
