"""A user's whole way, with the pictures of docs/freecad.md."""

import os

import FreeCAD as App
import FreeCADGui as Gui
from gui_common import CLOSE, OK, OUT, ROOT
from PySide import QtCore, QtGui


def walk(driver):
    """The whole way: open, find, fill with preview, OK, check, export. Takes the pictures of docs."""
    Gui.activateWorkbench("SutureWorkbench")
    driver.panel_width(300)
    yield from get_program(driver)
    driver.later(lambda: Gui.runCommand("Std_Open", 0))
    yield from driver.choose_file(ROOT / "docs/examples/suitcase_corner.step", "STEP with colors")
    yield driver.until("the model", lambda: opened() or options_of_import())
    if not opened():  # 1.x asks how to import
        driver.press(OK, options_of_import()[0])
    yield driver.until("the model", opened)
    document, obj = App.ActiveDocument, App.ActiveDocument.Objects[-1]
    obj.Label = "suitcase corner"
    yield driver.pause(1.5)  # FreeCAD fits the view to what it has opened
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(1.0)
    driver.picture("1_open")

    yield from driver.tool("Suture_FindHoles")
    yield driver.until(
        "the holes",
        lambda: driver.there("SutureHoles") and driver.find("SutureFillTicked").isEnabled(),
    )
    tree = driver.find("SutureHoles", QtGui.QTreeWidget)
    row = tree.topLevelItem(0).child(0)
    driver.said["row"] = [row.text(column) for column in range(4)]
    driver.click_row(tree, row, 1)
    yield driver.until("the edges", lambda: bool(Gui.Selection.getSelectionEx()))
    driver.said["selected"] = list(Gui.Selection.getSelectionEx()[0].SubElementNames)
    yield driver.pause(0.5)
    driver.picture("2_holes")

    driver.click(driver.find("SutureFillTicked"))
    yield driver.until("the fill panel", lambda: driver.there("SutureMethod"))
    driver.choose("SutureMethod", "mvs")
    yield driver.pause(0.5)
    yield driver.preview()
    Gui.Selection.clearSelection()
    yield driver.pause(0.5)
    driver.said["preview"] = driver.status()
    driver.said["objects_before"] = len(document.Objects)
    driver.picture("3_preview")
    driver.unfold("SutureSurface")
    yield driver.until("the shading", lambda: driver.there("SutureShading"))
    driver.choose("SutureShading", "zebra")
    yield driver.pause(0.7)
    driver.picture("3_stripes")

    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    filled = document.getObject("Filled")
    driver.said["solid"] = filled.Shape.ShapeType
    driver.said["valid"] = filled.Shape.isValid()
    driver.said["undo"] = document.UndoCount
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.5)
    driver.picture("4_filled")
    Gui.getDocument(document.Name).setEdit(filled.Name)
    yield driver.preview()
    driver.find("SutureSide9", QtGui.QComboBox).setCurrentText("G0")
    yield driver.pause(0.6)
    yield driver.preview()
    yield driver.pause(0.3)
    driver.picture("4_edit")
    driver.key(driver.view_widget(), QtCore.Qt.Key_Escape)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["edited"] = filled.EdgesG0 is not None
    driver.look(1.1, 0.9, 0.8)

    Gui.Selection.addSelection(filled)
    yield from driver.tool("Suture_Check")
    yield driver.until(
        "the check", lambda: driver.there("SutureEdges") and driver.settled()
    )
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
    driver.unfold("SutureSurface")
    yield driver.until("the shading", lambda: driver.there("SutureShading"))
    driver.choose("SutureShading", "zebra")
    yield driver.pause(0.5)
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.7)
    driver.picture("7_zebra")
    driver.click(driver.find("SutureExportReport"))
    yield from driver.choose_file(OUT / "report.html", "look at")
    yield driver.until("the report", (OUT / "report.html").exists)
    yield driver.until("its end", lambda: not driver.there("SutureProgress"))
    driver.said["report"] = (OUT / "report.html").read_text(encoding="utf-8")[:15].lower()
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())

    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(filled)
    yield from export(driver, OUT / "filled.step", "STEP with holes filled", "8_export")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    yield from export(driver, OUT / "exported.step", "STEP with holes filled")
    yield from export(driver, OUT / "exported.iges", "IGES with holes filled")


def opened():
    return App.ActiveDocument and App.ActiveDocument.Objects


def options_of_import():
    """FreeCAD's own dialog about the import, in a list; empty if there is none."""
    windows = QtGui.QApplication.topLevelWidgets()
    dialogs = [w for w in windows if isinstance(w, QtGui.QDialog) and w.isVisible()]
    return [d for d in dialogs if not isinstance(d, QtGui.QFileDialog)]


def get_program(driver):
    """The dialog for getting the program: it is located in a folder where nobody looks for it."""
    from suture_workbench import settings
    from suture_workbench.gui.program_dialog import ProgramDialog

    settings.save_program("/no/suture")
    dialog = ProgramDialog()
    driver.later(dialog.run)
    yield driver.until("the dialog", lambda: driver.there("SutureProgramDialog"))
    yield driver.pause(0.3)
    state = driver.find("SutureProgramState", QtGui.QLabel)
    driver.said["program"] = [state.text()]
    driver.find("SutureProgramDialog").grab().save(str(OUT / "0_program.png"))
    dialog.locate(os.environ["SUTURE_EXE"])
    driver.said["program"].append(driver.find("SutureProgramState", QtGui.QLabel).text())
    driver.press(CLOSE, driver.find("SutureProgramDialog"))
    yield driver.until("the dialog to close", lambda: not driver.there("SutureProgramDialog"))


def export(driver, path, kind, picture=None):
    """File > Export of what is selected, through FreeCAD's own dialog."""
    driver.later(lambda: Gui.runCommand("Std_Export", 0))
    yield from driver.choose_file(path, kind, picture)
    yield driver.until("the file", path.exists)
    yield driver.pause(0.3)
