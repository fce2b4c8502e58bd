#!/usr/bin/python3
"""Makes the table of docs/methods/recognise.md: how near `auto` comes to every lost face of the reopened models.

    recognise_table.py [--cases WORD...] [--prefer original] > TABLE.md

All figures are shares of the hole's diameter. Distance: largest one between the new face and the lost one, both
ways; noise: how far the hole's edges lie off the lost face and its neighbours, all by `suture_referee` on the
written file. A face counts as given back if its distance is at most 1e-6 or 1.5 times the noise.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from bench import judged, outcome_of
from cases import reopened_cases, with_holes
from program import SUTURE, run
from tables import number, table

LIMIT = 600  # seconds for one run of the program
ENOUGH, OF_NOISE = 1e-6, 1.5
COLUMNS = (
    "hole", "recognised", "told by", "noise", "distance", "given back", "angle [deg]", "`--recognise off`",
    "distance", "angle [deg]",
)  # fmt: skip


def fill(case, folder, options):
    """(the hole's entry in the report, what the referee says), both None where nothing was filled. What is bad is
    kept to be measured, and said to be out."""
    out = folder / "out.step"
    done = run([SUTURE, "fill", case.model, "-o", out, "--hole", case.hole, "--json", "--force", "--keep-bad",
            *options], LIMIT)
    status, _, entry = outcome_of(done, case.hole)
    if status != "filled" or not out.exists():
        return None, None
    return entry, judged(case, out)


def share(verdict, key, case):
    value = verdict and verdict.get(key)
    return None if value is None else value / case.diameter if key == "border_noise" else value


def words_of(entry):
    found = entry.get("recognised")
    if not found:
        return entry["method_used"], "-"
    sizes = ", ".join(f"{value:.7g}" for value in found["parameters"].values())
    return f"{found['kind']} {sizes}".strip(), found["from"]


def row_of(case, folder, options):
    entry, verdict = fill(case, folder, options)
    without, plain = fill(case, folder, ["--recognise", "off"])
    if entry is None:
        return [case.name, "stays open", *["-"] * 8], None
    noise, distance = share(verdict, "border_noise", case), share(verdict, "fidelity", case)
    back = distance is not None and distance <= max(ENOUGH, OF_NOISE * noise)
    bad = [found["text"] for found in entry["findings"] if found["severity"] == "bad" and not found["before"]]
    name, source = words_of(entry)
    cells = [case.name, f"{name} (left out: {bad[0]})" if bad else name, source, number(noise), number(distance), "yes" if back else "no",
             number(entry["max_angle_deg"])]  # fmt: skip
    if without is None:
        return [*cells, "stays open", "-", "-"], back
    return [*cells, without["method_used"], number(share(plain, "fidelity", case)),
            number(without["max_angle_deg"])], back  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", nargs="*", help="words in the names of the cases to run")
    parser.add_argument("--prefer", choices=("tight", "original"), default="tight")
    options = parser.parse_args()
    rows, given_back = [], []
    with tempfile.TemporaryDirectory(prefix="suture_recognise_") as folder:
        for model in reopened_cases():
            # R and H: faces of real models; all others are constructed, or have no lost face.
            wanted = not options.cases or any(word in model.name for word in options.cases)
            if model.name[0] not in "RH" or not wanted:
                continue
            for case in with_holes(model):
                cells, back = row_of(case, Path(folder), ["--prefer", options.prefer])
                rows.append(cells)
                given_back.append(bool(back))
                print(" | ".join(map(str, cells)), file=sys.stderr, flush=True)
    print(table(COLUMNS, rows))
    print(f"{sum(given_back)} of {len(given_back)} faces are given back.")


if __name__ == "__main__":
    main()
