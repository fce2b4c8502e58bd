#!/usr/bin/python3
"""Makes docs/benchmark.md, or another Markdown file, of what bench.py and overhead.py have written.

    tables.py BENCH.json [OVERHEAD.json] -o OUT.md

Every row of the results is in the tables, in the order of the runs: also refusals, with their reason,
and cases that come out worse.
"""

import argparse
import json
import statistics
from pathlib import Path

LARGE_FILE = 0.5e6  # bytes

HEADER = """\
# Benchmark

Made by `cmake --preset bench && cmake --build --preset bench` (tests/bench); not edited by hand.

{program}, {date}; {processor}, {cores} cores; median of {runs} run(s); methods: {methods}.
`tube`, `manifold`, `algebraic` and `concentric` have tables of their own on their pages in docs/methods.

- **fill s**: seconds within the fill method, with `auto` in all that it tried; **all s**: the whole
  process, from reading to measuring; **MB**: its largest process.
- **gap** [mm], **angle** [deg], **curvature** [%]: largest on the new face's edges, by the report, which
  measures the written file after reading it again; angle and curvature where the program chose to join
  smoothly.
- **deviation**: largest distance between the new face and the lost one, both ways, divided by the hole's
  diameter; measured by `suture_referee`, which shares no code with the program. "-": the lost face is not
  known.
- **given back**: faces whose deviation is at most 1e-6 or 1.5 times the file's own noise, which is how far the
  hole's edges lie off the lost face and its neighbours, of those that are known; by `suture_referee`.
- **variation**: integral of |grad II|^2 over the new faces times the diameter squared, in brackets that of
  the lost face; **signs**: how often the Gauss curvature changes its sign, likewise. By `suture_referee`.
  Where the new face varies less than the lost one, the boundary does not tell what was inside.
- **net**: degree and number of poles of the new surfaces, or the name of a closed form.
- **valid**: the written file holds no free edge where the hole was, and OCCT's BRepCheck finds nothing
  wrong with it, by the judge; "re-trimmed": so many old faces whose border has moved, by less than
  1e-3 in area and centroid: OCCT's reader mends what lies within the accuracy that a file states.
"""

COLUMNS = (
    "method", "fill s", "all s", "MB", "gap", "angle", "curvature", "deviation", "variation", "signs",
    "net", "valid", "result",
)  # fmt: skip


def number(value, digits=2):
    if value is None:
        return "-"
    if value == 0:
        return "0"
    return f"{value:.{digits}g}" if abs(value) < 0.01 or abs(value) >= 1e4 else f"{value:.{digits + 1}g}"


def seconds(value):
    return "-" if value is None else f"{value:.2f}"


def table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    lines += ["| " + " | ".join(str(cell).replace("|", "/") for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def fairness_of(row):
    """(variation, signs): of the new faces, with the lost one's in brackets."""
    new, old = row["judge"].get("fairness"), row["judge"].get("truth_fairness")
    if new is None:
        return "-", "-"
    size = row["diameter"] ** 2
    cells = number(new["variation"] * size), new["sign_changes"]
    lost = (number(old["variation"] * size), old["sign_changes"]) if old else None
    return tuple(f"{cell} ({lost[k]})" if lost else str(cell) for k, cell in enumerate(cells))


def net_of(patches):
    """"5x5: 17x17" for a spline, "sphere" for a closed form; equal ones counted."""
    words = [
        f"{patch['degree_u']}x{patch['degree_v']}: {patch['poles_u']}x{patch['poles_v']}"
        if patch["poles_u"]
        else patch["kind"]
        for patch in patches
    ]
    counted = [(words.count(word), word) for word in dict.fromkeys(words)]
    return ", ".join(word if count == 1 else f"{count} of {word}" for count, word in counted)


def validity_of(row):
    judge = row["judge"]
    if "judge_error" in judge:
        return "judge failed: " + judge["judge_error"]
    if not judge["valid"]:
        return "NOT VALID"
    closed = "closed" if judge["free_edges"] == 0 else f"{judge['free_edges']} free edges"
    if judge["changed_faces"]:
        closed += f", {judge['changed_faces']} re-trimmed"
    return closed if judge["lost_faces"] == 0 else f"{closed}, {judge['lost_faces']} FACES CHANGED"


def result_of(row):
    if row["status"] != "filled":
        return f"{row['status']}: {row['reason']}"
    used = "" if row["method_used"] == row["method"] else f"{row['method_used']}; "
    found = row.get("recognised")
    if found:
        used = f"{row['method_used']} ({found['kind']}); "
    if row["within_tolerance"]:
        return used + "within tolerance"
    return used + ": ".join(["out of tolerance", "; ".join(row.get("findings", []))]).rstrip(": ")


def given_back(row):
    """Whether a face is the lost one to within the file's own noise; None if that is not known."""
    deviation, noise = (row["judge"].get(key) for key in ("fidelity", "border_noise"))
    if deviation is None or noise is None:
        return None
    return deviation <= max(1e-6, 1.5 * noise / row["diameter"])


def misses(result, method):
    """Every hole that a method does not fill within tolerance or whose lost face it does not give back."""
    rows = []
    for row in result["rows"]:
        if row["method"] != method:
            continue
        filled = row["status"] == "filled"
        back = given_back(row) if filled else None
        if filled and row["within_tolerance"] and back is not False:
            continue
        deviation = row["judge"].get("fidelity") if filled else None
        noise = row["judge"].get("border_noise") if filled else None
        rows.append([
            row["case"], number(deviation), number(noise and noise / row["diameter"]), result_of(row),
            "" if back is not False else row["reason"],
        ])  # fmt: skip
    return table(("hole", "deviation", "noise", "result", "why the lost face is not given back"), rows)


def cells_of(row):
    first = [row["method"], seconds(row["seconds_fill"]), seconds(row["seconds_process"])]
    first.append(f"{row['peak_bytes'] / 2**20:.0f}")
    if row["status"] != "filled":
        return first + ["-"] * 8 + [result_of(row)]
    curvature = row["max_curvature_mismatch"]
    return first + [
        number(row["max_gap"]),
        number(row["max_angle_deg"]),
        number(None if curvature is None else 100 * curvature),
        number(row["judge"].get("fidelity")),
        *fairness_of(row),
        net_of(row["patches"]),
        validity_of(row),
        result_of(row),
    ]


def median(values):
    known = [value for value in values if value is not None]
    return statistics.median(known) if known else None


def back_of(rows):
    known = [back for back in map(given_back, rows) if back is not None]
    return f"{sum(known)} of {len(known)}"


def summary(result):
    """One line for each method over all cases."""
    rows = []
    for method in result["methods"]:
        own = [row for row in result["rows"] if row["method"] == method]
        filled = [row for row in own if row["status"] == "filled"]
        judges = [row["judge"] for row in filled]
        rows.append([
            method,
            f"{len(filled)} of {len(own)}",
            sum(row["within_tolerance"] for row in filled),
            sum(1 for judge in judges if not judge.get("valid")),
            number(median(row["max_gap"] for row in filled)),
            number(median(row["max_angle_deg"] for row in filled)),
            number(max((row["max_angle_deg"] or 0 for row in filled), default=None)),
            number(median(judge.get("fidelity") for judge in judges)),
            number(max((judge.get("fidelity") or 0 for judge in judges), default=None)),
            back_of(filled),
            seconds(median(row["seconds_fill"] for row in filled)),
            seconds(max((row["seconds_fill"] or 0 for row in filled), default=None)),
            f"{sum(row.get('seconds_cpu', 0) for row in own):.0f}",
        ])  # fmt: skip
    columns = (
        "method", "filled", "within tolerance", "not valid", "median gap", "median angle", "worst angle",
        "median deviation", "worst deviation", "given back", "median fill s", "worst fill s", "CPU s of all",
    )  # fmt: skip
    return table(columns, rows)


def hole_tables(result):
    text = ""
    for case in dict.fromkeys(row["case"] for row in result["rows"]):
        rows = [row for row in result["rows"] if row["case"] == case]
        text += f"\n### {case}\n\n{rows[0]['sides']} sides, diameter {rows[0]['diameter']:.4g} mm\n\n"
        text += table(COLUMNS, [cells_of(row) for row in rows])
    for broken in result["cases_without_hole"]:
        text += f"\n### {broken['case']}\n\n{broken['reason']}\n"
    return text


def overhead_section(result):
    stages = ("read", "detect", "fill", "sew", "write", "check")
    rows = []
    for row in result["rows"]:
        size = f"{row['bytes'] / 1e6:.2f}"
        if "ratio" not in row:
            rows.append([row["case"], size, row["method"] or "-", row["reason"]] + ["-"] * 13)
            continue
        rows.append([
            row["case"], size, row["method"], f"{row['ratio']:.2f}", f"{row['names_ratio']:.2f}",
            f"{row['cpu_ratio']:.2f}", f"{row['whole_ratio']:.2f}", seconds(row["bare_seconds"]),
            seconds(row["names_seconds"]), seconds(row["seconds"]),
            *(seconds(row["stages"].get(stage)) for stage in stages),
            f"{row['peak_bytes'] / row['bare_peak_bytes']:.2f}",
        ])  # fmt: skip
    columns = (
        "case", "MB", "method", "ratio", "with names", "of CPU time", "whole", "bare s", "with names s", "suture s",
        *stages, "memory ratio",
    )  # fmt: skip
    large = [
        row["whole_ratio"]
        for row in result["rows"]
        if "whole_ratio" in row and row["bytes"] > LARGE_FILE
    ]
    median = f"{statistics.median(large):.2f} in the median of {len(large)}" if large else "not measured"
    return f"""
## Overhead

`suture fill` against a bare OCCT program that reads and writes the same file (STEPControl_Reader and
Writer; "with names": STEPCAFControl_Reader and Writer, which keep names, colours and the assembly tree as
`suture fill` does), in turns, medians of {result['runs']} runs of the whole processes; the seconds within
the fill method are taken off, with `auto` also those of making and measuring what each method gave. The
aim is a ratio of at most 1.3. "Whole" is the CPU time of all of `suture fill` by `auto` against that of the
program with names: of files above {LARGE_FILE / 1e6} MB {median}.

{table(columns, rows)}"""


def benchmark(result, overhead):
    text = HEADER.format(runs=result["runs"], program=result["program"], date=result["date"],
                         methods=", ".join(result["methods"]), **result["machine"])  # fmt: skip
    text += f"\n## All holes\n\n{summary(result)}"
    if "auto" in result["methods"]:
        text += f"\n## What `auto` misses\n\n{misses(result, 'auto')}"
    if overhead:
        text += overhead_section(overhead)
    return text + "\n## Hole by hole\n" + hole_tables(result)


def load(path):
    return json.loads(path.read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bench", type=Path)
    parser.add_argument("overhead", type=Path, nargs="?")
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args()
    overhead = load(options.overhead) if options.overhead else None
    options.output.write_text(benchmark(load(options.bench), overhead), encoding="utf-8")
    print(options.output)


if __name__ == "__main__":
    main()
