#!/usr/bin/python3
"""Fills the corners of `suture_corners` as models, by `auto`, and says how near each one comes.

    tests/bench/corner_files.py [-o TABLE.md] [--pictures FOLDER]

36 open shells of fillets of unequal radii and the planes between them (corner_files.cpp). Angles and gaps are those of the
written file, read again. --pictures: each corner open and filled, with zebra stripes, by docs/figures/render.py.
SUTURE_PROGRAM and SUTURE_BINARY_DIR say what is run.
"""

import argparse
import statistics
import sys
import tempfile
from pathlib import Path

from program import BUILD, SOURCE, SUTURE, run
from tables import number, table

LIMIT = 120  # seconds for a run
WITHIN = 0.01  # degrees
NEAR, SIZE = "0,0,-1", 7  # what a picture shows
COLUMNS = ("corner", "sides", "method", "net", "gap / diameter", "angle", "result", "CPU s")


def measure(model, folder, pictures):
    out = folder / "filled.step"
    holes = run([SUTURE, "inspect", model, "--json"], LIMIT).document()["holes"]
    done = run([SUTURE, "fill", model, "-o", out, "--force", "--json"], LIMIT)
    row = {"corner": model.stem.replace("_", " "), "sides": holes[0]["sides"], "seconds": done.cpu_seconds, "code": done.code}
    document = done.document()
    filled = [hole for hole in (document or {}).get("holes", []) if hole["status"] == "filled"]
    if not filled:
        return row | {"result": "refused"}
    if pictures:
        picture = [model, out, pictures / f"{model.stem}.png", "--zebra", "--view", "0.3,-0.5,1", "--near", NEAR, "--size", SIZE]
        run([SOURCE / "docs/figures/render.py", *picture], LIMIT)
    (hole,) = filled
    return row | {
        "method": hole["method_used"],
        "nets": [(patch["poles_u"], patch["poles_v"]) for patch in hole["patches"]],
        "gap": hole["max_gap"] / holes[0]["diameter"],
        "angle": hole["max_angle_deg"],
        "result": hole["severity"],
    }


def cells(row):
    nets = ", ".join(f"{u}x{v}" for u, v in row.get("nets", [])) or "-"
    return (
        row["corner"], str(row["sides"]), row.get("method", "-"), nets, number(row.get("gap"), 2),
        number(row.get("angle"), 2), row["result"], f"{row['seconds']:.1f}",
    )  # fmt: skip


def summary(rows):
    filled = [row for row in rows if "angle" in row]
    within = sum(row["angle"] <= WITHIN for row in filled)
    good = sum(row["result"] == "good" for row in rows)
    poles = statistics.median(sum(u * v for u, v in row["nets"]) for row in filled)
    slowest = max(row["seconds"] for row in rows)
    return (
        f"{within} of {len(rows)} within {WITHIN} degrees, {good} good; {poles:.0f} poles in the median; "
        f"at most {slowest:.1f} s of CPU for the whole run."
    )


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", type=Path, help="the table")
    parser.add_argument("--pictures", type=Path, help="a folder for pictures")
    chosen = parser.parse_args(arguments)
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        made = run([BUILD / "tests/bench/suture_corner_files", folder], LIMIT)
        if made.code != 0:
            sys.exit(made.err.strip())
        for model in sorted(folder.glob("*_edges_*.step")):
            rows.append(measure(model, folder, chosen.pictures))
            print(" | ".join(cells(rows[-1])), file=sys.stderr, flush=True)
    text = f"{table(COLUMNS, map(cells, rows))}\n\n{summary(rows)}\n"
    if chosen.o:
        chosen.o.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main(sys.argv[1:])
