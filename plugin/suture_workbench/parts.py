# SPDX-License-Identifier: LGPL-2.1-or-later
"""What containers (Parts, groups, links to them) hold, shown or hidden, and how it is numbered."""

import Part


def is_container(obj):
    """Whether the shape of an object is nothing but those of others in it."""
    linked = obj.getLinkedObject(True)
    return not linked.isDerivedFrom("Part::Feature") and bool(
        linked.hasExtension("App::GroupExtension")
        or linked.hasExtension("App::LinkBaseExtension")
        and obj.getSubObjects()
    )


def leaves(obj):
    """What a container holds: [(path, shape), ...] in the tree's order, seen from the container.

    What another one in the container was made from is left out, as the box of a cut is.
    """
    found = []
    for path in _leaf_paths(obj, "", obj):
        shape = Part.getShape(obj, path, needSubElement=False, transform=False)
        if not shape.isNull() and shape.Faces:
            found.append((path, shape))
    return found


def _leaf_paths(top, path, container):
    members = [(sub, top.getSubObject(path + sub, retType=1)) for sub in container.getSubObjects()]
    members = [(sub, member) for sub, member in members if member is not None]
    for sub, member in members:
        if member is container:
            yield path + sub
        elif is_container(member):
            yield from _leaf_paths(top, path + sub, member)
        elif not member.isDerivedFrom("Part::Datum") and not any(
            _is_made_from(other, member) for _, other in members
        ):
            yield path + sub


def leaf_objects(obj):
    """The objects whose shapes an object shows; links lead to what they link."""
    paths = [path for path, _ in leaves(obj)] if is_container(obj) else [""]
    members = (obj.getSubObject(path, retType=1) if path else obj for path in paths)
    found = []
    for member in members:
        linked = member.getLinkedObject(True)
        if linked not in found:
            found.append(linked)
    return found


_PLACING = ("Support", "AttachmentSupport", "LinkedObject", "ExpressionEngine", "Proxy")


def _is_made_from(other, obj):
    """Whether an object takes another into its own shape; to stand on it or to link it is not that."""
    if other is obj or other not in obj.InList or other.isDerivedFrom("App::Link"):
        return False
    return any(
        _names(getattr(other, name, None), obj)
        for name in other.PropertiesList
        if name not in _PLACING and "Link" in other.getTypeIdOfProperty(name)
    )


def _names(value, obj):
    """Whether the value of a link property, however deep, is an object."""
    if isinstance(value, (tuple, list)):
        return any(_names(entry, obj) for entry in value)
    return value is obj


def names_in(container):
    """The names of all objects that a container holds, at whatever depth."""
    names = []
    for obj in container.getLinkedObject(True).OutList:
        names.append(obj.Name)
        if obj is not container and is_container(obj):
            names += names_in(obj)
    return names


def element_path(obj, kind, number):
    """How FreeCAD names an element ("Edge", 9) of shape_of(obj), seen from the object."""
    if is_container(obj):
        for path, shape, before in _counted(obj, kind):
            if number <= before + _count(shape, kind):
                return f"{path}{kind}{number - before}"
    return f"{kind}{number}"


def number_of(obj, path, kind, number):
    """The number in shape_of(obj) of an element that lies at a path in it; None: not in it."""
    if not is_container(obj):
        return number if not path else None
    for leaf, _, before in _counted(obj, kind):
        if leaf == path:
            return before + number
    return None


def kind_and_number(element):
    """("Edge", 9) of "Edge9"."""
    kind = element.rstrip("0123456789")
    digits = element[len(kind) :]
    return kind, int(digits) if digits else 0


def _counted(obj, kind):
    """The leaves of a container with the number of elements that come before theirs."""
    shapes = []
    for path, shape in leaves(obj):
        yield path, shape, _count(Part.Compound(shapes), kind) if shapes else 0
        shapes.append(shape)


def _count(shape, kind):
    return len(getattr(shape, "Vertexes" if kind == "Vertex" else kind + "s"))
