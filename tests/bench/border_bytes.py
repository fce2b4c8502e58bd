#!/usr/bin/env python3
"""Proves that `fill --boundary` with all edges of a hole, in random order, writes the file that
`fill --hole` writes, to the byte: on every hole of the models in a folder.

    border_bytes.py [--only TEXT] [--seed N] PROGRAM FOLDER [-- further words for `fill`]

Exit code 1 if one differs, naming it.
"""

import argparse
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path


def holes_of(program, model):
    """Lists of loops that bound one face each."""
    said = subprocess.run([program, "inspect", model, "--json"], capture_output=True, text=True, check=False)
    loops = {h["id"]: h for h in json.loads(said.stdout)["holes"] if h["kind"] == "hole"}
    seen = set()
    for loop in loops.values():
        group = [loop["id"], *(n for n in loop["islands_with"] if n in loops)]
        if not seen.intersection(group):
            yield [loops[n] for n in group]
        seen.update(group)


def outcome(program, model, words, out):
    """What a run ends in, and what it writes."""
    out.unlink(missing_ok=True)
    ended = subprocess.run(
        [program, "fill", model, "-o", out, *words], capture_output=True, text=True, check=False
    )
    return ended.returncode, out.read_bytes() if out.exists() else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="models whose name has this in it")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("words", nargs="*")
    asked = parser.parse_args()
    shuffled = random.Random(asked.seed).sample
    same = differing = 0
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.brep"
        for model in sorted(asked.folder.glob("*.st*p")):
            if asked.only not in model.name:
                continue
            for loops in holes_of(asked.program, model):
                edges = [edge for loop in loops for edge in loop["edges"]]
                ids = "+".join(str(loop["id"]) for loop in loops)
                border = ",".join(map(str, shuffled(edges, len(edges))))
                by_hole = outcome(asked.program, model, ["--hole", ids, *asked.words], out)
                by_edges = outcome(asked.program, model, ["--boundary", border, *asked.words], out)
                if by_hole == by_edges and by_hole[1]:
                    same += 1
                    continue
                differing += 1
                codes = f"exit codes {by_hole[0]} and {by_edges[0]}"
                print(f"{model.name}: hole {ids} and boundary {border} differ, {codes}", flush=True)
    print(f"{same} holes the same, {differing} not")
    return 1 if differing or not same else 0


if __name__ == "__main__":
    sys.exit(main())
