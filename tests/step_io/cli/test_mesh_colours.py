"""Colours, parts and names of an assembly come back from 3MF, glTF and OBJ, read by Assimp."""

import json
import shutil
import subprocess
import sys
import unittest

from program import DONE, Case, run
from time_limits import limit


def make_assembly(folder):
    """Machine > frame (plate, bolt twice) and bolt once more: a blue plate with one red face, grey bolts."""
    script = folder / "make.py"
    script.write_text(f'''
import sys
sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD, Import, Part
document = FreeCAD.newDocument("machine")
def part(name, holder=None, place=(0, 0, 0)):
    made = document.addObject("App::Part", name); made.Label = name
    made.Placement.Base = FreeCAD.Vector(*place)
    if holder: holder.addObject(made)
    return made
machine = part("machine")
frame = part("frame", machine, (0, 0, 40))
plate = document.addObject("Part::Feature", "plate"); plate.Shape = Part.makeBox(30, 20, 5); frame.addObject(plate)
for i, place in enumerate(((5, 5, 0), (25, 5, 1))):
    bolt = document.addObject("Part::Feature", f"bolt{{i}}"); bolt.Shape = Part.makeCylinder(2, 15)
    bolt.Placement.Base = FreeCAD.Vector(*place); frame.addObject(bolt)
spare = document.addObject("Part::Feature", "spare"); spare.Shape = Part.makeCylinder(2, 15)
spare.Placement.Base = FreeCAD.Vector(-20, 3, 0); machine.addObject(spare)
document.recompute()
Import.export([machine], {str(folder / "machine.step")!r})
''')
    subprocess.run([sys.executable, script], check=True, capture_output=True, timeout=limit(100))
    text = (folder / "machine.step").read_text()
    return colour_faces(folder, text)


def colour_faces(folder, text):
    """Adds styles to the STEP text: FreeCAD without a window writes none."""
    import re

    context = re.search(r"#(\d+) = \( GEOMETRIC_REPRESENTATION_CONTEXT", text)[1]
    solids = [(m[1], m[2]) for m in re.finditer(r"#(\d+) = MANIFOLD_SOLID_BREP\('[^']*',#(\d+)\)", text)]
    number = max(map(int, re.findall(r"#(\d+) =", text))) + 1
    lines, styled = [], []

    def style(item, colour):
        nonlocal number
        n = number
        number += 7
        lines.append(
            f"#{n} = COLOUR_RGB('',{colour[0]},{colour[1]},{colour[2]});\n#{n+1} = FILL_AREA_STYLE_COLOUR('',#{n});\n"
            f"#{n+2} = FILL_AREA_STYLE('',(#{n+1}));\n#{n+3} = SURFACE_STYLE_FILL_AREA(#{n+2});\n"
            f"#{n+4} = SURFACE_SIDE_STYLE('',(#{n+3}));\n#{n+5} = SURFACE_STYLE_USAGE(.BOTH.,#{n+4});\n"
            f"#{n+6} = PRESENTATION_STYLE_ASSIGNMENT((#{n+5}));\n")
        styled.append(number)
        lines.append(f"#{number} = STYLED_ITEM('',(#{n+6}),#{item});\n")
        number += 1

    for solid, shell in solids:
        faces = re.search(rf"#{shell} = CLOSED_SHELL\('[^']*',\(([^)]*)\)", text)[1].replace("#", "").split(",")
        is_plate = len(faces) == 6
        style(solid, (0.2, 0.4, 0.6) if is_plate else (0.5, 0.5, 0.5))
        if is_plate:
            style(faces[0].strip(), (1.0, 0.0, 0.0))
    items = ",".join(f"#{n}" for n in styled)
    lines.append(f"#{number} = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({items}),#{context});\n")
    end = text.rindex("ENDSEC;")
    file = folder / "coloured.step"
    file.write_text(text[:end] + "".join(lines) + text[end:])
    return file


@unittest.skipUnless(shutil.which("assimp"), "assimp is not installed")
class Colours(Case):
    def read(self, name):
        """Assimp's JSON of a file: nodes, meshes, materials."""
        out = self.folder / (name + ".json")
        done = subprocess.run(["assimp", "export", self.folder / name, out, "-fassjson"], capture_output=True,
                              text=True, timeout=limit(60), check=False)
        self.assertTrue(out.exists(), done.stdout)
        return json.loads(out.read_text())

    def nodes(self, node, outer=(0, 0, 0)):
        """Name, place and meshes of every node that has meshes."""
        m = node["transformation"]
        place = tuple(round(outer[i] + m[4 * i + 3], 5) for i in range(3))
        found = [(node["name"], place, node["meshes"])] if node.get("meshes") else []
        for child in node.get("children", []):
            found += self.nodes(child, place)
        return found

    def names(self, node):
        return [node["name"]] + [name for child in node.get("children", []) for name in self.names(child)]

    def colour(self, scene, mesh):
        properties = scene["materials"][scene["meshes"][mesh]["materialindex"]]["properties"]
        return tuple(round(x, 2) for x in next(p["value"] for p in properties if p["key"] == "$clr.diffuse")[:3])

    def test_they_come_back(self):
        source = make_assembly(self.folder)
        triangles = {}
        for name in ("a.3mf", "a.glb", "a.obj"):
            finished = self.expect(run("convert", source, self.folder / name, "--json"), DONE)
            triangles[name] = finished.json["mesh"]["triangles"]
            scene = self.read(name)
            with self.subTest(name):
                colours = [self.colour(scene, mesh) for _, _, meshes in self.nodes(scene["rootnode"]) for mesh in meshes]
                linear = name == "a.glb"  # as the format has it
                blue = (0.03, 0.13, 0.32) if linear else (0.2, 0.4, 0.6)
                grey = (0.21, 0.21, 0.21) if linear else (0.5, 0.5, 0.5)
                self.assertEqual(set(colours), {blue, (1.0, 0.0, 0.0), grey})
                names = " ".join(self.names(scene["rootnode"]) + [m.get("name", "") for m in scene["meshes"]])
                for part in ("plate", "spare"):
                    self.assertIn(part, names)
                if name != "a.obj":
                    self.assertIn("frame", names)
                red = sum(len(scene["meshes"][mesh]["faces"]) for _, _, meshes in self.nodes(scene["rootnode"])
                          for mesh in meshes if self.colour(scene, mesh) == (1.0, 0.0, 0.0))
                self.assertEqual(red, 2)  # one side of the plate


if __name__ == "__main__":
    unittest.main()
