# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes of other programs, in and out by their own BREP export: none of them is imported before it is used.

| kind | in | out |
|---|---|---|
| path | as it is | the path of the output, or bytes |
| bytes | as a file | bytes |
| FreeCAD `Part.Shape`, or an object with a `Shape` | `exportBrep(path)` | `importBrep(path)` of a new shape |
| CadQuery `Workplane` (`val()`), `Shape` | `exportBrep(path)` | the class method `importBrep(path)` |
| build123d `Shape` | its `wrapped`, as OCP | `cast` of its class |
| OCP `TopoDS_Shape` | `BRepTools.Write_s(shape, path)` | `BRepTools.Read_s(shape, path, builder)` |
| pythonocc `TopoDS_Shape` | `breptools.Write(shape, path)` | `breptools.Read(shape, path, builder)` |
"""

from __future__ import annotations

import importlib
import os
from pathlib import Path


class Input:
    """A shape as a file. `file` is its path; `back(path)` makes a shape of the same kind from a file."""

    def __init__(self, shape, folder):
        self.suffix = ".brep"
        self.file = Path(folder) / "input.brep"
        self.back = None
        if isinstance(shape, (str, os.PathLike)):
            self.file = Path(shape)
            self.suffix = self.file.suffix or ".step"
            self.back = Path.read_bytes
        elif isinstance(shape, (bytes, bytearray, memoryview)):
            self.suffix = ".step"
            self.file = Path(folder) / "input"  # the program knows a file by its content
            self.file.write_bytes(shape)
            self.back = Path.read_bytes
        else:
            self.back = _export(shape, str(self.file))


def _export(shape, path):
    shape = getattr(shape, "Shape", shape)  # an object in a document of FreeCAD
    if callable(getattr(shape, "val", None)):
        shape = shape.val()  # what a CadQuery Workplane holds
    if hasattr(shape, "exportBrep"):
        shape.exportBrep(path)
        return lambda file: _import(type(shape), str(file))
    wrapped = getattr(shape, "wrapped", shape)
    module, tools = _tools_of(wrapped)
    tools["write"](wrapped, path)
    if wrapped is shape:
        return lambda file: _read(module, tools, str(file))
    return lambda file: type(shape).cast(_read(module, tools, str(file)))


def _import(kind, path):
    """CadQuery's is a class method that gives the shape, FreeCAD's one of a shape that it changes."""
    for base in kind.__mro__:
        if isinstance(base.__dict__.get("importBrep"), classmethod):
            return base.importBrep(path)
    shape = kind()
    # FreeCAD's Solid takes no compound: what it may become is known after it is read.
    if kind.__module__ == "Part":
        shape = importlib.import_module("Part").Shape()
    shape.importBrep(path)
    return shape


def _tools_of(shape):
    """The module that a TopoDS_Shape is from, and its functions that write and read BREP."""
    package = type(shape).__module__.split(".")[0]
    if package == "OCP":
        tools = importlib.import_module("OCP.BRepTools").BRepTools
        return "OCP", {"write": tools.Write_s, "read": tools.Read_s}
    if package == "OCC":
        tools = importlib.import_module("OCC.Core.BRepTools").breptools
        return "OCC.Core", {"write": tools.Write, "read": tools.Read}
    raise TypeError(
        f"{type(shape).__module__}.{type(shape).__qualname__} is no shape that suture knows: give a path, "
        "bytes, or a shape of FreeCAD, CadQuery, build123d, OCP or pythonocc"
    )


def _read(module, tools, path):
    shape = importlib.import_module(f"{module}.TopoDS").TopoDS_Shape()
    builder = importlib.import_module(f"{module}.BRep").BRep_Builder()
    tools["read"](shape, path, builder)
    return shape
