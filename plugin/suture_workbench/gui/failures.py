# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows failures: a sentence in a box, and the edges that it names selected in the view."""

import traceback

import FreeCAD as App
import FreeCADGui as Gui

from ..compat import QtWidgets, run_loop, translate
from ..errors import Cancelled, NothingToDo, SutureError
from . import pick


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
    run_loop(box)


def report(status, error, item):
    """The sentence in a panel's status line; no hole at all is no failure."""
    if isinstance(error, NothingToDo):
        status.good(translate("There is no hole: {}.").format(error))
        return
    status.bad(text_of(error))
    select(error, item)


def select(error, item):
    """Selects the edges that the error names."""
    if item is None or not getattr(error, "edges", ()):
        return
    count = len(item.obj.Shape.Edges) if hasattr(item.obj, "Shape") else 0
    edges = [edge for edge in error.edges if edge <= count]
    if edges:
        pick.select_edges(item, edges)
