"""The Python API over the program: its doctests, shapes of other programs, progress, cancel, failures."""

import doctest
import os
import shutil
import sys
import tempfile
import threading
import types
import unittest
from pathlib import Path
from unittest import mock

SOURCE = Path(os.environ["SUTURE_SOURCE_DIR"])
os.environ["SUTURE_EXE"] = os.environ["SUTURE_PROGRAM"]
sys.dont_write_bytecode = True
sys.path.insert(0, str(SOURCE / "step_io/python"))

import suture  # noqa: E402
import suture.commands  # noqa: E402
import suture.shapes  # noqa: E402

CORNER = SOURCE / "docs/examples/suitcase_corner.step"
FREECAD = Path("/usr/lib/freecad-python3/lib")


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.mkdtemp(prefix="suture_python_")
        self.addCleanup(shutil.rmtree, folder)
        before = Path.cwd()
        self.addCleanup(os.chdir, before)
        os.chdir(folder)
        shutil.copy(CORNER, ".")


class Documentation(InFolder):
    def test_what_it_shows_is_so(self):
        tried = 0
        for module in (suture, suture.commands):
            done = doctest.testmod(module, optionflags=doctest.IGNORE_EXCEPTION_DETAIL)
            self.assertEqual(done.failed, 0)
            tried += done.attempted
        self.assertGreater(tried, 10)


class Filling(InFolder):
    def test_a_path_gives_its_output_and_a_page(self):
        result = suture.fill(CORNER, "out.step", page=True)
        self.assertEqual(result.shape, Path("out.step"))
        self.assertEqual(result.holes[0].method_used, "recognise")
        self.assertIn("<iframe srcdoc=", result._repr_html_())
        self.assertGreater(len(result.page), 100_000)
        self.assertTrue(suture.check("out.step").document["shape"]["closed"])

    def test_bytes_give_bytes(self):
        result = suture.fill(CORNER.read_bytes(), method="mvs")
        Path("again.step").write_bytes(result.shape)
        self.assertEqual(suture.check("again.step").document["shape"]["free_edges"], 0)

    def test_progress_goes_up_to_the_end(self):
        steps = []
        suture.fill(CORNER, "out.step", progress=lambda *step: steps.append(step))
        fractions = [fraction for fraction, _ in steps]
        self.assertEqual(fractions, sorted(fractions))
        self.assertGreater(fractions[-1], 0.9)
        self.assertIn("finding holes", [text for _, text in steps])

    def test_cancel_leaves_nothing_behind(self):
        cancel = threading.Event()
        with self.assertRaises(suture.Cancelled):
            # By a method that takes a while, or all is done before it is stopped.
            suture.fill(CORNER, "out.step", method="tube", cancel=cancel, progress=lambda *_: cancel.set())
        self.assertEqual(os.listdir("."), ["suitcase_corner.step"])

    def test_an_error_in_a_callback_stops_the_run_and_comes_through(self):
        def broken(fraction, stage):
            raise ValueError(stage)

        with self.assertRaisesRegex(ValueError, "reading"):
            suture.fill(CORNER, "out.step", progress=broken)

    def test_strict_carries_the_findings(self):
        with self.assertRaises(suture.OutOfTolerance) as caught:
            suture.fill(CORNER, "out.step", method="occt", strict=True)
        self.assertIn("angle", {finding.kind for finding in caught.exception.findings})
        worst = caught.exception.findings[0]
        self.assertGreater(worst.value, worst.limit)
        self.assertEqual(caught.exception.result.holes[0].status, "filled")

    def test_failures_are_exceptions_with_the_programs_words(self):
        for wrong, kind in (
            (lambda: suture.inspect("nowhere.step"), suture.Unreadable),
            (lambda: suture.fill(CORNER, method="nonsense"), suture.UsageError),
            (lambda: suture.inspect(b"no model"), suture.Unreadable),
        ):
            with self.assertRaises(kind) as caught:
                wrong()
            self.assertEqual(str(caught.exception), caught.exception.document["error"]["message"])
        with self.assertRaisesRegex(TypeError, "builtins.int"):
            suture.inspect(3)

    def test_without_a_program_it_says_so(self):
        with mock.patch.dict(os.environ, {"SUTURE_EXE": "", "PATH": "/nowhere"}):
            with self.assertRaises(suture.ProgramMissing):
                suture.version()


class Shapes(InFolder):
    @unittest.skipUnless(FREECAD.exists(), f"there is no {FREECAD}")
    def test_a_freecad_shape_comes_back_as_one(self):
        sys.path.append(str(FREECAD))
        import FreeCAD  # noqa: F401
        import Part

        box = Part.makeBox(1, 2, 3)
        for open_box in (Part.makeShell(box.Faces[:5]), types.SimpleNamespace(Shape=Part.makeShell(box.Faces[1:]))):
            result = suture.fill(open_box)
            self.assertEqual(type(result.shape).__module__, "Part")
            self.assertTrue(result.shape.isValid())
            self.assertAlmostEqual(result.shape.Volume, 6.0, places=9)

    def test_a_cadquery_workplane_comes_back_as_its_shape(self):
        """cadquery/occ_impl/shapes.py: exportBrep(self, f), and the class method importBrep(cls, f)."""

        class Shape:
            def __init__(self, content):
                self.content = content

            def exportBrep(self, f):
                Path(f).write_bytes(self.content)
                return True

            @classmethod
            def importBrep(cls, f):
                return cls(Path(f).read_bytes())

        suture.convert(CORNER, "corner.brep")
        shape = Shape(Path("corner.brep").read_bytes())
        workplane = types.SimpleNamespace(val=lambda: shape)  # Workplane.val(self)
        result = suture.fill(workplane, "out.step")
        self.assertIsInstance(result.shape, Shape)
        self.assertNotEqual(result.shape.content, shape.content)
        self.assertTrue(suture.check(result.shape).document["shape"]["closed"])
        self.assertTrue(suture.check("out.step").document["shape"]["closed"])

    def test_shapes_of_ocp_and_build123d_come_back(self):
        """OCP: BRepTools.Write_s(shape, file), Read_s(shape, file, builder); build123d: Shape.wrapped, Shape.cast."""
        ocp, solid = stand_in_for_ocp()
        suture.convert(CORNER, "corner.brep")
        solid.content = Path("corner.brep").read_bytes()

        class Shape:
            def __init__(self, wrapped):
                self.wrapped = wrapped

            @classmethod
            def cast(cls, wrapped):
                return cls(wrapped)

        with mock.patch.dict(sys.modules, ocp):
            for given, content in ((solid, lambda s: s), (Shape(solid), lambda s: s.wrapped)):
                result = suture.fill(given)
                self.assertIs(type(result.shape), type(given))
                Path("back.brep").write_bytes(content(result.shape).content)
                self.assertTrue(suture.check("back.brep").document["shape"]["closed"])


def stand_in_for_ocp():
    """The few names of OCP that are used. Result   its modules, and an empty shape"""

    class TopoDS_Shape:
        content = b""

    TopoDS_Shape.__module__ = "OCP.TopoDS"

    class BRepTools:
        @staticmethod
        def Write_s(shape, file):
            Path(file).write_bytes(shape.content)

        @staticmethod
        def Read_s(shape, file, builder):
            shape.content = Path(file).read_bytes()

    modules = {
        "OCP": types.ModuleType("OCP"),
        "OCP.TopoDS": types.SimpleNamespace(TopoDS_Shape=TopoDS_Shape),
        "OCP.BRepTools": types.SimpleNamespace(BRepTools=BRepTools),
        "OCP.BRep": types.SimpleNamespace(BRep_Builder=object),
    }
    return modules, TopoDS_Shape()


if __name__ == "__main__":
    unittest.main()
