#!/usr/bin/python3
"""Fills the reopened CAD models by `concentric` and writes the table of docs/methods/concentric.md.

    tests/bench/concentric_cases.py [-o TABLE.md] [--json ROWS.json] [--option KEY=VALUE...] [CASE...]

CASE: names, or beginnings of names, of rows of CAD/reopened/cases.tsv; none: all. SUTURE_PROGRAM is the program. Default
tolerances. Angles are those of the written file, read again: along the hole's own edges, and along all edges of the new
faces. `check` is run on the same file: where what it finds on these edges is not what `fill` said, the row says so.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

from cases import inspect, reopened_cases, with_holes
from program import SUTURE, run
from tables import number, table

LIMIT = 300  # seconds for a run
MOST_POLES, MOST_ANGLE, MOST_SECONDS = 5000, 0.1, 5.0  # what is aimed at; the last one for refusals
COLUMNS = ("hole", "sides", "own edges", "all edges", "corners", "poles", "s", "result")
SAME = 1e-6  # degrees: two readings of one file


def corner_mismatch(case):
    """The largest angle between the normals of two neighbours at a corner, in degrees: half of it no face can meet."""
    hole = next(hole for hole in inspect(case.model) if hole["id"] == case.hole)
    return max((corner["normal_mismatch_deg"] or 0.0 for corner in hole["corners"]), default=0.0)


def largest(values):
    return max((value for value in values if value is not None), default=0.0)


def checked(out, faces):
    """The largest angle that `suture check` finds on the edges of some faces of a file."""
    document = run([SUTURE, "check", out, "--json"], LIMIT).document()
    edges = [edge for edge in document["edges"] if faces & set(edge["faces"])]
    return largest(edge["max_angle_deg"] for edge in edges)


def measure(case, folder, more):
    out = folder / f"{case.name}.step"
    done = run([SUTURE, "fill", case.model, "-o", out, "--hole", case.hole, "--method", "concentric", "--json", *more], LIMIT)
    row = {"case": case.name, "sides": case.sides, "corners": corner_mismatch(case), "seconds": done.seconds}
    document = done.document()
    if document is None:
        return row | {"status": "failed", "reason": f"exit code {done.code}"}
    entry = next(hole for hole in document["holes"] if case.hole in hole["ids"])
    row |= {"status": entry["status"], "reason": entry["reason"], "notes": entry["notes"], "fill": document["seconds"]["fill"]}
    if entry["status"] != "filled":
        return row
    row |= {
        "own": largest(edge["max_angle_deg"] for edge in entry["edges"]),
        "all": entry["max_angle_deg"] or 0.0,
        "gap": entry["max_gap"],
        "poles": sum(patch["poles_u"] * patch["poles_v"] for patch in entry["patches"]),
        "nets": [(patch["poles_u"], patch["poles_v"]) for patch in entry["patches"]],
        "valid": document["valid"],
        "severity": entry["severity"],
        "findings": [found["text"] for found in entry["findings"] if found["severity"] != "good"],
    }
    row["checked"] = checked(out, {patch["face"] for patch in entry["patches"]})
    return row


def words_of(row):
    if row["status"] != "filled":
        return f"{row['status']}: {row['reason'].removeprefix('concentric: ')}"
    words = [row["severity"]]
    if not row["valid"]:
        words.append("NOT VALID")
    # `fill` leaves out what is no edge of the new faces alone: sides that want position only.
    if row["checked"] > row["all"] * (1.0 + 1e-3) + SAME:
        words.append(f"`check` finds {number(row['checked'])} deg")
    return ", ".join(words)


def cells_of(row):
    figures = [number(row.get(key)) for key in ("own", "all", "corners")]
    return [row["case"], row["sides"], *figures, row.get("poles", "-"), f"{row['seconds']:.1f}", words_of(row)]


def summary(rows):
    filled = [row for row in rows if row["status"] == "filled"]
    near = [row for row in filled if row["all"] <= MOST_ANGLE]
    large = [row["case"] for row in filled if row["poles"] > MOST_POLES]
    refused = [row["seconds"] for row in rows if row["status"] != "filled"]
    return (
        f"\n{len(filled)} of {len(rows)} holes are filled, {len(near)} within {MOST_ANGLE:g} degrees along all edges and "
        f"{sum(row['own'] <= MOST_ANGLE for row in filled)} along the\nhole's own; "
        f"{max((row['poles'] for row in filled), default=0)} poles at most (above {MOST_POLES}: {', '.join(large) or 'none'}); "
        f"refusals take {max(refused, default=0.0):.1f} s at most.\n"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*")
    parser.add_argument("-o", "--output", type=Path)
    parser.add_argument("--json", type=Path, help="all figures")
    parser.add_argument("--option", nargs="*", default=[], help="KEY=VALUE of the method's own")
    options = parser.parse_args()
    more = [word for option in options.option for word in ("--option", option)]
    rows = []
    with tempfile.TemporaryDirectory(prefix="suture_concentric_") as folder:
        for model in reopened_cases():
            if options.cases and not model.name.startswith(tuple(options.cases)):
                continue
            rows.append(measure(with_holes(model)[0], Path(folder), more))
            print("\t".join(map(str, cells_of(rows[-1]))), file=sys.stderr, flush=True)
    text = table(COLUMNS, [cells_of(row) for row in rows]) + summary(rows)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
    if options.output:
        options.output.write_text(text, encoding="utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
