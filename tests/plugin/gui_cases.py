"""What else a user does and meets in the window."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import Part
from gui_common import CANCEL, CLOSE, OK, OUT, ROOT, open_example, rows
from PySide import QtGui


def failures(driver):
    """A refused hole: a sentence, its edges selected; a missing program: how to get it."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    yield from driver.tool("Suture_Fill")
    yield driver.until("the panel", lambda: driver.there("SutureMethod"))
    driver.choose("SutureMethod", "extend")
    yield driver.until("the refusal", lambda: "refused" in driver.status())
    driver.said["way_on_unasked"] = driver.there("SutureWayOn")
    driver.said["refusal"] = driver.status()
    driver.said["selected"] = list(Gui.Selection.getSelectionEx()[0].SubElementNames)
    yield driver.pause(0.3)
    driver.picture("refused")
    App.ParamGet("User parameter:BaseApp/Preferences/Mod/Suture").SetString("Program", "/no/suture")
    driver.choose("SutureMethod", "mvs")
    yield driver.until("the sentence", lambda: "There is no program" in driver.status())
    driver.said["missing"] = driver.status()
    driver.said["way_on"] = driver.there("SutureWayOn")
    driver.press(OK)
    yield driver.until("the box", lambda: driver.there("SutureFailure"))
    driver.said["box"] = driver.find("SutureFailure", QtGui.QMessageBox).text()
    driver.picture("missing")
    driver.click(driver.find("SutureFailure").findChildren(QtGui.QPushButton)[0])
    yield driver.until("the box to close", lambda: not driver.there("SutureFailure"))
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["objects"] = len(document.Objects)


def edit(driver):
    """An edge picked in the view, the fill edited by a double click, undone and redone."""
    document, obj = open_example(driver)
    yield driver.pause(0.7)
    edge = obj.Shape.Edges[8]
    middle = edge.valueAt(sum(edge.ParameterRange) / 2)
    driver.pick("Edge9", middle)
    yield driver.until("the edge", lambda: bool(Gui.Selection.getSelectionEx()))
    driver.said["picked"] = list(Gui.Selection.getSelectionEx()[0].SubElementNames)
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    driver.said["edges"] = list(filled.Base[1])
    driver.said["hidden"] = not obj.ViewObject.Visibility
    filled.ViewObject.Proxy.doubleClicked(filled.ViewObject)
    yield driver.preview()
    combo = driver.find("SutureSide9", QtGui.QComboBox)
    combo.setCurrentText("G0")
    yield driver.until("a new preview", lambda: not driver.settled())
    yield driver.preview()
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["sides"] = list(filled.EdgesG0[1])
    driver.said["objects"] = len(document.Objects)
    driver.said["visible"] = filled.ViewObject.Visibility and not obj.ViewObject.Visibility
    Gui.runCommand("Std_Undo", 0)
    yield driver.pause(0.3)
    driver.said["sides_undone"] = filled.EdgesG0 is None or list(filled.EdgesG0[1])
    Gui.runCommand("Std_Undo", 0)
    yield driver.pause(0.3)
    driver.said["objects_undone"] = len(document.Objects)
    driver.said["base_back"] = obj.ViewObject.Visibility
    Gui.runCommand("Std_Redo", 0)
    yield driver.pause(0.3)
    driver.said["objects_redone"] = len(document.Objects)


def files(driver):
    """The preferences page, and files converted on disk without opening them."""
    import shutil

    Gui.activateWorkbench("SutureWorkbench")
    driver.later(lambda: Gui.showPreferences("Suture", 0))
    yield driver.until("the page", lambda: driver.there("SutureProgramFound"))
    yield driver.pause(0.5)
    driver.said["found"] = driver.find("SutureProgramFound", QtGui.QLabel).text()
    driver.picture_of_all("9_preferences")
    path = driver.find("SutureProgramPath", QtGui.QLineEdit)
    path.setText("/no/suture")
    driver.said["not_found"] = driver.find("SutureProgramFound", QtGui.QLabel).text()
    path.setText(os.environ["SUTURE_EXE"])
    page = driver.find("SuturePreferences")
    driver.find("SutureDefaultMethod", QtGui.QComboBox).setCurrentText("mvs")
    driver.press(OK, page.window())
    yield driver.until("the preferences to close", lambda: not driver.there("SuturePreferences"))
    from suture_workbench import settings

    driver.said["method"], driver.said["program"] = settings.method(), settings.program()

    sources = []
    for name in ("suitcase_corner", "box_without_lid"):
        sources.append(OUT / f"{name}.step")
        shutil.copyfile(ROOT / "docs/examples" / f"{name}.step", sources[-1])
    broken = OUT / "broken.step"
    broken.write_text("ISO-10303-21; nothing more", encoding="ascii")
    yield from driver.tool("Suture_Convert")
    yield driver.until("the panel", lambda: driver.there("SutureFiles"))
    panel = driver.find("ConvertPanel")
    driver.later(lambda: driver.click(panel.findChildren(QtGui.QPushButton)[0]))
    yield from driver.choose_file(" ".join(f'"{path}"' for path in [*sources, broken]), "Models")
    yield driver.until(
        "the list", lambda: driver.find("SutureFiles", QtGui.QListWidget).count() == 3
    )
    driver.click(driver.find("SutureRunConvert"))
    yield driver.until("the files", lambda: "written" in driver.status())
    yield driver.pause(0.3)
    driver.said["converted"] = driver.status()
    driver.said["documents"] = len(App.listDocuments())
    driver.picture("9_convert")
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())


def containers(driver):
    """A coloured base in a placed Part: colours are kept, the loop is drawn where it stands."""
    document, obj = open_example(driver)
    part = document.addObject("App::Part", "Part")
    part.addObject(obj)
    part.Placement = App.Placement(App.Vector(100, 50, 20), App.Rotation(30, 0, 0))
    colors = [(0.1 * index, 0.5, 1.0 - 0.1 * index, 0.0) for index in range(9)]
    obj.ViewObject.DiffuseColor = colors
    document.recompute()
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.5)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, "Part", f"{obj.Name}.Edge19")
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    yield driver.pause(0.3)
    driver.picture("part")
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    driver.said["parent"] = filled.getParentGeoFeatureGroup().Name
    driver.said["colors"] = [
        [round(x, 2) for x in color] for color in filled.ViewObject.DiffuseColor
    ]
    driver.said["wanted"] = [[round(x, 2) for x in color] for color in obj.ViewObject.DiffuseColor]
    driver.said["plain"] = [round(x, 2) for x in obj.ViewObject.ShapeColor[:3]] + [0.0]  # opaque
    driver.look(1.1, 0.9, 0.8)
    Gui.Selection.clearSelection()
    yield driver.pause(0.3)
    driver.picture("colors")


def through(driver):
    """A point beside the hole is selected in the view and added: the face goes through it."""
    document, obj = open_example(driver, "bump_window")
    edges = obj.Shape.Edges
    hole = [e for e in edges if len(obj.Shape.ancestorsOfType(e, Part.Face)) == 1]
    middle = sum((edge.CenterOfMass for edge in hole), App.Vector()) * (1 / len(hole))
    probe = document.addObject("Part::Feature", "Probe")
    probe.Shape = Part.Vertex(middle + App.Vector(0, 0, 0.5))
    document.recompute()
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.5)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    yield from driver.tool("Suture_Fill")
    yield driver.until("the preview", lambda: done(driver))
    driver.choose("SutureMethod", "mvs")
    driver.unfold("SutureMore")
    yield driver.until("the list", lambda: driver.there("SutureAddThrough"))
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, "Probe", "Vertex1")
    driver.click(driver.find("SutureAddThrough"))
    yield driver.until("the point", lambda: "passes 1 points" in driver.status())
    driver.said["status"] = driver.status()
    driver.picture("through")
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    new = [filled.Shape.Faces[number - 1] for number in filled.NewFaces]
    driver.said["distance"] = min(face.distToShape(probe.Shape)[0] for face in new)
    probe.Shape = Part.Vertex(middle + App.Vector(0, 0, 0.7))
    document.recompute()
    new = [filled.Shape.Faces[number - 1] for number in filled.NewFaces]
    driver.said["followed"] = min(face.distToShape(probe.Shape)[0] for face in new)


def near_misses(driver):
    """A corner filled by OCCT is not quite tangent: that shows, unless the limits are loosened."""
    document, obj = open_example(driver)
    from suture_workbench import api

    filled = api.fill(obj, method="occt")
    driver.look(1.1, 0.9, 0.8)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, filled.Name, "Edge9")
    yield from driver.tool("Suture_Check")
    yield driver.until("one edge", lambda: table(driver) and table(driver).topLevelItemCount() == 1)
    driver.said["one"] = table(driver).topLevelItemCount()
    driver.click(driver.find("SutureSelectedOnly", QtGui.QCheckBox))
    yield driver.until("all edges", lambda: table(driver).topLevelItemCount() == 21)
    row = table(driver).topLevelItem(0)
    driver.said["first"] = [row.text(0), row.text(1)]
    driver.said["legend"] = legend(driver)
    driver.click_row(table(driver), row, 1)
    yield driver.until("the edge", lambda: bool(Gui.Selection.getSelectionEx()))
    driver.said["selected"] = list(Gui.Selection.getSelectionEx()[0].SubElementNames)
    yield driver.pause(0.5)
    driver.picture("near_misses")
    driver.choose("SutureProfile", "own")
    yield driver.until("the same again", lambda: table(driver).topLevelItemCount() == 21)
    boxes = driver.find("CheckPanel").findChildren(QtGui.QDoubleSpinBox)
    boxes[0].setValue(1.0)
    boxes[1].setValue(2.0)
    yield driver.until("the loose limits", lambda: driver.state() == "good")
    driver.said["loose"] = legend(driver)


def overlays(driver):
    """The command for combs shows and hides them; a changed shape loses its drawings."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    Gui.Selection.addSelection(document.Name, obj.Name, "Edge1")
    counts = driver.said["counts"] = [driver.drawn()]
    for _ in range(3):
        yield from driver.tool("Suture_Combs")
        yield driver.until("the drawing", lambda: driver.drawn() != counts[-1])
        counts.append(driver.drawn())
        yield driver.pause(0.3)
    obj.Placement = App.Placement(App.Vector(1, 0, 0), App.Rotation())
    counts.append(driver.drawn())


def table(driver):
    return driver.there("SutureEdges") and driver.find("SutureEdges", QtGui.QTreeWidget)


def legend(driver):
    entries = driver.find("SutureLegend", QtGui.QListWidget)
    return [entries.item(index).text() for index in range(entries.count())]


def own_option(driver):
    """A method has an option of its own: its line appears, and what is typed is computed with."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    yield from driver.tool("Suture_Fill")
    yield driver.until("the preview", lambda: done(driver))
    driver.said["before"] = driver.there("SutureOption_bend")
    driver.choose("SutureMethod", "mvs")
    driver.unfold("SutureMore")
    yield driver.until("the line", lambda: driver.there("SutureOption_bend"))
    line = driver.find("SutureOption_bend", QtGui.QLineEdit)
    driver.said["tip"] = line.toolTip()
    line.setText("0.5")
    line.editingFinished.emit()
    yield driver.until("a new preview", lambda: not done(driver))
    yield driver.until("its end", lambda: done(driver))
    driver.picture("own_option")
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["kept"] = list(document.getObject("Filled").MethodOptions)


def done(driver):
    return driver.there("SutureSides") and driver.settled()


def german(driver):
    """The texts of the toolbar and of a panel in another language."""
    open_example(driver)
    yield driver.pause(0.5)
    buttons = driver.window.findChildren(QtGui.QToolButton)
    actions = [button.defaultAction() for button in buttons if button.defaultAction()]
    driver.said["button"] = [a.text() for a in actions if a.objectName() == "Suture_FindHoles"][0]
    yield from driver.tool("Suture_Fill")
    yield driver.until("the hole", lambda: driver.there("SutureHoles") and rows(driver))
    driver.said["row"] = [rows(driver)[0].text(column) for column in range(2)]
    boxes = driver.find("FillPanel").findChildren(QtGui.QDoubleSpinBox)
    driver.said["gap"] = boxes[0].text()
    driver.picture("german")
