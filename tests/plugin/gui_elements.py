"""The commands on chosen edges and faces, as a user clicks through them."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
from gui_common import CANCEL, OK
from gui_look import WIDTH, cut_off
from PySide import QtCore, QtGui

V = App.Vector


def sheet(*points):
    points = [V(*p) for p in points]
    return Part.Face(Part.makePolygon([*points, points[0]]))


def add(document, name, shape):
    obj = document.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def numbers(obj, wanted):
    middles = ((n, e.valueAt(sum(e.ParameterRange) / 2)) for n, e in enumerate(obj.Shape.Edges, 1))
    return [n for n, middle in middles if wanted(middle)]


def listed(driver):
    shown = driver.find("SutureElements", QtGui.QListWidget)
    return [shown.item(index).text() for index in range(shown.count())]


def start(driver):
    Gui.activateWorkbench("SutureWorkbench")
    document = App.newDocument("Model")
    document.UndoMode = 1
    driver.said["cut_off"] = {}
    return document


def opened(driver, command, panel):
    yield from driver.tool(command)
    yield driver.until("the panel", lambda: driver.there(panel))


def measure(driver, panel):
    driver.panel_width(WIDTH)
    yield driver.pause(0.4)
    driver.said["cut_off"][panel] = cut_off(driver, panel)
    driver.picture(panel)
    driver.panel_width(440)


def accept(driver):
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())


def edges(driver):
    """A bridge between clicked edges of two objects, edited; then a border that closes its side."""
    document = start(driver)
    left = add(document, "Left", sheet((0, 0, 0), (40, 0, 0), (40, 30, 0), (0, 30, 0)))
    right = add(document, "Right", sheet((70, 0, 20), (110, 0, 20), (110, 30, 20), (70, 30, 20)))
    driver.look(0.3, -1.0, 0.8)
    yield driver.pause(0.7)
    (a,) = numbers(left, lambda p: abs(p.x - 40) < 1e-6)
    (b,) = numbers(right, lambda p: abs(p.x - 70) < 1e-6)
    Gui.Selection.addSelection(left, f"Edge{a}")
    yield from opened(driver, "Suture_Bridge", "BridgePanel")
    driver.said["first"] = listed(driver)
    yield driver.until("why not yet", lambda: driver.state() == "bad")
    driver.said["not_yet"] = driver.status()
    driver.pick(f"Edge{b}", right.Shape.Edges[b - 1].valueAt(15))
    yield driver.until("the edge", lambda: len(listed(driver)) == 2)
    driver.said["both"] = listed(driver)
    yield driver.until("the preview", lambda: driver.state() == "good")
    yield from measure(driver, "BridgePanel")
    driver.said["untouched"] = len(document.Objects)
    driver.find(f"SutureSide{a}", QtGui.QComboBox).setCurrentText("G0")
    yield driver.until("a new preview", lambda: driver.state() == "busy")
    yield driver.until("its end", lambda: driver.settled())
    yield from accept(driver)
    bridge = document.getObject("Filled")
    driver.said["bridge"] = [len(bridge.Shape.Faces), len(bridge.Shape.Shells), list(bridge.EdgesG0[1])]
    driver.said["hidden"] = [left.Visibility, right.Visibility]
    bridge.ViewObject.Proxy.doubleClicked(bridge.ViewObject)
    yield driver.until("the panel", lambda: driver.there("BridgePanel"))
    yield driver.until("the preview", driver.settled)
    driver.said["again"] = listed(driver)
    driver.said["shown"] = [left.Visibility, right.Visibility, bridge.Visibility]
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["after"] = [left.Visibility, right.Visibility, bridge.Visibility]
    sketch = document.addObject("Sketcher::SketchObject", "Outline")
    for line in ((V(0, 0, 0), V(20, 0, 0)), (V(20, 0, 0), V(20, 10, 0)), (V(20, 10, 0), V(0, 10, 0))):
        sketch.addGeometry(Part.LineSegment(*line))
    sketch.Placement.Base = V(0, 60, 0)
    document.recompute()
    Gui.Selection.clearSelection()
    for edge in (2, 3, 1):
        Gui.Selection.addSelection(sketch, f"Edge{edge}")
    yield from opened(driver, "Suture_FillEdges", "BorderPanel")
    yield driver.until("the gap", lambda: driver.state() == "bad")
    driver.said["gap"] = driver.status()
    driver.click(driver.find("SutureConnect", QtGui.QCheckBox))
    yield driver.until("the preview", lambda: driver.state() == "good")
    yield from measure(driver, "BorderPanel")
    yield from accept(driver)
    driver.said["area"] = document.getObject("Filled001").Shape.Area
    driver.said["drawn"] = driver.drawn()
    App.closeDocument(document.Name)


def faces(driver):
    """A fillet selected in the view is removed, a wall of what is left replaced."""
    document = start(driver)
    box = Part.makeBox(30, 20, 10)
    rounded = add(document, "Rounded", box.makeFillet(4, [box.Edges[0]]))
    faces = enumerate(rounded.Shape.Faces, 1)
    (fillet,) = (n for n, face in faces if "Cylinder" in face.Surface.TypeId)
    driver.look(-1.0, -1.0, 0.8)
    yield driver.pause(0.7)
    yield from opened(driver, "Suture_RemoveFaces", "RemovePanel")
    driver.said["hint"] = driver.status()
    u0, u1, v0, v1 = rounded.Shape.Faces[fillet - 1].ParameterRange
    driver.pick(f"Face{fillet}", rounded.Shape.Faces[fillet - 1].valueAt((u0 + u1) / 2, (v0 + v1) / 2))
    yield driver.until("the face", lambda: listed(driver) == [f"Face{fillet}"])
    yield driver.until("the preview", driver.settled)
    driver.said["removed"] = driver.status()
    yield from measure(driver, "RemovePanel")
    yield from accept(driver)
    sharp = document.getObject("Filled")
    driver.said["volume"] = sharp.Shape.Volume
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(sharp, "Face2")
    yield from opened(driver, "Suture_ReplaceFaces", "ReplacePanel")
    yield driver.until("the preview", driver.settled)
    driver.said["sides"] = driver.find("SutureSides", QtGui.QTreeWidget).topLevelItemCount()
    yield from measure(driver, "ReplacePanel")
    yield from accept(driver)
    replaced = document.getObject("Filled001")
    driver.said["replaced"] = [len(replaced.Shape.Faces), replaced.Shape.Volume, list(replaced.Base[1])]
    driver.said["drawn"] = driver.drawn()
    App.closeDocument(document.Name)


def extras(driver):
    """Holes chosen by size in the panel and merged; a curve that leans on a clicked face."""
    document = start(driver)
    plate = sheet((0, 0, 0), (100, 0, 0), (100, 40, 0), (0, 40, 0))
    for radius, x in ((2, 15), (6, 40)):
        plate = plate.cut(Part.makeCylinder(radius, 2, V(x, 20, -1)))
    add(document, "Plate", plate)
    Gui.Selection.addSelection(document.getObject("Plate"))
    driver.look(0.3, -1.0, 0.8)
    yield from opened(driver, "Suture_Fill", "FillPanel")
    yield driver.until("the preview", driver.settled)
    driver.unfold("SutureMore")
    yield driver.until("the fields", lambda: driver.there("SutureExtra_larger"))
    driver.said["fields"] = driver.there("SutureExtra_tension")
    driver.find("SutureExtra_larger", QtGui.QDoubleSpinBox).setValue(10.0)
    tree = driver.find("SutureHoles", QtGui.QTreeWidget)
    holes = tree.topLevelItem(0)
    driver.said["ticked"] = [holes.child(i).checkState(0) == QtCore.Qt.Checked for i in range(holes.childCount())]
    driver.find("SutureExtra_merge", QtGui.QCheckBox).setChecked(True)  # it is scrolled out of sight
    yield driver.until("a new preview", lambda: driver.state() == "busy")
    yield driver.until("its end", driver.settled)
    yield from measure(driver, "FillPanel")
    yield from accept(driver)
    filled = document.getObject("Filled")
    driver.said["filled"] = [len(filled.Shape.Faces), len(filled.Shape.Edges), filled.Merge, list(filled.Base[1])]
    filled.ViewObject.Proxy.doubleClicked(filled.ViewObject)
    yield driver.until("the panel", lambda: driver.there("FillPanel"))
    yield driver.until("the preview", driver.settled)
    holes = driver.find("SutureHoles", QtGui.QTreeWidget).topLevelItem(0)
    driver.said["again"] = [holes.child(i).checkState(0) == QtCore.Qt.Checked for i in range(holes.childCount())]
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    App.closeDocument(document.Name)
    document = App.newDocument("Ball")
    document.UndoMode = 1
    ball = add(document, "Ball", Part.makeSphere(6, V(), V(0, 0, 1), -30, 30).Faces[0])
    circle = add(document, "Circle", Part.makeCircle(20**0.5, V(0, 0, 4)))
    driver.look(0.3, -1.0, 0.8)
    yield driver.pause(0.7)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(circle, "Edge1")
    yield from opened(driver, "Suture_FillEdges", "BorderPanel")
    yield driver.until("the preview", driver.settled)
    shown = driver.find("SutureElements", QtGui.QListWidget)
    shown.item(0).setSelected(True)
    driver.pick("Face1", ball.Shape.Faces[0].valueAt(-1.57, 0.0))
    yield driver.until("the support", lambda: "tangent to" in listed(driver)[0])
    yield driver.until("a new preview", lambda: driver.state() == "busy")
    yield driver.until("its end", driver.settled)
    driver.said["leaning"] = listed(driver)
    yield from measure(driver, "BorderPanel")
    yield from accept(driver)
    made = document.getObject("Filled")
    driver.said["area"] = made.Shape.Area - ball.Shape.Area
    made.ViewObject.Proxy.doubleClicked(made.ViewObject)
    yield driver.until("the panel", lambda: driver.there("BorderPanel"))
    driver.said["leaning_again"] = listed(driver)
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    App.closeDocument(document.Name)
