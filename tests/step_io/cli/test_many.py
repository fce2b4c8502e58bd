"""Many files in one run: each for itself, done once, one summary, the exit code of the worst."""

import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROGRAM = os.environ["SUTURE_PROGRAM"]
EXAMPLES = Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs/examples"


class ManyFiles(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="suture_many_"))
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ("suitcase_corner", "box_without_lid"):
            shutil.copy(EXAMPLES / f"{name}.step", self.folder)

    def run_it(self, *words, code=0):
        done = subprocess.run(
            [PROGRAM, *map(str, words)],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def fill(self, *words, code=0):
        files = sorted(path.name for path in self.folder.glob("*.step"))
        done = self.run_it("fill", *files, "--out-dir", "out", "--json", *words, code=code)
        document = json.loads(done.stdout)
        self.assertEqual(document["exit_code"], code)
        return {entry["input"]: entry for entry in document["files"]}

    def test_every_file_has_its_output_and_document(self):
        files = self.fill("--method", "auto")
        self.assertEqual(set(files), {"box_without_lid.step", "suitcase_corner.step"})
        for name in files:
            document = json.loads((self.folder / "out" / f"{name}.json").read_text())
            self.assertTrue(document["closed"])
            checked = self.run_it("check", f"out/{name}", "--json").stdout
            self.assertEqual(json.loads(checked)["shape"]["free_edges"], 0)
        self.assertIn("suitcase_corner.step", (self.folder / "out/summary.html").read_text())
        self.assertEqual(json.loads((self.folder / "out/summary.json").read_text())["exit_code"], 0)

    def test_one_that_fails_stops_nothing_and_is_the_exit_code(self):
        (self.folder / "a_broken.step").write_text("ISO-10303-21;\nHEADER;\n")
        files = self.fill("--summary", "all.xml", "--summary", "all.csv", code=2)
        self.assertEqual(files["a_broken.step"]["status"], "unreadable")
        self.assertEqual(files["suitcase_corner.step"]["status"], "done")
        self.assertFalse((self.folder / "out/a_broken.step").exists())
        suite = ElementTree.parse(self.folder / "all.xml").getroot()[0]
        self.assertEqual([suite.get(key) for key in ("tests", "failures", "errors")], ["3", "0", "1"])
        self.assertEqual(len((self.folder / "all.csv").read_text().splitlines()), 4)

    def test_what_is_done_and_unchanged_is_not_done_again(self):
        self.fill()
        before = {path: path.stat().st_mtime_ns for path in (self.folder / "out").glob("*.step")}
        self.assertEqual([entry["kept"] for entry in self.fill().values()], [True, True])
        for path, time_before in before.items():
            self.assertEqual(path.stat().st_mtime_ns, time_before)
        self.assertEqual([e["kept"] for e in self.fill("--again").values()], [False, False])
        # Other words, another input, an output that is gone or cut off: each is done again.
        self.assertEqual([e["kept"] for e in self.fill("--angle", "0.02").values()], [False, False])
        source = self.folder / "box_without_lid.step"
        source.write_text(source.read_text().replace("FreeCAD Model", "Another model"))
        with (self.folder / "out/suitcase_corner.step").open("r+") as file:
            file.truncate(1000)
        self.assertEqual([e["kept"] for e in self.fill("--angle", "0.02").values()], [False, False])

    def test_the_exit_code_is_that_of_the_worst(self):
        self.assertEqual(self.fill("--method", "occt", code=4)["box_without_lid.step"]["status"], "done")
        closed = self.folder / "closed"
        self.run_it("fill", "box_without_lid.step", "--out-dir", closed)
        self.run_it("fill", closed / "box_without_lid.step", closed / "no.step", "--out-dir", "o", code=2)
        self.run_it("fill", closed / "box_without_lid.step", "--out-dir", "o", code=3)

    def test_check_and_inspect_and_convert_take_many_too(self):
        names = ("box_without_lid.step", "suitcase_corner.step")
        found = json.loads(self.run_it("inspect", *names, "--json", "--jobs", "2").stdout)
        self.assertEqual([e["verdict"] for e in found["files"]], ["1 hole", "1 hole"])
        self.run_it("check", *names, "--summary", "c.json")
        self.assertEqual(len(json.loads((self.folder / "c.json").read_text())["files"]), 2)
        self.run_it("convert", *names, "--out-dir", "meshes", "--to", ".stl", "--open-ok")
        self.assertGreater((self.folder / "meshes/suitcase_corner.stl").stat().st_size, 1000)

    def test_lists_of_numbers_are_no_files(self):
        two = ("box_without_lid.step", "suitcase_corner.step")
        self.run_it("fill", "--edges", "9", "1-30", *two, "--out-dir", "out", code=1)  # not in both
        self.run_it("fill", "--hole", "1", *two, "--out-dir", "out")
        self.assertEqual(len(list(self.folder.glob("out/*.step"))), 2)

    def test_names_of_different_folders_stay_apart(self):
        for sub in ("a", "b"):
            (self.folder / sub).mkdir()
            shutil.copy(EXAMPLES / "box_without_lid.step", self.folder / sub / "part.step")
        self.run_it("fill", "a/part.step", "b/part.step", "--out-dir", "out")
        self.assertTrue((self.folder / "out/a/part.step").exists())
        self.assertTrue((self.folder / "out/b/part.step").exists())

    def test_wrong_words_are_found_before_anything_is_done(self):
        two = ("box_without_lid.step", "suitcase_corner.step")
        for words, message in (
            (("fill", *two), "--out-dir"),
            (("fill", *two, "--out-dir", "out", "-o", "x.step"), "-o is for one file"),
            (("fill", *two, "--out-dir", "out", "--methd", "mvs"), "--methd"),
            (("fill", *two, "--out-dir", "out", "--jobs", "0"), "--jobs"),
            (("fill", *two, "--out-dir", "."), "would be written over"),
            (("fill", two[0], two[0], "--out-dir", "out"), "would both be written"),
            (("check", *two, "--summary", "x.pdf"), ".html, .json, .xml, .csv"),
        ):
            said = self.run_it(*words, code=1).stderr
            self.assertIn(message, said)
            self.assertEqual(len(said.splitlines()), 1)
        self.assertEqual(list(self.folder.glob("out/*.step")), [])

    def test_killed_in_the_middle_it_goes_on_where_it_was(self):
        for i in range(8):
            shutil.copy(EXAMPLES / "suitcase_corner.step", self.folder / f"c{i}.step")
        files = sorted(path.name for path in self.folder.glob("*.step"))
        words = [PROGRAM, "fill", *files, "--out-dir", "out", "--jobs", "2"]
        process = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.DEVNULL)
        while len(list(self.folder.glob("out/*.step.json"))) < 2:
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
        process.wait()
        done = len(list(self.folder.glob("out/*.step.json")))
        self.assertLess(done, len(files))
        for document in self.folder.glob("out/*.step.json"):
            self.assertTrue(json.loads(document.read_text())["closed"])
        entries = self.fill()
        self.assertGreaterEqual(sum(entry["kept"] for entry in entries.values()), done)
        self.assertEqual({entry["status"] for entry in entries.values()}, {"done"})

    def test_interrupted_it_tells_what_it_did_not_do(self):
        for i in range(8):
            shutil.copy(EXAMPLES / "suitcase_corner.step", self.folder / f"c{i}.step")
        files = sorted(path.name for path in self.folder.glob("*.step"))
        process = subprocess.Popen(
            [PROGRAM, "fill", *files, "--out-dir", "out", "--jobs", "1", "--json"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            text=True,
        )
        while not list(self.folder.glob("out/*.step.json")):
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        document = json.loads(process.communicate()[0])
        self.assertEqual(process.returncode, 130)
        states = [entry["status"] for entry in document["files"]]
        self.assertIn("not run", states)
        self.assertIn("done", states)


if __name__ == "__main__":
    unittest.main()
