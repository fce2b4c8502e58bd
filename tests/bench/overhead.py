#!/usr/bin/python3
"""Weighs `suture fill` against bare OCCT programs that read and write the same file.

    overhead.py [-o RESULT.json] [--runs 5] [--cases WORD...] [--methods ID...]

One of them keeps the shapes only, the other names, colours and the assembly tree too, as `suture
fill` does. All are run in turns, so that a busy machine slows all. The ratios are of the medians of
the whole processes' seconds, the seconds of the fill method taken off: with `auto`, trying and
measuring candidates is the method. But "whole" is all of `suture fill` by `auto`, in processor time.
"""

import argparse
import json
import statistics
import sys
import tempfile
from pathlib import Path

from bench import machine
from cases import reopened_cases, with_holes
from program import BARE, BARE_NAMES, BUILD, SUTURE, run

LIMIT = 300  # seconds for one run
METHODS = ("plane", "extend", "mvs", "concentric", "auto")
STAGES = ("read", "detect", "fill", "sew", "write", "check")
# Constructed models, and real ones: two small ones and all above half a megabyte.
CASES = (
    "01_suitcase_equal", "26_sphere_octant", "R01_sphere3_boxblend", "R02_", "R04_", "R07_", "R11_",
    "R13_", "R18_", "R19_", "R20_", "R23_", "R30_", "R31_", "R36_", "H01_", "H02_", "H03_", "H05_",
    "H07_", "H09_", "H11_",
)  # fmt: skip


def medians(runs):
    """Median of every stage over the runs."""
    stages = [document.get("seconds", {}) for document in (one.document() or {} for one in runs)]
    keys = {key for stage in stages for key in stage}
    return {key: statistics.median(stage[key] for stage in stages if key in stage) for key in keys}


def method_that_fills(case, methods, out):
    """The first of the methods that closes the hole: what is weighed is a whole run."""
    for method in methods:
        done = run(command(case, method, out), LIMIT)
        holes = (done.document() or {}).get("holes", [])
        if any(hole["status"] == "filled" for hole in holes):
            return method
    return None


def command(case, method, out):
    return [SUTURE, "fill", case.model, "-o", out, "--hole", case.hole, "--method", method, "--json"]


def method_seconds(one):
    """Of a run of `suture fill`: what its method took."""
    document = one.document()
    methods = {h["method_requested"] for h in document["holes"] if h["status"] != "skipped"}
    return document["seconds"]["choose" if methods == {"auto"} else "fill"]


def weigh(case, methods, runs, folder):
    out, bare_out = folder / "filled.step", folder / "bare.step"
    method = method_that_fills(case, methods, out)
    row = {"case": case.name, "bytes": case.model.stat().st_size, "method": method}
    if method is None:
        return row | {"reason": f"none of {', '.join(methods)} fills it"}
    ours, bare, names, whole = [], [], [], []
    for _ in range(runs):
        bare.append(run([BARE, case.model, bare_out], LIMIT))
        names.append(run([BARE_NAMES, case.model, bare_out], LIMIT))
        ours.append(run(command(case, method, out), LIMIT))
        whole.append(run(command(case, "auto", out), LIMIT))
    if failed := [one for one in bare + names if one.code != 0]:
        return row | {"reason": f"bare OCCT fails: {failed[0].err.strip()}"}
    own = [one.seconds - method_seconds(one) for one in ours]
    own_cpu = [one.cpu_seconds - method_seconds(one) for one in ours]
    row |= {
        "bare_seconds": statistics.median(one.seconds for one in bare),
        "names_seconds": statistics.median(one.seconds for one in names),
        "seconds": statistics.median(one.seconds for one in ours),
        "fill_seconds": statistics.median(method_seconds(one) for one in ours),
        "ratio": statistics.median(own) / statistics.median(one.seconds for one in bare),
        "names_ratio": statistics.median(own) / statistics.median(one.seconds for one in names),
        "cpu_ratio": statistics.median(own_cpu) / statistics.median(one.cpu_seconds for one in bare),
        "whole_ratio": statistics.median(one.cpu_seconds for one in whole)
        / statistics.median(one.cpu_seconds for one in names),
        "stages": medians(ours),
        "bare_peak_bytes": max(one.peak_bytes for one in bare),
        "peak_bytes": max(one.peak_bytes for one in ours),
    }
    return row


def overhead(options):
    wanted = options.cases or CASES
    rows = []
    with tempfile.TemporaryDirectory(prefix="suture_overhead_") as folder:
        for model in reopened_cases():
            if not any(word in model.name for word in wanted):
                continue
            for case in with_holes(model):
                rows.append(weigh(case, options.methods, options.runs, Path(folder)))
                print(
                    f"{case.name:24} {rows[-1].get('ratio', float('nan')):6.2f} "
                    f"{rows[-1].get('names_ratio', float('nan')):6.2f} "
                    f"{rows[-1].get('cpu_ratio', float('nan')):6.2f}",
                    file=sys.stderr,
                )
    return {"machine": machine(), "runs": options.runs, "rows": rows}


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=BUILD / "overhead.json")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--cases", nargs="*", help="words in the names of the cases to run")
    parser.add_argument("--methods", nargs="*", default=METHODS)
    options = parser.parse_args(arguments)
    result = overhead(options)
    options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    print(options.output)
    return 0 if result["rows"] else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
