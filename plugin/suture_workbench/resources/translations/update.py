#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the .ts files up to date with the sources, and makes the .qm files that FreeCAD reads.

    update.py [LANGUAGE...]   by default those that there are; a new one (update.py fr) begins empty

Every text in translate("…"), mark("…"), QT_TRANSLATE_NOOP("context", "…") in the .ui files and in program.txt is taken. What has been translated stays; what is gone from
the sources goes. Needs lrelease (Debian: qttools5-dev-tools).
"""

import ast
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCES = HERE.parent.parent.parent  # plugin/
CONTEXT = "Suture"
PROGRAM = "Suture_program"


def texts():
    """{(context, text): first place} of everything to translate, in the order of the sources."""
    found = {}
    for path in sorted(SOURCES.rglob("*.py")):
        place = str(path.relative_to(SOURCES))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"), str(path))):
            if isinstance(node, ast.Call):
                for context, text in _texts_of(node):
                    found.setdefault((context, text), place)
    for line in (HERE / "program.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            found.setdefault((PROGRAM, line), "program.txt")
    for path in sorted(SOURCES.rglob("*.ui")):
        form = ElementTree.parse(path).getroot()
        for string in form.iter("string"):
            if string.text and string.get("notr") != "true":
                place = str(path.relative_to(SOURCES))
                found.setdefault((form.findtext("class"), string.text), place)
    return found


def _texts_of(call):
    """The texts of translate("…"), mark("…") and QT_TRANSLATE_NOOP("context", "…")."""
    constants = [node.value for node in call.args if isinstance(node, ast.Constant)]
    name = getattr(call.func, "id", "")
    if name in ("translate", "mark") and isinstance((constants or [0])[0], str):
        return [(CONTEXT, constants[0])]
    if name == "QT_TRANSLATE_NOOP" and len(constants) == 2:
        return [tuple(constants)]
    return []


def translations(file):
    """{(context, text): translation} of a .ts file."""
    if not file.exists():
        return {}
    return {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation") or ""
        for context in ElementTree.parse(file).getroot().iter("context")
        for message in context.iter("message")
    }


def write(file, language, known):
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    contexts = {}
    for (context, text), place in texts().items():
        if context not in contexts:
            contexts[context] = ElementTree.SubElement(root, "context")
            ElementTree.SubElement(contexts[context], "name").text = context
        message = ElementTree.SubElement(contexts[context], "message")
        ElementTree.SubElement(message, "location", filename=place)
        ElementTree.SubElement(message, "source").text = text
        translation = ElementTree.SubElement(message, "translation")
        if known.get((context, text)):
            translation.text = known[context, text]
        else:
            translation.set("type", "unfinished")
    ElementTree.indent(root)
    head = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
    file.write_text(head + ElementTree.tostring(root, encoding="unicode") + "\n", encoding="utf-8")


def main(languages):
    languages = languages or sorted(file.stem.split("_")[1] for file in HERE.glob("Suture_*.ts"))
    for language in languages:
        file = HERE / f"Suture_{language}.ts"
        known = translations(file)
        write(file, language, known)
        missing = sum(1 for text in texts() if not known.get(text))
        print(f"{file.name}: {len(texts())} texts, {missing} not translated")
        made = file.with_suffix(".new")
        subprocess.run(["lrelease", "-silent", file, "-qm", made], check=True)
        made.replace(file.with_suffix(".qm"))  # at once: a FreeCAD that runs has the old one open


if __name__ == "__main__":
    main(sys.argv[1:])
