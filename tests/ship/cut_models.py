# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes many open models: cut_models.py TO COUNT MODEL...

Takes one face out of a model and turns it, another one each time. Needs FreeCAD (Debian: freecad-python3).
"""

import itertools
import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402
import Part  # noqa: E402


def cuts(shape):
    """The model without its first face, its second, ... as open shells."""
    for missing in range(len(shape.Faces)):
        yield Part.makeShell([face for i, face in enumerate(shape.Faces) if i != missing])


def main(to, count, models):
    to.mkdir(parents=True, exist_ok=True)
    shapes = []
    for model in models:
        shape = Part.Shape()
        shape.read(str(model))
        shapes.append((model.stem, cuts(shape)))
    shells = itertools.chain.from_iterable(itertools.zip_longest(*(pair[1] for pair in shapes)))
    made = 0
    for stem, shell in zip(itertools.cycle([pair[0] for pair in shapes]), shells):
        if shell is None or made == count:
            continue
        shell.rotate(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(1, 2, 3), 7.0 * made)
        shell.exportStep(str(to / f"{stem}_{made:03}.step"))
        made += 1
    if made < count:
        raise SystemExit(f"only {made} models could be made")


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), [Path(word) for word in sys.argv[3:]])
