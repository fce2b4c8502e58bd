#!/usr/bin/python3
"""Which part of `suture fill` goes into looking for clashes and for folds.

    judge_cost.py [-o RESULT.json] [--method auto] [FILE...]   (default: all of shared/cad/reopened)

`perf` samples the whole run with all its processes, and a sample counts where one of the functions
that look for clashes or folds is on the stack. Shares do not depend on what else the machine does.
Needs perf (Debian: linux-perf).
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from bench import machine
from program import BUILD, SOURCE, SUTURE

LIMIT = 300  # seconds for one run
SAMPLES = 399  # in a second of a core
STACK = 16384  # bytes of it that are kept, to be unwound afterwards
FILES = Path(os.environ.get("SUTURE_CAD_DIR", SOURCE.parent / "shared/cad")) / "reopened"
LOOKED_FOR = {"clashes": "suture::find_clashes", "folds": "suture::find_folds"}
LINE = re.compile(r"^\s*([0-9.]+)%\s+\[\.\]\s+(.*\S)\s*$")


def share_of(function, report):
    """The part of all samples, 0 to 1, that have a function on the stack."""
    found = [LINE.match(line) for line in report.splitlines()]
    return max((float(m[1]) for m in found if m and m[2] == function), default=0.0) / 100.0


def weigh(file, method):
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "samples"
        command = [SUTURE, "fill", file, "-o", Path(folder) / "filled.step", "--method", method]
        record = ["perf", "record", "-q", "-F", str(SAMPLES), f"--call-graph=dwarf,{STACK}", "-o", data]
        done = subprocess.run(
            [*record, "--", *command], stdin=subprocess.DEVNULL, capture_output=True, timeout=LIMIT, check=False
        )
        show = ["perf", "report", "-i", data, "--children", "--no-inline", "-g", "none", "--stdio"]
        report = subprocess.run(
            [*show, "--percent-limit", "0.01", "-F", "overhead_children,symbol"],
            stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=LIMIT, check=True,
        ).stdout  # fmt: skip
    shares = {name: share_of(function, report) for name, function in LOOKED_FOR.items()}
    return {"file": file.name, "exit_code": done.returncode} | shares | {"both": sum(shares.values())}


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=BUILD / "judge_cost.json")
    parser.add_argument("--method", default="auto")
    options = parser.parse_args(arguments)
    rows = []
    for file in options.files or sorted(FILES.iterdir()):
        rows.append(weigh(file, options.method))
        figures = [f"{100.0 * rows[-1][key]:6.2f} %" for key in ("clashes", "folds", "both")]
        print(f"{file.name:42}", *figures, file=sys.stderr, flush=True)
    median = statistics.median(row["both"] for row in rows)
    print(f"median {100.0 * median:.2f} %", file=sys.stderr)
    result = {"machine": machine(), "method": options.method, "median": median, "rows": rows}
    options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
