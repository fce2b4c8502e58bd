# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between FreeCAD 0.20 (Qt 5) and 1.x (Qt 6): here and nowhere else."""

import contextlib
import sys

import FreeCAD as App

from .errors import SutureError

try:
    from PySide import QtCore, QtGui

    try:
        from PySide import QtWidgets
    except ImportError:  # 0.20: PySide.QtGui holds the widgets
        QtWidgets = QtGui
except ImportError:  # plain Python without FreeCAD's Ext folder: no window, no Qt
    QtCore = QtGui = QtWidgets = None


def translate(text):
    """`text` in the user's language."""
    return App.Qt.translate("Suture", text)


def translate_in(context, text):
    """`text` in the user's language, where it stands in a context of its own."""
    return App.Qt.translate(context, text)


def QT_TRANSLATE_NOOP(context, text):
    """`text` as it is, which Qt translates in a context of its own (a command's, by FreeCAD)."""
    return text


def mark(text):
    """`text` as it is, to be translated where it is shown."""
    return text


def as_int(flags):
    """Qt's flags as the int that FreeCAD's getStandardButtons takes."""
    return int(getattr(flags, "value", flags))


def run_loop(loop):
    """QEventLoop or QDialog until it ends."""
    return loop.exec() if hasattr(loop, "exec") else loop.exec_()


@contextlib.contextmanager
def without_traceback():
    """FreeCAD reports what an object's execute raises with a traceback, before anybody else can. A
    SutureError is the user's: its sentence is enough."""
    try:
        yield
    except SutureError:
        if App.GuiUp:
            sys.tracebacklimit = 0
            QtCore.QTimer.singleShot(0, _with_traceback)
        raise


def _with_traceback():
    if hasattr(sys, "tracebacklimit"):
        del sys.tracebacklimit


class Stateless:
    """A proxy without state of its own, for every version's way of saving it."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def element_of(sub):
    """The element ("Edge9") that a sub-element name ends in, or "".

    1.x puts mapped names before it, as in "Body.Pad.;g233;SKT.Face6", and a "?" before the element
    where it no longer knows which one is meant: that is an error, not a number.
    """
    element = sub.rsplit(".", 1)[-1] if sub else ""
    if element.startswith("?"):
        raise SutureError(
            translate("{} is no longer there after the object has changed: choose it again.").format(
                element.lstrip("?")
            )
        )
    return element


def face_colors(view_object):
    """The colours of the faces as tuples of four floats; one for all of them, or one for each."""
    return [tuple(float(part) for part in color) for color in view_object.DiffuseColor]


def plain_color(view_object):
    """The colour of an object as one of face_colors. The last number there is transparency; that of
    ShapeColor is opacity on 1.x."""
    color = tuple(float(part) for part in view_object.ShapeColor[:3])
    return (*color, view_object.Transparency / 100.0)


def set_face_colors(view_object, colors):
    """DiffuseColor takes nothing but floats; 1.x translates it to ShapeAppearance."""
    view_object.DiffuseColor = [tuple(float(part) for part in color) for color in colors]
