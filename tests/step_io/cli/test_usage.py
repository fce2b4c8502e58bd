"""What the command line takes, and what it says of what it does not take."""

import os
import subprocess

from program import DONE, NOTHING, PROGRAM, USAGE, Case, example, run
from time_limits import limit

COMMANDS = ("inspect", "fill", "check", "convert", "patch", "methods", "demo", "algebraic")


class Usage(Case):
    def test_version_answers_at_once(self):
        """Nearly all of it is the loading of OCCT's libraries, 25 to 50 ms on an idle machine."""
        seconds = []
        for _ in range(10):
            process = subprocess.Popen([PROGRAM, "--version"], stdout=subprocess.PIPE)
            text = process.stdout.read().decode()
            process.stdout.close()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = status
            self.assertRegex(text, r"^suture \d+\.\d+\.\d+\n$")
            seconds.append(used.ru_utime + used.ru_stime)
        # Processor time of the best run: other tests may keep the machine busy.
        self.assertLess(min(seconds), limit(0.2))

    def test_libraries_that_few_runs_need_are_not_loaded_at_the_start(self):
        """They doubled what the program adds to the start of a bare OCCT program."""
        lines = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, check=True).stdout
        loaded = {line.split()[0].partition(".so")[0] for line in lines.splitlines()}
        self.assertTrue({"libTKXDESTEP", "libTKDESTEP"} & loaded)  # OCCT 7.6, 7.8
        seldom = {"libTKIGES", "libTKXDEIGES", "libTKDEIGES", "libTKOffset", "libTKFillet", "libopenblas", "libzip"}
        self.assertEqual(seldom & loaded, set())

    def test_help_names_every_command_and_exit_code(self):
        text = self.expect(run("--help"), DONE).out
        for word in (*COMMANDS, "130/143", "unreadable input", "First steps"):
            self.assertIn(word, text)

    def test_help_of_every_command_has_examples(self):
        for command in COMMANDS:
            text = self.expect(run(command, "--help"), DONE).out
            self.assertIn("Examples:", text)
            self.assertIn(f"suture {command}", text)
            self.assertIn("--json", text)

    def test_no_command_is_wrong_usage(self):
        self.assertIn("suture fill", self.expect(run(), USAGE).out)

    def test_unknown_command_is_named(self):
        self.expect_refused(run("fil", "x.step"), USAGE, "no command 'fil'", "did you mean 'fill'", *COMMANDS)
        self.expect_refused(run("zzzzzzzzz"), USAGE, "no command 'zzzzzzzzz'")

    def test_options_come_after_the_command(self):
        words = ("--verbose", "inspect", example("box_without_lid"))
        self.expect_refused(run(*words), USAGE, "suture inspect --verbose")
        self.expect_refused(run("-V"), USAGE, "-V", "--help")

    def test_help_is_a_command_too(self):
        self.assertEqual(run("help").out, run("--help").out)
        self.assertEqual(self.expect(run("help", "fill"), DONE).out, run("fill", "--help").out)

    def test_an_error_names_the_help_of_its_command(self):
        self.expect_refused(run("convert", "a.step"), USAGE, "name the file to write", "suture convert --help")

    def test_empty_words_are_wrong_usage(self):
        """They come from scripts; --hole "" must not fill every hole."""
        fill = ["fill", example("pipe_elbow"), "-o", self.folder / "out.step"]
        for option in ("--hole", "--edges", "--tolerance", "--method", "--edge-continuity"):
            self.expect_refused(run(*fill, option, ""), USAGE, option, "empty")
            self.expect_refused(run(*fill, f"{option}="), USAGE, option, "no value")
        self.expect_refused(run("inspect", ""), USAGE, "inspect", "empty")
        self.expect_files()

    def test_unknown_flag_is_wrong_usage(self):
        self.expect_refused(run("inspect", example("box_without_lid"), "--holes-please"), USAGE)

    def test_missing_output_is_wrong_usage(self):
        self.expect_refused(run("fill", example("box_without_lid")), USAGE, "-o")

    def test_methods_lists_all_with_source(self):
        methods = {m["id"]: m for m in self.expect(run("methods", "--json"), DONE).json["methods"]}
        self.assertLessEqual({"auto", "extend", "plane", "occt"}, set(methods))
        for method in methods.values():
            for key in ("title", "source", "sides", "highest_continuity"):
                self.assertTrue(method[key], method)
            for option in method["options"]:
                self.assertTrue(all(option[key] for key in ("key", "value", "text")), option)

    def test_methods_table_is_for_readers(self):
        text = self.expect(run("methods"), DONE).out
        self.assertIn("extend", text)
        self.assertNotIn("{", text)


class WrongValues(Case):
    def refuse(self, words, *said, command="fill"):
        output = ["-o", self.folder / "out.step"] if command == "fill" else []
        finished = run(command, example("box_without_lid"), *output, *words)
        self.expect_refused(finished, USAGE, *said)
        self.expect_files()

    def test_options_belong_to_a_method(self):
        self.refuse(["--option", "nonsense=1"], "'auto' has no option 'nonsense'")
        self.refuse(["--method", "plane", "--option", "pole=1"], "'plane' has no option 'pole'")
        self.refuse(["--option", "nonsense"], "KEY=VALUE")

    def test_tolerances_must_be_positive_numbers(self):
        for flag in ("--tolerance", "--angle", "--curvature", "--sew-tolerance", "--timeout", "--occt-timeout",
                     "--memory"):
            for value in ("0", "-1", "nan", "inf"):
                self.refuse([f"{flag}={value}"], flag, "positive")

    def test_tolerance_must_be_a_number(self):
        self.refuse(["--tolerance", "tight"], "--tolerance")

    def test_limits_of_check_must_be_positive_numbers(self):
        for flag in ("--g0", "--g1", "--g2", "--sharp"):
            for value in ("0", "-0.5", "nan"):
                self.refuse([f"{flag}={value}"], flag, "positive", command="check")

    def test_read_timeout_must_be_positive(self):
        for value in ("0", "-3", "nan"):
            self.refuse([f"--read-timeout={value}"], "--read-timeout", command="inspect")

    def test_jobs_must_be_positive(self):
        self.refuse(["--jobs=0"], "--jobs")

    def test_unknown_method_suggests_the_nearest(self):
        self.refuse(["--method", "extned"], "did you mean 'extend'", "plane", "occt")

    def test_unknown_method_far_from_all_lists_them(self):
        finished = run("fill", example("box_without_lid"), "-o", self.folder / "o.step", "--method=zzzzzz")
        self.expect_refused(finished, USAGE, "zzzzzz", "extend", "plane", "occt")
        self.assertNotIn("did you mean", finished.err)

    def test_unknown_continuity(self):
        self.refuse(["--continuity", "G3"], "G3", "G0, G1, G2")

    def test_edge_continuity_needs_a_continuity(self):
        self.refuse(["--edge-continuity", "12"], "12=G2")

    def test_hole_that_does_not_exist(self):
        self.refuse(["--hole", "99"], "no hole 99", "suture inspect")

    def test_loop_named_twice_in_one_hole(self):
        self.refuse(["--hole", "1+1"], "1+1", "twice")

    def test_progress_of_unknown_style(self):
        self.refuse(["--progress", "loud"], "--progress", "auto,bar,json,none")
        self.refuse(["--progress", "1"], "--progress")

    def test_deflection_that_no_mesher_takes(self):
        self.refuse(["--deflection=1e-9"], "--deflection", "at least 1e-07 mm")

    def test_hole_that_is_no_number(self):
        for word in ("0", "1-2", "3++4"):
            self.refuse([f"--hole={word}"], "hole")

    def test_edge_that_does_not_exist(self):
        self.refuse(["--edges", "999"], "no edge 999", "12 edges")

    def test_edge_that_bounds_no_hole(self):
        shared = {e["edge"] for e in run("check", example("box_without_lid"), "--json").json["edges"]}
        self.refuse(["--edges", min(shared)], "bounds no hole")

    def test_hole_and_edges_together(self):
        self.refuse(["--hole", "1", "--edges", "1"], "not both")

    def test_unknown_profile(self):
        self.refuse(["--profile", "catya"], "catya", "catia", command="check")

    def test_report_of_unknown_type(self):
        self.refuse(["--report", self.folder / "r.pdf"], ".html")

    def test_report_over_the_output(self):
        output = self.folder / "out.json"
        finished = run("fill", example("box_without_lid"), "-o", output, "--report", output)
        self.expect(finished, USAGE)
        self.expect_files()

    def test_wrong_usage_as_json_is_a_document_too(self):
        finished = run(
            "fill", example("box_without_lid"), "-o", self.folder / "o.step", "--tolerance=0", "--json"
        )
        self.expect(finished, USAGE)
        self.assertEqual(finished.json["error"]["code"], "usage")
        self.assertEqual(finished.json["exit_code"], USAGE)


    def test_what_the_parser_refuses_is_a_document_too(self):
        for words in (["inspect"], ["fill", "x.step", "--holes-please"], ["fil"], []):
            finished = self.expect(run(*words, "--json"), USAGE)
            self.assertEqual(finished.json["error"]["code"], "usage", words)
            self.assertEqual(finished.json["error"]["message"], finished.err[len("error: "):-1])


class Lists(Case):
    def test_an_option_may_be_given_once_for_each_hole(self):
        fill = ["fill", example("pipe_elbow"), "-o", self.folder / "out.step", "--json"]
        holes = run("inspect", example("pipe_elbow"), "--json").json["holes"]
        edges = [hole["edges"][0] for hole in holes]
        for words in (["--hole", "1", "--hole", "2"], ["--hole=2", "--holes", "1"],
                      ["--edges", edges[0], "--edge", edges[1]],
                      ["--edges", f"Edge{edges[0]}", f"Edge{edges[1]}"],
                      ["--edges", f"Edge{edges[0]},{edges[1]}"],
                      ["--edge-continuity", f"Edge{edges[0]}=G0", "--edge-continuity", f"{edges[1]}=G0"]):
            finished = self.expect(run(*fill, *words), DONE)
            self.assertEqual([h["status"] for h in finished.json["holes"]], ["filled"] * 2, words)
        one = self.expect(run(*fill, "--hole", "1"), DONE).json["holes"]
        self.assertEqual(sorted(h["status"] for h in one), ["filled", "skipped"])

    def test_hole_list_may_stand_before_the_file(self):
        output = self.folder / "out.step"
        finished = run("fill", "--hole", "1", "2", example("pipe_elbow"), "-o", output, "--json")
        self.expect(finished, DONE)
        self.assertEqual([h["status"] for h in finished.json["holes"]], ["filled", "filled"])

    def test_closed_model_has_nothing_to_do(self):
        closed = self.folder / "closed.step"
        self.expect(run("fill", example("box_without_lid"), "-o", closed), DONE)
        output = self.folder / "again.step"
        self.expect_refused(run("fill", closed, "-o", output), NOTHING, "no hole")
        self.expect_files("closed.step")
