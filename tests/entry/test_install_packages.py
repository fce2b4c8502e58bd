"""cmake/install_packages.sh on made-up systems: each has only the commands that are put there."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["SUTURE_SOURCE_DIR"])
SCRIPT = SOURCE / "cmake/install_packages.sh"
BASIC = ["dirname", "env", "grep", "readlink", "sed", "sh", "tr"]


def listed(kinds):
    text = (SOURCE / "cmake/packages.txt").read_text(encoding="utf-8")
    return re.findall(rf"^(?:{kinds}) +(\S+)(?: unless \S+)?$", text, re.MULTILINE)


class InstallPackages(unittest.TestCase):
    def setUp(self):
        self.bin = Path(tempfile.mkdtemp(prefix="suture_packages_"))
        self.addCleanup(shutil.rmtree, self.bin)
        self.log = self.bin / "log"
        for name in BASIC:
            (self.bin / name).symlink_to(shutil.which(name))

    def add(self, name, body):
        path = self.bin / name
        path.write_text(f'#!/bin/sh\necho "{name} $*" >> {self.log}\n{body}\n', encoding="utf-8")
        path.chmod(0o755)

    def add_debian(self, installed, user=0, apt="true"):
        lines = "\\n".join(f"installed {name}" for name in installed)
        self.add("dpkg-query", f"printf '{lines}\\n'; exit 1")  # as for a name it does not know
        self.add("apt-get", apt)
        self.add("id", f"echo {user}")

    def run_script(self, kind, **environment):
        return subprocess.run(
            [str(SCRIPT), kind],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            env={"PATH": str(self.bin), **environment},
            check=False,
        )

    def calls(self, name):
        if not self.log.exists():
            return []
        lines = self.log.read_text(encoding="utf-8").splitlines()
        return [line for line in lines if line.startswith(name)]

    def test_a_package_is_not_wanted_where_its_command_is(self):
        self.add_debian([name for name in listed("run|test") if name not in ("nodejs", "npm")])
        self.assertNotEqual(self.run_script("run").stderr, "")
        self.add("node", "true")
        self.add("npm", "true")
        done = self.run_script("run")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_nothing_missing_touches_nothing(self):
        self.add_debian(listed("run|test"))
        for kind in ("run", "test"):
            done = self.run_script(kind)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(self.calls("apt-get"), [])

    def test_only_what_is_missing_is_installed_and_stdout_stays_empty(self):
        self.add_debian([name for name in listed("run") if name != "cmake"], apt="echo noise")
        done = self.run_script("run")
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        update, install = self.calls("apt-get")
        self.assertRegex(update, r" update$")
        self.assertRegex(install, r" install -y --no-install-recommends cmake$")

    def test_running_needs_no_test_package(self):
        self.add_debian([])
        self.run_script("run")
        install = self.calls("apt-get")[1].split("--no-install-recommends ")[1].split()
        self.assertEqual(install, listed("run"))
        self.assertNotIn("freecad-python3", install)

    def test_testing_needs_all_of_them(self):
        self.add_debian([])
        self.run_script("test")
        install = self.calls("apt-get")[1].split("--no-install-recommends ")[1].split()
        self.assertEqual(install, listed("run|test"))

    def test_a_failed_update_is_no_reason_to_give_up(self):
        self.add_debian([], apt='case "$*" in *update) exit 100;; esac')
        self.assertEqual(self.run_script("run").returncode, 0)

    def test_a_failed_install_names_the_packages(self):
        self.add_debian([], apt='case "$*" in *install*) exit 100;; esac')
        done = self.run_script("run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("could not install: " + " ".join(listed("run")), done.stderr)

    def test_a_user_without_sudo_is_told_what_to_run(self):
        self.add_debian([], user=1000)
        done = self.run_script("run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt-get install --no-install-recommends ccache cmake", done.stderr)
        self.assertEqual(self.calls("apt-get"), [])

    def test_a_user_with_sudo_installs_with_it(self):
        self.add_debian([], user=1000)
        self.add("sudo", '"$@"')
        self.assertEqual(self.run_script("run").returncode, 0)
        self.assertEqual(len(self.calls("sudo")), 2)
        self.assertEqual(len(self.calls("apt-get")), 2)

    def test_a_system_without_apt_is_told_the_packages(self):
        done = self.run_script("run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no apt-get", done.stderr)
        self.assertIn("libocct-foundation-dev", done.stderr)
        self.assertEqual(self.run_script("run", SUTURE_NO_INSTALL="1").returncode, 0)


if __name__ == "__main__":
    unittest.main()
