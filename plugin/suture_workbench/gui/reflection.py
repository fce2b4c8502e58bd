# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zebra stripes and curvature combs over objects of the document; each command switches them."""

import FreeCAD as App

from .. import combs, meshes, places
from ..compat import QtCore, QtWidgets
from . import overlay

_COMB_COLORS = ((0.85, 0.10, 0.35), (0.10, 0.35, 0.90))
_zebras, _combs = {}, {}


def zebra_nodes(layer, shape):
    """Draws stripes over every face of a shape."""
    texture = overlay.stripes()
    deflection = meshes.fineness(shape)
    for face in shape.Faces:
        # A large model takes seconds: the window repaints meanwhile, but takes no clicks.
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)
        layer.mesh(*meshes.mesh_of(face, deflection), (1.0, 1.0, 1.0), 0.0, texture)


def comb_nodes(layer, shape, edges, stretch=1.0):
    """Draws the combs of both faces at each edge, one colour for each side."""
    found = combs.at_edges(shape, edges)
    longest = max((shape.Edges[number - 1].Length for number in edges), default=1.0)
    scale = stretch * combs.good_scale([comb for _, comb in found], longest)
    sides = {}
    for number, comb in found:
        side = sides[number] = sides.get(number, -1) + 1
        layer.lines(combs.hairs(comb, scale), _COMB_COLORS[side % 2], 1.5)


def toggle_zebra(item):
    """Stripes on, or off where there are some."""
    return _toggle(_zebras, item, lambda layer, shape: zebra_nodes(layer, shape))


def toggle_combs(item):
    """Combs at the selected edges, or at every edge where none is selected; or off."""

    def draw(layer, shape):
        comb_nodes(layer, shape, item.edges or range(1, len(shape.Edges) + 1))

    return _toggle(_combs, item, draw)


def _toggle(layers, item, draw):
    key = (item.obj.Document.Name, item.obj.Name)
    if key in layers:
        layers.pop(key).close()
        return False
    layer = overlay.Overlay(places.shown_at(item))
    layers[key] = layer  # before the drawing: events go on meanwhile
    _watch()
    try:
        draw(layer, places.local_shape(item.obj))
    except BaseException:
        layers.pop(key, layer).close()
        raise
    return True


class _Follower:
    """Takes drawings away when their object changes or goes."""

    def slotChangedObject(self, obj, name):
        if name in ("Shape", "Placement"):
            self._drop(obj)

    def slotDeletedObject(self, obj):
        self._drop(obj)

    def slotDeletedDocument(self, document):
        for layers in (_zebras, _combs):
            for key in [key for key in layers if key[0] == document.Name]:
                layers.pop(key).close()

    def _drop(self, obj):
        key = (obj.Document.Name, obj.Name)
        for layers in (_zebras, _combs):
            if key in layers:
                layers.pop(key).close()


_follower = None


def _watch():
    global _follower
    if _follower is None:
        _follower = _Follower()
        App.addDocumentObserver(_follower)
