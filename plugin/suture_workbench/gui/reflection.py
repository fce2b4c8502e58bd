# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature combs over objects of the document; the command switches them."""

import FreeCAD as App

from .. import combs, places
from . import overlay

_COMB_COLORS = ((0.85, 0.10, 0.35), (0.10, 0.35, 0.90))
_layers = {}


def comb_nodes(layer, shape, edges, stretch=1.0):
    """Draws the combs of both faces at each edge, one colour for each side."""
    found = combs.at_edges(shape, edges)
    longest = max((shape.Edges[number - 1].Length for number in edges), default=1.0)
    scale = stretch * combs.good_scale([comb for _, comb in found], longest)
    sides = {}
    for number, comb in found:
        side = sides[number] = sides.get(number, -1) + 1
        layer.lines(combs.hairs(comb, scale), _COMB_COLORS[side % 2], 1.5)


def toggle_combs(item):
    """Combs at the selected edges, or at every edge where none is selected; or off."""
    key = (item.obj.Document.Name, item.obj.Name)
    if key in _layers:
        _layers.pop(key).close()
        return False
    layer = overlay.Overlay(places.shown_at(item))
    _watch()
    shape = places.local_shape(item.obj)
    try:
        comb_nodes(layer, shape, item.edges or range(1, len(shape.Edges) + 1))
    except BaseException:
        layer.close()
        raise
    _layers[key] = layer
    return True


class _Follower:
    """Takes combs away when their object changes, is hidden or goes."""

    def slotChangedObject(self, obj, name):
        if name in ("Shape", "Placement") or name == "Visibility" and not obj.Visibility:
            self._drop(obj)

    def slotDeletedObject(self, obj):
        self._drop(obj)

    def slotDeletedDocument(self, document):
        for key in [key for key in _layers if key[0] == document.Name]:
            _layers.pop(key).close()

    def _drop(self, obj):
        layer = _layers.pop((obj.Document.Name, obj.Name), None)
        if layer is not None:
            layer.close()


_follower = None


def _watch():
    global _follower
    if _follower is None:
        _follower = _Follower()
        App.addDocumentObserver(_follower)
