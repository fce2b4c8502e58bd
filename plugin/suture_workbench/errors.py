# SPDX-License-Identifier: LGPL-2.1-or-later
"""Failures as sentences that a user can act on."""

import re

_NUMBERED = re.compile(r"\b(edge|face)s? (\d+(?:(?:, | and )\d+)*)", re.IGNORECASE)


class SutureError(Exception):
    """A failure to show to the user; `edges` are the numbers of the edges that it names."""

    def __init__(self, message, edges=()):
        super().__init__(message)
        self.edges = tuple(edges)


class ProgramMissing(SutureError):
    """The program is not there, or cannot be started."""


class Cancelled(SutureError):
    """The user stopped the run."""


class NothingToDo(SutureError):
    """The shape has no hole."""


def in_freecads_words(text):
    """`text` with "edge 9" as "Edge9" and "face 3" as "Face3", as FreeCAD writes them."""

    def rename(match):
        kind = match[1].capitalize()
        return re.sub(r"\d+", lambda number: kind + number[0], match[2])

    return _NUMBERED.sub(rename, text)


def edges_named_in(text):
    """The numbers of the edges that a sentence of the program names, in order, each once."""
    numbers = re.findall(r"Edge(\d+)", in_freecads_words(text))
    return list(dict.fromkeys(map(int, numbers)))
