#!/usr/bin/python3
"""Whether every model becomes a mesh in every format, and whether OpenSCAD takes those that are closed.

    meshes.py [-o FILE] [--fills] [NAME...]   the files of ../shared/cad/files; with --fills, in their place, the
                                              models of ../shared/cad/reopened, filled

OpenSCAD gets each closed mesh as OFF, and cuts it with a box that holds all of it: so render() has to make
a solid of it in exact arithmetic, which is where meshes with needles or cracks end in an error.
"""

import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from cases import CAD, reopened_cases  # noqa: E402
from program import SUTURE, run  # noqa: E402
from tables import table  # noqa: E402

FORMATS = ("stl", "off", "obj", "3mf", "glb")
LIMIT = 600  # seconds for each program
SCRIPT = 'render() intersection() {{ import("{}"); translate([-1e5, -1e5, -1e5]) cube(2e5); }}\n'
# Exact arithmetic takes seconds for a thousand facets: of larger meshes it gets one that is coarser.
MOST = 10000
COARSE = ["--angular-deflection", "40"]


def last_line(text):
    lines = text.strip().splitlines()
    return lines[-1] if lines else ""


def openscad(mesh, folder):
    """(whether it is a solid in exact arithmetic, what is to be said)"""
    script = folder / "in.scad"
    script.write_text(SCRIPT.format(mesh.name))
    done = run(["openscad", "--render", "-o", folder / "out.off", script], LIMIT)
    words = " ".join(done.err.split())
    solid = done.code == 0 and "ERROR" not in done.err and "Simple: yes" in words
    if done.timed_out:
        return False, f"no end after {LIMIT} s"
    return solid, f"solid, {done.cpu_seconds:.1f} s" if solid else last_line(done.err)


def convert(model, folder):
    """The table's cells of a model, and whether all went well."""
    cells, well, closed, triangles, seconds = [], True, None, 0, 0.0
    for ending in FORMATS:
        done = run([SUTURE, "convert", model, folder / f"mesh.{ending}", "--json"], LIMIT)
        document = done.document() or {}
        mesh = document.get("mesh")
        seconds += done.cpu_seconds
        if mesh is None or done.code not in (0, 4):
            well = False
            cells.append(last_line(done.err) or f"exit code {done.code}")
            continue
        open_edges = mesh["open_edges"]
        cells.append("closed" if open_edges == 0 else f"open: {open_edges}")
        closed, triangles = (open_edges == 0, mesh["triangles"]) if ending == "off" else (closed, triangles)
    if not closed:
        return [*cells, triangles, f"{seconds:.1f}", "not tried"], well
    if triangles > MOST:
        run([SUTURE, "convert", model, folder / "mesh.off", *COARSE], LIMIT)
    solid, said = openscad(folder / "mesh.off", folder)
    if triangles > MOST:
        said += ", a coarser one"
    well = well and solid
    return [*cells, triangles, f"{seconds:.1f}", said], well


def fill(case, folder):
    mesh = folder / "mesh.off"
    done = run([SUTURE, "fill", case.model, "-o", mesh, "--json", *COARSE], LIMIT)
    document = done.document() or {}
    if done.code not in (0, 4):
        return ["-", last_line(done.err) or f"exit code {done.code}", "-"], False
    status = ", ".join(sorted({hole["status"] for hole in document["holes"]}))
    if not document["closed"]:
        return [status, f"open, {document['free_edges']} free edges", "not tried"], True
    solid, said = openscad(mesh, folder)
    return [status, "closed", said], solid


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="only models whose name begins so")
    parser.add_argument("--fills", action="store_true")
    parser.add_argument("-o", "--output", type=Path)
    options = parser.parse_args()
    if options.fills:
        columns = ("model", "holes", "mesh", "OpenSCAD")
        cases = [(case.name, case) for case in reopened_cases()]
    else:
        columns = ("file", *FORMATS, "triangles", "s for all", "OpenSCAD")
        cases = [(file.name, file) for file in sorted((CAD / "files").iterdir())]
    cases = [(name, case) for name, case in cases if not options.names or name.startswith(tuple(options.names))]
    rows, failed = [], []
    for name, case in cases:
        with tempfile.TemporaryDirectory() as folder:
            cells, well = (fill if options.fills else convert)(case, Path(folder))
        rows.append([name, *cells])
        print(*rows[-1], sep=" | ", flush=True)
        if not well:
            failed.append(name)
    text = table(columns, rows) + f"\n{len(rows) - len(failed)} of {len(rows)} went well.\n"
    if options.output:
        options.output.write_text(text, encoding="utf-8")
    print(f"{len(failed)} failed: {', '.join(failed)}" if failed else "all went well")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
