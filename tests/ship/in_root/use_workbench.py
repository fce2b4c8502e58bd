"""What a FreeCAD user does first, without a window. freecadcmd ends with 0 whatever happens: the last line tells."""

import FreeCAD
import Import

from suture_workbench import api

document = FreeCAD.newDocument("first")
Import.insert("suitcase_corner.step", document.Name)
part = next(item for item in document.Objects if item.isDerivedFrom("Part::Feature"))
holes = api.find_holes(part).report.holes
print("FreeCAD", ".".join(FreeCAD.Version()[:3]), "finds", len(holes), "hole with", len(holes[0].edges), "sides")
filled = api.fill(part)
print(filled.Verdict)
assert filled.Shape.isClosed() and filled.Shape.isValid() and filled.Shape.Volume > 0.0
api.export([filled], "by_workbench.step")
print("used: well")
