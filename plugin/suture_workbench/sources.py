# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several objects as one shape, numbered through: borders run along edges of more than one."""

import Part

from . import places


class Sources:
    """The objects whose edges or faces are chosen. The first is the base: the shape, all of them in
    one, is seen from it, and its numbers are the shape's own."""

    def __init__(self, objects):
        self.objects = list(dict.fromkeys(objects))
        shapes = [places.local_shape(obj) for obj in self.objects]
        back = places.to_document(self.objects[0]).inverse()
        for obj, shape in zip(self.objects[1:], shapes[1:]):
            shape.Placement = back.multiply(places.to_document(obj))
        # Not makeCompound: it ends the process where FreeCAD 1.0 is a module of plain Python.
        before = [Part.Compound(shapes[:n]) if n else Part.Shape() for n in range(len(shapes))]
        self._edges_before = [len(shape.Edges) for shape in before]
        self._faces_before = [len(shape.Faces) for shape in before]
        self.shape = shapes[0] if len(shapes) == 1 else Part.Compound(shapes)

    def number(self, obj, edge):
        """The number in the shape of an object's edge."""
        return self._edges_before[self.objects.index(obj)] + edge

    def face_number(self, obj, face):
        """The same of a face."""
        return self._faces_before[self.objects.index(obj)] + face

    def origin(self, edge):
        """(object, its own number) of an edge of the shape."""
        return self._origin(edge, self._edges_before)

    def face_origin(self, face):
        """The same of a face."""
        return self._origin(face, self._faces_before)

    def _origin(self, number, numbers_before):
        index = max(n for n, before in enumerate(numbers_before) if before < number)
        return self.objects[index], number - numbers_before[index]

    def by_object(self, edges):
        """[(object, its own numbers), ...], the base first, also if it has none of the edges."""
        chosen = {obj: [] for obj in self.objects}
        for edge in edges:
            obj, number = self.origin(edge)
            chosen[obj].append(number)
        return list(chosen.items())
