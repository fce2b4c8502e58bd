"""What a user does in FreeCAD's window, one scenario a function; gui_driver.py carries them out."""

import os
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

OUT = Path(os.environ["SUTURE_OUT"])
ROOT = Path(os.environ["SUTURE_SOURCE_DIR"])
OK, CANCEL, CLOSE = (
    QtGui.QDialogButtonBox.Ok,
    QtGui.QDialogButtonBox.Cancel,
    QtGui.QDialogButtonBox.Close,
)


def open_example(driver, name="suitcase_corner"):
    Gui.activateWorkbench("SutureWorkbench")
    import ImportGui

    document = App.newDocument("Model")
    ImportGui.insert(str(ROOT / "docs/examples" / f"{name}.step"), document.Name)
    obj = document.Objects[-1]
    obj.Label = name.replace("_", " ")
    driver.look(1.1, 0.9, 0.8)
    return document, obj


def walk(driver):
    """The whole way: open, find, fill with preview, OK, check, export. Takes the pictures of docs."""
    Gui.activateWorkbench("SutureWorkbench")
    driver.later(lambda: Gui.runCommand("Std_Open", 0))
    yield driver.pause(0.7)
    driver.choose_file(ROOT / "docs/examples/suitcase_corner.step", "STEP with colors")
    yield driver.until("the model", lambda: App.ActiveDocument and App.ActiveDocument.Objects)
    document, obj = App.ActiveDocument, App.ActiveDocument.Objects[-1]
    obj.Label = "suitcase corner"
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(1.0)
    driver.picture("1_open")

    driver.tool("Suture_FindHoles")
    yield driver.until("the holes", lambda: driver.there("SutureHoles") and driver.find("SutureFillTicked").isEnabled())
    tree = driver.find("SutureHoles", QtGui.QTreeWidget)
    row = tree.topLevelItem(0).child(0)
    driver.said["row"] = [row.text(column) for column in range(5)]
    driver.click_row(tree, row, 1)
    yield driver.until("the edges", lambda: bool(Gui.Selection.getSelectionEx()))
    driver.said["selected"] = list(Gui.Selection.getSelectionEx()[0].SubElementNames)
    yield driver.pause(0.5)
    driver.picture("2_holes")

    driver.click(driver.find("SutureFillTicked"))
    yield driver.until("the fill panel", lambda: driver.there("SutureMethod"))
    method = driver.find("SutureMethod", QtGui.QComboBox)
    method.setCurrentText("mvs")
    yield driver.until("the preview", lambda: "within" in driver.status())
    Gui.Selection.clearSelection()
    yield driver.pause(0.5)
    driver.said["preview"] = driver.status()
    driver.said["objects_before"] = len(document.Objects)
    driver.picture("3_preview")

    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    driver.said["solid"] = filled.Shape.ShapeType
    driver.said["valid"] = filled.Shape.isValid()
    driver.said["undo"] = document.UndoCount
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.5)
    driver.picture("4_filled")

    Gui.Selection.addSelection(filled)
    driver.tool("Suture_Check")
    yield driver.until("the check", lambda: driver.there("SutureEdges") and "pass" in driver.status())
    driver.said["check"] = driver.status()
    table = driver.find("SutureEdges", QtGui.QTreeWidget)
    driver.said["rows"] = table.topLevelItemCount()
    yield driver.pause(0.5)
    driver.picture("5_check")
    driver.click_row(table, table.topLevelItem(0), 1)
    yield driver.until("the edge", lambda: bool(Gui.Selection.getSelectionEx()))
    driver.click(driver.find("SutureCombsBox"))
    yield driver.pause(0.7)
    driver.picture("6_combs")
    driver.click(driver.find("SutureCombsBox"))
    yield driver.pause(0.3)
    driver.click(driver.find("SutureZebraBox"))
    yield driver.pause(0.5)
    driver.said["zebra"] = driver.find("SutureZebraBox").isChecked()
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.7)
    driver.picture("7_zebra")
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())

    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(filled)
    yield from export(driver, OUT / "filled.step", "STEP with holes filled", "8_export")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    yield from export(driver, OUT / "exported.step", "STEP with holes filled")
    yield from export(driver, OUT / "exported.iges", "IGES with holes filled")


def export(driver, path, kind, picture=None):
    """File > Export of what is selected, through FreeCAD's own dialog."""
    driver.later(lambda: Gui.runCommand("Std_Export", 0))
    yield driver.pause(0.7)
    driver.choose_file(path, kind, picture)
    yield driver.until("the file", path.exists)
    yield driver.pause(0.3)


def idle(driver):
    """How often the window ticks when it has nothing to do."""
    before, began = driver.ticks, time.monotonic()
    yield driver.pause(1.0)
    driver.said["ticks_idle"] = (driver.ticks - before) / (time.monotonic() - began)


def slow(driver):
    """A fill that takes long: the window lives, Stop ends it within two seconds, nothing is left."""
    open_example(driver)
    yield driver.pause(0.5)
    yield from idle(driver)
    driver.tool("Suture_Fill")
    yield driver.until("the run", lambda: driver.there("SutureStop"))
    yield driver.until("the fill", lambda: "filling" in driver.status())
    before, began = driver.ticks, time.monotonic()
    yield driver.pause(2.0)
    driver.said["ticks_per_second"] = (driver.ticks - before) / (time.monotonic() - began)
    pids = descendants()
    driver.said["processes_while_running"] = len(pids)
    driver.picture("slow")
    began = time.monotonic()
    driver.click(driver.find("SutureStop"))
    yield driver.until("the status", lambda: "Stopped" in driver.status())
    driver.said["seconds_to_answer"] = time.monotonic() - began
    yield driver.until("the end of the processes", lambda: not any(map(alive, pids)))
    driver.said["seconds_to_stop"] = time.monotonic() - began
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["objects"] = len(App.ActiveDocument.Objects)


def slow_ok(driver):
    """OK without a preview waits in a dialog; its Stop leaves the panel open and the model alone."""
    open_example(driver)
    yield driver.pause(0.5)
    yield from idle(driver)
    driver.tool("Suture_Fill")
    yield driver.until("the holes", lambda: driver.there("SuturePreview"))
    driver.find("SuturePreview", QtGui.QCheckBox).setChecked(False)
    yield driver.until("the holes", lambda: "No preview" in driver.status())
    driver.press(OK)
    yield driver.until("the dialog", lambda: driver.there("SutureProgress"))
    before, began = driver.ticks, time.monotonic()
    yield driver.pause(2.0)
    driver.said["ticks_per_second"] = (driver.ticks - before) / (time.monotonic() - began)
    pids = descendants()
    dialog = driver.find("SutureProgress")
    began = time.monotonic()
    driver.click(dialog.findChildren(QtGui.QPushButton)[0])
    yield driver.until("the dialog to close", lambda: not driver.there("SutureProgress"))
    driver.said["seconds_to_stop"] = time.monotonic() - began
    driver.said["processes_while_running"] = len(pids)
    driver.said["left"] = sum(map(alive, pids))
    driver.said["panel_open"] = driver.dialog_open()
    driver.said["objects"] = len(App.ActiveDocument.Objects)


def descendants():
    """The processes below this one (Linux)."""
    parents = {}
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                fields = (folder / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            parents.setdefault(int(fields[1]), []).append(int(folder.name))
    found, todo = [], [os.getpid()]
    while todo:
        children = parents.get(todo.pop(), [])
        found += children
        todo += children
    return found


def alive(pid):
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def failures(driver):
    """A refused hole: a sentence, its edges selected; a missing program: how to get it."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    driver.tool("Suture_Fill")
    yield driver.until("the panel", lambda: driver.there("SutureMethod"))
    driver.find("SutureMethod", QtGui.QComboBox).setCurrentText("extend")
    yield driver.until("the refusal", lambda: "refused" in driver.status())
    driver.said["refusal"] = driver.status()
    driver.said["selected"] = list(Gui.Selection.getSelectionEx()[0].SubElementNames)
    yield driver.pause(0.3)
    driver.picture("refused")
    App.ParamGet("User parameter:BaseApp/Preferences/Mod/Suture").SetString("Program", "/no/suture")
    driver.find("SutureMethod", QtGui.QComboBox).setCurrentText("mvs")
    yield driver.until("the sentence", lambda: "There is no program" in driver.status())
    driver.said["missing"] = driver.status()
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
    driver.tool("Suture_Fill")
    yield driver.until("the preview", lambda: driver.there("SutureStatus") and "within" in driver.status())
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    driver.said["edges"] = list(filled.Base[1])
    driver.said["hidden"] = not obj.ViewObject.Visibility
    filled.ViewObject.Proxy.doubleClicked(filled.ViewObject)
    yield driver.until("the preview", lambda: driver.there("SutureStatus") and "within" in driver.status())
    combo = driver.find("SutureSide9", QtGui.QComboBox)
    combo.setCurrentText("G0")
    yield driver.until("a new preview", lambda: "within" not in driver.status())
    yield driver.until("its end", lambda: "within" in driver.status())
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
    yield driver.pause(1.5)
    driver.said["found"] = driver.find("SutureProgramFound", QtGui.QLabel).text()
    driver.picture_of_all("9_preferences")
    path = driver.find("SutureProgramPath", QtGui.QLineEdit)
    path.setText("/no/suture")
    driver.said["not_found"] = driver.find("SutureProgramFound", QtGui.QLabel).text()
    path.setText(os.environ["SUTURE_EXE"])
    page = driver.find("SuturePreferences")
    page.findChildren(QtGui.QComboBox)[0].setCurrentText("mvs")
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
    driver.tool("Suture_Convert")
    yield driver.until("the panel", lambda: driver.there("SutureFiles"))
    panel = driver.find("ConvertPanel")
    driver.later(lambda: driver.click(panel.findChildren(QtGui.QPushButton)[0]))
    yield driver.pause(1.0)
    driver.choose_file(" ".join(f'"{path}"' for path in [*sources, broken]), "Models")
    yield driver.until("the list", lambda: driver.find("SutureFiles", QtGui.QListWidget).count() == 3)
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
    driver.tool("Suture_Fill")
    yield driver.until("the preview", lambda: driver.there("SutureStatus") and "within" in driver.status())
    yield driver.pause(0.3)
    driver.picture("part")
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    driver.said["parent"] = filled.getParentGeoFeatureGroup().Name
    driver.said["colors"] = [[round(x, 2) for x in color] for color in filled.ViewObject.DiffuseColor]
    driver.said["wanted"] = [[round(x, 2) for x in color] for color in obj.ViewObject.DiffuseColor]
    driver.said["plain"] = [round(x, 2) for x in obj.ViewObject.ShapeColor]
    driver.look(1.1, 0.9, 0.8)
    Gui.Selection.clearSelection()
    yield driver.pause(0.3)
    driver.picture("colors")


def recompute(driver):
    """A slow recompute shows a dialog, the window lives, Stop leaves the last shape."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    Gui.Selection.addSelection(obj)
    driver.tool("Suture_Fill")
    yield driver.until("the preview", lambda: driver.there("SutureStatus") and "within" in driver.status())
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    volume = filled.Shape.Volume
    os.environ["SUTURE_EXE"] = str(ROOT / "tests/plugin/bad_suture.py")
    yield from idle(driver)
    filled.Method = "mvs"
    driver.later(document.recompute)
    yield driver.until("the dialog", lambda: driver.there("SutureProgress"))
    before, began = driver.ticks, time.monotonic()
    yield driver.pause(2.0)
    driver.said["ticks_per_second"] = (driver.ticks - before) / (time.monotonic() - began)
    pids = descendants()
    driver.picture_of_all("recompute")
    began = time.monotonic()
    driver.click(driver.find("SutureProgress").findChildren(QtGui.QPushButton)[0])
    yield driver.until("the end of the processes", lambda: not any(map(alive, pids)))
    driver.said["seconds_to_stop"] = time.monotonic() - began
    yield driver.until("the dialog to close", lambda: not driver.there("SutureProgress"))
    yield driver.pause(0.3)
    driver.said["state"] = list(filled.State)
    driver.said["kept"] = filled.Shape.Volume == volume


def german(driver):
    """The texts of the toolbar and of a panel in another language."""
    open_example(driver)
    yield driver.pause(0.5)
    buttons = driver.window.findChildren(QtGui.QToolButton)
    actions = [button.defaultAction() for button in buttons if button.defaultAction()]
    driver.said["button"] = [a.text() for a in actions if a.objectName() == "Suture_FindHoles"][0]
    driver.tool("Suture_Fill")
    yield driver.until("the hole", lambda: driver.there("SutureHoles") and rows(driver))
    driver.said["row"] = [rows(driver)[0].text(column) for column in range(3)]
    boxes = driver.find("FillPanel").findChildren(QtGui.QDoubleSpinBox)
    driver.said["gap"] = boxes[0].text()
    driver.picture("german")


def rows(driver):
    """The rows of the first group of the list of holes."""
    group = driver.find("SutureHoles", QtGui.QTreeWidget).topLevelItem(0)
    return [group.child(index) for index in range(group.childCount())] if group else []


def closing(driver):
    """The document is closed while a fill of it runs: the panel goes, and the processes too."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    driver.tool("Suture_Fill")
    yield driver.until("the fill", lambda: driver.there("SutureStatus") and "filling" in driver.status())
    pids = descendants()
    App.closeDocument(document.Name)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.until("the end of the processes", lambda: not any(map(alive, pids)), 5)
    driver.said["processes"] = len(pids)
    open_example(driver, "box_without_lid")
    yield driver.pause(0.5)
    driver.tool("Suture_FindHoles")
    yield driver.until("the holes", lambda: driver.there("SutureHoles") and rows(driver))
    driver.said["row"] = rows(driver)[0].text(0)
