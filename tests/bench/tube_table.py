#!/usr/bin/python3
"""Makes the table of docs/methods/tube.md: every reopened hole with three sides or more, by `tube`.

    tube_table.py [--angle 0.1] [--cases WORD...] > TABLE.md

Asked for are the angle and a gap of 1e-5 of the hole's diameter, but no less than 1e-4 mm. Gap and angle
are those of the written file, read again; the deviation from the lost face is the judge's.
"""

import argparse
import re
import sys
import tempfile
from pathlib import Path

from bench import bench_one
from cases import reopened_cases, with_holes
from tables import net_of, number, seconds, table, validity_of

FEWEST_SIDES = 3
GAP = 1e-5  # of the diameter
LEAST_GAP = 1e-4  # mm
COLUMNS = (
    "hole", "sides", "gap / diameter", "angle", "crease inside", "deviation", "net", "fill s", "result",
)  # fmt: skip


def crease_of(notes):
    found = [re.search(r"crease along the corners' lines (\S+) deg", note) for note in notes]
    return next((float(match[1]) for match in found if match), None)


def run_all(angle, words):
    rows = []
    with tempfile.TemporaryDirectory(prefix="suture_tube_") as folder:
        for model in reopened_cases():
            if model.sides < FEWEST_SIDES or (words and not any(w in model.name for w in words)):
                continue
            for case in with_holes(model):
                tolerance = max(GAP * case.diameter, LEAST_GAP)
                arguments = ["--method", "tube", "--tolerance", tolerance, "--angle", angle]
                rows.append(bench_one(case, "tube", arguments, 1, Path(folder)))
                print(case.name, rows[-1]["status"], file=sys.stderr)
    return rows


def cells_of(row):
    head = [row["case"], row["sides"]]
    if row["status"] != "filled":
        return [*head, *["-"] * 6, f"{row['status']}: {row['reason'].removeprefix('tube: ')}"]
    crease = crease_of(row["notes"])
    return [
        *head,
        number(row["max_gap"] / row["diameter"]),
        number(row["max_angle_deg"]),
        number(crease),
        number(row["judge"].get("fidelity")),
        net_of(row["patches"]),
        seconds(row["seconds_fill"]),
        validity_of(row),
    ]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--angle", type=float, default=0.1, help="degrees")
    arguments.add_argument("--cases", nargs="*", help="words in the names of the cases to run")
    options = arguments.parse_args()
    rows = run_all(options.angle, options.cases)
    print(table(COLUMNS, [cells_of(row) for row in rows]))
    filled = [row for row in rows if row["status"] == "filled"]
    good = [row for row in filled if row["max_angle_deg"] <= options.angle]
    print(f"{len(rows)} holes, {len(filled)} filled, {len(good)} of them within {options.angle:g} degrees.")


if __name__ == "__main__":
    main()
