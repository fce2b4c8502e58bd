"""Ways to leave a panel, what can be selected, what is said: each was wrong once."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import Part
from gui_common import CANCEL, OK, OUT, open_example, rows
from PySide import QtCore, QtGui


def filled_corner(driver, method="mvs"):
    """A corner that was filled by script."""
    document, obj = open_example(driver)
    from suture_workbench import api

    filled = api.fill(obj, method=method)
    yield driver.pause(0.3)
    driver.look(1.1, 0.9, 0.8)
    return document, obj, filled


def double_click(driver, obj):
    """A double click on an object in the tree (`yield from` it)."""

    for dock in driver.window.findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Combo View", "Tree view", "Model"):
            dock.show()

    def rows():
        return [
            (tree, row)
            for tree in driver.window.findChildren(QtGui.QTreeWidget)
            if tree.isVisible()
            for row in tree.findItems(obj.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
        ]

    yield driver.until("the tree", rows, 20)
    tree, row = rows()[0]
    tree.scrollToItem(row)
    place = QtCore.QPointF(tree.visualItemRect(row).center())
    for kind in (
        QtCore.QEvent.MouseButtonPress,
        QtCore.QEvent.MouseButtonRelease,
        QtCore.QEvent.MouseButtonDblClick,
        QtCore.QEvent.MouseButtonRelease,
    ):
        button, none = QtCore.Qt.LeftButton, QtCore.Qt.NoModifier
        event = QtGui.QMouseEvent(kind, place, button, button, none)
        QtGui.QApplication.postEvent(tree.viewport(), event)


def shown(obj):
    return obj.ViewObject.Visibility


def escape_edit(driver):
    """Esc in the 3D view while a fill is edited leaves all as it was; looking is no step of undo."""
    document, obj, filled = yield from filled_corner(driver)
    driver.said["undo"] = document.UndoCount
    yield from double_click(driver, filled)
    yield driver.preview()
    driver.said["while"] = [shown(obj), shown(filled), driver.drawn() > 0]
    driver.key(driver.view_widget(), QtCore.Qt.Key_Escape)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.pause(0.3)
    driver.said["after"] = [shown(obj), shown(filled), driver.drawn()]
    driver.said["undo_after_escape"] = document.UndoCount
    yield from double_click(driver, filled)
    yield driver.preview()
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.pause(0.3)
    driver.said["after_cancel"] = [shown(obj), shown(filled), driver.drawn()]
    driver.said["undo_after_cancel"] = document.UndoCount
    App.closeDocument(document.Name)
    yield driver.pause(0.5)


def edit_another(driver):
    """A second fill is edited while the first one is; then it is deleted under its panel."""
    document, obj, filled = yield from filled_corner(driver)
    from suture_workbench import api

    other_base = document.addObject("Part::Feature", "OtherBase")
    other_base.Shape = obj.Shape.translated(App.Vector(40, 0, 0))
    other = api.fill(other_base, method="mvs")
    yield driver.pause(0.3)
    view = Gui.getDocument(document.Name)
    view.setEdit(filled.Name)
    yield driver.preview()
    view.setEdit(other.Name)
    yield driver.until("the other panel", lambda: driver.dialog_open() and shown(other_base))
    yield driver.pause(0.5)
    driver.said["first"] = [shown(obj), shown(filled)]
    yield driver.preview()
    document.removeObject(other.Name)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.pause(0.5)
    driver.said["drawn"] = driver.drawn()
    driver.said["base"] = shown(other_base)


def escape_new(driver):
    """Esc in the 3D view cancels a new fill."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.key(driver.view_widget(), QtCore.Qt.Key_Escape)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["after"] = [shown(obj), driver.drawn(), len(document.Objects)]


def groups(driver):
    """A LinkGroup, the only thing there is, is filled from the tree; hiding a part changes nothing."""
    document, obj = open_example(driver)
    group = document.addObject("App::LinkGroup", "Group")
    other = document.addObject("Part::Feature", "Other")
    other.Shape = obj.Shape.translated(App.Vector(40, 0, 0))
    group.ElementList = [obj, other]
    document.recompute()
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.5)
    Gui.Selection.clearSelection()
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.said["heading"] = driver.find("SutureHeading", QtGui.QLabel).text()
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.pause(0.3)
    filled = document.getObject("Filled")
    driver.said["state"] = list(filled.State)
    driver.said["solids"] = [len(filled.Shape.Solids)]
    key = filled.InputKey
    for hidden in (obj, other, group):
        hidden.ViewObject.Visibility = False
        filled.touch()
        document.recompute()
        driver.said["solids"].append(len(filled.Shape.Solids))
    driver.said["same"] = filled.InputKey == key and filled.isValid()


def message(driver):
    """What a box says; then it is closed."""
    yield driver.until("the box", lambda: driver.there("SutureFailure"))
    driver.said.setdefault("messages", []).append(
        driver.find("SutureFailure", QtGui.QMessageBox).text()
    )
    driver.click(driver.find("SutureFailure").findChildren(QtGui.QPushButton)[0])
    yield driver.until("the box to close", lambda: not driver.there("SutureFailure"))


def targets(driver):
    """What cannot be worked on is named, with the next step; nothing else is taken instead."""
    import Mesh

    document, obj = open_example(driver)
    mesh = document.addObject("Mesh::Feature", "Triangles")
    mesh.Mesh = Mesh.createBox(5, 5, 5)
    wire = document.addObject("Part::Feature", "Outline")
    wire.Shape = Part.makePolygon([App.Vector(), App.Vector(1, 0, 0), App.Vector(1, 1, 0)])
    second = document.addObject("Part::Feature", "Second")
    second.Shape = Part.makeBox(3, 3, 3)
    document.recompute()
    yield driver.pause(0.5)
    for chosen in ([mesh], [wire], [obj, second], []):
        Gui.Selection.clearSelection()
        for one in chosen:
            Gui.Selection.addSelection(one)
        driver.later(lambda: Gui.runCommand("Suture_Fill", 0))
        yield from message(driver)
        driver.said["open"] = driver.dialog_open()


def picking(driver):
    """An edge clicked in the view shows its row; a row turns the camera to its hole."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    Gui.Selection.addSelection(obj)
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    edge = obj.Shape.Edges[18]
    driver.pick("Edge19", edge.valueAt(sum(edge.ParameterRange) / 2))
    sides = driver.find("SutureSides", QtGui.QTreeWidget)
    yield driver.until("the row", lambda: sides.currentItem() is not None)
    driver.said["side"] = sides.currentItem().text(0)
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.look(-1.1, -0.9, -0.8)  # from behind
    view = Gui.ActiveDocument.ActiveView
    outward = App.Vector(1, 1, 1).normalize()
    middle = sum((obj.Shape.Edges[n - 1].CenterOfMass for n in (9, 19, 21)), App.Vector()) / 3
    if (middle - obj.Shape.BoundBox.Center).dot(outward) < 0:
        outward = outward * -1
    driver.said["before"] = -App.Vector(view.getViewDirection()).dot(outward)
    yield from driver.tool("Suture_FindHoles")
    yield driver.until("the hole", lambda: driver.there("SutureHoles") and rows(driver))
    driver.click_row(driver.find("SutureHoles", QtGui.QTreeWidget), rows(driver)[0], 1)
    yield driver.until("the edges", lambda: bool(Gui.Selection.getSelectionEx()))
    yield driver.pause(0.5)
    driver.said["facing"] = -App.Vector(view.getViewDirection()).dot(outward)
    driver.picture("turned")
    Gui.Selection.clearSelection()
    tree = driver.find("SutureHoles", QtGui.QTreeWidget)
    tree.clearSelection()
    driver.pick("Edge9", obj.Shape.Edges[8].valueAt(sum(obj.Shape.Edges[8].ParameterRange) / 2))
    yield driver.until("the row", lambda: bool(tree.selectedItems()))
    driver.said["hole"] = tree.selectedItems()[0].text(0)


def shortcuts(driver):
    """No shortcut of ours is one of FreeCAD's, or the beginning of one."""
    for name in ("Draft", "Part", "PartDesign", "Sketcher", "Surface", "Mesh", "Suture"):
        Gui.activateWorkbench(f"{name}Workbench")
        yield driver.pause(0.2)
    keys = {name: Gui.Command.get(name).getShortcut() for name in Gui.listCommands()}
    ours = {name: key for name, key in keys.items() if name.startswith("Suture_")}
    driver.said["ours"] = ours
    driver.said["clashes"] = [
        [name, other]
        for name, key in ours.items()
        for other, taken in keys.items()
        if name != other and key and taken
        and (taken.startswith(key) or key.startswith(taken + ","))
    ]


def language(driver):
    """The commands follow the language."""
    open_example(driver)
    yield driver.pause(0.5)

    def text():
        action = Gui.Command.get("Suture_FindHoles").getAction()[0]
        return action.text().replace("&", "")

    driver.said["texts"] = [text()]
    Gui.setLocale("German")
    yield driver.pause(0.5)
    driver.said["texts"].append(text())
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.said["status"] = driver.status()
    driver.said["label"] = driver.find("gapLabel", QtGui.QLabel).text() if driver.there("gapLabel") else ""
    driver.choose("SutureMethod", "extend")
    yield driver.until("the refusal", lambda: driver.settled() and driver.state() == "bad")
    driver.said["refusal"] = driver.status()
    driver.picture("german")


def bad_fill(driver):
    """A fill that is far from what was asked for is not kept unasked; only its bad sides are named."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.choose("SutureMethod", "occt")
    yield driver.pause(0.6)
    yield driver.preview()
    driver.said["status"], driver.said["state"] = driver.status(), driver.state()
    yield driver.pause(0.3)
    driver.picture("bad")
    for button in (1, 0):  # change something; keep it
        driver.press(OK)
        yield driver.until("the question", lambda: driver.there("SutureDoubts"))
        box = driver.find("SutureDoubts", QtGui.QMessageBox)
        driver.said["question"] = box.text()
        driver.said.setdefault("objects", []).append(len(document.Objects))
        named = [b for b in box.findChildren(QtGui.QPushButton)]
        wanted = "Change something" if button else "Keep it"
        driver.click([b for b in named if b.text().replace("&", "") == wanted][0])
        yield driver.until("the box to close", lambda: not driver.there("SutureDoubts"))
        yield driver.pause(0.3)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["objects"].append(len(document.Objects))


def runs():
    """How often the program was asked to fill (bad_suture.py counts)."""
    path = OUT / "runs"
    return len(path.read_text().splitlines()) if path.exists() else 0


def no_run_twice(driver):
    """OK waits for the preview that runs already; an edit begins with what the object has."""
    document, obj = open_example(driver)
    yield driver.pause(0.5)
    os.environ["SUTURE_RUNS"] = str(OUT / "runs")
    yield from driver.tool("Suture_Fill")
    yield driver.until("the fill", lambda: runs() == 1)
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["runs"] = [runs()]
    filled = document.getObject("Filled")
    Gui.getDocument(document.Name).setEdit(filled.Name)
    yield driver.preview()
    driver.said["runs"].append(runs())
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["runs"].append(runs())
    driver.said["state"] = list(filled.State)


def failed_recompute(driver):
    """A refusal at a recompute is one sentence in the report view, no traceback."""
    document, obj, filled = yield from filled_corner(driver)
    filled.Method = "extend"
    document.recompute()
    yield driver.pause(0.5)
    driver.said["state"] = list(filled.State)
    driver.said["why"] = filled.getStatusString()
    driver.said["report"] = [
        v.toPlainText() for v in driver.window.findChildren(QtGui.QTextEdit) if v.objectName() == "Report view"
    ][0][-600:]
