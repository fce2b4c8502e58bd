# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all task panels do: open, hear of Esc and of clicks in the 3D view, and leave nothing behind."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import places
from ..compat import QtCore, QtGui, QtWidgets, as_int
from . import failures, pick
from .forms import connect_folds, find, load_form

Buttons = QtWidgets.QDialogButtonBox


class Panel:
    """A task panel: `form`, and the buttons that FreeCAD puts above it."""

    icon = ""
    title = ""
    buttons = (Buttons.Close,)
    item = None  # places.Selected that the panel works on
    current = None  # the panel that is open

    def __init__(self, ui):
        self.form = load_form(ui)
        self.form.setWindowTitle(self.title)
        self.form.setObjectName(type(self).__name__)
        if self.icon:
            self.form.setWindowIcon(QtGui.QIcon(self.icon))
        connect_folds(self.form)
        self._guards = []
        self._left = False

    def child(self, name, kind=QtWidgets.QWidget):
        return find(self.form, name, kind)

    def show(self, document=None):
        """Opens the panel; it goes when `document` or what it works on does."""
        if document is not None:
            self._guards = [_Documents(self, document), _Keys(self, document), _Picks(self)]
        Panel.current = self
        Gui.Control.showDialog(self)
        return self

    def close(self):
        """Takes the panel away, with all that it has drawn and started."""
        if self.end():
            Gui.Control.closeDialog()
            if Gui.ActiveDocument is not None:
                Gui.ActiveDocument.resetEdit()

    def end(self):
        """Leaves once, however the panel comes to its end. Result   whether this was the time"""
        if self._left:
            return False
        self._left = True
        if Panel.current is self:
            Panel.current = None
        for guard in self._guards:
            guard.stop()
        self._guards = []
        try:
            self.leave()
        except Exception as error:  # the panel has to go all the same
            failures.text_of(error)
        return True

    def watched(self):
        """The objects without which the panel cannot go on."""
        return [self.item.obj] if self.item is not None else []

    def getStandardButtons(self):
        total = 0
        for button in self.buttons:
            total |= as_int(button)
        return total

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return False

    def reject(self):
        self.close()
        return True

    def leave(self):
        """Takes away what the panel has drawn and started."""

    def clicked_in_view(self, top, sub, point):
        """The user has clicked something in the 3D view."""
        found = places.element_in(self.item, top, sub)
        if found is not None:
            self.picked(*found, point)

    def picked(self, kind, number, point):
        """The user has clicked an element ("Edge", 9) of the item in the 3D view."""


class _Documents:
    """Closes a panel when its document or its object goes."""

    def __init__(self, panel, document):
        self._panel, self._name = panel, document.Name
        App.addDocumentObserver(self)

    def stop(self):
        App.removeDocumentObserver(self)

    def slotDeletedDocument(self, document):
        if document.Name == self._name:
            self._panel.close()

    def slotDeletedObject(self, obj):
        if any(obj is watched for watched in self._panel.watched()):
            self._panel.close()


class _Keys:
    """Esc in the 3D view is Cancel; FreeCAD itself hears it only in the panel."""

    def __init__(self, panel, document):
        self._panel = panel
        self._view = Gui.getDocument(document.Name).ActiveView
        self._callback = None
        if hasattr(self._view, "addEventCallback"):
            self._callback = self._view.addEventCallback("SoKeyboardEvent", self._pressed)

    def stop(self):
        if self._callback is not None:
            try:
                self._view.removeEventCallback("SoKeyboardEvent", self._callback)
            except (RuntimeError, ReferenceError):
                pass  # the view was closed before
            self._callback = None

    def _pressed(self, event):
        if event["Key"] == "ESCAPE" and event["State"] == "UP":
            QtCore.QTimer.singleShot(0, self._cancel)  # not while the view calls its listeners

    def _cancel(self):
        if not self._panel._left:
            self._panel.reject()


class _Picks:
    """Tells a panel what is clicked in the 3D view of its object."""

    def __init__(self, panel):
        self._panel = panel
        Gui.Selection.addObserver(self)

    def stop(self):
        Gui.Selection.removeObserver(self)

    def addSelection(self, document, name, sub, point):
        if self._panel.item is None or not sub or pick.selecting():
            return
        top = App.getDocument(document).getObject(name)
        self._panel.clicked_in_view(top, sub, App.Vector(*point))
