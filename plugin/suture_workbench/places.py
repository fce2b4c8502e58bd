# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where objects stand: their shapes, their containers, and what a user has selected of them."""

from collections import namedtuple

import FreeCAD as App
import Part

from . import exchange
from .compat import element_of, translate
from .errors import SutureError
from .parts import is_container, kind_and_number, leaves, number_of

# What is selected of one object: numbers of edges and faces, and how the 3D view names it.
Selected = namedtuple("Selected", "obj edges faces top path")


def has_shape(obj):
    """Whether there is a shape with faces or edges to work on."""
    try:
        return not shape_of(obj).isNull()
    except SutureError:
        return False


def has_faces(obj):
    """Whether there is a surface to work on."""
    try:
        return bool(shape_of(obj).Faces)
    except SutureError:
        return False


def shape_of(obj):
    """The shape of anything that has one (features, Bodies, links, Parts), in its container.

    Of a Part, a group or a link to one it is all that is in it, shown or hidden: FreeCAD itself
    leaves out what is hidden, and what is shown must not change what is computed.
    """
    try:
        if is_container(obj):
            # Not makeCompound: it ends the process where 1.0 is a module of plain Python.
            shape = Part.Compound([shape for _, shape in leaves(obj)])
            shape.Placement = placement_of(obj)
            null = not shape.SubShapes
        else:
            shape = Part.getShape(obj)
            null = shape.isNull()
    except Exception:  # FreeCAD raises several kinds for objects that have none
        null = True
    if null:
        raise SutureError(translate("{} has no shape.").format(obj.Label))
    return shape


def exists(obj):
    """Whether an object is still in its document."""
    try:
        return obj.Document.getObject(obj.Name) is obj and not getattr(obj, "Removing", False)
    except (AttributeError, ReferenceError, RuntimeError):
        return False


def in_window(obj):
    """Whether an object still has a view: while its document is being closed it has none."""
    try:
        return obj.ViewObject is not None
    except (NameError, ReferenceError, RuntimeError):
        return False


def placement_of(obj):
    """Where an object stands in its container."""
    if is_container(obj):
        return obj.Placement if hasattr(obj, "Placement") else App.Placement()
    return shape_of(obj).Placement


def element_in(item, top, sub):
    """Which element ("Edge", 9) of shape_of(item.obj) a selection (top, sub) names; None: no such."""
    leaf, path, element = resolve(top, sub)
    kind, number = kind_and_number(element)
    if kind not in ("Edge", "Face", "Vertex"):
        return None
    if leaf is item.obj:
        return kind, number
    if top is not item.top or not path.startswith(item.path):
        return None
    number = number_of(item.obj, path[len(item.path) :], kind, number)
    return None if number is None else (kind, number)


def local_shape(obj):
    """The shape at the origin: moving the object does not change it."""
    return exchange.without_placement(shape_of(obj))


def containers(obj):
    """The Parts and Bodies around an object, innermost first."""
    result = []
    while True:
        obj = obj.getParentGeoFeatureGroup()
        if obj is None:
            return result
        result.append(obj)


def frame(obj):
    """From the coordinates in which an object's shape stands to those of the document."""
    placement = App.Placement()
    for container in containers(obj):
        placement = container.Placement.multiply(placement)
    return placement


def to_document(obj):
    """From the coordinates of local_shape to those of the document."""
    return frame(obj).multiply(placement_of(obj))


def shown_at(selected):
    """As to_document, of the very instance that was selected: links show an object several times."""
    if not selected.path:
        return to_document(selected.obj)
    return frame(selected.top).multiply(selected.top.getSubObject(selected.path, retType=3))


def home_for_result(obj):
    """The container that a result made from `obj` belongs in: its Part; None for the document.

    A Body takes nothing but its own features, so what is made from one stands beside it.
    """
    for container in containers(obj):
        if container.TypeId == "App::Part":
            return container
    return None


def base_of(obj):
    """What to work on when `obj` was picked: the Body instead of the feature at its tip."""
    container = obj.getParentGeoFeatureGroup()
    if container is not None and getattr(container, "Tip", None) is obj:
        return container
    return obj


def selection(selected, fits=has_faces):
    """What a selection (Gui.Selection.getSelectionEx("", 0)) holds that fits, object by object."""
    found = {}
    for entry in selected:
        for sub in entry.SubElementNames or ("",):
            obj, path, element = resolve(entry.Object, sub)
            if not fits(obj):
                continue
            key = (obj.Document.Name, obj.Name, path)
            item = found.setdefault(key, Selected(obj, [], [], entry.Object, path))
            if element.startswith("Edge"):
                item.edges.append(int(element[4:]))
            elif element.startswith("Face"):
                item.faces.append(int(element[4:]))
    return list(found.values())


def resolve(top, sub):
    """The object that a sub-element name leads to, the way to it, and the element of it."""
    element = element_of(sub)
    names = sub.split(".")[:-1]
    chain = top.getSubObjectList(sub) or [top]
    named = [obj for obj in chain if obj is not None]
    leaf = base_of(named[-1])
    if leaf is not named[-1] and leaf in named:
        names = names[: named.index(leaf)]
    names = [name for name in names if not name.startswith(";")]
    return leaf, "".join(name + "." for name in names), element


def points_through(references, obj):
    """Points of vertices and edges of other objects, in the coordinates of local_shape(obj): (x, y, z),
    or, where one lies on a face that is among them, (x, y, z, nx, ny, nz) with the face's normal.

    references   [(object, ("Vertex1", "Edge2", "Face3")), ...]; no sub-elements: all edges, else all
                 vertices
    """
    back = to_document(obj).inverse()
    points, faces = [], []
    for other, subs in references or ():
        move = back.multiply(frame(other))
        shape = shape_of(other)
        subs = [sub for sub in subs if sub]
        parts = [shape.getElement(element_of(sub)) for sub in subs] or _all_parts(shape)
        for part in parts:
            if part.ShapeType == "Face":
                part = part.copy()
                part.Placement = move.multiply(part.Placement)
                faces.append(part)
            else:
                points += [move.multVec(point) for point in _points_of(part)]
    if faces and not points:
        raise SutureError(translate("Points to pass through are vertices and edges, not faces."))
    return [(*point, *_normal_there(faces, point)) for point in points]


def _normal_there(faces, point):
    """The normal of the face that a point lies on; nothing if there is none."""
    for face in faces:
        reach = max(1e-6 * face.BoundBox.DiagonalLength, 1e-7)
        if face.distToShape(Part.Vertex(point))[0] <= reach:
            return tuple(face.normalAt(*face.Surface.parameter(point)))
    return ()


_POINTS_ON_AN_EDGE = 33


def _all_parts(shape):
    return shape.Edges or shape.Vertexes


def _points_of(part):
    if part.ShapeType == "Vertex":
        return [part.Point]
    return part.discretize(_POINTS_ON_AN_EDGE)
