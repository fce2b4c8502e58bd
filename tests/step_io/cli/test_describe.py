"""Man pages and completions say what the command line takes, all of it."""

import os
import re
import shutil
import subprocess
import unittest

PROGRAM = os.environ["SUTURE_PROGRAM"]


def ask(*words, code=0):
    done = subprocess.run(
        [PROGRAM, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
    )
    if done.returncode != code:
        raise AssertionError(done.stderr)
    return done.stdout


def options_of(command):
    """As the help has them, which CLI11 writes itself."""
    return set(re.findall(r"^  +(?:-\w,)?(--[a-z][a-z0-9-]*)", ask(command, "--help"), re.MULTILINE))


class Descriptions(unittest.TestCase):
    commands = ask("describe", "commands").split()

    def test_they_know_every_command(self):
        self.assertGreaterEqual(set(self.commands), {"fill", "inspect", "check", "convert", "demo"})
        for command in self.commands:
            self.assertIn(f"suture {command}", ask("describe", "man"))
            self.assertIn(command, ask("--help"))

    def test_they_know_every_option(self):
        bash, zsh, fish = (ask("describe", shell) for shell in ("bash", "zsh", "fish"))
        for command in self.commands:
            page = ask("describe", "man", command).replace("\\-", "-")
            options = options_of(command)
            self.assertGreaterEqual(len(options), 3, command)
            ours = [line for line in bash.splitlines() if line.strip().startswith(f"{command})")]
            for option in options:
                self.assertIn(f"\\fB{option}\\fR", page)
                self.assertRegex(ours[0], rf"[ ']{option}[ ']")
                self.assertIn(f"'*{option}[", zsh)
                self.assertRegex(fish, rf"from {command}'.* -l {option[2:]} ")

    def complete(self, *words):
        script = (
            'eval "$("$0" describe bash)"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _suture; '
            'printf "%s\\n" "${COMPREPLY[@]}"'
        )
        done = subprocess.run(
            ["bash", "-c", script, PROGRAM, *words], capture_output=True, text=True, check=True
        )
        return done.stdout.split()

    def test_bash_completes_commands_options_and_values(self):
        self.assertEqual(self.complete("suture", "ins"), ["inspect"])
        self.assertEqual(self.complete("suture", "fill", "--edge-c"), ["--edge-continuity"])
        self.assertEqual(self.complete("suture", "fill", "--continuity", "G"), ["G0", "G1", "G2"])
        self.assertEqual(self.complete("suture", "fill", "--occt-setting", "t"), ["tuned"])
        self.assertEqual(self.complete("suture", "fill", "par"), [])  # a file: bash's own

    @unittest.skipUnless(shutil.which("man"), "there is no man")
    def test_man_shows_the_page_without_complaint(self):
        for words in (("man",), ("man", "fill")):
            done = subprocess.run(
                ["man", "--warnings", "-l", "-"],
                input=ask("describe", *words),
                capture_output=True,
                text=True,
                check=True,
                env={**os.environ, "MANPAGER": "cat", "MANWIDTH": "100", "LC_ALL": "C.UTF-8"},
            )
            self.assertEqual(done.stderr, "")
            self.assertIn("suture", done.stdout)

    def test_what_it_does_not_know_is_wrong_usage(self):
        ask("describe", "man", "nonsense", code=1)
        ask("describe", code=1)


if __name__ == "__main__":
    unittest.main()
