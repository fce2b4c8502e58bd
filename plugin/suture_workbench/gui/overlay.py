# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings in the 3D view that belong to no document: outlines, previews, markers, zebra, combs."""

import FreeCADGui as Gui
from pivy import coin

ORANGE = (0.98, 0.55, 0.10)


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
        self._add(_flat(color), style, _coordinates(points), lines)

    def markers(self, points, color):
        """Draws a cross at each point."""
        markers = coin.SoMarkerSet()
        markers.markerIndex = coin.SoMarkerSet.DIAMOND_FILLED_9_9
        self._add(_flat(color), _coordinates([tuple(point) for point in points]), markers)

    def mesh(self, points, normals, triangles, color, transparency=0.0, stripes=None):
        """Draws a shaded mesh; with `stripes` (a texture) as a mirror of them."""
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
            nodes += [stripes, coin.SoTextureCoordinateEnvironment()]
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
            line = coin.SoSeparator()
            place = coin.SoTranslation()
            place.translation = (-0.97, 0.9 - 0.06 * row, 0.0)
            written = coin.SoText2()
            written.string = text
            for node in (_flat(color), place, written):
                line.addChild(node)
            layer.addChild(line)
        self._body.addChild(layer)

    def _add(self, *nodes):
        part = coin.SoSeparator()
        for node in nodes:
            part.addChild(node)
        self._body.addChild(part)


def outline(edge, deflection):
    """An edge as a polyline."""
    return edge.discretize(Deflection=deflection) if edge.Length > 0 else []


def fineness(shape):
    """A deflection at which a shape looks round."""
    return max(shape.BoundBox.DiagonalLength * 5e-4, 1e-6)


def mesh_of(face, deflection):
    """(points, normals, triangles) of a face, with the surface's own normals."""
    points, triangles = face.tessellate(deflection)
    nodes = face.getUVNodes()
    if len(nodes) == len(points):
        parameters = nodes
    else:
        parameters = [face.Surface.parameter(point) for point in points]
    normals = [tuple(face.normalAt(u, v)) for u, v in parameters]
    return [tuple(point) for point in points], normals, triangles


def stripes(count=24):
    """Black and white stripes as an environment to be mirrored."""
    width = 512
    row = bytes(255 if (x * count // width) % 2 else 20 for x in range(width))
    texture = coin.SoTexture2()
    texture.image.setValue(coin.SbVec2s(width, 2), 1, row * 2)
    texture.model = coin.SoTexture2.MODULATE
    return texture


def _coordinates(points):
    node = coin.SoCoordinate3()
    node.point.setValues(0, len(points), points)
    return node


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


