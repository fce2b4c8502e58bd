# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the program as functions."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Union

from . import results
from .errors import OutOfTolerance
from .program import run
from .shapes import Input

Shape = Any  # see shapes.py
Path_ = Union[str, "os.PathLike[str]"]
Progress = Callable[[float, str], None]


def inspect(shape: Shape, *, progress: Progress | None = None, cancel=None) -> list[results.Hole]:
    """The boundary loops of a model: holes, rims, seams, slits.

    >>> [(hole.id, hole.sides, hole.edges) for hole in inspect("suitcase_corner.step")]
    [(1, 3, [9, 19, 21])]
    """
    with tempfile.TemporaryDirectory(prefix="suture-") as folder:
        return results.holes(run(["inspect", Input(shape, folder).file], progress, cancel))


def fill(
    shape: Shape,
    output: Path_ | None = None,
    *,
    holes: Iterable[int | str] | None = None,
    method: str = "auto",
    continuity: str = "auto",
    edge_continuity: Mapping[int, str] | None = None,
    tolerance: float | None = None,
    angle: float | None = None,
    options: Iterable[str] = (),
    strict: bool = False,
    page: bool = False,
    progress: Progress | None = None,
    cancel=None,
) -> results.FillResult:
    """Fills holes.

    output        also write it there: .step, .iges, .brep, or a mesh
    holes         ids from `inspect`, "3+4" for a face with an island; None: all holes
    continuity    G0, G1, G2 or auto; edge_continuity the same for single edges: {12: "G2"}
    tolerance     the largest gap in millimetres; angle: of tangent joins, in degrees
    options       more words for the command line: ["--keep-bad"]
    strict        raise OutOfTolerance where a hole stays open or is out of tolerance
    page          keep the HTML report: `result.page`, and what a notebook shows
    progress      called with the fraction done and what is being done
    cancel        a threading.Event: when it is set, Cancelled is raised, and nothing is written
    Result        `result.shape` is of the kind that was given; for a path or bytes it is the path of
                  the output, or without one the bytes of a file in the same format

    >>> result = fill("suitcase_corner.step", holes=[1], continuity="G1")
    >>> result.verdict.split(";")[0]
    'filled 1 of 1 hole, within 0.001 mm and 0.01 deg'
    >>> result.shape[:13]
    b'ISO-10303-21;'
    >>> fill("filled.step")
    Traceback (most recent call last):
    suture.errors.NothingToDo: filled.step has no hole
    """
    with tempfile.TemporaryDirectory(prefix="suture-") as folder:
        given = Input(shape, folder)
        is_file = isinstance(shape, (str, os.PathLike, bytes, bytearray, memoryview))
        direct = output is not None and is_file
        written = Path(output) if direct else Path(folder) / f"filled{given.suffix}"
        words = ["fill", given.file, "-o", written, "--method", method, "--continuity", continuity]
        if holes is not None:
            words += ["--hole", ",".join(map(str, holes))]
        if edge_continuity:
            pairs = (f"{edge}={wish}" for edge, wish in edge_continuity.items())
            words += ["--edge-continuity", ",".join(pairs)]
        for name, value in (("--tolerance", tolerance), ("--angle", angle)):
            words += [] if value is None else [name, repr(float(value))]
        report = Path(folder) / "report.html"
        words += [*options, *(["--report", report] if page else [])]
        document = run(words, progress, cancel)
        if output is not None and not direct:
            run(["convert", written, output])
        back = written if direct else given.back(written)
        text = report.read_text(encoding="utf-8") if page else None
        return _judged(results.FillResult(document, back, text), strict)


def _judged(result, strict):
    if strict and not result.good:
        error = OutOfTolerance(result.verdict, result.document)
        error.findings = result.findings
        error.result = result
        raise error
    return result


def check(
    shape: Shape,
    *,
    profile: str | None = None,
    options: Iterable[str] = (),
    page: bool = False,
    progress: Progress | None = None,
    cancel=None,
) -> results.CheckReport:
    """Measures gap, angle and curvature along every edge between two faces.

    >>> report = check("suitcase_corner.step")
    >>> report.good, len(report.edges), sorted({edge.continuity for edge in report.edges})
    (True, 18, ['G1', 'sharp'])
    """
    with tempfile.TemporaryDirectory(prefix="suture-") as folder:
        report = Path(folder) / "report.html"
        words = ["check", Input(shape, folder).file]
        words += ["--profile", profile] if profile else []
        words += [*options, *(["--report", report] if page else [])]
        document = run(words, progress, cancel)
        return results.CheckReport(
            document, report.read_text(encoding="utf-8") if page else None
        )


def convert(
    shape: Shape,
    output: Path_,
    *,
    options: Iterable[str] = (),
    progress: Progress | None = None,
    cancel=None,
) -> Path:
    """Writes a model as STEP, IGES, BREP or a mesh, by the ending of `output`.

    >>> convert("suitcase_corner.step", "corner.stl").name
    'corner.stl'
    """
    with tempfile.TemporaryDirectory(prefix="suture-") as folder:
        run(["convert", Input(shape, folder).file, output, *options], progress, cancel)
    return Path(output)


def methods() -> list[dict[str, Any]]:
    """The fill methods.

    >>> "mvs" in [method["id"] for method in methods()]
    True
    """
    return run(["methods"])["methods"]
