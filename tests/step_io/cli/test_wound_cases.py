"""The given cases of chosen edges and faces, as their rows in cases.tsv have them; measured with
FreeCAD's Part alone."""

import csv
import math
import unittest

from program import CAD, DONE, OUT_OF_TOLERANCE, Case, run

CASES = CAD.parent / "cases"

try:
    import wounds
    from wounds import Part, Read
except ImportError as error:  # no FreeCAD
    wounds = error


def angles(shape):
    """The largest angle between the two faces along each edge that two faces have, in degrees."""
    found = []
    for edge in shape.Edges:
        pair = shape.ancestorsOfShape(edge, Part.Face) if hasattr(shape, "ancestorsOfShape") else []
        pair = pair or [f for f in shape.Faces if any(e.isSame(edge) for e in f.Edges)]
        if len(pair) != 2:
            continue
        first, last = edge.ParameterRange
        worst = 0.0
        for k in range(9):
            point = edge.valueAt(first + (last - first) * (k + 0.5) / 9)
            a, b = (face.normalAt(*face.Surface.parameter(point)) for face in pair)
            worst = max(worst, math.degrees(a.getAngle(b)))
        found.append(worst)
    return found


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
@unittest.skipUnless(CASES.exists(), f"needs {CASES}")
class WoundCases(Case):
    def made(self, command, name, *words, code=None):
        out = self.folder / "out.step"
        finished = run(command, CASES / "wound" / name, "-o", out, "--json", *words)
        self.assertIn(finished.code, (DONE, OUT_OF_TOLERANCE) if code is None else (code,), str(finished))
        filled = [h for h in finished.json["holes"] if h["status"] == "filled"]
        return filled, Read(out)

    def test_every_row_has_its_test(self):
        with (CASES / "cases.tsv").open(encoding="utf-8") as rows:
            names = {row[0][6:] for row in csv.reader(rows, delimiter="\t") if row[0].startswith("wound/")}
        mine = "".join(name for name in dir(self) if name.startswith("test_"))
        self.assertEqual([name for name in names if name.split(".")[0] not in mine], [])

    def test_sharp_edge_back_has_its_edge_back(self):
        _, out = self.made("fill", "sharp_edge_back.step", "--grow", code=DONE)
        self.assertEqual((out.faces, out.solids, out.valid), (6, 1, True))
        self.assertAlmostEqual(out.volume, 72000, delta=1e-5)

    def test_two_plates_are_bridged_by_a_tangent_sheet(self):
        shape = Part.read(str(CASES / "wound/two_plates.step"))
        left, right = (face.Edges for face in shape.Faces)
        near = min(
            ((a, b) for a in left for b in right),
            key=lambda pair: (pair[0].CenterOfMass - pair[1].CenterOfMass).Length,
        )
        numbers = [next(n for n, e in enumerate(shape.Edges, 1) if e.isSame(edge)) for edge in near]
        filled, out = self.made("bridge", "two_plates.step", "--edges", wounds.mixed(numbers, 3), code=DONE)
        self.assertEqual((len(filled), out.faces, out.shells, out.solids, out.valid), (1, 3, 1, 0, True))
        self.assertEqual(len(angles(out.shape)), 2)
        self.assertLess(max(angles(out.shape)), 0.01)

    def test_four_sheets_get_one_face_over_their_edges(self):
        filled, out = self.made("fill", "four_sheets.step", "--boundary", "13,8,1,9")
        self.assertEqual((len(filled), out.faces, out.shells, out.solids), (1, 5, 1, 0))
        self.assertEqual(len(angles(out.shape)), 4)

    def test_loose_curves_bound_one_face(self):
        before = Part.read(str(CASES / "wound/loose_curves.step"))
        _, out = self.made("fill", "loose_curves.step", "--boundary", "1,2,3", code=DONE)
        self.assertEqual((out.faces, len(out.shape.Edges), out.valid), (1, 3, True))
        lengths = [sorted(edge.Length for edge in shape.Edges) for shape in (before, out.shape)]
        for a, b in zip(*lengths):
            self.assertAlmostEqual(a, b, delta=1e-6)

    def test_hull_gets_deck_and_transom(self):
        filled, out = self.made("fill", "hull.igs", "--all-loops", "--split", "auto")
        self.assertEqual((len(filled), out.faces, out.solids, out.valid), (2, 4, 1, True))
        self.assertGreater(out.volume, 0.0)

    def test_faceted_ball_is_followed(self):
        _, out = self.made("fill", "faceted_ball.step")
        self.assertEqual((out.solids, out.valid), (1, True))
        self.assertAlmostEqual(out.volume / 32227, 1.0, delta=0.002)


if __name__ == "__main__":
    unittest.main()
