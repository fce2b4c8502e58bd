"""Makes STEP of an OpenSCAD script, with exact cylinders, spheres and planes, for `suture fill` and others.

    scad_to_step.py part.scad part.step

It needs OpenSCAD and FreeCAD (freecadcmd); FreeCAD's importCSG does the work. Cylinders and spheres are exact
where the script leaves $fn at 0; hull(), minkowski(), text() and import() of meshes stay facets or are left out.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

INSIDE = """
import FreeCAD, os, Part
FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/OpenSCAD").SetString("openscadexecutable", os.environ["OPENSCAD"])
import importCSG
importCSG.open(os.environ["CSG"])
document = FreeCAD.ActiveDocument
document.recompute()
roots = [o for o in document.Objects if not o.InList and getattr(o, "Shape", None) and o.Shape.Faces]
if roots:
    Part.export(roots, os.environ["STEP"])
"""


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: scad_to_step.py IN.scad OUT.step")
    source, target = (Path(word).resolve() for word in sys.argv[1:])
    programs = {name: shutil.which(name) for name in ("openscad", "freecadcmd")}
    for name, found in programs.items():
        if found is None:
            sys.exit(f"error: {name} is not installed")
    with tempfile.TemporaryDirectory() as folder:
        csg = Path(folder) / f"{source.stem}.csg"
        subprocess.run([programs["openscad"], "-o", csg, source], check=True, capture_output=True)
        script = Path(folder) / "inside.py"
        script.write_text(INSIDE)
        made = Path(folder) / "made.step"
        places = {"OPENSCAD": programs["openscad"], "CSG": str(csg), "STEP": str(made)}
        done = subprocess.run([programs["freecadcmd"], script], env={**os.environ, **places}, check=False,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if not made.exists():
            sys.exit(f"error: FreeCAD made nothing of {source}: {done.stdout[-500:]}{done.stderr[-500:]}")
        shutil.move(made, target)


if __name__ == "__main__":
    main()
