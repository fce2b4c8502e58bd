"""The holes that the benchmark fills: the reopened CAD models, and the bundled examples."""

import csv
import math
import os
from dataclasses import dataclass
from pathlib import Path

from program import SOURCE, SUTURE, run

CAD = Path(os.environ.get("SUTURE_CAD_DIR", SOURCE / "../shared/cad"))
EXAMPLES = SOURCE / "docs/examples"
INSPECT_LIMIT = 120  # seconds


@dataclass
class Case:
    """One hole of a model, and the face that was there if it is known."""

    name: str
    model: Path
    truth: Path | None
    near: tuple | None  # a point near the hole; None: every hole
    hole: int = 0
    sides: int = 0
    diameter: float = math.nan


def reopened_cases(folder=None):
    """The cases of CAD/reopened/cases.tsv, their holes not yet looked for; none without the folder."""
    folder = folder or CAD / "reopened"
    table = folder / "cases.tsv"
    if not table.exists():
        return []
    with table.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream, delimiter="\t", quoting=csv.QUOTE_NONE))
    return [
        Case(
            name=row["name"],
            model=folder / row["open"],
            truth=None if row["truth"] == "-" else folder / row["truth"],
            near=tuple(float(x) for x in row["near"].split(",")),
            sides=int(row["n"]),
        )
        for row in rows
    ]


def example_cases():
    return [Case(path.stem, path, None, None) for path in sorted(EXAMPLES.glob("*.step"))]


def inspect(model):
    """The holes that `suture inspect` lists. Raises RuntimeError with its message if it fails."""
    done = run([SUTURE, "inspect", model, "--json"], INSPECT_LIMIT)
    document = done.document()
    if done.code not in (0, 3) or document is None:
        raise RuntimeError(f"suture inspect {model.name}: {done.err.strip() or done.code}")
    return [hole for hole in document["holes"] if hole["kind"] == "hole"]


def distance_to(hole, near):
    """From a point to the nearest corner, then to the middle of all corners."""
    corners = [corner["point"] for corner in hole["corners"]]
    if not corners:
        return math.inf, math.inf
    middle = [sum(axis) / len(corners) for axis in zip(*corners)]
    return min(math.dist(corner, near) for corner in corners), math.dist(middle, near)


def with_holes(case):
    """The same case once for each hole that it means, each with the hole's facts."""
    holes = inspect(case.model)
    if case.near is not None:
        # Of several openings near the point, the one that has the lost face's number of sides.
        order = lambda hole: (hole["sides"] != case.sides, distance_to(hole, case.near))  # noqa: E731
        holes = sorted(holes, key=order)[:1]
    return [
        Case(
            name=case.name if len(holes) == 1 else f"{case.name} hole {hole['id']}",
            model=case.model,
            truth=case.truth,
            near=case.near,
            hole=hole["id"],
            sides=hole["sides"],
            diameter=hole["diameter"],
        )
        for hole in holes
    ]
