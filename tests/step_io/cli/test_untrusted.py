"""Files that nobody vouches for: they crash nothing, hang nothing, eat no machine, open no other file
and steer no terminal."""

import json
import os
import re
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

from program import (
    CAD,
    DONE,
    INTERNAL,
    NOTHING,
    OUT_OF_TOLERANCE,
    PROGRAM,
    UNREADABLE,
    USAGE,
    Case,
    example,
    run,
    write_slow_brep,
)
from time_limits import limit

FUZZ = CAD.parent / "cases" / "fuzz"
LONGEST_LINE = 300


def shared(name):
    if not FUZZ.is_dir():
        raise unittest.SkipTest(f"no cases in {FUZZ}")
    return FUZZ / name


class Untrusted(Case):
    def write(self, name, content):
        file = self.folder / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def expect_refused(self, finished, code, *words):
        super().expect_refused(finished, code, *words)
        self.assertLessEqual(len(finished.err.splitlines()[0]), LONGEST_LINE)


class Limits(Untrusted):
    def test_the_whole_run_has_a_time_limit(self):
        slow = write_slow_brep(self.folder)
        finished = run("inspect", slow, "--timeout", "0.5", timeout=30)
        self.expect_refused(finished, INTERNAL, "slow.brep", "0.5 s", "--timeout")

    def test_filling_has_it_too(self):
        output = self.write("out.step", "old")
        finished = run("fill", example("bump_window"), "-o", output, "--timeout", "0.05", timeout=30)
        self.expect_refused(finished, INTERNAL, "--timeout", "nothing was written")
        self.assertEqual(output.read_text(), "old")

    def test_memory_has_a_limit(self):
        if "memory limit: none" in run("--version", "-v").out:
            self.skipTest("a sanitizer takes terabytes of addresses")
        finished = run("fill", example("bump_window"), "-o", self.folder / "out.step", "--memory", "0.05")
        self.assertIn(finished.code, (UNREADABLE, INTERNAL), str(finished))
        self.expect_refused(finished, finished.code)
        self.expect_files()

    def test_a_kill_from_outside_is_no_damaged_file(self):
        slow = write_slow_brep(self.folder)
        process = subprocess.Popen([PROGRAM, "inspect", slow], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        worker = None
        deadline = time.monotonic() + limit(30)
        while worker is None and time.monotonic() < deadline:
            time.sleep(0.05)
            children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
            worker = int(children[0]) if children else None
        time.sleep(0.2)
        os.kill(worker, signal.SIGKILL)
        _, err = process.communicate(timeout=limit(30))
        self.assertEqual(process.returncode, INTERNAL, err)
        self.assertIn(b"SIGKILL", err)
        self.assertNotIn(b"damaged", err)

    @unittest.skipUnless(os.geteuid() == 0, "to become somebody with few processes")
    def test_few_processes_are_one_line(self):
        os.chmod(self.folder, 0o777)
        for processes in (0, 1, 2, 3):
            done = subprocess.run(
                ["prlimit", f"--nproc={processes}", "setpriv", "--reuid=54321", "--clear-groups",
                 PROGRAM, "inspect", example("box_without_lid")],
                capture_output=True, check=False, timeout=limit(60))
            if b"Permission denied" in done.stderr:
                self.skipTest("another user cannot run the program here")
            self.assertIn(done.returncode, (DONE, INTERNAL), done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 0 if done.returncode == DONE else 1, done.stderr)
            self.assertNotIn(b"Segmentation", done.stderr)

    def test_limits_are_positive_and_finite(self):
        for option in ("--timeout", "--memory"):
            for value in ("0", "-1", "nan", "1e12"):
                self.expect_refused(run("inspect", example("dome_window"), f"{option}={value}"), USAGE, option)


class OtherFiles(Untrusted):
    def assembly(self, name, part):
        """The assembly of two boxes whose one part stands in another file."""
        text = shared("ext_abs.step").read_text().replace("/srv/elsewhere/box_without_lid.step", str(part))
        return self.write(name, text)

    def test_a_file_elsewhere_is_not_opened(self):
        for part in (example("box_without_lid"), "../outside.step", "/dev/zero"):
            outside = self.folder / "outside.step"
            outside.write_bytes(example("box_without_lid").read_bytes())
            (self.folder / "in").mkdir(exist_ok=True)
            finished = run("check", self.assembly("in/main.step", part), timeout=30)
            self.expect_refused(finished, UNREADABLE, "not in the folder")

    def test_a_link_that_leads_elsewhere_is_not_opened(self):
        (self.folder / "link.step").symlink_to(example("box_without_lid"))
        self.expect_refused(run("check", self.assembly("main.step", "link.step")), UNREADABLE, "link.step")

    def test_a_file_beside_the_input_is_read_unless_forbidden(self):
        self.write("part.step", example("box_without_lid").read_bytes())
        main = self.assembly("main.step", "part.step")
        self.assertEqual(run("inspect", main, "--json").json["hole_count"], 1)
        self.expect_refused(run("inspect", main, "--external-references", "no"), UNREADABLE, "part.step",
                            "--external-references")

    def test_a_part_that_names_a_file_elsewhere_is_not_opened(self):
        self.assembly("part.step", example("box_without_lid"))
        self.expect_refused(run("inspect", self.assembly("main.step", "part.step")), UNREADABLE,
                            "not in the folder")

    def test_a_missing_part_is_named_and_no_success(self):
        text = shared("ext_two_main.step").read_text()
        main = self.write("main.step", text)
        part = "ext_part.stp"
        self.write(part, example("box_without_lid").read_bytes())
        for words in (["check", main], ["convert", main, self.folder / "half.brep"], ["inspect", main]):
            finished = run(*words)
            self.assertIn(finished.code, (OUT_OF_TOLERANCE, DONE) if words[0] == "inspect" else (OUT_OF_TOLERANCE,),
                          str(finished))
            self.assertIn("NOT whole: ext_second.stp missing", finished.out)
        document = run("check", main, "--json").json
        self.assertEqual(document["missing_parts"], ["ext_second.stp"])

    def test_points_come_from_ordinary_files_only(self):
        pipe = self.folder / "pipe.csv"
        os.mkfifo(pipe)
        for points in (pipe, "/dev/zero"):
            finished = run("fill", example("dome_window"), "-o", self.folder / "o.step", "--through", points,
                           timeout=20)
            self.expect_refused(finished, USAGE, "--through", "ordinary")
        long = self.write("long.csv", "1 2 3" + " " * 5000 + "\n")
        self.expect_refused(run("fill", example("dome_window"), "-o", self.folder / "o.step", "--through", long),
                            USAGE, "line 1", "1000")


class Numbers(Untrusted):
    def setUp(self):
        super().setUp()
        self.plain = self.folder / "plain.brep"
        self.expect(run("convert", example("box_without_lid"), self.plain), DONE)

    def test_far_points_and_wild_ranges_are_refused_by_number(self):
        text = self.plain.read_text()
        vertex = re.search(r"\nVe\n[^\n]*\n([^\n]*)\n", text)
        edge = re.search(r"\n1  (\d+) 0 ([^\n]*)\n", text)
        self.assertTrue(vertex and edge)
        for place, new, noun in ((vertex, "1e300 0 0", "vertex"), (vertex, "-1e14 0 0", "vertex"),
                                 (edge, "1e308 -1e308", "edge"), (edge, "4 3", "edge")):
            group = 1 if noun == "vertex" else 2
            start, end = place.span(group)
            wild = self.write("wild.brep", text[:start] + new + text[end:])
            for words in (["inspect", wild], ["fill", wild, "-o", self.folder / "o.step"]):
                finished = run(*words, timeout=30)
                self.expect_refused(finished, UNREADABLE, "wild.brep", f"is damaged: {noun} ")

    def test_no_file_is_written_that_cannot_be_read(self):
        for name in ("convert-d573a991dd.bin", "fill-4756e5887f.bin"):
            output = self.write("out.step", "old")
            finished = run(name.split("-")[0], shared(name), *(["-o"] if name.startswith("fill") else []), output)
            if finished.code in (DONE, OUT_OF_TOLERANCE):
                self.assertNotIn(run("check", output).code, (UNREADABLE, INTERNAL))
                self.assertNotIn("NAN", output.read_text().upper().split("DATA;")[1])
            else:
                self.assertEqual(output.read_text(), "old")


class Words(Untrusted):
    def test_names_do_not_steer_the_terminal(self):
        text = example("box_without_lid").read_text()
        name = re.search(r"= PRODUCT\('([^']*)',\s*'([^']*)'", text)
        evil = text.replace(name[0], "= PRODUCT('\x1b[31mred\x1b]0;t\x07','\x1b[31mred\x1b]0;t\x07'")
        finished = run("inspect", self.write("ansi.step", evil))
        self.expect(finished, DONE)
        self.assertNotRegex(finished.out + finished.err, "[\x00-\x09\x0b-\x1f\x7f-\x9f]")
        self.assertIn("\\x1B[31mred", finished.out)

    def test_long_error_lines_are_cut(self):
        deep = self.folder / ("a" * 200) / ("b" * 200)
        finished = run("inspect", deep / "part.step")
        self.expect_refused(finished, UNREADABLE, "does not exist", "...")

    def test_a_file_name_that_is_no_utf8_stays_in_valid_reports(self):
        name = os.fsencode(self.folder) + b"/part\xff\xfe.step"
        with open(name, "wb") as file:
            file.write(example("box_without_lid").read_bytes())
        junit, html, document = (self.folder / f"r.{ending}" for ending in ("xml", "html", "json"))
        done = subprocess.run([PROGRAM, "check", name, "--report", junit, "--report", html, "--report", document],
                              capture_output=True, check=False, timeout=limit(60))
        self.assertIn(done.returncode, (DONE, OUT_OF_TOLERANCE), done.stderr)
        xml.etree.ElementTree.parse(junit)
        html.read_bytes().decode()
        json.loads(document.read_bytes().decode())
        done.stdout.decode()
        missing = subprocess.run([PROGRAM, "check", name + b"x"], capture_output=True, check=False)
        missing.stderr.decode()

    def test_a_closed_stderr_puts_nothing_on_stdout(self):
        for words, code in ((["inspect", example("dome_window"), "--json"], DONE),
                            (["inspect", self.folder / "none.step"], UNREADABLE)):
            done = subprocess.run(["sh", "-c", 'exec "$0" "$@" 2>&-', PROGRAM, *map(str, words)],
                                  stdout=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, code)
            self.assertEqual(done.stdout == b"", code == UNREADABLE)
            if done.stdout:
                json.loads(done.stdout)

    def test_force_is_offered_only_where_there_is_one(self):
        part = self.write("part.json", example("table_corner").with_suffix(".json").read_bytes())
        finished = run("algebraic", part, "--mesh", part)
        self.expect_refused(finished, USAGE, "is the input itself")
        self.assertNotIn("--force", finished.err)

    def test_a_link_to_nothing_stays_a_link(self):
        link, target = self.folder / "link.step", self.folder / "made.step"
        link.symlink_to("made.step")
        self.expect(run("fill", example("box_without_lid"), "-o", link), DONE)
        self.assertTrue(link.is_symlink())
        self.assertTrue(target.is_file())


class Texts(Untrusted):
    def test_a_long_name_is_cut_and_the_model_read(self):
        text = example("box_without_lid").read_text()
        name = re.search(r"PRODUCT\('([^']*)'", text)
        for quote in ("x" * 20_000, "''" * 16_000, "\\X2\\00E4\\X0\\" * 4_000):
            long = self.write("long.step", text.replace(name[0], f"PRODUCT('{quote}'"))
            finished = run("inspect", long, "--memory", "3")
            self.expect(finished, DONE)
            self.assertRegex(finished.err, r"^warning: 1 text of more than 8000 characters is cut, .*#\d+\n$")

    def test_no_address_in_memory_is_told(self):
        text = example("box_without_lid").read_text()
        digits = text.replace("CARTESIAN_POINT('',(0.", "CARTESIAN_POINT('',(0." + "0" * 40_000, 1)
        self.assertNotEqual(text, digits)
        finished = run("inspect", self.write("digits.step", digits))
        if finished.code != DONE:
            self.expect_refused(finished, UNREADABLE, "digits.step")
            self.assertNotRegex(finished.err, "0x[0-9a-f]+")


class Algebraic(Untrusted):
    def problem(self, **changes):
        whole = json.loads((Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs/examples/table_corner.json").read_text())
        whole.update(changes)
        return whole

    def refuse(self, text, code, *words):
        finished = run("algebraic", self.write("p.json", text), timeout=20)
        self.expect_refused(finished, code, "p.json", *words)

    def test_nested_parentheses_are_counted(self):
        problem = self.problem()
        problem["sides"][0]["surface"] = "(" * 9000 + "x" + ")" * 9000
        self.refuse(json.dumps(problem), USAGE, "100 parentheses")
        problem["sides"][0]["surface"] = "(" * 100 + "x" + ")" * 100 + "*0 + " + self.problem()["sides"][0]["surface"]
        self.assertIn(run("algebraic", self.write("p.json", json.dumps(problem))).code, (DONE, OUT_OF_TOLERANCE))

    def test_high_degrees_and_orders_are_refused(self):
        self.refuse(json.dumps(self.problem(degree=1e9)), USAGE, "degree", "20")
        self.refuse(json.dumps(self.problem(k=1000)), USAGE, "from 0 to 8")
        problem = self.problem()
        problem["sides"] = problem["sides"] * 20
        self.refuse(json.dumps(problem), USAGE, "sides")

    def test_json_that_is_nested_deep_is_refused(self):
        self.refuse('{"sides": ' + "[" * 10_000 + "]" * 10_000 + "}", UNREADABLE, "32 deep")


class SeenBefore(Untrusted):
    """Every small input that once crashed, hung or ate memory."""

    WORDS = {"alg_nest10000": "algebraic", "algebraic": "algebraic", "check": "check", "convert": "convert",
             "fill": "fill", "inspect": "inspect", "patch": "patch"}

    def test_all_end_within_limits(self):
        shared("n_ansi.step")
        for file in sorted(FUZZ.iterdir()):
            with self.subTest(file.name):
                command = self.WORDS.get(file.stem.split("-")[0], "inspect")
                output = self.folder / "out.step"
                words = {"fill": ["-o", output], "convert": [output], "patch": ["-o", output]}.get(command, [])
                before = file.read_bytes()
                finished = run(command, file, *words, "--timeout", limit(15), "--memory", "4",
                               *(["--read-timeout", limit(10)] if command in ("check", "fill", "convert", "inspect") else []),
                               timeout=60)
                self.assertIn(finished.code, range(6), str(finished))
                self.assertNotIn("crashed", finished.err)
                for line in finished.err.splitlines():
                    self.assertLessEqual(len(line), LONGEST_LINE)
                self.assertEqual(file.read_bytes(), before)
                self.assertIn(os.listdir(self.folder), ([], ["out.step"]))
                output.unlink(missing_ok=True)


if __name__ == "__main__":
    unittest.main()
