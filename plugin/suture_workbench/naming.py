# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of faces, edges and vertices by which FreeCAD 1.x knows them when their numbers change.

What the program gives back has no names. Here it gets those that its base has; what is new is named
after what bounds it. FreeCAD 0.20 has no such names: nothing is done there.
"""

import hashlib

_KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}


def carry_over(shape, before, origins, tag):
    """Gives the elements of `shape` names.

    before    the base; its elements without a name of their own are known by their number
    origins   exchange.face_origins of the faces
    tag       of the object that the shape is for: FreeCAD takes names from tagged shapes only
    """
    if origins is None or not hasattr(shape, "ElementMap"):
        return
    same = _kept(shape, before, origins)
    known = before.ElementReverseMap
    names = {element: _name(known, old) for element, old in same.items()}
    _name_new(shape, names)
    shape.Tag = tag
    shape.ElementMap = {name: element for element, name in names.items()}


def _name(known, old):
    name = known.get(old)
    if isinstance(name, (list, tuple)):
        name = name[0] if name else None
    return str(name) if name else f"SUT;{old}"


def _kept(shape, before, origins):
    """{"Edge7": "Edge5"}: what an element of the shape is in the base. The edges of a face that stayed
    stand in their old order, and where they were."""
    numbers = [{kind: _numbers(one, kind) for kind in ("Edge", "Vertex")} for one in (shape, before)]
    reach = max(1e-6 * before.BoundBox.DiagonalLength, 1e-7)
    faces, old_faces = shape.Faces, before.Faces  # FreeCAD makes the list anew each time
    same = {}
    for index, origin in enumerate(origins):
        if origin is None:
            continue
        same[f"Face{index + 1}"] = f"Face{origin + 1}"
        face, old_face = faces[index], old_faces[origin]
        for kind in ("Edge", "Vertex"):
            elements, old_elements = getattr(face, _KINDS[kind]), getattr(old_face, _KINDS[kind])
            if len(elements) != len(old_elements):
                continue
            for element, old in zip(elements, old_elements):
                if (_place(element) - _place(old)).Length <= reach:
                    same[numbers[0][kind](element)] = numbers[1][kind](old)
    return same


def _place(element):
    if element.ShapeType == "Vertex":
        return element.Point
    if element.Degenerated:
        return element.Vertexes[0].Point
    return element.valueAt(sum(element.ParameterRange) / 2)


def _numbers(shape, kind):
    """A function that names an element of a shape by its number."""
    by_hash = {}
    for number, element in enumerate(getattr(shape, _KINDS[kind]), 1):
        by_hash.setdefault(element.hashCode(), []).append((element, number))

    def name(element):
        candidates = by_hash[element.hashCode()]
        return f"{kind}{next(number for one, number in candidates if one.isSame(element))}"

    return name


def _name_new(shape, names):
    """Names what has none yet: faces after the edges that they had before, edges after the faces beside
    them, vertices after their edges. Where two would be called alike, neither is named."""
    edge_name, vertex_name = _numbers(shape, "Edge"), _numbers(shape, "Vertex")
    edges_of = [[edge_name(edge) for edge in face.Edges] for face in shape.Faces]
    around = {f"Face{number}": edges for number, edges in enumerate(edges_of, 1)}
    _name_after(around, names)
    around = {}
    for number, edges in enumerate(edges_of, 1):
        for edge in edges:
            around.setdefault(edge, []).append(f"Face{number}")
    _name_after(around, names)
    around = {}
    for number, edge in enumerate(shape.Edges, 1):
        for vertex in edge.Vertexes:
            around.setdefault(vertex_name(vertex), []).append(f"Edge{number}")
    _name_after(around, names)


def _name_after(around, names):
    made = {}
    for element, others in around.items():
        if element not in names:
            said = sorted({names[other] for other in others if other in names})
            if said:
                digest = hashlib.sha256("|".join(said).encode()).hexdigest()[:12]
                made.setdefault(f"SUT;{digest}", []).append(element)
    names.update({elements[0]: name for name, elements in made.items() if len(elements) == 1})
