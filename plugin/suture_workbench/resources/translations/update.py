#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the .ts files up to date with the sources, and makes the .qm files that FreeCAD reads.

    update.py [LANGUAGE...]   by default those that there are; a new one (update.py fr) begins empty

Every text in translate("…") and mark("…") is taken. What has been translated stays; what is gone from
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


def texts():
    """{text: first place} of everything to translate, in the order of the sources."""
    found = {}
    for path in sorted(SOURCES.rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"), str(path))
        for node in ast.walk(tree):
            if not (
                isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("translate", "mark")
            ):
                continue
            for argument in node.args[:1]:
                if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                    found.setdefault(argument.value, f"{path.relative_to(SOURCES)}")
    return found


def translations(file):
    """{text: translation} of a .ts file."""
    if not file.exists():
        return {}
    messages = ElementTree.parse(file).getroot().iter("message")
    return {m.findtext("source"): m.findtext("translation") or "" for m in messages}


def write(file, language, known):
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    for text, place in texts().items():
        message = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(message, "location", filename=place)
        ElementTree.SubElement(message, "source").text = text
        translation = ElementTree.SubElement(message, "translation")
        if known.get(text):
            translation.text = known[text]
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
        subprocess.run(["lrelease", "-silent", file, "-qm", file.with_suffix(".qm")], check=True)


if __name__ == "__main__":
    main(sys.argv[1:])
