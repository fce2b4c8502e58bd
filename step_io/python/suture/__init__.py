# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closes the holes of CAD models with smooth faces, by the program `suture` that comes with it.

>>> import suture
>>> holes = suture.inspect("suitcase_corner.step")
>>> holes[0].sides, holes[0].kind
(3, 'hole')
>>> result = suture.fill("suitcase_corner.step", "filled.step", holes=[1])
>>> result.good, result.closed, result.holes[0].continuity_reached
(True, True, 'G1')
>>> suture.check("filled.step").summary["near_misses"]
0

A shape is a path, the bytes of a file, a shape or object of FreeCAD, or one of CadQuery, build123d,
OCP or pythonocc; what comes back is of the same kind. Lengths are millimetres, angles degrees.
"""

from .commands import check, convert, fill, inspect, methods
from .errors import (
    Cancelled,
    NothingToDo,
    OutOfTolerance,
    ProgramMissing,
    SutureError,
    Unreadable,
    UsageError,
)
from .program import find_program, version
from .results import CheckReport, Edge, FillResult, FilledHole, Finding, Hole

__all__ = [
    "Cancelled",
    "CheckReport",
    "Edge",
    "FillResult",
    "FilledHole",
    "Finding",
    "Hole",
    "NothingToDo",
    "OutOfTolerance",
    "ProgramMissing",
    "SutureError",
    "Unreadable",
    "UsageError",
    "check",
    "convert",
    "fill",
    "find_program",
    "inspect",
    "methods",
    "version",
]
