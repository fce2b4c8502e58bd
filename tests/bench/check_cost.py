#!/usr/bin/python3
"""Weighs `suture check` against a bare OCCT program that reads the same file.

    check_cost.py [-o RESULT.json] [--runs 3] [FILE...]     (default: all of shared/cad/files)

Both are run in turns, so that a busy machine slows both. `whole` is the ratio of the medians of the
processes' seconds, `step` that of the check alone to the bare program, `memory` that of the peaks.
"""

import argparse
import json
import os
import statistics
import sys
from pathlib import Path

from bench import machine
from program import BUILD, SOURCE, SUTURE, run

LIMIT = 300  # seconds for one run
BARE_READ = BUILD / "tests/bench/suture_bare_read"
FILES = Path(os.environ.get("SUTURE_CAD_DIR", SOURCE.parent / "shared/cad")) / "files"


def weigh(file, runs):
    bare, ours = [], []
    for _ in range(runs):
        bare.append(run([BARE_READ, file], LIMIT))
        ours.append(run([SUTURE, "check", file, "--json"], LIMIT))
    row = {"file": file.name, "bytes": file.stat().st_size}
    if any(one.code != 0 for one in bare) or any(one.document() is None for one in ours):
        return row | {"reason": bare[0].err.strip() or ours[0].err.strip()}
    seconds = statistics.median(one.seconds for one in bare)
    step = statistics.median(one.document()["seconds"]["check"] for one in ours)
    return row | {
        "edges": ours[0].document()["summary"]["edges"],
        "bare_seconds": seconds,
        "seconds": statistics.median(one.seconds for one in ours),
        "check_seconds": step,
        "whole": statistics.median(one.seconds for one in ours) / seconds,
        "step": step / seconds,
        "cpu": statistics.median(one.cpu_seconds for one in ours)
        / statistics.median(one.cpu_seconds for one in bare),
        "memory": max(one.peak_bytes for one in ours) / max(one.peak_bytes for one in bare),
    }


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=BUILD / "check_cost.json")
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args(arguments)
    rows = []
    for file in options.files or sorted(FILES.iterdir()):
        rows.append(weigh(file, options.runs))
        figures = [f"{rows[-1].get(key, float('nan')):6.2f}" for key in ("whole", "step", "cpu", "memory")]
        print(f"{file.name:42}", *figures, file=sys.stderr, flush=True)
    result = {"machine": machine(), "runs": options.runs, "rows": rows}
    options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
