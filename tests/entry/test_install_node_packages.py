"""cmake/install_node_packages.sh with an npm that only says what it was told."""

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["SUTURE_SOURCE_DIR"])
SCRIPT = SOURCE / "cmake/install_node_packages.sh"
WEB = SOURCE / "step_io/report/web"

NPM = """#!/bin/sh
echo "$*" >> "$LOG"
mkdir -p "$8/node_modules/.bin" "$8/node_modules/three"
[ -z "${BROKEN-}" ]
"""


class InstallNodePackages(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="suture npm "))
        self.addCleanup(shutil.rmtree, self.folder)
        self.web, self.to = self.folder / "web", self.folder / "to"
        shutil.copytree(WEB, self.web)
        (self.folder / "npm").write_text(NPM, encoding="utf-8")
        (self.folder / "npm").chmod(0o755)
        self.log = self.folder / "log"

    def run_script(self, **environment):
        path = f"{self.folder}:{os.environ['PATH']}"
        return subprocess.run(
            [str(SCRIPT), str(self.web), str(self.to)], stdin=subprocess.DEVNULL, capture_output=True,
            text=True, env={**os.environ, "PATH": path, "LOG": str(self.log), **environment}, check=False)

    def calls(self):
        return self.log.read_text().splitlines() if self.log.exists() else []

    def test_it_asks_npm_once_for_a_lock_file(self):
        for _ in range(2):
            self.assertEqual(self.run_script().returncode, 0)
        self.assertEqual(len(self.calls()), 1)
        self.assertIn("ci --ignore-scripts", self.calls()[0])
        lock = self.web / "package-lock.json"
        lock.write_text(lock.read_text() + "\n", encoding="utf-8")
        self.assertEqual(self.run_script().returncode, 0)
        self.assertEqual(len(self.calls()), 2)

    def test_a_failing_npm_is_told_and_tried_again(self):
        done = self.run_script(BROKEN="1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("npm could not install", done.stderr)
        self.assertEqual(self.run_script().returncode, 0)

    def test_without_leave_to_install_it_says_what_is_missing(self):
        done = self.run_script(SUTURE_NO_INSTALL="1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("npm ci", done.stderr)
        self.assertEqual(self.calls(), [])


class LockFile(unittest.TestCase):
    def test_it_names_versions_and_sums_but_no_addresses(self):
        text = (WEB / "package-lock.json").read_text(encoding="utf-8")
        self.assertIsNone(re.search(r"resolved|https?:", text))
        packages = json.loads(text)["packages"]
        self.assertIn("node_modules/three", packages)
        for name, entry in packages.items():
            if name:
                self.assertIn("integrity", entry, name)


if __name__ == "__main__":
    unittest.main()
