# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of the program in the user's language.

The program speaks English. Its sentences are made of the patterns in resources/translations/program.txt, which
translators find in the context Suture_program; {0}, {1}… are what the program has put in, which may be made of
patterns itself. What fits no pattern stays as it is.
"""

import functools
import re
from collections import namedtuple

from . import RESOURCES
from .compat import translate_in
from .errors import SutureError, edges_named_in, in_freecads_words

CONTEXT = "Suture_program"
_JOINTS = ("; ", ". ", ": ", ", ")  # what the program joins sentences with, the widest first
_DEEPEST = 30
_Pattern = namedtuple("_Pattern", "pattern expression letters")


def patterns():
    """All patterns, as translators see them."""
    text = (RESOURCES / "translations" / "program.txt").read_text(encoding="utf-8")
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def in_your_language(text):
    """`text`, of the program, as far as its patterns are translated."""
    first = _known()[0].pattern
    translation = translate_in(CONTEXT, first)
    if not text or translation == first:
        return text  # English, or a language that nobody has translated to yet
    return _remembered(text, translation)


def in_users_words(text):
    """A sentence of the program in the user's language, with FreeCAD's names of edges and faces."""
    return in_freecads_words(in_your_language(text))


def failure(text):
    """The program's sentence as an error that knows its edges."""
    said = in_users_words(text).replace("`suture inspect` lists", "Find holes lists")
    return SutureError(said, edges_named_in(text))


@functools.lru_cache(maxsize=1000)
def _remembered(text, _language):
    return _said(text, 0)


@functools.lru_cache(maxsize=1)
def _known():
    """All patterns with their regular expressions, the most special first."""
    found = []
    for pattern in patterns():
        words = re.split(r"\{\d\}", pattern)
        expression = "(.+?)".join(map(re.escape, words))
        found.append(_Pattern(pattern, re.compile(expression, re.DOTALL), sum(map(len, words))))
    return sorted(found, key=lambda one: -one.letters)


def _said(text, depth):
    if depth > _DEEPEST or not any(letter.isalpha() for letter in text):
        return text
    for pattern, expression, _ in _known():
        match = expression.fullmatch(text)
        translation = translate_in(CONTEXT, pattern) if match else pattern
        if match and translation != pattern:
            return translation.format(*(_said(part, depth + 1) for part in match.groups()))
    for joint in _JOINTS:
        head, found, rest = text.partition(joint)
        if found:
            head = _said(head, depth + 1) if " " in head else head  # a single word is a method's name
            return head + joint + _said(rest, depth + 1)
    return text
