"""What the tests of the workbench without a window share: FreeCAD, shapes, a document."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
PROGRAM = os.environ["SUTURE_PROGRAM"]
EXAMPLES = ROOT / "docs/examples"
HOME = tempfile.TemporaryDirectory(prefix="suture-home-")
os.environ["FREECAD_USER_HOME"] = HOME.name
tempfile.tempdir = HOME.name  # what other tests make meanwhile is not in it
os.environ["SUTURE_EXE"] = PROGRAM
# Plain Python does not know FreeCAD's home: Bodies need PartDesign's Python part.
sys.path[:0] = ["/usr/lib/freecad-python3/lib", "/usr/share/freecad/Mod"]
sys.path[:0] = [str(ROOT / "plugin"), str(HERE)]

try:
    import FreeCAD as App
    import Part
except ImportError as missing:
    raise unittest.SkipTest(f"FreeCAD is not installed: {missing}") from missing

CORNER = [9, 19, 21]  # the edges of the open suitcase corner
TURNED = App.Placement(App.Vector(5, -7, 11), App.Rotation(20, 30, 40))


def example(name="suitcase_corner"):
    shape = Part.Shape()
    shape.read(str(EXAMPLES / f"{name}.step"))
    return shape


def open_box():
    """A box without two opposite sides: two planar holes."""
    box = Part.makeBox(10, 20, 30)
    return Part.Shell([face for index, face in enumerate(box.Faces) if index not in (0, 1)])


class Case(unittest.TestCase):
    """A new document for every test."""

    def setUp(self):
        os.environ["SUTURE_EXE"] = PROGRAM
        os.environ.pop("SUTURE_BEHAVIOUR", None)
        self.document = App.newDocument()

    def tearDown(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)

    def add(self, shape, name="Base"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        return obj

    def misbehave(self, behaviour):
        os.environ["SUTURE_EXE"] = str(HERE / "bad_suture.py")
        os.environ["SUTURE_BEHAVIOUR"] = behaviour

    def assert_same_face(self, face, other):
        self.assertLess((face.CenterOfMass - other.CenterOfMass).Length, 1e-7)
        self.assertAlmostEqual(face.Area, other.Area, delta=1e-6 * face.Area)
