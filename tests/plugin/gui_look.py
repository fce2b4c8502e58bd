"""How things look: panels in FreeCAD's usual width, stripes and curvature on models."""

import os
import time

import FreeCAD as App
import FreeCADGui as Gui
import Part
from gui_common import CANCEL, CLOSE, OK, open_example, rows
from PySide import QtCore, QtGui

WIDTH = 275  # of FreeCAD's panel by default


def cut_off(driver, panel):
    """The names of what lies beyond the right border of the task panel."""
    form = driver.find(panel)
    areas = [a for a in driver.window.findChildren(QtGui.QScrollArea) if a.isAncestorOf(form)]
    viewport = areas[-1].viewport()
    lists = form.findChildren(QtGui.QAbstractScrollArea)  # these scroll what they hold
    outside = []
    for widget in [form, *form.findChildren(QtGui.QWidget)]:
        if not widget.isVisible() or any(one.isAncestorOf(widget) for one in lists):
            continue
        right = widget.mapTo(viewport, QtCore.QPoint(widget.width(), 0)).x()
        if right > viewport.width():
            outside.append(widget.objectName() or type(widget).__name__)
    return outside


def squeezed(driver, panel):
    """The labels that are lower than their text is in their width."""
    labels = driver.find(panel).findChildren(QtGui.QLabel)
    return [
        label.objectName() or label.text()
        for label in labels
        if label.isVisible() and label.text() and label.height() < label.heightForWidth(label.width())
    ]


def look_at_panel(driver, panel, name, *folds):
    """Measures and pictures a panel, as it opens and with all of it unfolded."""
    yield driver.pause(0.4)
    yield driver.until("all labels at their height", lambda: not squeezed(driver, panel), 20)
    driver.said["cut_off"][name] = cut_off(driver, panel)
    driver.said["widths"][name] = driver.find(panel).width()
    driver.picture(name)
    for fold in folds:
        driver.unfold(fold)
        yield driver.pause(0.2)
        yield driver.until("all labels at their height", lambda: not squeezed(driver, panel), 20)
    if folds:
        driver.said["cut_off"][name + " unfolded"] = cut_off(driver, panel)
        form = driver.find(panel)
        form.grab().save(str(driver.out / f"{name}_unfolded.png"))


def narrow(driver):
    """Every panel in FreeCAD's default width."""
    driver.said["cut_off"], driver.said["widths"] = {}, {}
    document, obj = open_example(driver)
    obj.Label = "a label that is much longer than the panel is wide, as those from other programs"
    driver.panel_width(WIDTH)
    yield driver.pause(0.7)
    yield from driver.tool("Suture_FindHoles")
    yield driver.until("the hole", lambda: driver.there("SutureHoles") and rows(driver))
    driver.panel_width(WIDTH)
    yield from look_at_panel(driver, "HolesPanel", "holes")
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.panel_width(WIDTH)
    yield from look_at_panel(
        driver, "FillPanel", "fill", "SutureLimits", "SutureMore", "SutureSurface"
    )
    driver.choose("SutureShading", "zebra")
    driver.choose("SutureMethod", "tube")
    yield driver.pause(0.7)
    yield driver.preview()
    yield from look_at_panel(driver, "FillPanel", "tube", "SutureLimits")
    driver.choose("SutureMethod", "mvs")
    yield driver.pause(0.7)
    yield driver.preview()
    driver.press(OK)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.getObject("Filled"))
    yield from driver.tool("Suture_Check")
    yield driver.until("the check", lambda: driver.there("SutureEdges") and driver.settled())
    driver.panel_width(WIDTH)
    yield from look_at_panel(driver, "CheckPanel", "check", "SutureLimits", "SutureSurface")
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield from driver.tool("Suture_Zebra")
    yield driver.until("the panel", lambda: driver.there("ZebraPanel"))
    driver.panel_width(WIDTH)
    yield from look_at_panel(driver, "ZebraPanel", "zebra")
    driver.choose("SutureShading", "curvature")
    yield from look_at_panel(driver, "ZebraPanel", "curvature")
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield from driver.tool("Suture_Convert")
    yield driver.until("the panel", lambda: driver.there("ConvertPanel"))
    driver.panel_width(WIDTH)
    yield from look_at_panel(driver, "ConvertPanel", "convert")
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    for name in ("Patch", "Algebraic"):
        yield from driver.tool(f"Suture_{name}")
        yield driver.until("the panel", lambda: driver.there("SurfacePanel"))
        driver.panel_width(WIDTH)
        yield from look_at_panel(driver, "SurfacePanel", name.lower())
        driver.press(CANCEL)
        yield driver.until("the panel to close", lambda: not driver.dialog_open())
    from suture_workbench.gui.program_dialog import ProgramDialog

    dialog = ProgramDialog()
    driver.later(dialog.run)
    yield driver.until("the dialog", lambda: driver.there("SutureProgramDialog"))
    yield driver.pause(0.3)
    driver.picture_of_all("program")
    driver.press(CLOSE, driver.find("SutureProgramDialog"))
    yield driver.until("its end", lambda: not driver.there("SutureProgramDialog"))


def many_faces(count=20):
    """A model of 26 faces times `count`: rounded boxes."""
    box = Part.makeBox(8, 8, 8)
    rounded = box.makeFillet(1.5, box.Edges)
    copies = [
        rounded.translated(App.Vector(10 * (index % 5), 10 * (index // 5), 0))
        for index in range(count)
    ]
    return Part.Compound(copies)


def pixels(driver):
    """The picture of the 3D view."""
    driver.view_widget().viewport().repaint()
    widget = driver.view_widget()
    picture = driver.window.screen().grabWindow(driver.window.winId()).toImage()
    corner = widget.mapTo(driver.window, QtCore.QPoint(0, 0))
    return picture.copy(QtCore.QRect(corner, widget.size()))


def black(image):
    """The share of pixels that are nearly black."""
    step, found, total = 3, 0, 0
    for x in range(0, image.width(), step):
        for y in range(0, image.height(), step):
            color = QtGui.QColor(image.pixel(x, y))
            found += max(color.red(), color.green(), color.blue()) < 50
            total += 1
    return found / total


def zebra(driver):
    """Stripes on a large model: at once, quick to turn, gone with the object, and turned by a slider."""
    Gui.activateWorkbench("SutureWorkbench")
    document = App.newDocument("Model")
    obj = document.addObject("Part::Feature", "Large")
    obj.Shape = many_faces()
    document.recompute()
    driver.said["faces"] = len(obj.Shape.Faces)
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(1.0)
    driver.said["black"] = [black(pixels(driver))]
    Gui.Selection.addSelection(obj)
    Gui.Selection.clearSelection()
    viewport = driver.view_widget().viewport()
    cpu, wall = time.process_time(), time.monotonic()
    Gui.runCommand("Suture_Zebra", 0)
    viewport.repaint()
    driver.said["seconds_on"] = [time.process_time() - cpu, time.monotonic() - wall]
    yield driver.until("the panel", lambda: driver.there("ZebraPanel"))
    yield driver.pause(0.5)
    driver.said["black"].append(black(pixels(driver)))
    driver.picture("stripes")
    camera = Gui.ActiveDocument.ActiveView.getCameraNode()
    turns = 10
    cpu, wall = time.process_time(), time.monotonic()
    for turn in range(turns):
        rotation = App.Rotation(App.Vector(0, 0, 1), 36.0 * turn).multiply(
            App.Rotation(App.Vector(1, 0, 0), 60)
        )
        camera.orientation = tuple(rotation.Q)
        viewport.repaint()
    driver.said["seconds_a_turn"] = [
        (time.process_time() - cpu) / turns,
        (time.monotonic() - wall) / turns,
    ]
    driver.look(1.1, 0.9, 0.8)
    before = pixels(driver)
    slider = driver.find("SutureDirection", QtGui.QSlider)
    slider.setValue(90)
    yield driver.pause(0.4)
    turned = pixels(driver)
    driver.said["turned"] = sum(
        before.pixel(x, y) != turned.pixel(x, y)
        for x in range(0, before.width(), 7)
        for y in range(0, before.height(), 7)
    )
    driver.press(CLOSE)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    yield driver.pause(0.3)
    driver.said["black"].append(black(pixels(driver)))  # closing leaves them
    obj.ViewObject.Visibility = False
    yield driver.pause(0.4)
    driver.said["black"].append(black(pixels(driver)))  # hidden
    obj.ViewObject.Visibility = True
    yield from driver.tool("Suture_Zebra")
    yield driver.pause(0.5)
    driver.said["black"].append(black(pixels(driver)))  # off


def curvature(driver):
    """The map of curvature has one colour on a ball: that of its radius."""
    Gui.activateWorkbench("SutureWorkbench")
    document = App.newDocument("Model")
    ball = document.addObject("Part::Feature", "Ball")
    ball.Shape = Part.makeSphere(10)
    document.recompute()
    ball.ViewObject.DisplayMode = "Shaded"
    ball.ViewObject.Deviation = 0.02
    driver.look(1.1, 0.9, 0.8)
    yield driver.pause(0.7)
    from suture_workbench.gui import shading

    shading.show_on(ball, shading.CURVATURE)
    driver.said["colors"] = []
    # Red from the ball's own radius, twice that, and a hundred times less: t = 1, 0.5, 0.01.
    for radius in (10.0, 5.0, 0.1):
        shading.set_radius(radius)
        yield driver.pause(0.3)
        image = pixels(driver)
        middle = image.width() // 2, image.height() // 2
        seen = [
            QtGui.QColor(image.pixel(middle[0] + dx, middle[1] + dy)).getRgb()[:3]
            for dx in range(-60, 61, 20)
            for dy in range(-60, 61, 20)
        ]
        driver.said["colors"].append(seen)
        driver.picture(f"curvature_{radius:g}")
    driver.said["shown"] = shading.shown_on(ball)
    shading.show_on(ball, shading.NONE)
    driver.said["off"] = shading.shown_on(ball)


def preview_with_stripes(driver):
    """The preview has stripes too; Cancel takes all of them away."""
    document, obj = open_example(driver)
    from suture_workbench.gui import shading

    yield driver.pause(0.5)
    yield from driver.tool("Suture_Fill")
    yield driver.preview()
    driver.unfold("SutureSurface")
    yield driver.until("the shading", lambda: driver.there("SutureShading"))
    driver.choose("SutureShading", "zebra")
    yield driver.pause(0.5)
    Gui.Selection.clearSelection()
    driver.picture("preview")
    driver.said["kinds"] = [shading.shown_on(obj)]
    driver.press(CANCEL)
    yield driver.until("the panel to close", lambda: not driver.dialog_open())
    driver.said["kinds"].append(shading.shown_on(obj))
