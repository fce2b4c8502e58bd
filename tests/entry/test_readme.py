"""What README.md states about the program is what the program says of itself."""

import json
import os
import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
PROGRAM = os.environ["SUTURE_PROGRAM"]


def ask(*words):
    done = subprocess.run(
        [PROGRAM, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True
    )
    return done.stdout


class Readme(unittest.TestCase):
    text = (ROOT / "README.md").read_text(encoding="utf-8")

    def test_its_methods_are_the_programs(self):
        rows = re.findall(r"^\| `(\w+)` \| .* \| (G\d) \| .*\|$", self.text, re.MULTILINE)
        methods = json.loads(ask("methods", "--json"))["methods"]
        self.assertEqual(
            sorted(rows), sorted((row["id"], row["highest_continuity"]) for row in methods)
        )

    def test_its_commands_exist(self):
        commands = set(re.findall(r"^    \./suture (\w+)", self.text, re.MULTILINE))
        self.assertGreaterEqual(commands, {"demo", "fill", "inspect", "check", "convert"})
        for command in commands:
            self.assertIn("Examples:", ask(command, "--help"), command)

    def test_its_options_of_fill_exist(self):
        table = self.text.split("| to | write |")[1].split("\n\n")[0]
        options = set(re.findall(r"`(--[a-z-]+)", table))
        self.assertGreaterEqual(len(options), 8)
        help_text = ask("fill", "--help")
        for option in options:
            self.assertIn(option, help_text)

    def test_the_version_is_the_same_everywhere(self):
        version = re.search(r"VERSION ([\d.]+) ", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(ask("--version").split()[1], version)
        self.assertIn(f"\nversion: {version}\n", (ROOT / "CITATION.cff").read_text())
        self.assertIn(f"<version>{version}</version>", (ROOT / "package.xml").read_text())
        for page in ("README.md", "docs/ship.md"):
            named = re.findall(r"suture-(\d+\.\d+\.\d+)-", (ROOT / page).read_text())
            self.assertEqual(set(named), {version}, page)

    def test_its_links_lead_somewhere(self):
        for page in (ROOT / name for name in ("README.md", "CONTRIBUTING.md", "docs/pipeline.md", "docs/ship.md", "docs/python.md", "docs/batch.md")):
            for target in re.findall(r"\]\((?!https?:)([^)#]+)", page.read_text(encoding="utf-8")):
                self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")


if __name__ == "__main__":
    unittest.main()
