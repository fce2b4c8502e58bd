"""Surfaces that files describe, made in the window."""

import FreeCAD as App
import FreeCADGui as Gui
from gui_common import CANCEL, OK, OUT, ROOT
from PySide import QtGui
from star_mesh import star


def surfaces(driver):
    """A control mesh and a problem of polynomials become objects; Cancel leaves nothing."""
    Gui.activateWorkbench("SutureWorkbench")
    mesh = star(OUT / "star.obj")
    yield from driver.tool("Suture_Patch")
    yield driver.until("the panel", lambda: driver.there("SurfacePanel"))
    driver.said["hint"] = driver.status()
    driver.later(lambda: driver.find("SutureChooseFile", QtGui.QPushButton).click())
    yield from driver.choose_file(mesh, "OBJ")
    yield driver.until("the surface", driver.settled)
    driver.said["patch"] = [driver.state(), driver.status()]
    Gui.ActiveDocument.ActiveView.fitAll()
    yield driver.pause(0.3)
    driver.said["drawn"] = [driver.drawn()]
    driver.picture("patch")
    driver.find("SutureOrder", QtGui.QSpinBox).setValue(0)
    yield driver.until("another", lambda: driver.settled() and "order 0" in driver.status())
    driver.said["objects"] = [len(App.ActiveDocument.Objects)]
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["objects"].append(len(App.ActiveDocument.Objects))
    driver.said["label"] = App.ActiveDocument.Objects[0].Label
    driver.said["undo"] = App.ActiveDocument.UndoCount

    yield from driver.tool("Suture_Algebraic")
    yield driver.until("the panel", lambda: driver.there("SurfacePanel"))
    driver.said["folded"] = driver.there("SutureOrder")
    driver.later(lambda: driver.find("SutureChooseFile", QtGui.QPushButton).click())
    yield from driver.choose_file(ROOT / "docs/examples/table_corner.json", "JSON")
    yield driver.until("the surface", driver.settled)
    yield driver.pause(0.3)
    driver.said["algebraic"] = [driver.state(), driver.status()]
    driver.picture("algebraic")
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.pause(0.2)
    driver.said["drawn"].append(driver.drawn())
    driver.said["objects"].append(len(App.ActiveDocument.Objects))

    yield from driver.tool("Suture_Algebraic")
    yield driver.until("the panel", lambda: driver.there("SurfacePanel"))
    driver.later(lambda: driver.find("SutureChooseFile", QtGui.QPushButton).click())
    bad = OUT / "bad.json"
    bad.write_text("{}", encoding="ascii")
    yield from driver.choose_file(bad, "JSON")
    yield driver.until("the refusal", driver.settled)
    driver.said["bad"] = [driver.state(), driver.status()]
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
