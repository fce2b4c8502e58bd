"""What chosen edges and faces cannot be: one exact line each, exit code 1, and nothing is written."""

import unittest

from program import USAGE, Case, run

try:
    import wounds
    from wounds import Part, V
except ImportError as error:  # no FreeCAD
    wounds = error

# words of `fill` or `bridge`, and the line
LINES = [
    ("fill lines --boundary 1,2,3,4,1", "edge 1 is named twice in one boundary"),
    (
        "fill lines --boundary 1,2,3,4,5",
        "edge 5 forms no closed chain: between the ends at (0, 0, 50) and (9, 0, 50) is a gap of 9, wider "
        "than the 0.001 that closes by itself; --connect bridges it",
    ),
    (
        "fill lines --boundary 1,2",
        "the edges 1, 2 form no closed chain: between the ends at (0, 0, 0) and (40, 40, 0) is a gap of "
        "56.57, wider than the 0.001 that closes by itself; --connect bridges it",
    ),
    ("fill lines --boundary 1,2,77", "there is no edge 77: the model has 5 edges"),
    ("fill box --boundary 1,2,3,4", "edge 1 lies between the faces 1 and 3: no further face can be joined there"),
    ("fill box --replace-faces 9", "there is no face 9: the model has 6 faces"),
    ("fill box --remove-faces 1,9", "there is no face 9: the model has 6 faces"),
    ("fill box --remove-faces 2,2", "face 2 is named twice"),
    ("fill box --replace-faces 2,1,2", "face 2 is named twice"),
    (
        "fill box --replace-faces 1-6",
        "faces 1, 2, 3, 4, 5, 6: all faces would go: nothing would be left around them",
    ),
    (
        "fill box --remove-faces 1-6",
        "faces 1, 2, 3, 4, 5, 6: all faces would go: nothing would be left around them",
    ),
    (
        "bridge lines --edges 1,2",
        "a bridge stands on two chains of edges or on two closed rims, and these edges form 1 open and 0 closed",
    ),
    ("bridge lines --edges 1,1", "edge 1 is named twice in one boundary"),
    ("bridge box --edges 1,2", "edge 1 lies between the faces 1 and 3: no further face can be joined there"),
    ("fill lines --boundary 1,2,3,4 --support 1=3", "there is no face 3: the model has 0 faces"),
    ("fill lines --boundary 1,2,3,4 --support 5=1", "--support: edge 5 is no edge of the border"),
    ("fill lines --boundary 1,2,3,4 --support 1", "'1' names no support: write it as 3=7, edge and face"),
    ("fill box --support 1=2", "--support is for edges of a --boundary"),
]


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class BorderWords(Case):
    def test_each_is_one_exact_line(self):
        square = wounds.polygon([(0, 0, 0), (40, 0, 0), (40, 40, 0), (0, 40, 0)])
        lines = Part.Compound([*square, Part.makeLine(V(0, 0, 50), V(9, 0, 50))])
        files = {"lines": lines, "box": Part.makeBox(1, 2, 3)}
        for name, shape in files.items():
            wounds.save(shape, self.folder / f"{name}.step")
        for words, line in LINES:
            with self.subTest(words):
                command, name, *rest = words.split()
                out = self.folder / "none.step"
                finished = run(command, self.folder / f"{name}.step", "-o", out, *rest)
                self.expect_refused(finished, USAGE)
                self.assertEqual(finished.err, f"error: {line}\n")
                self.expect_files("box.step", "lines.step")


if __name__ == "__main__":
    unittest.main()
