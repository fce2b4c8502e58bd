#!/usr/bin/python3
"""Makes the table of a paper's method: what it does on every reopened hole, for its page in docs/methods.

    papers_table.py --method algebraic [--option KEY=VALUE...] [--cases WORD...] > TABLE.md

Default tolerances. Gap and angle are those of the written file, read again; deviation (the largest distance from
the lost face, by the hole's diameter) and area (the new faces' over the lost one's) are the judge's.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from bench import bench_one
from cases import reopened_cases, with_holes
from tables import number, table, validity_of

COLUMNS = ("hole", "sides", "gap [mm]", "angle [deg]", "deviation", "faces", "poles", "CPU s", "result")


def cells_of(row):
    head = [row["case"], row["sides"]]
    if row["status"] != "filled":
        return [*head, *["-"] * 5, number(row["seconds_cpu"]), f"{row['status']}: {row['reason']}"]
    patches = row["patches"]
    return [
        *head,
        number(row["max_gap"]),
        number(row["max_angle_deg"]),
        number(row["judge"].get("fidelity")),
        len(patches),
        sum(patch["poles_u"] * patch["poles_v"] for patch in patches),
        number(row["seconds_cpu"]),
        validity_of(row),
    ]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--method", required=True)
    arguments.add_argument("--option", nargs="*", default=[], help="KEY=VALUE of the method's own")
    arguments.add_argument("--cases", nargs="*", help="words in the names of the cases to run")
    options = arguments.parse_args()
    given = [word for option in options.option for word in ("--option", option)]
    rows = []
    with tempfile.TemporaryDirectory(prefix="suture_papers_") as folder:
        for model in reopened_cases():
            if options.cases and not any(word in model.name for word in options.cases):
                continue
            for case in with_holes(model):
                row = bench_one(case, options.method, ["--method", options.method, *given], 1, Path(folder))
                rows.append(row)
                print(case.name, row["status"], file=sys.stderr)
    print(table(COLUMNS, [cells_of(row) for row in rows]))
    filled = [row for row in rows if row["status"] == "filled"]
    print(f"{len(rows)} holes, {len(filled)} filled.")


if __name__ == "__main__":
    main()
