"""Fills are as good in the written file as in memory, for FreeCAD's Part module too.

In memory is what a BREP file has, which keeps every bit and every tolerance.
"""

import json
import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "bench")]

from program import BUILD, SOURCE, SUTURE, run  # noqa: E402
from time_limits import limit  # noqa: E402

FILL_LIMIT = limit(300)  # seconds
TRUST = SOURCE / "../shared/cases/trust"
EXAMPLES = SOURCE / "docs/examples"
FOLDER = BUILD / "tests/verify/written"
GROWTH, ROUNDING_MM, ROUNDING_DEG = 1.5, 1e-6, 1e-4
RELATIVE = 0.01  # how well two measurements agree


def fill(model, output, *extra):
    """The hole's entry in the report."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    output.unlink(missing_ok=True)
    done = run([SUTURE, "fill", model, "-o", output, "--json", *extra], FILL_LIMIT)
    assert output.exists(), done.err
    return next(hole for hole in done.document()["holes"] if hole["status"] == "filled")


class Written(unittest.TestCase):
    def setUp(self):
        try:
            import shapes
        except ImportError as error:
            self.skipTest(f"no FreeCAD: {error}")
        self.shapes = shapes

    def assert_survives(self, model, *extra):
        if not model.exists():
            self.skipTest(f"no {model}")
        memory = fill(model, FOLDER / f"{model.stem}.brep", *extra)
        for ending in ("step", "iges"):
            with self.subTest(ending):
                file = FOLDER / f"{model.stem}.{ending}"
                entry = fill(model, file, *extra)
                for key, rounding in (("max_gap", ROUNDING_MM), ("max_angle_deg", ROUNDING_DEG)):
                    self.assertLessEqual(
                        entry[key], max(GROWTH * memory[key], memory[key] + rounding), key
                    )
                if ending == "step":
                    self.assert_freecad_agrees(model, file, entry)

    def assert_freecad_agrees(self, model, file, entry):
        before, after = self.shapes.read(model), self.shapes.read(file)
        added = self.shapes.Comparison(before, after).added
        self.assertEqual(len(added), len(entry["patches"]))
        gap, _ = self.shapes.largest_gap_and_angle(after, added)
        self.assertAlmostEqual(gap, entry["max_gap"], delta=max(RELATIVE * gap, ROUNDING_MM))
        own = max(edge.Tolerance for edge in before.Edges)
        for facts in added:
            for edge in facts.face.Edges:
                self.assertLessEqual(edge.Tolerance, max(GROWTH * entry["max_gap"], own))
        try:
            after.check(True)
        except Exception as error:  # FreeCAD's own kind
            self.assertNotIn("CurveOnSurface", str(error))

    def test_strips(self):
        self.assert_survives(TRUST / "strips4.step")

    def test_soapbar(self):
        self.assert_survives(TRUST / "soapbar.step", "--continuity", "G1", "--method", "mvs")

    def test_boss(self):
        self.assert_survives(TRUST / "boss_without_fillet.step", "--hole", "1+2")

    def test_suitcase_corner(self):
        self.assert_survives(EXAMPLES / "suitcase_corner.step")

    def test_loose_layout(self):
        """Edges grow by the gap, not by how far the layout is off."""
        model = TRUST / "loose_tol.brep"
        if not model.exists():
            self.skipTest(f"no {model}")
        for ending in ("brep", "step"):
            # Sewn, its sheets would meet within their stated tolerance of 0.025.
            entry = fill(model, FOLDER / f"loose.{ending}", "--no-sew")
            shape = self.shapes.read(FOLDER / f"loose.{ending}")
            self.assertLess(entry["max_gap"], 3e-4)
            self.assertLessEqual(
                max(edge.Tolerance for edge in shape.Edges), GROWTH * entry["max_gap"]
            )

    def test_void(self):
        """A body whose void has lost a face: a void again, no second solid."""
        Part, vector = self.shapes.Part, self.shapes.FreeCAD.Vector
        hollow = Part.makeBox(6, 6, 6, vector(7, 7, 7))
        hollow = hollow.makeFillet(1, hollow.Edges[:1])
        body = Part.makeBox(20, 20, 20).cut(hollow)
        FOLDER.mkdir(parents=True, exist_ok=True)
        whole, file = FOLDER / "void-whole.step", FOLDER / "void.step"
        body.exportStep(str(whole))
        # The last CLOSED_SHELL is that of the void: it loses a plane.
        text = whole.read_text(encoding="latin-1").replace("\n", "")
        start = text.rindex("= CLOSED_SHELL('',(") + len("= CLOSED_SHELL('',(")
        faces = text[start : text.index(")", start)].split(",")
        text = text[:start] + ",".join(faces[:2] + faces[3:]) + text[text.index(")", start) :]
        file.write_text(text.replace(";", ";\n"), encoding="latin-1")
        open_shells = [shell for shell in self.shapes.read(file).Shells if not shell.isClosed()]
        self.assertEqual(len(open_shells), 1)
        fill(file, FOLDER / "void-filled.step")
        filled = self.shapes.read(FOLDER / "void-filled.step")
        self.assertEqual([len(solid.Shells) for solid in filled.Solids], [2])
        self.assertTrue(filled.isValid())
        self.assertAlmostEqual(filled.Volume, body.Volume, delta=1e-5 * body.Volume)

    def test_same_bytes(self):
        """Of models with colours, by processes at different addresses."""
        assembly = SOURCE / "../shared/cad/files/Reflector_Definition.step"
        part = SOURCE / "../shared/cad/files/0044_bb_boxblend_03_colored.stp"
        if not assembly.exists():
            self.skipTest(f"no {assembly}")
        os.environ["SOURCE_DATE_EPOCH"] = "951827696"
        try:
            for model, ending in (
                (assembly, "step"), (assembly, "brep"), (assembly, "3mf"), (part, "step"), (part, "iges"),
            ):  # fmt: skip
                contents = set()
                for k in range(3):
                    file = FOLDER / str(k) / f"same.{ending}"
                    file.parent.mkdir(parents=True, exist_ok=True)
                    done = run([SUTURE, "convert", model, file, "--open-ok", "--json"], FILL_LIMIT)
                    self.assertEqual(done.code, 0, done.err)
                    contents.add(file.read_bytes())
                    self.assertEqual(bool(json.loads(done.out)["lost"]), ending == "brep")
                self.assertEqual(len(contents), 1, f"{model.name} as {ending}")
        finally:
            del os.environ["SOURCE_DATE_EPOCH"]


if __name__ == "__main__":
    unittest.main()
