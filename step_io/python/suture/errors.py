# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong. Each error has the program's own words, and its JSON document."""


class SutureError(Exception):
    """message: one line; document: the program's JSON document, or {}; findings: what the judge found."""

    def __init__(self, message, document=None):
        super().__init__(message)
        self.document = document or {}
        self.findings = []


class ProgramMissing(SutureError):
    """There is no program `suture`."""


class UsageError(SutureError):
    """The arguments make no sense."""


class Unreadable(SutureError):
    """The model cannot be read."""


class NothingToDo(SutureError):
    """The model has no hole to fill."""


class Cancelled(SutureError):
    """Stopped by `cancel`."""


class OutOfTolerance(SutureError):
    """`strict`: a hole stayed open or is out of tolerance. result: what was done all the same."""

    result = None
