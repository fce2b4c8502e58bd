#!/usr/bin/python3
"""Compares fill methods and settings on the same holes, by running the program itself.

    bench.py [-o RESULT.json] [--runs 3] [--cases WORD...] [--methods ID...] [--examples-only]

Every method that `suture methods` lists is run on every hole: of the models in ../shared/cad/reopened,
whose lost faces are known, and of the bundled examples. The result is a JSON file; tables.py makes the
Markdown tables of it. `cmake --build --preset bench` does all that, and writes docs/benchmark.md.
"""

import argparse
import json
import os
import platform
import statistics
import sys
import tempfile
import time
from pathlib import Path

from cases import example_cases, reopened_cases, with_holes
from program import BUILD, REFEREE, SUTURE, run

FILL_LIMIT = 600  # seconds for one run of the program
JUDGE_LIMIT = 300
OCCT_SETTINGS = ("default", "tuned")


def settings_of(wanted):
    """[(name, arguments)]: every method of the program, OCCT's with each of its settings, `auto` also
    without looking for the lost face."""
    listed = run([SUTURE, "methods", "--json"], FILL_LIMIT).document()
    settings = []
    for method in (row["id"] for row in listed["methods"]):
        if method == "occt":
            settings += [
                (f"occt {name}", ["--method", "occt", "--occt-setting", name]) for name in OCCT_SETTINGS
            ]
        else:
            settings.append((method, ["--method", method]))
        if method == "auto":
            settings.append(("auto without recognise", ["--method", "auto", "--recognise", "off"]))
    return [row for row in settings if not wanted or row[0].split()[0] in wanted]


def first_line(text):
    return (text.strip().splitlines() or [""])[0]


def outcome_of(done, hole):
    """(status, reason, the hole's entry in the report or None)"""
    document = done.document()
    if done.timed_out:
        return "timeout", f"stopped after {FILL_LIMIT} s", None
    if document is None or "holes" not in document:
        return "failed", first_line(done.err) or f"exit code {done.code}", None
    entry = next((entry for entry in document["holes"] if hole in entry["ids"]), None)
    if entry is None:
        return "failed", "the report does not mention the hole", None
    return entry["status"], entry["reason"], entry


def judged(case, out):
    """What the judge says of a written file; its figures are lengths."""
    done = run([REFEREE, case.model, out] + ([case.truth] if case.truth else []), JUDGE_LIMIT)
    verdict = done.document()
    if verdict is None:
        return {"judge_error": first_line(done.err) or f"exit code {done.code}"}
    distances = [verdict.get("truth_to_new"), verdict.get("new_to_truth")]
    if case.truth:
        known = None not in distances
        verdict["fidelity"] = max(distances) / case.diameter if known else None
    return verdict


def bench_one(case, name, arguments, runs, folder):
    """One row: a method on a hole."""
    out = folder / f"{case.name}-{name}.step".replace(" ", "_")
    command = [SUTURE, "fill", case.model, "-o", out, "--hole", case.hole, "--json", *arguments]
    done = [run(command, FILL_LIMIT)]
    status, reason, entry = outcome_of(done[0], case.hole)
    if status == "filled":
        done += [run(command, FILL_LIMIT) for _ in range(runs - 1)]
    documents = [document for document in (one.document() for one in done) if document]
    row = {
        "case": case.name,
        "sides": case.sides,
        "diameter": case.diameter,
        "method": name,
        "status": status,
        "reason": reason,
        "seconds_cpu": statistics.median(one.cpu_seconds for one in done),
        "seconds_process": statistics.median(one.seconds for one in done),
        "peak_bytes": max(one.peak_bytes for one in done),
        "runs": len(done),
    }
    timings = [document["seconds"]["fill"] for document in documents if "seconds" in document]
    row["seconds_fill"] = statistics.median(timings) if timings else None
    if status == "filled":
        report = documents[0]
        row |= {key: entry[key] for key in ("max_gap", "max_angle_deg", "max_curvature_mismatch")}
        row |= {key: entry[key] for key in ("method_used", "within_tolerance", "patches", "notes")}
        row |= {key: report[key] for key in ("valid", "closed", "measured_on")}
        row["recognised"] = entry.get("recognised")
        row["findings"] = [found["text"] for found in entry["findings"]
                           if found["severity"] != "good" and not found["before"]]  # fmt: skip
        row["judge"] = judged(case, out)
    out.unlink(missing_ok=True)
    return row


def machine():
    model = next(
        (line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if "model name" in line),
        platform.machine(),
    )
    return {"processor": model, "cores": os.cpu_count()}


def chosen_cases(options):
    cases = ([] if options.examples_only else reopened_cases()) + example_cases()
    if options.cases:
        cases = [case for case in cases if any(word in case.name for word in options.cases)]
    return cases


def bench(options):
    settings = settings_of(options.methods)
    rows, broken = [], []
    with tempfile.TemporaryDirectory(prefix="suture_bench_") as folder:
        for model in chosen_cases(options):
            try:
                cases = with_holes(model)
            except RuntimeError as error:
                broken.append({"case": model.name, "reason": str(error)})
                continue
            if not cases:
                broken.append({"case": model.name, "reason": "suture inspect finds no hole in it"})
            for case in cases:
                for name, arguments in settings:
                    row = bench_one(case, name, arguments, options.runs, Path(folder))
                    rows.append(row)
                    print(
                        f"{case.name:28} {name:14} {row['status']:8} {row['seconds_process']:7.2f} s",
                        file=sys.stderr,
                    )
    version = run([SUTURE, "--version"], FILL_LIMIT).out.strip()
    return {
        "program": version,
        "date": time.strftime("%Y-%m-%d"),
        "machine": machine(),
        "runs": options.runs,
        "methods": [name for name, _ in settings],
        "rows": rows,
        "cases_without_hole": broken,
    }


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=BUILD / "bench.json")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--cases", nargs="*", help="words in the names of the cases to run")
    parser.add_argument("--methods", nargs="*", help="ids of the methods to run")
    parser.add_argument("--examples-only", action="store_true")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    result = bench(options)
    options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    print(options.output)
    return 0 if result["rows"] else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
