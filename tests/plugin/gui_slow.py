"""Runs that take long: the window lives, and stopping them leaves nothing behind."""

import os
import time

import FreeCAD as App
import FreeCADGui as Gui
from gui_common import CANCEL, OK, ROOT, alive, descendants, idle, open_example, rows
from PySide import QtGui


def slow(driver):
    """A fill that takes long: the window lives, Stop ends it within two seconds, nothing is left."""
    open_example(driver)
    yield driver.pause(0.5)
    yield from idle(driver)
    yield from driver.tool("Suture_Fill")
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
    yield from driver.tool("Suture_Fill")
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


def recompute(driver):
    """A slow recompute shows a dialog, the window lives, Stop leaves the last shape."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    Gui.Selection.addSelection(obj)
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
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


def closing(driver):
    """The document is closed while a fill of it runs: the panel goes, and the processes too."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    yield from driver.tool("Suture_Fill")
    yield driver.until(
        "the fill", lambda: driver.there("SutureStatus") and "filling" in driver.status()
    )
    pids = descendants()
    App.closeDocument(document.Name)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.until("the end of the processes", lambda: not any(map(alive, pids)), 5)
    driver.said["processes"] = len(pids)
    open_example(driver, "box_without_lid")
    yield driver.pause(0.5)
    yield from driver.tool("Suture_FindHoles")
    yield driver.until("the holes", lambda: driver.there("SutureHoles") and rows(driver))
    driver.said["row"] = rows(driver)[0].text(0)
