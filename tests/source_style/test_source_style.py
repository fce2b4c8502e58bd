"""Rules of the house that a script can check."""

import os
import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
COMPLAINT = re.compile(r"(.*):\d+:\d+: error: code should be clang-formatted")
VERSION = "14"  # Debian 12's
FOLDERS = ["kernel", "step_io", "tests"]


def sources():
    return sorted(
        path for top in FOLDERS for path in (ROOT / top).rglob("*") if path.suffix in (".h", ".cpp")
    )


def format_complaints(files):
    """What clang-format would change, one line for each place; empty where it is content."""
    done = subprocess.run(
        ["clang-format", "--dry-run", "--Werror", *map(str, files)],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=False,
    )
    lines = [line for line in done.stderr.splitlines() if COMPLAINT.match(line)]
    if done.returncode != 0 and not lines:
        raise AssertionError(f"clang-format ended with {done.returncode}:\n{done.stderr}")
    return lines


def clang_format():
    """Its main version; each lays some things out otherwise."""
    said = subprocess.run(["clang-format", "--version"], capture_output=True, text=True, check=True)
    return re.search(r"version (\d+)", said.stdout)[1]


@unittest.skipUnless(clang_format() == VERSION, f"clang-format is not {VERSION}, whose layout is ours")
class Format(unittest.TestCase):
    def test_clang_format_would_change_nothing(self):
        files = sources()
        self.assertGreater(len(files), 50)
        complaints = format_complaints(files)
        bad = sorted({str(Path(COMPLAINT.match(line)[1]).relative_to(ROOT)) for line in complaints})
        self.assertEqual(bad, [], f"\nrun: clang-format -i {' '.join(bad)}")

    def test_a_badly_formatted_file_is_found(self):
        bad = Path(os.environ["SUTURE_BINARY_DIR"]) / "tests/source_style/bad.cpp"
        bad.write_text("int  f( ){return 1 ;}\n", encoding="utf-8")
        (bad.parent / ".clang-format").write_bytes((ROOT / ".clang-format").read_bytes())
        self.assertNotEqual(format_complaints([bad]), [])


class Sources(unittest.TestCase):
    def assert_found_in_none(self, pattern, allowed=()):
        found = [
            f"{path.relative_to(ROOT)}:{text.count(chr(10), 0, match.start()) + 1}: {match.group()}"
            for path in sources()
            if str(path.relative_to(ROOT)) not in allowed
            for text in [path.read_text(encoding="utf-8")]
            for match in re.finditer(pattern, text, re.MULTILINE)
        ]
        self.assertEqual(found, [])

    def test_every_header_has_an_include_guard(self):
        for path in sources():
            if path.suffix == ".h":
                self.assertIn("#pragma once", path.read_text(encoding="utf-8"), path)

    def test_occt_failures_are_caught_in_one_place(self):
        self.assert_found_in_none(
            r"catch\s*\(\s*(const\s+)?Standard_\w+", allowed=["kernel/suture/occ/guard.h"]
        )

    def test_nothing_is_left_to_do(self):
        self.assert_found_in_none(r"\b(TODO|FIXME|XXX)\b")


if __name__ == "__main__":
    unittest.main()
