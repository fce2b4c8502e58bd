"""No two types have the same full name.

The compiler does not see it, the linker takes the code of one for both: a vector of one type is then
handled by the code for a vector of the other.
"""

import os
import re
import tempfile
import unittest
from collections import defaultdict
from pathlib import Path

TOKEN = re.compile(
    r"//[^\n]*|/\*.*?\*/"
    r"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'"
    r"|\bnamespace\s+(?P<space>[\w:]+)?\s*\{"
    r"|\b(?:struct|class|union|enum(?:\s+class)?)\s+(?P<type>\w+(?:::\w+)*)\s*(?:final\s*)?"
    r"(?::(?!:)[^;{()]*)?\{"
    r"|[{}]",
    re.DOTALL,
)


def types_in(text):
    """The full names of the types that a file defines, without those of functions and of unnamed
    namespaces."""
    found, scopes = [], []  # None: a scope whose names nobody else sees
    for token in TOKEN.finditer(text):
        if token[0] == "}":
            scopes = scopes[:-1]
        elif token[0].endswith("{"):
            name = token["space"] or token["type"]
            scopes.append(name)
            if token["type"] and None not in scopes:
                found.append("::".join(scopes))
    return found


def defined_twice(root):
    files = defaultdict(list)
    for top in ("kernel", "step_io"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                for name in types_in(path.read_text(encoding="utf-8")):
                    files[name].append(str(path.relative_to(root)))
    return {name: where for name, where in files.items() if len(where) > 1}


class TypeNames(unittest.TestCase):
    def test_every_type_is_defined_once(self):
        self.assertEqual(defined_twice(Path(os.environ["SUTURE_SOURCE_DIR"])), {})

    def test_the_types_of_the_flow_are_seen(self):
        header = Path(os.environ["SUTURE_SOURCE_DIR"]) / "kernel/suture/model/patch.h"
        self.assertIn("suture::EdgeUse", types_in(header.read_text(encoding="utf-8")))


class Clash(unittest.TestCase):
    def found_in(self, first, second):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("kernel/a.h", first), ("step_io/b.cpp", second)):
                file = Path(folder) / name
                file.parent.mkdir()
                file.write_text(text, encoding="utf-8")
            return defined_twice(Path(folder))

    def test_two_of_a_name_are_found_with_their_files(self):
        found = self.found_in(
            "namespace suture {\nclass Use final : public A<int> { int i = 0; };\n}",
            "namespace suture {\nvoid f() { g('{'); }\nstruct Use {};\n}",
        )
        self.assertEqual(found, {"suture::Use": ["kernel/a.h", "step_io/b.cpp"]})

    def test_nested_types_have_the_names_around_them(self):
        inside = "namespace suture::cli { struct A { enum class Kind : int { B }; }; }"
        self.assertIn("suture::cli::A::Kind", self.found_in(inside, inside))
        self.assertEqual(self.found_in(inside, "namespace suture::cli { struct B::Kind {}; }"), {})

    def test_names_that_nobody_else_sees_may_recur(self):
        mine = "namespace suture { namespace { struct Use {}; } void f() { struct Inner {}; } }"
        self.assertEqual(self.found_in(mine, mine), {})

    def test_other_namespaces_and_declarations_are_no_clash(self):
        other = "namespace suture::bench { struct Use {}; } namespace suture { struct Gap; }"
        self.assertEqual(self.found_in("namespace suture { struct Use {}; struct Gap {}; }", other), {})


if __name__ == "__main__":
    unittest.main()
