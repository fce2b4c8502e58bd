"""What the program opens while it works on a file of a stranger's."""

import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from program import DONE, OUT_OF_TOLERANCE, PROGRAM, Case, example
from time_limits import limit

# The system's: libraries, fonts, what threads and memory there are.
SYSTEM = ["/usr", "/lib", "/lib64", "/etc/ld.so.cache", "/etc/localtime", "/proc", "/sys", "/dev/null", "/dev/urandom",
          "/dev/tty", "/etc/fonts", "/var/cache/fontconfig"]


class Opened(Case):
    def setUp(self):
        super().setUp()
        if shutil.which("strace") is None:
            self.skipTest("there is no strace")

    def opened(self, *words):
        """The files that the program and its children have opened, by their real paths."""
        trace = self.folder / "trace"
        done = subprocess.run(["strace", "-f", "-qq", "-e", "trace=open,openat,creat", "-o", trace, PROGRAM,
                               *map(str, words)], capture_output=True, check=False, timeout=limit(120),
                              env={**os.environ, "TMPDIR": str(self.folder / "tmp")})
        if b"ptrace" in done.stderr:
            self.skipTest("no right to trace: " + done.stderr.decode())
        self.assertIn(done.returncode, (DONE, OUT_OF_TOLERANCE), done.stderr)
        names = re.findall(r'open(?:at)?\((?:AT_FDCWD, )?"([^"]*)"[^=]*= \d+', trace.read_text())
        trace.unlink()
        self.assertTrue(names)
        return {os.path.realpath(name) for name in names if not name.startswith("/proc/")}

    def test_only_the_folders_of_input_and_output_and_the_systems(self):
        for name in ("in", "out", "tmp"):
            (self.folder / name).mkdir()
        source = self.folder / "in" / "part.step"
        source.write_bytes(example("box_without_lid").read_bytes())
        allowed = SYSTEM + [str(self.folder), str(Path(PROGRAM).parents[1])]
        for words in (["inspect", source], ["check", source, "--report", self.folder / "out" / "r.html"],
                      ["fill", source, "-o", self.folder / "out" / "o.step"],
                      ["convert", source, self.folder / "out" / "o.igs"],
                      ["fill", source, "-o", self.folder / "out" / "o.step", "--method", "occt"]):
            for file in self.opened(*words):
                self.assertTrue(any(file == place or file.startswith(place + "/") for place in allowed), (words, file))

    def test_the_version_tells_what_there_is(self):
        done = subprocess.run([PROGRAM, "--version", "-v"], capture_output=True, check=True)
        self.assertRegex(done.stdout.decode(), r"^suture [\d.]+\nsandbox: [^\n]+\n"
                                               r"memory limit: ([\d.]+ GB|none, with a sanitizer)\n$")


if __name__ == "__main__":
    unittest.main()
