"""The words, the fingerprints, and the repository as an addon."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from headless import CORNER, EXAMPLES, ROOT, Case, example  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import combs, exchange, meshes  # noqa: E402
from suture_workbench.errors import in_freecads_words  # noqa: E402
from suture_workbench.said import failure  # noqa: E402
from suture_workbench.options import FillOptions  # noqa: E402
from time_limits import limit  # noqa: E402


class Words(Case):
    def test_numbers_are_written_as_freecad_does(self):
        self.assertEqual(
            in_freecads_words("edge 9 (face 3) and edges 12, 13 and 14"),
            "Edge9 (Face3) and Edge12, Edge13 and Edge14",
        )
        self.assertEqual(failure("edge 9 of faces 3 and 4, edge 9, edge 2").edges, (9, 2))

    def test_a_fingerprint_changes_with_the_shape_alone(self):
        shape = example()
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.brep")
            shape.exportBrep(path)
            again = Part.Shape()
            again.importBrep(path)
        self.assertEqual(exchange.fingerprint(shape), exchange.fingerprint(again))
        moved = shape.translated(App.Vector(0, 0, 1e-3))
        self.assertNotEqual(exchange.fingerprint(shape), exchange.fingerprint(moved))
        other = example()
        other.reverse()
        self.assertNotEqual(exchange.fingerprint(shape), exchange.fingerprint(other))

    def test_faces_are_traced_back_or_not_at_all(self):
        self.assertEqual(exchange.face_origins([3], 3, 4), [0, 1, None, 2])
        self.assertIsNone(exchange.face_origins([3], 3, 5))

    def test_meshes_have_the_surfaces_normals_also_where_there_is_none(self):
        sphere = Part.makeSphere(5).Faces[0]
        points, normals, triangles = meshes.mesh_of(sphere, 0.05)
        self.assertGreater(len(triangles), 100)
        for point, normal in zip(points, normals):
            self.assertLess((App.Vector(*normal) - App.Vector(*point) / 5).Length, 1e-6)
        cone = next(f for f in Part.makeCone(5, 0, 9).Faces if "Cone" in f.Surface.TypeId)
        _, normals, _ = meshes.mesh_of(cone, 0.05)
        for normal in normals:
            self.assertAlmostEqual(App.Vector(*normal).Length, 1.0, delta=1e-9)

    def test_combs_measure_the_curvature_across_an_edge(self):
        box = Part.makeBox(10, 10, 10)
        solid = box.makeFillet(2, [box.Edges[0]])
        fillet = next(f for f in solid.Faces if "Cylinder" in f.Surface.TypeId)
        straight = next(e for e in fillet.Edges if "Line" in e.Curve.TypeId)
        comb = combs.across(straight, fillet)
        for curvature in comb.curvatures:
            self.assertAlmostEqual(abs(curvature), 0.5, delta=1e-9)
        middle = App.Vector(5, 5, 5)
        for foot, tip in combs.hairs(comb, 1.0)[:-1]:
            self.assertGreater(
                (tip - middle).Length, (foot - middle).Length, "outside of what bends"
            )
        plane = next(f for f in combs.faces_at(solid, 1) if "Plane" in f.Surface.TypeId)
        flat = combs.across(plane.Edges[0], plane)
        self.assertEqual((len(flat.curvatures), max(map(abs, flat.curvatures))), (41, 0.0))
        ball = Part.makeSphere(5, App.Vector(), App.Vector(0, 0, 1), 0, 90)
        (round_face,) = (face for face in ball.Faces if "Sphere" in face.Surface.TypeId)
        rim = next(n for n, e in enumerate(ball.Edges, 1) if not e.Degenerated and e.isClosed())
        comb = combs.across(ball.Edges[rim - 1], round_face)
        self.assertEqual(len(comb.curvatures), 41)
        for curvature in comb.curvatures:
            self.assertAlmostEqual(abs(curvature), 0.2, delta=1e-9)
        self.assertGreater(len(combs.at_edges(ball, range(1, len(ball.Edges) + 1))), 2)
        arc = next(e for e in fillet.Edges if "Circle" in e.Curve.TypeId)
        self.assertLess(max(map(abs, combs.across(arc, fillet).curvatures)), 1e-9)

    def test_options_that_do_not_exist_are_refused(self):
        self.assertRaises(TypeError, FillOptions, colour="red")


class Addon(Case):
    def run_freecadcmd(self, script):
        """Runs a script in FreeCADCmd with the repository linked into Mod. Result   what it wrote"""
        with tempfile.TemporaryDirectory(prefix="suture-home-") as folder:
            folder = Path(folder)
            (folder / "Mod").mkdir()
            (folder / "Mod" / "AnyName").symlink_to(ROOT)
            out, file = folder / "out.json", folder / "script.py"
            file.write_text(
                "import json, sys, traceback\n"
                "def said(value):\n"
                f"    open({str(out)!r}, 'w').write(json.dumps(value))\n"
                "try:\n"
                + "".join(f"    {line}\n" for line in script.splitlines())
                + "except Exception:\n    traceback.print_exc()\n    sys.exit(1)\nsys.exit(0)\n"
            )
            done = subprocess.run(
                ["freecadcmd", str(file)],
                env=os.environ | {"FREECAD_USER_HOME": str(folder)},
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                timeout=limit(120),
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(out.read_text(encoding="utf-8"))

    def test_the_repository_linked_into_mod_is_an_addon(self):
        types = self.run_freecadcmd(
            "import FreeCAD, suture_workbench\n" "said(FreeCAD.getExportType())"
        )
        self.assertIn("suture_workbench.export_step", json.dumps(types))
        self.assertIn("suture_workbench.export_iges", json.dumps(types))

    def test_every_command_works_in_freecadcmd(self):
        example_file = str(EXAMPLES / "suitcase_corner.step")
        said = self.run_freecadcmd(
            "import FreeCAD, Import\n"
            "from suture_workbench import api\n"
            "d = FreeCAD.newDocument()\n"
            f"Import.insert({example_file!r}, d.Name)\n"
            "base = d.Objects[-1]\n"
            "hole = api.find_holes(base).report.holes[0]\n"
            "filled = api.fill(base, edges=hole.edges[:1], method='mvs')\n"
            "said([hole.edges, filled.Shape.ShapeType, api.check(filled).near_misses])"
        )
        self.assertEqual(said, [CORNER, "Solid", 0])

    def test_the_manifest_names_what_is_there(self):
        meta = App.Metadata(str(ROOT / "package.xml"))
        workbench = meta.Content["workbench"][0]
        folder = ROOT / workbench.Subdirectory
        self.assertTrue((folder / "InitGui.py").is_file())
        self.assertIn(
            f"class {workbench.Classname}", (folder / "InitGui.py").read_text(encoding="utf-8")
        )
        self.assertTrue((folder / workbench.Icon).is_file())
        self.assertTrue((ROOT / meta.Icon).is_file())
        self.assertTrue(meta.supportsCurrentFreeCAD())
        kinds = {url["type"] for url in meta.Urls}
        self.assertEqual(kinds, {"repository", "readme", "bugtracker", "documentation"})
        self.assertEqual([entry["package"] for entry in meta.Depend], ["part"])


if __name__ == "__main__":
    unittest.main()
