#!/usr/bin/python3
"""What the measures of the check find on good models, and what they cost.

    measures.py [-o RESULT.json] [--samples 20000] [--fills 10] [CASE...]

`clashes`: fills the reopened holes and the examples, and looks for clashes and folds of the new faces;
`cost` is the CPU time of that against that of the whole `suture fill`.
`peaks`: the figures of the check against those of many samples on every edge with a search around the
highest, on five public files and on the edges of the new faces of the first fills: the smallest ratios.
"""

import argparse
import json
import statistics
import sys
import tempfile
from pathlib import Path

from bench import machine
from cases import CAD, example_cases, reopened_cases
from program import BUILD, SUTURE, run

LIMIT = 600  # seconds for one run
MEASURES = BUILD / "tests/bench/suture_face_measures"
PEAKS = BUILD / "tests/bench/suture_edge_peaks"
PUBLIC = ["ubend2.stp", "wavy-cube.stp", "0044_bb_boxblend_03_colored.stp", "goteborg.step",
          "Trigger_SO101.step"]  # fmt: skip
FIGURES = ("gap", "angle", "mismatch")


def fill(model, output):
    """The new faces' numbers in the output, and the CPU milliseconds of the run."""
    done = run([SUTURE, "fill", model, "-o", output, "--json", "--force"], LIMIT)
    holes = (done.document() or {}).get("holes", [])
    faces = [patch["face"] for hole in holes for patch in hole.get("patches") or []]
    return [face for face in faces if face], 1e3 * done.cpu_seconds


def clash_row(name, output, faces, fill_ms):
    found = run([MEASURES, output, *faces], LIMIT).document()
    if found is None:
        return {"name": name, "reason": "not measured"}
    kinds = ("clashes", "folds", "undecided", "overlays", "backwards")
    cost = found["clashes_ms"] + found["folds_ms"]
    row = {"name": name, "fill_ms": fill_ms, "clashes_ms": found["clashes_ms"],
           "folds_ms": found["folds_ms"], "cost": cost / fill_ms}  # fmt: skip
    return row | {kind: len(found[kind]) for kind in kinds}


def peak_row(name, file, faces, samples):
    found = run([PEAKS, file, samples, *faces], LIMIT).document()
    if found is None:
        return {"name": name, "reason": "not measured"}
    row = {"name": name, "edges": found["edges"], "check_ms": found["check_ms"]}
    return row | {key: found.get(key, 1.0) for key in FIGURES} | {"missed": found["missed"]}


def show(row):
    figures = [f"{key} {value:.3g}" for key, value in row.items() if isinstance(value, (int, float))]
    print(row["name"], *figures, row.get("reason", ""), file=sys.stderr, flush=True)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*")
    parser.add_argument("-o", "--output", type=Path, default=BUILD / "measures.json")
    parser.add_argument("--samples", type=int, default=20000)
    parser.add_argument("--fills", type=int, default=10)
    options = parser.parse_args(arguments)
    result = {"machine": machine(), "samples": options.samples, "clashes": [], "peaks": []}
    for name in PUBLIC if not options.cases else []:
        result["peaks"].append(peak_row(name, CAD / "files" / name, [], options.samples))
        show(result["peaks"][-1])
    with tempfile.TemporaryDirectory() as folder:
        cases = [*reopened_cases(), *example_cases()]
        for case in cases:
            if options.cases and case.name not in options.cases:
                continue
            output = Path(folder) / f"{case.name}.step"
            faces, fill_ms = fill(case.model, output)
            if not faces:
                continue
            result["clashes"].append(clash_row(case.name, output, faces, fill_ms))
            show(result["clashes"][-1])
            measured = sum(row["name"] not in PUBLIC for row in result["peaks"])
            # Exact fills have no peaks to miss.
            if measured < options.fills and case.name[0] in "HR":
                result["peaks"].append(peak_row(case.name, output, faces, options.samples))
                show(result["peaks"][-1])
    costs = [row["cost"] for row in result["clashes"] if "cost" in row]
    if costs:
        result["median_cost"] = statistics.median(costs)
        print(f"median cost {result['median_cost']:.3f} of a fill", file=sys.stderr)
    options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
