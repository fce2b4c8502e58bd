"""What the scenarios share."""

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


def idle(driver):
    """How often the window ticks when it has nothing to do."""
    before, began = driver.ticks, time.monotonic()
    yield driver.pause(1.0)
    driver.said["ticks_idle"] = (driver.ticks - before) / (time.monotonic() - began)


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


def rows(driver):
    """The rows of the first group of the list of holes."""
    group = driver.find("SutureHoles", QtGui.QTreeWidget).topLevelItem(0)
    return [group.child(index) for index in range(group.childCount())] if group else []
