#!/usr/bin/python3
"""What becomes of fills on their way through files, and whether other programs can go on with them.

    written.py units [-o FILE] [NAME...]     gap and angle in memory and read again, for ten fills, as STEP,
                                             IGES and BREP in millimetres, inches and metres
    written.py booleans [-o FILE] [NAME...]  FreeCAD's check of every model before and after its fill, and
                                             whether it can be cut in two (suture_halves): of ../shared and
                                             the bundled examples

In memory is what a BREP file in millimetres has, which keeps every bit and every tolerance. Read again is
what FreeCAD's Part module measures in the file (tests/verify/shapes.py): no code of the program.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "verify")]

from cases import CAD, EXAMPLES, reopened_cases, with_holes  # noqa: E402
from program import BUILD, SOURCE, SUTURE, run  # noqa: E402
from tables import number, table  # noqa: E402

HALVES = BUILD / "tests/bench/suture_halves"
LIMIT = 300  # seconds for a fill
CHECK_LIMIT = 300  # for FreeCAD's check of one shape
UNITS = {"mm": "MM", "inch": "INCH", "m": "M"}  # as OCCT names them
FORMATS = ("step", "iges", "brep")
TRUST = SOURCE / "../shared/cases/trust"

# Ten fills: the bundled examples, and those of ../shared that came back worse than they were.
TEN = (
    (EXAMPLES / "suitcase_corner.step", []),
    (EXAMPLES / "dome_window.step", []),
    (EXAMPLES / "bump_window.step", []),
    (EXAMPLES / "pipe_elbow.step", []),
    (TRUST / "strips4.step", []),
    (TRUST / "soapbar.step", ["--continuity", "G1", "--method", "mvs"]),
    (TRUST / "boss_without_fillet.step", ["--hole", "1+2"]),
    (CAD / "reopened/03_suitcase_occt_unequal.open.step", []),
    (CAD / "reopened/11_freeform_circle4.open.step", []),
    (CAD / "reopened/R01_sphere3_boxblend.open.step", []),
)


def freecad(action, *arguments, limit=CHECK_LIMIT):
    """Runs one action of this file in a process of its own: FreeCAD can crash, hang and print."""
    with tempfile.NamedTemporaryFile("r", suffix=".txt") as answer:
        try:
            done = subprocess.run(
                [sys.executable, __file__, "act", action, answer.name, *map(str, arguments)],
                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=limit, check=False, text=True,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return f"no answer in {limit} s"
        return answer.read() or f"FreeCAD ended with {done.returncode}: {done.stderr.strip()[-200:]}"


def act_convert(answer, model, unit, target):
    """The model as a STEP file in another unit."""
    import shapes

    shapes.Part.exportUnits(unit)
    shapes.read(model).exportStep(target)
    answer.write("done")


def act_measure(answer, before, after):
    """Largest gap in mm and angle in degrees along the edges of the faces that are new."""
    import shapes

    old, new = shapes.read(before), shapes.read(after)
    added = shapes.Comparison(old, new).added
    gap, angle = shapes.largest_gap_and_angle(new, added)
    answer.write(f"{gap} {angle} {len(added)}")


def act_check(answer, file):
    """FreeCAD's check with that for Boolean operations: nothing, or what it finds."""
    import shapes

    try:
        shapes.read(file).check(True)
        answer.write("passes")
    except Exception as error:  # FreeCAD's own kind, with one line for each fault
        faults = [line.strip() for line in str(error).splitlines() if line.strip()]
        kinds = sorted({fault.split(":")[-1].strip() for fault in faults})
        answer.write("; ".join(kinds))


def fill(model, output, extra=()):
    done = run([SUTURE, "fill", model, "-o", output, "--json", *extra], LIMIT)
    return done, done.document()


def units(output, names):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for model, extra in TEN:
            if names and not any(word in model.name for word in names):
                continue
            if not model.exists():
                print(f"{model.name}: not there", file=sys.stderr)
                continue
            for unit, freecads in UNITS.items():
                source = Path(folder) / f"{model.stem}-{unit}.step"
                freecad("convert", model, freecads, source)
                memory = None
                for kind in ("brep", "step", "iges"):
                    file = Path(folder) / f"{model.stem}-{unit}-filled.{kind}"
                    done, _ = fill(source, file, extra)
                    if not file.exists():
                        rows.append((model.stem, unit, kind, "-", "-", "-", "-", done.err.strip()[-80:]))
                        continue
                    found = freecad("measure", source, file).split()
                    if len(found) != 3:
                        rows.append((model.stem, unit, kind, "-", "-", "-", "-", " ".join(found)))
                        continue
                    gap, angle = float(found[0]), float(found[1])
                    memory = memory or (gap, angle)
                    bad = gap > max(1.5 * memory[0], memory[0] + 1e-6) or angle > max(
                        1.5 * memory[1], memory[1] + 1e-4
                    )
                    rows.append(
                        (model.stem, unit, kind, *map(number, (memory[0], gap, memory[1], angle)),
                         "worse" if bad else "as in memory")
                    )  # fmt: skip
                    print(*rows[-1], file=sys.stderr)
    columns = ("fill", "unit", "format", "gap in memory", "read again", "angle in memory", "read again", "")
    text = HEADER + table(columns, rows) + "\n"
    output.write_text(text, encoding="utf-8")


HEADER = """\
# Fills in memory and in files

Made by `tests/bench/written.py units -o docs/written.md`; not edited by hand. Gaps in mm, angles in
degrees: the largest along the new faces' edges, measured with FreeCAD's Part module. "In memory" is what
the same fill has as BREP, which keeps every bit; "worse" is more than 1.5 times that, and more than
1e-6 mm or 1e-4 deg above it.

"""


def models():
    """{name: (model, more arguments)} of all that is filled for `booleans`."""
    found = {}
    for case in reopened_cases():
        found[case.name] = (case.model, None, case)
    for path in sorted(EXAMPLES.glob("*.step")):
        found[path.stem] = (path, [], None)
    for path in sorted((SOURCE / "../shared/cases").glob("*/*")):
        if path.suffix.lower() in (".step", ".stp", ".brep", ".iges", ".igs") and path.parent.name != "fuzz":
            found[f"{path.parent.name}/{path.name}"] = (path, [], None)
    return found


def booleans(output, names):
    rows = []
    counts = {"models": 0, "filled": 0, "pass before": 0, "pass before and after": 0, "halves add up": 0}
    with tempfile.TemporaryDirectory() as folder:
        for name, (model, extra, case) in models().items():
            if names and not any(word in name for word in names):
                continue
            counts["models"] += 1
            before = freecad("check", model)
            if case is not None:
                extra = ["--hole", str(with_holes(case)[0].hole)]
            file = Path(folder) / f"{name.replace('/', '-')}.step"
            done, document = fill(model, file, extra)
            holes = [h for h in (document or {}).get("holes", []) if h["status"] == "filled"]
            if not file.exists() or not holes:
                rows.append((name, before, "not filled", "-", done.err.strip().splitlines()[-1:] or ""))
                continue
            counts["filled"] += 1
            counts["pass before"] += before == "passes"
            after = freecad("check", file)
            counts["pass before and after"] += before == after == "passes"
            halves = run([HALVES, file], CHECK_LIMIT).out.strip() if document.get("closed") else "-"
            try:
                counts["halves add up"] += float(halves) <= 1e-6
            except ValueError:
                pass
            rows.append((name, before, after, halves, holes[0].get("method_used", "")))
            print(*rows[-1], file=sys.stderr, flush=True)
    columns = ("model", "check before", "check after", "volume lost by halving", "method")
    lines = [f"{key}: {value}" for key, value in counts.items()]
    text = "\n".join([*lines, "", table(columns, rows)]) + "\n"
    if output:
        output.write_text(text, encoding="utf-8")
    print(text)


def main():
    if sys.argv[1:2] == ["act"]:
        with open(sys.argv[3], "w", encoding="utf-8") as answer:
            globals()["act_" + sys.argv[2]](answer, *sys.argv[4:])
            answer.flush()
            os._exit(0)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("units", "booleans"))
    parser.add_argument("names", nargs="*")
    parser.add_argument("-o", "--output", type=Path)
    options = parser.parse_intermixed_args()
    if options.what == "units":
        units(options.output or SOURCE / "docs/written.md", options.names)
    else:
        booleans(options.output, options.names)


if __name__ == "__main__":
    main()
