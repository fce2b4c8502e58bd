# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings in the 3D view that belong to no document: outlines, previews, markers, zebra, combs."""

import FreeCADGui as Gui
from pivy import coin

ORANGE = (0.98, 0.55, 0.10)
_LETTERS, _SHADOW = (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)


class Overlay:
    """A layer over one view; `placement` moves what is drawn to where its object stands."""

    def __init__(self, placement=None, view=None):
        document = Gui.ActiveDocument
        self._view = view or (document.ActiveView if document else None)
        self._root = coin.SoSeparator()
        self._root.setName("SutureOverlay")
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        self._root.addChild(pick)
        if placement is not None:
            self._root.addChild(_transform(placement))
        self._body = coin.SoGroup()
        self._root.addChild(self._body)
        self._graph = self._view.getSceneGraph() if hasattr(self._view, "getSceneGraph") else None
        if self._graph is not None:
            self._graph.addChild(self._root)

    def clear(self):
        self._body.removeAllChildren()

    def close(self):
        """Takes the layer away; harmless when its view is gone."""
        if self._graph is None:
            return
        try:
            if self._graph.findChild(self._root) >= 0:
                self._graph.removeChild(self._root)
        except (RuntimeError, ReferenceError):
            pass  # the view was closed before
        self._graph = None

    def lines(self, polylines, color, width=3.0):
        """Draws polylines (lists of points)."""
        points, indices = [], []
        for polyline in polylines:
            indices += range(len(points), len(points) + len(polyline))
            indices.append(-1)
            points += [tuple(point) for point in polyline]
        style = coin.SoDrawStyle()
        style.lineWidth = width
        lines = coin.SoIndexedLineSet()
        lines.coordIndex.setValues(0, len(indices), indices)
        self._add(_flat(color), _in_front(), style, _coordinates(points), lines)

    def markers(self, points, color):
        """Draws a cross at each point."""
        markers = coin.SoMarkerSet()
        markers.markerIndex = coin.SoMarkerSet.DIAMOND_FILLED_9_9
        places = _coordinates([tuple(point) for point in points])
        self._add(_flat(color), _in_front(), places, markers)

    def mesh(self, points, normals, triangles, color, transparency=0.0, stripes=None):
        """Draws a shaded mesh; `stripes` is a node of shading.py."""
        material = coin.SoMaterial()
        material.diffuseColor = color
        material.transparency = transparency
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        offset = coin.SoPolygonOffset()
        offset.factor, offset.units = -1.0, -1.0  # in front of the face that it covers
        normal = coin.SoNormal()
        normal.vector.setValues(0, len(normals), normals)
        binding = coin.SoNormalBinding()
        binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        faces = coin.SoIndexedFaceSet()
        indices = [i for triangle in triangles for i in (*triangle, -1)]
        faces.coordIndex.setValues(0, len(indices), indices)
        nodes = [material, hints, offset]
        if stripes is not None:
            nodes.append(stripes)
        self._add(*nodes, _coordinates(points), normal, binding, faces)

    def legend(self, rows):
        """Writes rows of (text, colour) into the view's upper left corner."""
        layer = coin.SoSeparator()
        camera = coin.SoOrthographicCamera()
        camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        camera.height, camera.aspectRatio = 2.0, 1.0
        camera.position = (0, 0, 5)
        depth = coin.SoDepthBuffer()
        depth.test = False
        font = coin.SoFont()
        font.size = 15
        for node in (camera, depth, _flat((0, 0, 0)), font):
            layer.addChild(node)
        for row, (text, color) in enumerate(rows):
            place = coin.SoTranslation()
            place.translation = (-0.96, 0.9 - 0.07 * row, 0.0)
            swatch = coin.SoMarkerSet()
            swatch.markerIndex = coin.SoMarkerSet.SQUARE_FILLED_9_9
            gap = coin.SoTranslation()
            gap.translation = (0.03, -0.015, 0.0)
            written = coin.SoText2()
            written.string = text
            line = coin.SoSeparator()
            for node in (place, _flat(color), _coordinates([(0, 0, 0)]), swatch):
                line.addChild(node)
            shadow = coin.SoTranslation()
            shadow.translation = (0.003, -0.004, 0.0)
            back = coin.SoTranslation()
            back.translation = (-0.003, 0.004, 0.0)
            for node in (gap, shadow, _flat(_SHADOW), written, back, _flat(_LETTERS), written):
                line.addChild(node)
            layer.addChild(line)
        self._body.addChild(layer)

    def _add(self, *nodes):
        part = coin.SoSeparator()
        for node in nodes:
            part.addChild(node)
        self._body.addChild(part)


def _coordinates(points):
    node = coin.SoCoordinate3()
    node.point.setValues(0, len(points), points)
    return node


def _in_front():
    """Lets lines win against faces that they lie on: the faces are drawn as triangles, which reach
    over a curved edge. What is farther behind stays hidden."""
    depth = coin.SoDepthBuffer()
    depth.range = (0.0, 0.99)
    return depth


def _flat(color):
    group = coin.SoGroup()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    base = coin.SoBaseColor()
    base.rgb = color
    group.addChild(light)
    group.addChild(base)
    return group


def _transform(placement):
    node = coin.SoTransform()
    node.translation = tuple(placement.Base)
    node.rotation = tuple(placement.Rotation.Q)
    return node
