"""To OpenSCAD and back, as docs/openscad.md has it."""

import shutil
import subprocess
import sys
import unittest

from program import CAD, DONE, EXAMPLES, OUT_OF_TOLERANCE, Case, example, run
from time_limits import limit


def openscad(*words, cwd):
    return subprocess.run(["openscad", *words], cwd=cwd, capture_output=True, text=True, timeout=limit(200), check=False)


@unittest.skipUnless(shutil.which("openscad"), "openscad is not installed")
class OpenScad(Case):
    def test_the_example_engraves_a_filled_part(self):
        self.expect(run("fill", example("box_without_lid"), "-o", self.folder / "box.off", "--deflection=0.02"), DONE)
        shutil.copy(EXAMPLES / "suture.scad", self.folder)
        done = openscad("-D", 'part="box.off"', "-o", "engraved.stl", "suture.scad", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Simple: yes", " ".join(done.stderr.split()))
        self.assertGreater((self.folder / "engraved.stl").stat().st_size, 1000)

    @unittest.skipUnless(shutil.which("freecadcmd"), "freecadcmd is not installed")
    def test_a_script_becomes_step_with_exact_faces(self):
        (self.folder / "part.scad").write_text(
            "difference() { cube([30, 20, 10]); translate([15, 10, -1]) cylinder(r=4, h=12); }")
        subprocess.run([sys.executable, EXAMPLES / "scad_to_step.py", "part.scad", "part.step"], cwd=self.folder,
                       check=True, timeout=limit(200))
        shape = self.expect(run("check", self.folder / "part.step", "--json"), DONE).json["shape"]
        self.assertEqual((shape["solids"], shape["faces"], shape["closed"]), (1, 7, True))
        self.assertEqual((self.folder / "part.step").read_text().count("CYLINDRICAL_SURFACE("), 1)

    @unittest.skipUnless(CAD.is_dir(), "no CAD files")
    def test_render_takes_a_mesh_that_had_needles(self):
        file = CAD / "files" / "body_structure_bottom.STEP"
        for name in ("part.off", "part.stl"):
            finished = self.expect(run("convert", file, self.folder / name, "--json"), DONE)
            self.assertEqual(finished.json["mesh"]["open_edges"], 0)
            self.assertGreater(finished.json["mesh"]["needles_removed"], 0)
        # With one more body, so that the exact arithmetic is used.
        (self.folder / "in.scad").write_text('intersection() { import("part.stl"); translate([-500, -500, -500]) cube(1000); }')
        done = openscad("--render", "-o", "out.off", "in.scad", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("ERROR", done.stderr)


class OpenMeshes(Case):
    def test_a_face_that_cannot_be_meshed_is_named(self):
        script = self.folder / "make.py"
        script.write_text(f"""
import sys
sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD, Part
crossed = Part.Face(Part.makePolygon([(0, 0, 0), (10, 10, 0), (10, 0, 0), (0, 10, 0), (0, 0, 0)]))
Part.Compound([Part.makeBox(30, 20, 5), crossed]).exportBrep({str(self.folder / "both.brep")!r})
""")
        subprocess.run([sys.executable, script], check=True, capture_output=True, timeout=limit(100))
        finished = self.expect(run("convert", self.folder / "both.brep", self.folder / "both.off", "--open-ok"),
                               OUT_OF_TOLERANCE)
        self.assertIn("12 triangles; WITHOUT 1 face: face 7 could not be meshed: its boundary crosses itself\n",
                      finished.out)
        self.assertTrue((self.folder / "both.off").exists())

    @unittest.skipUnless(CAD.is_dir(), "no CAD files")
    def test_faces_that_have_collapsed_to_a_line_are_told_and_no_loss(self):
        wing = CAD / "files" / "simple_wing.stp"
        finished = self.expect(run("convert", wing, self.folder / "wing.off", "--open-ok"), DONE)
        self.assertIn("; 6 faces without area", finished.out)
        mesh = self.expect(run("convert", wing, self.folder / "wing.3mf", "--open-ok", "--json"), DONE).json["mesh"]
        self.assertEqual([face["face"] for face in mesh["faces_left_out"]], [1, 4, 5, 8, 9, 12])
        self.assertEqual({(face["part"], face["has_area"]) for face in mesh["faces_left_out"]}, {("prodname", False)})

    def test_an_open_model_is_told(self):
        mesh = self.folder / "box.stl"
        finished = self.expect(run("convert", example("box_without_lid"), mesh), OUT_OF_TOLERANCE)
        self.assertIn("the mesh is OPEN along 4 edges", finished.out)
        self.assertIn("--open-ok", finished.out)
        self.assertTrue(mesh.exists())
        finished = self.expect(run("convert", example("box_without_lid"), mesh, "--open-ok", "--json"), DONE)
        self.assertEqual(finished.json["mesh"]["open_edges"], 4)
        step = self.expect(run("convert", example("box_without_lid"), self.folder / "box.step", "--json"), DONE)
        self.assertNotIn("mesh", step.json)


if __name__ == "__main__":
    unittest.main()
