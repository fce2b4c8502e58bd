"""What a user reads: one line for each wrong input, with the next step; and output that fits a screen."""

import gzip
import json
import os
import shutil
import struct
import subprocess
import unittest
import zipfile

from program import CAD, DONE, OUT_OF_TOLERANCE, PROGRAM, UNREADABLE, USAGE, Case, example, run
from time_limits import limit

STEP_MODEL = "as STEP, IGES or BREP"
MESH = "facets have no smooth surfaces to join; give the STEP file that it was made from"
CAD_FILE = "export it there as STEP"

# Name, content, what the line says.
FOREIGN = (
    ("a.stl", b"solid a\n facet normal 0 0 1\n", "is a mesh (STL)", MESH),
    ("binary.stl", bytes(80) + struct.pack("<I", 1) + bytes(50), "is a mesh (STL)", MESH),
    ("named.step", b"solid a\n facet normal 0 0 1\n", "is a mesh (STL)", MESH),
    ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "is a mesh (OBJ)", MESH),
    ("a.off", b"OFF\n3 1 0\n", "is a mesh (OFF)", MESH),
    ("a.ply", b"ply\nformat ascii 1.0\n", "is a mesh (PLY)", MESH),
    ("a.glb", b"glTF\x02\0\0\0", "is a mesh (glTF)", MESH),
    ("a.gltf", b'{"asset": {"version": "2.0"}}', "is a mesh (glTF)", MESH),
    ("a.3dm", b"3D Geometry File Format        5", "is a file of Rhino", CAD_FILE),
    ("a.x_t", b"**ABCDEFGHIJKLMNOPQRSTUVWXYZ****", "is a file of Parasolid", CAD_FILE),
    ("a.sat", b"700 0 1 0\n@33 Autodesk\n", "is a file of ACIS", CAD_FILE),
    ("a.sldprt", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "is a file of SolidWorks", CAD_FILE),
    ("a.CATPart", b"V5_CFV2\0", "is a file of CATIA", CAD_FILE),
    ("a.scad", b"cube(10);\n", "is an OpenSCAD script", "docs/openscad.md"),
    ("a.csg", b"cube(size = [10, 10, 10]);\n", "is an OpenSCAD script", "docs/openscad.md"),
    ("a.dxf", b"0\nSECTION\n2\nHEADER\n", "is a drawing (DXF)", STEP_MODEL),
    ("a.dwg", b"AC1027\0\0", "is a drawing (DWG)", STEP_MODEL),
    ("a.png", b"\x89PNG\r\n\x1a\n", "is a picture (PNG)", STEP_MODEL),
    ("a.jpg", b"\xff\xd8\xff\xe0", "is a picture (JPEG)", STEP_MODEL),
    ("a.pdf", b"%PDF-1.4\n", "is a document (PDF)", STEP_MODEL),
    ("a.step.xz", b"\xfd7zXZ\0", "is packed (xz)", "unpack it first"),
    ("page.step", b"<!DOCTYPE html>\n<html><body>404</body></html>", "is a web page", "download the model itself"),
    ("lfs.step", b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "Git LFS", "git lfs pull"),
    ("letter.step", b"Dear Sir,\n", "is of no known type", "neither STEP, IGES, BREP nor FCStd"),
    ("cut.step.gz", gzip.compress(b"ISO-10303-21;\n" * 99)[:-12], "cannot be unpacked", "cut off"),
    ("bad.step.gz", b"\x1f\x8b\x08\0\0\0\0\0\0\3" + b"\xff" * 40, "cannot be unpacked", "damaged"),
    ("cut.stpz", b"PK\3\4" + bytes(60), "cannot be unpacked", "zip"),
)

# The words after `suture`, {in} and {out} being files, and what the line says.
WORDS = (
    ("fill {in} {out}", "the output is named with -o: suture fill {in} -o {out}"),
    ("fill {in} --out {out}", "there is no option --out, did you mean --output?"),
    ("fill {in}", "say with -o where to write: suture fill IN -o OUT"),
    ("fill {in} -o", "--output needs a value after it"),
    ("fill {in} -o {out} --tolerance tight", "--tolerance takes a number, not 'tight'"),
    ("fill {in} -o {out} --hole", "--hole needs a value after it"),
    ("fill {in} -o {out} -o {out}", "--output is given 2 times"),
    ("fill -o {out}", "name the model to read"),
    ("convert {in}", "name the file to write, after the model"),
    ("methods here", "these words have no meaning here: here"),
    ("check {in} --jsn", "there is no option --jsn, did you mean --json?"),
    ("check {in} --quiet --verbose", "--verbose"),
    ("chek {in}", "there is no command 'chek', did you mean 'check'?"),
)


class WrongInput(Case):
    def test_every_foreign_format_is_named_with_the_next_step(self):
        for name, content, *said in FOREIGN:
            with self.subTest(name):
                file = self.folder / name
                file.write_bytes(content)
                self.expect_refused(run("inspect", file), UNREADABLE, file, *said)

    def test_archives_without_one_model_are_told(self):
        for name, entries, *said in (
            ("a.3mf", ["[Content_Types].xml", "3D/3dmodel.model"], "is a mesh (3MF)", MESH),
            ("a.zip", ["readme.txt"], "an archive without a STEP, IGES or BREP file"),
            ("a.f3d", ["Manifest.dat"], "is a file of Fusion", CAD_FILE),
            ("two.zip", ["a.step", "b/c.STP"], "holds 2 models (a.step, b/c.STP)", "give one"),
        ):
            file = self.folder / name
            with zipfile.ZipFile(file, "w") as archive:
                for entry in entries:
                    archive.writestr(entry, "x")
            self.expect_refused(run("inspect", file), UNREADABLE, file, *said)

    def test_every_wrong_word_has_its_line(self):
        names = {"in": example("box_without_lid"), "out": self.folder / "out.step"}
        for words, said in WORDS:
            with self.subTest(words):
                self.expect_refused(run(*words.format(**names).split()), USAGE, said.format(**names))
        self.expect_files()

    def test_a_browser_that_is_not_there_is_named(self):
        for named, said in (("/no/browser", "/no/browser"), ("no-such-browser", "no-such-browser")):
            finished = run("check", example("dome_window"), "--picture", self.folder / "p.png",
                           env={**os.environ, "SUTURE_BROWSER": named})
            self.expect_refused(finished, USAGE, "SUTURE_BROWSER names", said, "no such program")


class Packed(Case):
    def same_holes(self, file):
        finished = self.expect(run("inspect", file, "--json"), DONE).json
        self.assertEqual(finished["hole_count"], 1)
        return finished

    def test_gzip_and_zip_are_read(self):
        plain = example("suitcase_corner").read_bytes()
        packed = self.folder / "corner.step.gz"
        packed.write_bytes(gzip.compress(plain[:1000]) + gzip.compress(plain[1000:]))  # as `cat a.gz b.gz`
        self.same_holes(packed)
        shutil.copy(packed, self.folder / "corner.stpZ")
        self.same_holes(self.folder / "corner.stpZ")
        for entries in (["part/corner.STP"], ["ISO-10303-21.txt", "picture.png"]):
            archive = self.folder / "corner.stpz"
            with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as made:
                for entry in entries:
                    made.writestr(entry, plain)
            self.same_holes(archive)
        filled = run("fill", packed, "-o", self.folder / "filled.step")
        self.expect(filled, DONE)

    def test_an_archive_with_a_wrong_sum_is_refused(self):
        archive = self.folder / "corner.stpz"
        with zipfile.ZipFile(archive, "w") as made:  # stored, so that the bytes stand as they are
            made.writestr("corner.step", example("suitcase_corner").read_bytes())
        archive.write_bytes(archive.read_bytes().replace(b"ADVANCED_FACE", b"ADVANCED_FECE", 1))
        self.expect_refused(run("inspect", archive), UNREADABLE, archive, "cannot be unpacked", "CRC")

    @unittest.skipUnless(shutil.which("freecadcmd"), "freecadcmd is not installed")
    def test_a_freecad_document_gives_its_visible_shapes_in_place(self):
        script = self.folder / "make.py"
        file = self.folder / "made.FCStd"
        script.write_text(
            "import FreeCAD, Part\n"
            "d = FreeCAD.newDocument('made')\n"
            "open = d.addObject('Part::Feature', 'Open'); open.Label = 'Open box'\n"
            "box = Part.makeBox(3, 4, 5)\n"
            "open.Shape = Part.makeShell(box.Faces[:5])\n"
            "holder = d.addObject('App::Part', 'Holder'); holder.Placement.Base = FreeCAD.Vector(100, 0, 0)\n"
            "open.Placement.Base = FreeCAD.Vector(0, 20, 0)\n"
            "holder.addObject(open)\n"
            "body = d.addObject('PartDesign::Body', 'Body')\n"
            "body.newObject('PartDesign::AdditiveBox', 'Inner')\n"
            "hidden = d.addObject('Part::Box', 'Hidden'); hidden.Visibility = False\n"
            "link = d.addObject('App::Link', 'Link'); link.LinkedObject = open\n"
            f"d.recompute(); d.saveAs({str(file)!r})\n")
        subprocess.run(["freecadcmd", script], stdin=subprocess.DEVNULL, capture_output=True,
                       timeout=limit(120), check=True)
        finished = run("inspect", file, "--json")
        self.expect(finished, DONE)
        self.assertIn("links to other objects are left out (1)", finished.err)
        hole, = finished.json["holes"]
        self.assertEqual(hole["part"], "Open box")
        self.assertEqual({p[0] for p in (c["point"] for c in hole["corners"])}, {100, 103})  # of the App::Part, and the box
        self.assertEqual({p[1] for p in (c["point"] for c in hole["corners"])}, {20, 24})
        step = self.folder / "made.step"
        self.expect(run("convert", file, step), DONE)
        text = step.read_text()
        self.assertEqual(text.count("= ADVANCED_FACE("), 5 + 6)  # not the hidden box, the body once
        self.assertIn("'Open box'", text)
        self.expect_refused(run("convert", step, self.folder / "out.FCStd"), USAGE, ".FCStd")


class Piped(Case):
    """`-` is standard input; a pipe can be read once only, the program reads more than once."""

    def piped(self, file, *words, **options):
        with subprocess.Popen(["cat", file], stdout=subprocess.PIPE) as cat:
            return run(*words, stdin=cat.stdout, **options)

    def test_every_format_is_read_from_a_pipe(self):
        step = example("suitcase_corner")
        packed = self.folder / "corner.step.gz"
        packed.write_bytes(gzip.compress(step.read_bytes()))
        iges, brep = self.folder / "corner.iges", self.folder / "corner.brep"
        for other in (iges, brep):
            self.expect(run("convert", step, other), DONE)
        for file in (step, packed, iges, brep):
            with self.subTest(file.name):
                self.assertEqual(self.expect(self.piped(file, "inspect", "-", "--json"), DONE).json["hole_count"], 1)
        with step.open("rb") as stream:  # a file itself
            self.expect(run("inspect", "-", stdin=stream), DONE)

    def test_a_fill_from_a_pipe_is_that_of_the_file(self):
        piped, plain = self.folder / "piped.json", self.folder / "plain.json"
        self.expect(self.piped(example("suitcase_corner"), "fill", "-", "-o", self.folder / "a.step", "--report", piped), DONE)
        self.expect(run("fill", example("suitcase_corner"), "-o", self.folder / "b.step", "--report", plain), DONE)
        holes = [json.loads(file.read_text())["holes"][0] for file in (piped, plain)]
        self.assertEqual(holes[0]["max_gap"], holes[1]["max_gap"])
        self.assertEqual(holes[0]["patches"], holes[1]["patches"])

    def test_what_is_wrong_with_it_is_told(self):
        for content, *said in ((b"", "standard input is empty"), (b"solid a\n facet normal 0 0 1\n", "standard input", MESH),
                               (b"ISO-10303-21;\nHEADER;\n", "standard input")):
            file = self.folder / "wrong"
            file.write_bytes(content)
            self.expect_refused(self.piped(file, "inspect", "-"), UNREADABLE, *said)
        main, side = os.openpty()
        self.addCleanup(os.close, main)
        self.addCleanup(os.close, side)
        self.expect_refused(run("inspect", "-", stdin=side), USAGE, "pipe a model into it")


class Screen(Case):
    def fill(self, *words, name="suitcase_corner", code=DONE):
        return self.expect(run("fill", example(name), "-o", self.folder / "out.step", *words), code)

    def test_no_words_print_the_help(self):
        finished = self.expect(run(), USAGE)
        self.assertEqual(finished.out, run("--help").out)
        self.assertEqual(finished.err, "")

    def test_fill_prints_a_line_for_each_hole_and_the_verdict(self):
        lines = self.fill().out.splitlines()
        self.assertEqual(lines[0], "Holes")
        self.assertRegex(lines[2], r"^ +1 +3 +\w+ +G[12] .* good$")
        self.assertEqual(len(lines), 5)
        self.assertIn("filled 1 of 1 hole", lines[-1])
        self.assertLessEqual(max(map(len, lines[:-1])), 100)
        self.assertIn("hole 1: ", self.fill("-v").out)  # every method's reason

    def test_a_refused_hole_names_the_next_step(self):
        lines = self.fill("--method", "plane", code=OUT_OF_TOLERANCE).out.splitlines()
        self.assertLessEqual(max(map(len, lines[:-1])), 100)
        self.assertIn("next: -v says why", lines[-2])

    def test_check_prints_what_does_not_pass(self):
        finished = self.expect(run("check", example("suitcase_corner")), DONE)
        self.assertNotIn("Edges", finished.out)
        self.assertIn("all of ", finished.out.splitlines()[-1])
        every = self.expect(run("check", example("suitcase_corner"), "-v"), DONE)
        self.assertIn("Edges, the worst first", every.out)

    @unittest.skipUnless(CAD.is_dir(), "no CAD files")
    def test_check_of_a_faulty_model_fits_a_screen(self):
        finished = self.expect(run("check", CAD / "files" / "nist_ctc_05_asme1_rd.stp"),
                               OUT_OF_TOLERANCE)
        lines = finished.out.splitlines()
        self.assertLessEqual(len(lines), 36)
        self.assertIn("next: --report R.html", lines[-2])

    def test_quiet_leaves_the_exit_code_alone(self):
        finished = self.fill("--quiet", "--method", "plane", code=OUT_OF_TOLERANCE)
        self.assertEqual((finished.out, finished.err), ("", ""))
        self.assertEqual(self.fill("-q", "--json").json["holes"][0]["status"], "filled")
        self.expect_refused(run("inspect", self.folder / "nowhere.step", "-q"), UNREADABLE, "nowhere.step")
        self.assertEqual(self.fill("-q", "--progress", "bar").err, "")


if __name__ == "__main__":
    unittest.main()
