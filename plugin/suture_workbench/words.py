# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels say about the program's answers, in the user's language. Needs no window."""

from .compat import translate
from .said import in_users_words

_HUGE = 10.0  # a miss by so many times the limit is bad, not just short of it


def sentence(number, one, many):
    """`one` or `many` with the number in it."""
    return (one if number == 1 else many).format(number)


# -- what can be chosen


def method_text(method, title=""):
    """What a fill method does; `title` is the program's own text, for one that is new to us."""
    return {
        "auto": translate("Tries what applies, measures each result, and keeps the best."),
        "extend": translate("Continues the surface on which all neighbours lie. Exact."),
        "recognise": translate("Gives back the very face that was lost: cylinder, torus, copy of another…"),
        "plane": translate("Closes a hole that lies in a plane by a flat face. Exact."),
        "mvs": translate("The surface whose curvature varies least, as one freeform face."),
        "algebraic": translate("Surfaces given by polynomials, between planes, quadrics and tori."),
        "concentric": translate("A disc-like surface whose spokes run from the rim to the middle."),
        "tube": translate("A tube around the hole that closes in a point, as one face."),
        "manifold": translate("A patch of many sides: strips along the rim, a star in the middle."),
        "occt": translate("OpenCASCADE's own filling, as FreeCAD's Surface > Filling uses it."),
    }.get(method, title)


def task_name(task):
    """What is done, as the title of a panel and of a step of undo."""
    return {
        "Boundary": translate("Fill from edges"),
        "Bridge": translate("Bridge"),
        "Replace": translate("Replace faces"),
        "Remove": translate("Remove faces"),
    }.get(task, translate("Fill holes"))


def surface_name(command):
    """What is done by one of options.SURFACES."""
    return {
        "patch": translate("Patch from a mesh"),
        "algebraic": translate("Algebraic surface"),
    }[command]


def continuity_text(wanted):
    """What a wish for continuity means."""
    return {
        "auto": translate("Tangent wherever the neighbours allow it, else in position only."),
        "G0": translate("Position: no gap, but a visible edge."),
        "G1": translate("Tangent: no edge is seen; reflections have a kink."),
        "G2": translate("Equal curvature: reflections run on smoothly."),
    }[wanted]


def recognise_text(scope):
    """Where the very surface that was lost is looked for."""
    return {
        "model": translate("Among the surfaces of all faces, their offsets and copies."),
        "neighbours": translate("On the surfaces around the hole only."),
        "off": translate("Nowhere: each hole is filled smoothly."),
    }[scope]


def recognise_name(scope):
    """The same in a word or two."""
    return {
        "model": translate("in the whole model"),
        "neighbours": translate("around the hole"),
        "off": translate("not at all"),
    }[scope]


def effort_text(effort):
    """How much the method auto tries where nothing is within tolerance at once."""
    return {
        "quick": translate("auto tries what is quick only."),
        "normal": translate("auto takes some seconds more for a hole where it has to."),
        "thorough": translate("auto tries all that can come nearer, however long it takes."),
    }[effort]


def effort_name(effort):
    """The same in a word."""
    return {
        "quick": translate("quick"),
        "normal": translate("normal"),
        "thorough": translate("thorough"),
    }[effort]


def profile_text(profile):
    """Whose limits a profile of the check has."""
    return {
        "catia": translate("The limits of CATIA's Connect Checker; the strictest."),
        "vda4955": translate("VDA 4955, the car makers' rule for freeform surfaces."),
        "alias": translate("Autodesk Alias: below 0.1° a break in tangency is not seen."),
        "rhino": translate("Rhino's tolerances of a new document."),
        "occt": translate("The limits that OpenCASCADE itself uses."),
    }.get(profile, translate("Your own limits, below."))


# -- what was found


def holes_summary(report):
    """How many holes there are, and what else is open."""
    holes = sum(1 for hole in report.holes if hole.kind == "hole")
    others = len(report.holes) - holes
    lines = [
        sentence(holes, translate("{} hole."), translate("{} holes."))
        if holes
        else translate("There is no hole.")
    ]
    if others:
        lines.append(
            sentence(
                others,
                translate("{} other open border, which is no hole."),
                translate("{} other open borders, which are no holes."),
            )
        )
    if report.holes:
        lines.append(translate("Click a row to see it."))
    return " ".join(lines)


# -- what came of a fill


def side_faults(side, limits):
    """Where a side misses what was asked for there: [("angle", value, limit), ...].

    limits   the key `tolerance` of the program's answer
    """
    faults = []
    if side.gap is not None and side.gap > limits["gap_mm"]:
        faults.append(("gap", side.gap, limits["gap_mm"]))
    if side.wanted in ("G1", "G2") and (side.angle or 0.0) > limits["angle_deg"]:
        faults.append(("angle", side.angle, limits["angle_deg"]))
    percent = 100.0 * (side.curvature or 0.0)
    if side.wanted == "G2" and percent > limits["curvature_percent"]:
        faults.append(("curvature", percent, limits["curvature_percent"]))
    return faults


def side_reached(side, limits):
    """The highest continuity whose limits a side keeps: "G0", "G1", "G2"; "" if there is a gap."""
    if side.gap is None or side.gap > limits["gap_mm"]:
        return ""
    if side.angle is None or side.angle > limits["angle_deg"]:
        return "G0"
    if side.curvature is None or 100.0 * side.curvature > limits["curvature_percent"]:
        return "G1"
    return "G2"


def fault_text(fault):
    """("angle", 0.2, 0.01) in words."""
    kind, value, limit = fault
    return {
        "gap": translate("gap {:.3g} mm (at most {:.3g})"),
        "angle": translate("angle {:.3g}° (at most {:.3g})"),
        "curvature": translate("curvature differs by {:.3g} % (at most {:.3g})"),
    }[kind].format(value, limit)


def fill_summary(report):
    """What a fill is: how many holes, what was measured, whether it is closed."""
    filled = [hole for hole in report.holes if hole.status == "filled"]
    lines = [_as_sentence(change) for change in report.document.get("changes") or []]
    if filled or not lines:
        lines.append(
            sentence(len(filled), translate("{} hole filled."), translate("{} holes filled."))
        )
    gaps = [hole.gap for hole in filled if hole.gap is not None]
    angles = [hole.angle for hole in filled if hole.angle is not None]
    if gaps:
        text = translate("Largest gap {:.2g} mm").format(max(gaps))
        if angles:
            text += translate(", largest angle where tangent was asked for {:.2g}°").format(
                max(angles)
            )
        lines.append(text + ".")
    lines += [
        translate("Hole {} recognised: {}.").format(hole.id, hole.recognised)
        for hole in filled
        if hole.recognised
    ]
    lines.append(whole_text(report))
    for hole in report.holes:
        if hole.points and hole.distance is not None:
            lines.append(
                translate("Hole {} passes {} points within {:.2g} mm.").format(
                    hole.id, hole.points, hole.distance
                )
            )
    return "\n".join(lines)


def _as_sentence(change):
    """What the program has done to faces before it filled anything."""
    change = in_users_words(change)
    return f"{change[0].upper()}{change[1:]}."


def whole_text(report):
    """Whether the shape as a whole is closed and valid."""
    if not report.valid:
        return translate("The shape is not valid (Part > Check geometry says where).")
    if report.closed:
        return translate("The shape is closed and valid.")
    return sentence(
        report.free_edges,
        translate("The shape is open: {} free edge is left."),
        translate("The shape is open: {} free edges are left."),
    )


def shortfall(report):
    """Why a fill is not all that was asked for: the holes, and of each the sides, that miss it."""
    lines = []
    for hole in report.holes:
        if hole.status == "refused":
            edges = ", ".join(f"Edge{edge}" for edge in hole.edges)
            at = f" ({edges})" if edges else ""
            lines.append(translate("Hole {}{} was refused: {}").format(hole.id, at, hole.reason))
        elif hole.ok is False:
            lines += _hole_faults(hole, report.limits)
    if any(hole.status == "filled" for hole in report.holes):
        lines.append(fill_summary(report))
    if (report.document.get("sewing") or {}).get("changed"):
        lines.append(translate("Edge numbers are those after the loose faces were sewn."))
    return "\n".join(lines)


def finding_text(finding):
    """What is wrong, in words; what is new to us as the program says it."""
    name = {
        "gap": translate("gap"),
        "angle": translate("angle"),
        "curvature": translate("curvature mismatch"),
        "crease": translate("crease inside the new face"),
        "clash": translate("the new face cuts another one, to a depth of"),
        "balloon": translate("bulges: times the area of a stretched surface"),
        "tolerance_grown": translate("tolerance of the edge grown to"),
        "tangency_given_up": translate("tangency given up, angle"),
        "through": translate("distance of a point to be passed"),
        "through_angle": translate("angle to the normal wanted at a point,"),
    }.get(finding.kind)
    if name is not None:
        unit = "°" if finding.unit == "deg" else f" {finding.unit}".rstrip()
        return translate("{} {:.3g}{} (at most {:.3g})").format(
            name, finding.value, unit, finding.limit
        )
    return {
        "fold": translate("the new face folds"),
        "lies_on_face": translate("the new face lies on another one"),
        "open_edge": translate("an edge of the new face is open"),
        "not_measured": translate("could not be measured"),
        "not_valid": translate("the shape is not valid"),
    }.get(finding.kind, finding.text)


def _at(hole, finding):
    where = translate("Hole {}, Edge{}: {}.") if finding.edge else translate("Hole {}: {}.")
    place = (hole.id, finding.edge) if finding.edge else (hole.id,)
    return where.format(*place, finding_text(finding))


def _hole_faults(hole, limits):
    if hole.findings:
        return [_at(hole, finding) for finding in hole.findings]
    lines = []
    for side in hole.sides:
        faults = side_faults(side, limits)
        if faults:
            said = ", ".join(map(fault_text, faults))
            lines.append(translate("Hole {}, Edge{}: {}.").format(hole.id, side.edge, said))
    if not lines:
        inside = ("gap", hole.gap, limits["gap_mm"]), ("angle", hole.angle, limits["angle_deg"])
        said = [fault_text(fault) for fault in inside if fault[1] and fault[1] > fault[2]]
        said = said or [translate("the tolerances are not met")]
        lines.append(translate("Hole {}, inside: {}.").format(hole.id, ", ".join(said)))
    return lines


def doubts(report):
    """Why a fill should not be kept unasked: what is far off, or spoils the shape; "" if nothing."""
    lines = []
    for hole in report.holes:
        if hole.status == "refused":
            lines.append(translate("Hole {} was refused and stays open.").format(hole.id))
        if hole.findings and hole.status == "filled":
            bad = [finding for finding in hole.findings if finding.severity in ("poor", "bad")]
            lines += [_at(hole, finding) for finding in bad]
            continue
        for side in hole.sides if hole.status == "filled" else ():
            far = [f for f in side_faults(side, report.limits) if f[1] > _HUGE * f[2]]
            if far:
                said = ", ".join(map(fault_text, far))
                lines.append(translate("Hole {}, Edge{}: {}.").format(hole.id, side.edge, said))
    if not report.valid:
        lines.append(whole_text(report))
    return "\n".join(lines)


# -- what a check found


def check_summary(report):
    """(sentence, whether all is well) of a check."""
    lines, well = [], True
    unmeasured = sum(1 for edge in report.edges if not edge.measured)
    if report.near_misses:
        well = False
        lines.append(
            sentence(
                report.near_misses,
                translate("{} edge is neither smooth nor sharp: a near miss."),
                translate("{} edges are neither smooth nor sharp: near misses."),
            )
        )
    elif report.edges:
        lines.append(
            sentence(
                len(report.edges),
                translate("{} edge measured: it is smooth or sharp."),
                translate("{} edges measured: all are smooth or sharp."),
            )
        )
    if unmeasured:
        well = False
        lines.append(
            sentence(
                unmeasured,
                translate("{} edge could not be measured."),
                translate("{} edges could not be measured."),
            )
        )
    if report.free_edges:
        well = False
        lines.append(
            sentence(
                len(report.free_edges),
                translate("The shape is open: {} free edge."),
                translate("The shape is open: {} free edges."),
            )
        )
    certified = report.document.get("certificates")
    if certified:
        lines.append(
            translate("Proven bounds for {} of {} edges.").format(
                certified["certified"], certified["edges"]
            )
        )
    return "\n".join(lines), well


def surface_summary(document):
    """(sentence, whether all is well) of a surface that was made from a file."""
    if document["command"] == "patch":
        made = document
        lines = [
            translate("{} sides, {} layers of quads, smooth of order {} inside.").format(
                made["sides"], made["layers"], made["k"]
            )
        ]
        if not made["exact"]:
            lines.append(
                translate("The middle is fitted to within {:.2g} of the mesh's size.").format(
                    made["fit_error"] / made["diameter"]
                )
            )
    else:
        made = document["faces"]
        lines = [
            translate("Polynomials of degree {} in {} cells, smooth of order {}.").format(
                document["degree"], len(document["cells"]), document["k"]
            ),
            translate("The faces lie within {:.2g} mm and {:.2g}° of them.").format(
                made["fit_error"], made["fit_angle_deg"]
            ),
        ]
    shape = made["shape"]
    lines.append(
        translate("{} faces, largest gap {:.2g} mm, largest angle {:.2g}°.").format(
            shape["faces"], made["max_gap"], made["max_angle_deg"]
        )
    )
    if not shape["valid"]:
        lines.append(translate("The shape is not valid (Part > Check geometry says where)."))
    well = document["exit_code"] == 0
    if not well and shape["valid"]:
        lines.append(translate("The tolerances are not met."))
    return "\n".join(lines), well


def extra_name(name):
    """What one of extras.EXTRAS is called."""
    return {
        "merge": translate("Merge with equal neighbours"),
        "grow": translate("Let the neighbours grow together"),
        "split": translate("Cut in two"),
        "tension": translate("Tension"),
        "planar": translate("Planar holes only"),
        "larger": translate("Larger than"),
        "smaller": translate("Smaller than"),
        "corners": translate("With so many sides"),
    }[name]


def option_name(key):
    """What a method's own option is called; one that is new to us by its key."""
    return {
        "pole": translate("Closing point"),
        "normal": translate("Normal there"),
        "energy": translate("Fairness"),
        "magnitude": translate("Tangents there"),
        "move-pole": translate("Let it move"),
        "curvature": translate("Curvature there"),
        "border": translate("Border"),
        "join": translate("Border's joins"),
        "layers": translate("Layers"),
        "k": translate("Smoothness inside"),
        "aperture": translate("Size of middle"),
        "middle": translate("Middle"),
        "degree": translate("Degree"),
        "cells": translate("Cells"),
        "faces": translate("Faces"),
        "axis": translate("Axis"),
        "tension": translate("Tension"),
        "salience": translate("Cut branches"),
        "flatness": translate("Drop flat nodes"),
    }.get(key, key)


def sewn(sewing):
    """What came of sewing (the key `sewing` of the program's answer)."""
    return translate("{} loose faces sewn, gaps up to {:.2g} mm; {} free edges are left.").format(
        sewing["loose_faces"], sewing["largest_gap"], sewing["free_edges_after"]
    )
