"""./suture in a made-up checkout whose build script and program only say what they were told."""

import os
import resource
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(os.environ["SUTURE_SOURCE_DIR"])

BUILD = """#!/bin/sh
root=$(dirname "$(dirname "$0")")
echo "build $1"
cat
echo "$1" >> "$root/builds"
[ ! -e "$root/broken" ] || exit 1
mkdir -p "$root/build/release/bin"
cp "$root/program" "$root/build/release/bin/suture"
touch "$root/build/release/built"
"""

PROGRAM = """#!/bin/sh
pwd
for word; do echo "[$word]"; done
cat
echo to stderr >&2
exit 4
"""


class SutureScript(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="suture entry "))
        self.addCleanup(shutil.rmtree, self.root)
        for folder in ("kernel/suture/base", "step_io", "cmake"):
            (self.root / folder).mkdir(parents=True)
        for file in ("CMakeLists.txt", "CMakePresets.json", "kernel/suture/base/result.h"):
            (self.root / file).touch()
        shutil.copy(SOURCE / "suture", self.root)
        self.write_script("cmake/build.sh", BUILD)
        self.write_script("program", PROGRAM)

    def write_script(self, name, text):
        path = self.root / name
        path.write_text(text, encoding="utf-8")
        path.chmod(0o755)

    def run_suture(self, *words, script=None, given="", cwd="/"):
        return subprocess.run(
            [str(script or self.root / "suture"), *words],
            input=given,
            capture_output=True,
            text=True,
            cwd=cwd,
            check=False,
        )

    def builds(self):
        file = self.root / "builds"
        return file.read_text(encoding="utf-8").split() if file.exists() else []

    def test_first_use_builds_and_stdout_is_the_programs_alone(self):
        done = self.run_suture("inspect", "a b.step", given="from stdin\n", cwd="/usr")
        self.assertEqual(done.stdout, "/usr\n[inspect]\n[a b.step]\nfrom stdin\n")
        self.assertEqual(done.stderr, "build run\nto stderr\n")
        self.assertEqual(done.returncode, 4)
        self.assertEqual(self.builds(), ["run"])

    def test_second_use_does_not_build(self):
        self.run_suture()
        self.run_suture()
        self.assertEqual(self.builds(), ["run"])

    def test_a_newer_source_is_built(self):
        self.run_suture()
        time.sleep(0.05)  # the file system's clock ticks every few milliseconds
        (self.root / "kernel/suture/base/result.h").write_text("// new\n", encoding="utf-8")
        self.run_suture()
        self.run_suture()
        self.assertEqual(self.builds(), ["run", "run"])

    def test_a_deleted_source_is_built(self):
        self.run_suture()
        time.sleep(0.05)  # the file system's clock ticks every few milliseconds
        (self.root / "kernel/suture/base/result.h").unlink()
        self.run_suture()
        self.assertEqual(self.builds(), ["run", "run"])

    def test_a_failed_build_ends_with_code_5_and_is_tried_again(self):
        (self.root / "broken").touch()
        done = self.run_suture()
        self.assertEqual((done.returncode, done.stdout), (5, ""))
        self.assertIn("could not be built", done.stderr)
        (self.root / "broken").unlink()
        self.assertEqual(self.run_suture().returncode, 4)

    def test_a_link_to_it_works(self):
        link = self.root / "link"
        link.symlink_to(self.root / "suture")
        self.assertEqual(self.run_suture("demo", script=link).stdout, "/\n[demo]\n")

    def test_it_costs_less_than_30_ms(self):
        """On the real checkout's files. The least processor time: other tests can only add to it."""
        for folder in ("kernel", "step_io", "cmake"):
            shutil.rmtree(self.root / folder)
            shutil.copytree(SOURCE / folder, self.root / folder)
        self.write_script("cmake/build.sh", BUILD)
        self.write_script("program", "#!/bin/sh\n")
        self.run_suture()

        def used():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime

        def least_cost(command):
            costs = []
            for _ in range(21):
                before = used()
                subprocess.run([str(command)], check=True)
                costs.append(used() - before)
            return min(costs)

        program = self.root / "build/release/bin/suture"
        self.assertLess(least_cost(self.root / "suture") - least_cost(program), 0.030)
        self.assertEqual(self.builds(), ["run"])


if __name__ == "__main__":
    unittest.main()
