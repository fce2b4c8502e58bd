# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows failures: a sentence in a box, and the edges that it names selected in the view."""

import traceback

import FreeCAD as App
import FreeCADGui as Gui

from .. import places
from ..compat import QtWidgets, run_loop, translate
from ..errors import Cancelled, NothingToDo, ProgramMissing, SutureError
from . import pick
from .program_dialog import ProgramDialog


def text_of(error):
    """One sentence; what nobody expected goes to the report view as well."""
    if isinstance(error, SutureError):
        return str(error)
    trace = "".join(traceback.format_exception(type(error), error, error.__traceback__))
    App.Console.PrintError(trace)
    return translate("Something went wrong inside Suture: {}. Please report it.").format(error)


def show(error, item=None):
    """A box with the sentence; `item` is what the edges belong to."""
    text = text_of(error)
    select(error, item)
    if isinstance(error, Cancelled):
        Gui.getMainWindow().statusBar().showMessage(text, 5000)
        return
    App.Console.PrintError(text + "\n")
    box = QtWidgets.QMessageBox(Gui.getMainWindow())
    box.setObjectName("SutureFailure")
    box.setIcon(QtWidgets.QMessageBox.Warning)
    box.setWindowTitle("Suture")
    box.setText(text)
    box.addButton(QtWidgets.QMessageBox.Ok)
    get = None
    if isinstance(error, ProgramMissing):
        get = box.addButton(translate("Get the program…"), QtWidgets.QMessageBox.ActionRole)
    run_loop(box)
    if get is not None and box.clickedButton() is get:
        get_program()


def get_program():
    """The dialog that installs, locates or builds the program."""
    ProgramDialog().run()


def confirm(doubts):
    """Whether the user wants to keep what there are doubts about; without doubts it is not asked."""
    if not doubts:
        return True
    text = translate("The result is far from what was asked for:") + "\n\n" + doubts
    return _ask("SutureDoubts", text, translate("Keep it"), translate("Change something"))


def confirm_replacing(paths):
    """Whether the user wants to have files replaced."""
    names = "\n".join(path.name for path in paths)
    text = translate("These files are there already:") + "\n\n" + names
    return _ask("SutureReplace", text, translate("Replace"), translate("Cancel"))


def _ask(name, text, yes, no):
    box = QtWidgets.QMessageBox(Gui.getMainWindow())
    box.setObjectName(name)
    box.setIcon(QtWidgets.QMessageBox.Warning)
    box.setWindowTitle("Suture")
    box.setText(text)
    agree = box.addButton(yes, QtWidgets.QMessageBox.AcceptRole)
    back = box.addButton(no, QtWidgets.QMessageBox.RejectRole)
    box.setDefaultButton(back)
    box.setEscapeButton(back)
    run_loop(box)
    return box.clickedButton() is agree


def report(status, error, item):
    """The sentence in a panel's status line; no hole at all is no failure."""
    if isinstance(error, NothingToDo):
        status.good(translate("There is no hole."))
        return
    status.bad(text_of(error))
    if isinstance(error, ProgramMissing):
        status.offer(translate("Get the program…"), get_program)
    select(error, item)


def select(error, item):
    """Selects the edges that the error names."""
    if item is None or not getattr(error, "edges", ()):
        return
    count = len(places.shape_of(item.obj).Edges)
    edges = [edge for edge in error.edges if edge <= count]
    if edges:
        pick.select_edges(item, edges)
