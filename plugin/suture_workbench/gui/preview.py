# SPDX-License-Identifier: LGPL-2.1-or-later
"""The new faces of a fill, drawn before there is an object."""

from .. import exchange, meshes
from . import overlay, shading


class Preview:
    """Orange faces over the view; shaded like the base where that is (stripes, curvature)."""

    def __init__(self, placement):
        self._drawing = overlay.Overlay(placement)
        self._meshes = []
        self._kind = shading.NONE

    def show(self, filled, before):
        """Draws what is new in a tasks.Filled; where nothing is, what has grown. before   the shape then"""
        deflection = meshes.fineness(filled.shape)
        self._meshes = [
            meshes.mesh_of(filled.shape.Faces[number - 1], deflection)
            for number in filled.new_faces or exchange.changed_faces(before, filled.shape)
        ]
        self._draw()

    def shade(self, kind):
        """One of shading.NONE, ZEBRA, CURVATURE."""
        self._kind = kind
        self._draw()

    def clear(self):
        self._meshes = []
        self._drawing.clear()

    def close(self):
        self._meshes = []
        self._drawing.close()

    def _draw(self):
        self._drawing.clear()
        for mesh in self._meshes:
            if self._kind == shading.NONE:
                self._drawing.mesh(*mesh, overlay.ORANGE, 0.2)
            else:
                self._drawing.mesh(*mesh, (1.0, 1.0, 1.0), 0.0, shading.node(self._kind))
