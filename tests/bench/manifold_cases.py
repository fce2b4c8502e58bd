#!/usr/bin/python3
"""Fills the reopened CAD models by `manifold` and writes the table of docs/methods/manifold.md.

    tests/bench/manifold_cases.py [-o TABLE.md] [CASE...]

CASE: names, or beginnings of names, of rows of CAD/reopened/cases.tsv; none: all. SUTURE_PROGRAM is the program.
Closed, valid and the figures are those of the program's own report on the file it has written.
"""

import argparse
import math
import re
import sys
import tempfile
from pathlib import Path

from cases import inspect, reopened_cases, with_holes
from program import SUTURE, run
from tables import number, table

LIMIT = 120  # seconds for a run
GAP, ANGLE = 1e-5, 0.1  # of the diameter; degrees: what is asked for
# What the program says where the model's own edges are less accurate than that.
OWN_EDGES = re.compile(r"own edges here are only good to ([0-9.e+-]+)")
COLUMNS = ("case", "sides", "corners", "apart", "gap / diameter", "angle [deg]", "patches", "MB", "s", "result")


def mismatch(case):
    """The largest angle between the normals of two neighbours at a corner, in degrees."""
    hole = next(hole for hole in inspect(case.model) if hole["id"] == case.hole)
    return max((corner["normal_mismatch_deg"] or 0.0 for corner in hole["corners"]), default=0.0)


def measure(case, folder):
    """The row of one case, and whether it counts as met; None where no smooth face exists."""
    out = folder / f"{case.name}.step"
    done = run(
        [SUTURE, "fill", case.model, "-o", out, "--hole", case.hole, "--method", "manifold",
         "--tolerance", GAP * case.diameter, "--angle", ANGLE, "--json"], LIMIT,
    )  # fmt: skip
    corners = mismatch(case)
    first = [case.name, case.sides, number(corners), "-"]
    seconds = f"{done.seconds:.1f}"
    document = done.document()
    if document is None:
        reason = f"not done in {LIMIT} s" if done.timed_out else f"exit code {done.code}"
        return [*first, "-", "-", "-", "-", seconds, reason], False
    entry = next(hole for hole in document["holes"] if case.hole in hole["ids"])
    compatible = corners <= ANGLE
    own = [OWN_EDGES.search(note) for note in entry["notes"]]
    apart = max([float(found.group(1)) / case.diameter for found in own if found], default=0.0)
    first[-1] = number(apart) if apart else "-"
    if entry["status"] != "filled":
        return [*first, "-", "-", "-", "-", seconds, f"{entry['status']}: {entry['reason']}"], (
            False if compatible else None
        )
    gap = entry["max_gap"] / case.diameter
    angle = max([entry["max_angle_deg"] or 0.0] + [e["max_angle_deg"] or 0.0 for e in entry["edges"]])
    closed = document["closed"] or case.truth is None
    good = gap <= max(GAP, apart) and angle <= ANGLE and document["valid"] and closed
    said = "within" if good and gap <= GAP else "as near as the model's own edges" if good else "OUT"
    if not document["valid"]:
        said += ", NOT VALID"
    if not closed:
        said += f", {document['free_edges']} free edges"
    size = f"{(out.stat().st_size - case.model.stat().st_size) / 1e6:.1f}"
    row = [*first, number(gap), number(angle), len(entry["patches"]), size, seconds, said]
    return row, good if compatible or good else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*")
    parser.add_argument("-o", "--output", type=Path)
    options = parser.parse_args()
    chosen = [
        case for case in reopened_cases()
        if not options.cases or case.name.startswith(tuple(options.cases))
    ]  # fmt: skip
    rows, met = [], []
    with tempfile.TemporaryDirectory() as folder:
        for case in chosen:
            row, good = measure(with_holes(case)[0], Path(folder))
            print("\t".join(map(str, row)), file=sys.stderr, flush=True)
            rows.append(row)
            met.append(good)
    known = [good for good in met if good is not None]
    share = 100.0 * sum(known) / len(known) if known else math.nan
    within = sum(row[-1] == "within" for row in rows)
    text = table(COLUMNS, rows)
    text += (
        f"\n{sum(known)} of {len(known)} cases ({share:.0f} %) are closed and valid, with an angle of at most "
        f"{ANGLE} deg and a gap\nof at most {GAP:g} of the diameter or, where that is more, of what the model's own "
        f"edges are good to;\n{within} without the latter.\n"
    )
    if options.output:
        options.output.write_text(text, encoding="utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
