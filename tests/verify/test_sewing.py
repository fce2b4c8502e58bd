"""Sews dirty models made here and looks at the written file with FreeCAD's Part module.

What each body must be is known from how it was made; the program has no part in it. Where a gap was
closed, faces meet within its width only, and OCCT's volume is uncertain by as much.
"""

import math
import random
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parent / "bench"))

from program import SUTURE, run  # noqa: E402
from time_limits import limit  # noqa: E402

from shapes import Part  # noqa: E402
from FreeCAD import Matrix, Placement, Rotation, Vector  # noqa: E402

DONE, NOTHING = 0, 3
LIMIT = limit(60)  # seconds
SKEW = Placement(Vector(3, -7, 11), Rotation(Vector(1, 2, -0.5), 40))


def box(*corners):
    x, y, z, x1, y1, z1 = corners
    return Part.makeBox(x1 - x, y1 - y, z1 - z, Vector(x, y, z))


def loosened(shape):
    return [face.copy() for face in shape.Faces]


def lies_in(face, axis, at):
    low, high = face.BoundBox.getPoint(0)[axis], face.BoundBox.getPoint(6)[axis]
    return abs(low - at) < 1e-6 and abs(high - at) < 1e-6


def slabs(solid, cuts, gap):
    """The shells of a solid cut across x, moved apart along x by `gap` each."""
    bounds = solid.BoundBox
    at = [bounds.XMin - 1, *cuts, bounds.XMax + 1]
    shells = []
    for i in range(len(at) - 1):
        slab = box(at[i], bounds.YMin - 1, bounds.ZMin - 1, at[i + 1], bounds.YMax + 1, bounds.ZMax + 1)
        part = solid.common(slab)
        kept = [f for f in part.Faces if not any(lies_in(f, 0, cut) for cut in cuts)]
        shell = Part.Shell(kept)
        shell.translate(Vector(i * gap, 0, 0))
        shells.append(shell)
    return shells


def grouped(solid, groups, shift, seed=1):
    """The faces of a solid dealt out to shells, each moved by up to `shift`."""
    dice = random.Random(seed)
    shells = []
    for i in range(groups):
        faces = [face.copy() for face in solid.Faces[i::groups]]
        part = Part.Compound(faces)
        part.translate(Vector(*(dice.uniform(-1, 1) * shift for _ in range(3))))
        shells += part.Faces
    return shells


def cracked(solid, loose):
    """A shell in which some faces have edges of their own."""
    faces = [face.copy() if i in loose else face for i, face in enumerate(solid.Faces)]
    return [Part.Compound(faces)]


def polygon(*points):
    return Part.Face(Part.makePolygon([Vector(*p) for p in (*points, points[0])]))


def strips(y, cuts, height, turned):
    walls = []
    for a, b in zip(cuts, cuts[1:]):
        points = [(a, y, 0), (b, y, 0), (b, y, height), (a, y, height)]
        walls.append(polygon(*(reversed(points) if turned else points)))
    return walls


def t_joints(front, back, gap=0.0):
    """A box of 100 x 60 x 30 whose long walls are strips."""
    lid = polygon((0, 0, 30 + gap), (100, 0, 30 + gap), (100, 60, 30 + gap), (0, 60, 30 + gap))
    floor = polygon((0, 60, 0), (100, 60, 0), (100, 0, 0), (0, 0, 0))
    left = polygon((0, 0, 0), (0, 0, 30), (0, 60, 30), (0, 60, 0))
    right = polygon((100, 0, 0), (100, 60, 0), (100, 60, 30), (100, 0, 30))
    return [lid, floor, left, right, *strips(0, front, 30, False), *strips(60, back, 30, True)]


def cut_corner(size):
    """A box whose lid alone has a short edge across one corner."""
    walls = [f for f in loosened(box(0, 0, 0, 50, 60, 30)) if not lies_in(f, 2, 30)]
    return [*walls, polygon((size, 0, 30), (50, 0, 30), (50, 60, 30), (0, 60, 30), (0, size, 30))]


BOX = box(0, 0, 0, 100, 60, 30)
ROUND = BOX.makeFillet(6, BOX.Edges)
BRACKET = box(0, 0, 0, 80, 40, 50).cut(box(10, -1, 10, 81, 41, 51))
CYLINDER = Part.makeCylinder(20, 50)
BALL = Part.makeSphere(25)
RING = Part.makeTorus(30, 8)
HOLLOW = box(0, 0, 0, 60, 50, 40).cut(box(0.1, 0.1, 0.1, 59.9, 49.9, 39.9))
PLATE = box(0, 0, 0, 100, 80, 0.1)
TUBE = Part.makeCylinder(20, 60).cut(Part.makeCylinder(19.9, 60))

# name: (shapes of the dirty model, the volumes of the solids that it is, how exact: relative)
MODELS = {
    **{f"halves_{gap:g}": (slabs(BOX, [50], gap), [180000 + gap * 1800], 1e-9 + 0.01 * gap) for gap in (0, 1e-7, 1e-4, 1e-3, 0.01, 0.05)},
    "three_shells": (slabs(ROUND, [30, 71], 0.01), [ROUND.Volume + 0.02 * 1770], 1e-3),
    "four_shells": (slabs(ROUND, [20, 45, 77], 0.02), [ROUND.Volume + 0.06 * 1770], 1e-3),
    "six_shells": (slabs(ROUND, [17, 33, 50, 66, 80], 0.005), [ROUND.Volume + 0.025 * 1770], 1e-3),
    "six_shells_without_gaps": (slabs(ROUND, [17, 33, 50, 66, 80], 0), [ROUND.Volume], 1e-9),
    **{f"cylinder_{gap:g}": (slabs(CYLINDER, [0], gap), [CYLINDER.Volume + gap * 2000], 1e-9 + 0.03 * gap) for gap in (0, 0.01, 0.03)},
    **{f"ball_{gap:g}": (slabs(BALL, [-9, 10], gap), [BALL.Volume + gap * 3400], 1e-6 + 0.1 * gap) for gap in (0, 0.01)},
    "ring": (slabs(RING, [0], 0), [RING.Volume], 1e-6),
    "bracket_in_two": (grouped(BRACKET, 2, 0), [BRACKET.Volume], 1e-9),
    "bracket_in_six": (grouped(BRACKET, 6, 0.004), [BRACKET.Volume], 1e-3),
    "rounded_in_five": (grouped(ROUND, 5, 0.002), [ROUND.Volume], 1e-3),
    "crack_at_one_face": (cracked(BOX, {0}), [BOX.Volume], 1e-9),
    "crack_at_two_faces": (cracked(BOX, {1, 4}), [BOX.Volume], 1e-9),
    "crack_at_fillets": (cracked(ROUND, {3, 9, 17}), [ROUND.Volume], 1e-9),
    "t_joints": (t_joints([0, 30, 77, 100], [0, 41, 100]), [180000], 1e-9),
    "t_joints_many": (t_joints([0, 8, 30, 55, 77, 100], [0, 12, 41, 70, 100]), [180000], 1e-9),
    "t_joints_and_gap": (t_joints([0, 30, 77, 100], [0, 41, 100], 0.01), [180060], 1e-3),
    "thin_walls": (loosened(HOLLOW), [60 * 50 * 40, 59.8 * 49.8 * 39.8], 1e-9),
    "thin_plate": (loosened(PLATE), [800], 1e-9),
    "thin_tube": (loosened(TUBE), [TUBE.Volume], 1e-9),
    "short_edge_on_one_side": (cut_corner(2e-5), [90000], 1e-9),
    "shorter_edge_on_one_side": (cut_corner(5e-6), [90000], 1e-9),
    "two_groups_with_a_wall": (
        [Part.Compound(loosened(box(0, 0, 0, 4, 3, 2))), Part.Compound(loosened(box(4, 0, 0, 9, 3, 2)))],
        [24, 30],
        1e-9,
    ),
    "two_groups_with_an_edge": (
        [Part.Compound(loosened(box(0, 0, 0, 4, 3, 2))), Part.Compound(loosened(box(4, 3, 0, 9, 6, 2)))],
        [24, 30],
        1e-9,
    ),
}

# What must stay as it is.
KEPT = {
    "solids_with_a_common_face": [box(0, 0, 0, 10, 10, 10), box(10, 0, 0, 20, 10, 10)],
    "solids_with_a_common_edge": [box(0, 0, 0, 10, 10, 10), box(10, 10, 0, 20, 20, 10)],
    "solids_with_a_common_corner": [box(0, 0, 0, 10, 10, 10), box(10, 10, 10, 20, 20, 20)],
    "sheets_of_a_thin_plate": [f.copy() for f in PLATE.Faces if f.Area > 100],
    "tube_without_its_ends": [f.copy() for f in TUBE.Faces if f.Area > 100],
    "halves_far_apart": slabs(BOX, [50], 0.5),
}


class Sewing(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def sew(self, shapes, ending):
        model = Part.Compound(shapes)
        model.Placement = SKEW.multiply(model.Placement)
        given = self.folder / "dirty.brep"
        model.exportBrep(str(given))
        out = self.folder / f"sewn{ending}"
        return run([SUTURE, "sew", given, "-o", out, "--json"], LIMIT), out

    def test_each_becomes_the_body_that_it_was(self):
        self.assertGreaterEqual(len(MODELS) + len(KEPT), 30)
        for number, (name, (shapes, volumes, exact)) in enumerate(MODELS.items()):
            with self.subTest(name):
                done, out = self.sew(shapes, ".step" if number % 2 else ".brep")
                self.assertEqual(done.code, DONE, done.err)
                shape = Part.read(str(out))
                self.assertTrue(shape.isValid())
                self.assertEqual(len(shape.Solids), len(volumes))
                self.assertTrue(all(shell.isClosed() for shell in shape.Shells))
                for solid, volume in zip(sorted(s.Volume for s in shape.Solids), sorted(volumes)):
                    self.assertLess(abs(solid - volume), exact * volume)

    def test_what_is_meant_to_be_apart_stays_apart(self):
        for name, shapes in KEPT.items():
            with self.subTest(name):
                done, out = self.sew(shapes, ".brep")
                self.assertEqual(done.code, NOTHING, done.out)
                self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
