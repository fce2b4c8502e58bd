"""Files that cannot be read, outputs that cannot be written: one clear line, the right exit code, and
no output file or an intact old one."""

import os
import subprocess
import unittest

from program import (
    DONE,
    INTERNAL,
    UNREADABLE,
    OUT_OF_TOLERANCE,
    PROGRAM,
    USAGE,
    Case,
    example,
    run,
    write_slow_brep,
)

OLD = b"what was there before\n"


class BadInput(Case):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "out.step"
        self.output.write_bytes(OLD)

    def fill(self, source, *words):
        return run("fill", source, "-o", self.output, *words)

    def expect_unreadable(self, source, *said):
        self.expect_refused(self.fill(source), UNREADABLE, source.name, *said)
        self.assertEqual(self.output.read_bytes(), OLD)
        for command in ("inspect", "check"):
            self.expect_refused(run(command, source), UNREADABLE, source.name, *said)

    def write(self, name, content):
        file = self.folder / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def test_missing_file(self):
        self.expect_unreadable(self.folder / "nowhere.step")

    def test_folder(self):
        folder = self.folder / "folder.step"
        folder.mkdir()
        self.expect_unreadable(folder)

    def test_empty_file(self):
        self.expect_unreadable(self.write("empty.step", ""), "empty")

    def test_text_file(self):
        self.expect_unreadable(self.write("letter.step", "Dear Sir,\nthis is no model.\n"))

    def test_random_bytes(self):
        self.expect_unreadable(self.write("noise.step", bytes(range(256)) * 40))

    def test_step_without_any_face(self):
        source = self.write(
            "nothing.step",
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
            "FILE_NAME('','',(''),(''),'','','');\n"
            "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
            "#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n",
        )
        self.expect_unreadable(source)

    def test_unreadable_permissions(self):
        if os.geteuid() == 0:
            self.skipTest("root may read everything")
        source = self.write("secret.step", example("box_without_lid").read_bytes())
        source.chmod(0)
        self.expect_unreadable(source)

    def test_step_truncated_at_twenty_places(self):
        whole = example("suitcase_corner").read_bytes()
        for part in range(1, 21):
            source = self.write("short.step", whole[: len(whole) * part // 21])
            finished = self.fill(source)
            self.expect_refused(finished, UNREADABLE, "short.step")
            self.assertEqual(self.output.read_bytes(), OLD, part)

    def test_step_with_wrong_references_does_not_crash_the_program(self):
        whole = example("suitcase_corner").read_text()
        # Every reference to a face's surface, an edge's curve, a shell and a representation leads
        # nowhere: OCCT 7.6 is known to crash on such files.
        for entity in ("ADVANCED_FACE", "EDGE_CURVE", "OPEN_SHELL", "SHAPE_DEFINITION_REPRESENTATION"):
            lines = whole.replace(f"= {entity}(", f"= {entity}_NO_MORE(", 1)
            source = self.write("wrong.step", lines)
            finished = self.fill(source)
            # OCCT may drop what it does not find, and read the rest.
            self.assertIn(finished.code, (UNREADABLE, DONE, OUT_OF_TOLERANCE), str(finished))
            if finished.code == UNREADABLE:
                self.expect_refused(finished, UNREADABLE, "wrong.step")
                self.assertEqual(self.output.read_bytes(), OLD)
            self.output.write_bytes(OLD)

    def test_step_with_an_unresolved_reference_in_the_product_tree(self):
        whole = example("suitcase_corner").read_text()
        self.assertIn("SHAPE_DEFINITION_REPRESENTATION(#4,#10)", whole)
        source = self.write(
            "unresolved.step",
            whole.replace("SHAPE_DEFINITION_REPRESENTATION(#4,#10)",
                          "SHAPE_DEFINITION_REPRESENTATION(#4,#99999)"),
        )
        self.expect_refused(self.fill(source), UNREADABLE, "unresolved.step")
        self.assertEqual(self.output.read_bytes(), OLD)

    def test_crash_of_the_reader_is_one_line_and_a_document(self):
        whole = example("suitcase_corner").read_text()
        source = self.write("crash.step", whole.replace("#4,#10)", "#4,#99999)"))
        finished = run("inspect", source, "--json")
        self.expect(finished, UNREADABLE)
        self.assertEqual(finished.json["error"]["code"], "unreadable")
        self.assertEqual(len(finished.err.splitlines()), 1, str(finished))

    def test_iges_with_integers_for_reals(self):
        iges = self.folder / "box.iges"
        self.expect(run("convert", example("box_without_lid"), iges), DONE)
        broken = self.folder / "broken.iges"
        lines = iges.read_text().splitlines(keepends=True)
        # The parameter section has a P in column 73.
        changed = [
            line[:64].replace("0.,", "0,").ljust(64) + line[64:] if line[72:73] == "P" else line
            for line in lines
        ]
        broken.write_text("".join(changed))
        self.assertNotEqual(lines, changed)
        finished = self.fill(broken)
        self.assertIn(finished.code, (DONE, UNREADABLE), str(finished))
        if finished.code == UNREADABLE:
            self.assertEqual(len(finished.err.splitlines()), 1, str(finished))
            self.assertEqual(self.output.read_bytes(), OLD)


class SlowRead(Case):
    def test_reading_is_given_up_after_the_time_limit(self):
        slow = write_slow_brep(self.folder)
        finished = run("inspect", slow, "--read-timeout", "0.5", timeout=30)
        self.expect_refused(finished, UNREADABLE, "slow.brep", "0.5 s", "--read-timeout")

    def test_slow_file_is_read_in_the_end(self):
        slow = write_slow_brep(self.folder)
        self.expect(run("inspect", slow), DONE)

    def test_fifo_does_not_block_for_ever(self):
        fifo = self.folder / "pipe.step"
        os.mkfifo(fifo)
        finished = run("inspect", fifo, "--read-timeout", "1", timeout=30)
        self.expect_refused(finished, UNREADABLE, "pipe.step")


class BadOutput(Case):
    def fill(self, output, *words, name="box_without_lid"):
        return run("fill", example(name), "-o", output, *words)

    def test_folder_as_output(self):
        self.expect_refused(self.fill(self.folder), USAGE)
        named = self.folder / "folder.step"
        named.mkdir()
        self.expect_refused(self.fill(named), USAGE, "is a folder")

    def test_missing_folder(self):
        self.expect_refused(self.fill(self.folder / "no" / "out.step"), USAGE, "no folder")

    def test_unknown_ending(self):
        self.expect_refused(self.fill(self.folder / "out.dwg"), USAGE, ".dwg")

    def test_output_equal_to_input(self):
        part = self.folder / "part.step"
        part.write_bytes(example("box_without_lid").read_bytes())
        same_by_link = self.folder / "link.step"
        same_by_link.symlink_to(part)
        before = part.read_bytes()
        for output in (part, self.folder / "." / "part.step", same_by_link):
            self.expect_refused(run("fill", part, "-o", output), USAGE, "--force")
            self.assertEqual(part.read_bytes(), before)
        self.expect(run("fill", part, "-o", part, "--force"), DONE)
        self.assertNotEqual(part.read_bytes(), before)
        self.expect(run("check", part), DONE)

    def test_folder_that_takes_no_files(self):
        output = "/proc/out.step"
        finished = self.fill(output)
        self.assertIn(finished.code, (USAGE, INTERNAL), str(finished))
        self.assertEqual(len(finished.err.splitlines()), 1, str(finished))
        self.assertFalse(os.path.exists(output))

    def test_full_disk_leaves_the_old_file(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mount = subprocess.run(
            ["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", disk],
            capture_output=True,
            check=False,
        )
        if mount.returncode != 0:
            self.skipTest("no right to mount a small disk: " + mount.stderr.decode().strip())
        self.addCleanup(subprocess.run, ["umount", disk], check=False)
        for name in ("out.step", "out.stl", "out.brep", "out.3mf", "out.iges"):
            output = disk / name
            output.write_bytes(OLD)
            finished = self.fill(output, "--deflection=0.005", name="bump_window")
            self.expect_refused(finished, INTERNAL, name, "No space left")
            self.assertEqual(output.read_bytes(), OLD)
            self.assertEqual(os.listdir(disk), [name])
            output.unlink()

    def test_output_that_is_no_ordinary_file(self):
        fifo = self.folder / "fifo.step"
        os.mkfifo(fifo)
        self.expect_refused(run("fill", example("dome_window"), "-o", fifo), USAGE, "fifo.step", "ordinary")

    @unittest.skipIf(os.geteuid() == 0, "root writes everywhere")
    def test_output_that_is_write_protected(self):
        self.output.chmod(0o444)
        self.expect_refused(self.fill(example("dome_window")), USAGE, "out.step", "Permission denied")
        self.assertEqual(self.output.read_bytes(), OLD)

    def test_full_disk_behind_stdout(self):
        for words in (["inspect", example("dome_window")], ["methods", "--json"], ["--help"]):
            with open("/dev/full", "wb", buffering=0) as full:
                done = subprocess.run([PROGRAM, *words], stdout=full, stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, INTERNAL, words)
            self.assertEqual(done.stderr.decode().splitlines(),
                             ["error: the result cannot be written to stdout: No space left on device"], words)

    def test_nobody_at_stdout_is_no_failure(self):
        for redirection in (">&-", "| true"):
            script = f'{{ "$0" inspect "$1"; echo $? >&2; }} {redirection}'
            done = subprocess.run(["sh", "-c", script, PROGRAM, example("dome_window")],
                                  stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.stderr.decode(), f"{DONE}\n", redirection)

    def test_full_disk_for_the_report(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mount = subprocess.run(
            ["mount", "-t", "tmpfs", "-o", "size=4k", "tmpfs", disk], capture_output=True, check=False
        )
        if mount.returncode != 0:
            self.skipTest("no right to mount a small disk: " + mount.stderr.decode().strip())
        self.addCleanup(subprocess.run, ["umount", disk], check=False)
        finished = self.fill(
            self.folder / "out.step", "--report", disk / "r.json", name="bump_window"
        )
        self.expect_refused(finished, INTERNAL, "r.json")
        self.assertEqual(os.listdir(disk), [])


if __name__ == "__main__":
    unittest.main()
