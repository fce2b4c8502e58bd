"""Colours, parts and names of an assembly come back: from glTF and OBJ read by Assimp, from 3MF by lib3mf."""

import collections
import ctypes
import ctypes.util
import json
import re
import shutil
import subprocess
import sys
import unittest

from program import DONE, Case, run
from time_limits import limit


BLUE, RED, GREY = (0.2, 0.4, 0.6), (1.0, 0.0, 0.0), (0.5, 0.5, 0.5)


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


class Lib3mf:
    """What lib3mf reads in a file (its interface of Debian 12, 1.8)."""

    def __init__(self, file):
        self.library = ctypes.CDLL("lib3MF.so.1")
        self.model = self.new("createmodel")
        self.call("reader_readfromfileutf8", self.new("model_queryreader", self.model, b"3mf"), str(file).encode())

    def call(self, name, *arguments):
        result = getattr(self.library, f"lib3mf_{name}")(*arguments)
        if result != 0:
            raise AssertionError(f"lib3mf_{name}: {result & 0xFFFFFFFF:x}")

    def new(self, name, *arguments, kind=ctypes.c_void_p):
        """What a function gives as its last argument."""
        result = kind()
        self.call(name, *arguments, ctypes.byref(result))
        return result

    def objects(self, which):
        iterator = self.new(f"model_get{which}", self.model)
        while self.new("resourceiterator_movenext", iterator, kind=ctypes.c_int).value:
            yield self.new("resourceiterator_getcurrent", iterator)

    def name(self, item):
        text = ctypes.create_string_buffer(100)
        self.call("object_getnameutf8", item, text, len(text), ctypes.byref(ctypes.c_uint32()))
        return text.value.decode()

    def colours(self, mesh):
        """How many triangles there are of each colour."""
        handler = self.new("meshobject_createpropertyhandler", mesh)
        found = collections.Counter()
        for i in range(self.new("meshobject_gettrianglecount", mesh, kind=ctypes.c_uint32).value):
            group = ctypes.c_uint32()
            index = self.new("propertyhandler_getbasematerial", handler, i, ctypes.byref(group), kind=ctypes.c_uint32)
            base = self.new("model_getbasematerialbyid", self.model, group)
            rgba = [ctypes.c_ubyte() for _ in range(4)]
            self.call("basematerial_getdisplaycolor", base, index, *map(ctypes.byref, rgba))
            found[tuple(round(part.value / 255, 2) for part in rgba[:3])] += 1
        return found


def lib3mf():
    return ctypes.util.find_library("3MF") is not None


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
        for name in ("a.glb", "a.obj"):
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

    @unittest.skipUnless(lib3mf(), "lib3mf is not installed")
    def test_they_come_back_from_3mf(self):
        self.expect(run("convert", make_assembly(self.folder), self.folder / "a.3mf"), DONE)
        model = Lib3mf(self.folder / "a.3mf")
        colours = {model.name(mesh): model.colours(mesh) for mesh in model.objects("meshobjects")}
        self.assertEqual(colours["plate"], {BLUE: 10, RED: 2})
        for name in colours.keys() - {"plate"}:
            self.assertEqual(set(colours[name]), {GREY}, name)
        self.assertEqual({model.name(item) for item in model.objects("componentsobjects")} & {"machine", "frame"},
                         {"machine", "frame"})


if __name__ == "__main__":
    unittest.main()
