# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zebra stripes and a map of curvature, by a shader on the triangles that FreeCAD itself draws.

They cost nothing to switch on, follow the object's visibility, placement and changes, and lie on its
faces rather than over them. The widths and directions are the same for all that is shaded.
"""

import math

from pivy import coin

from .. import parts, places

NONE, ZEBRA, CURVATURE = "none", "zebra", "curvature"

_VERTEX = """
varying vec3 normal;
varying vec3 place;
void main() {
    normal = gl_NormalMatrix * gl_Normal;
    place = vec3(gl_ModelViewMatrix * gl_Vertex);
    gl_Position = ftransform();
}
"""
# Lines of light far away, mirrored: the angle between the mirrored view and the lines' plane, in
# stripes. The normals are those of the surfaces at the nodes of the mesh and turn evenly between
# them, so that two faces that are tangent show the same stripes along their common edge.
_ZEBRA = """
varying vec3 normal;
varying vec3 place;
uniform float stripes;
uniform vec3 axis;
void main() {
    vec3 view = gl_ProjectionMatrix[3][3] > 0.5 ? vec3(0.0, 0.0, -1.0) : normalize(place);
    vec3 n = normalize(normal);
    vec3 mirrored = reflect(view, faceforward(n, view, n));
    float phase = stripes * acos(clamp(dot(mirrored, axis), -1.0, 1.0));
    float edge = max(fwidth(phase), 0.0001);
    float white = smoothstep(-edge, edge, sin(phase));
    float light = 0.75 + 0.25 * abs(dot(n, view));
    gl_FragColor = vec4(vec3(light * mix(0.06, 1.0, white)), 1.0);
}
"""
# The shape operator from the changes of place and normal from one pixel to the next (do Carmo,
# Differential Geometry of Curves and Surfaces, 3-3): the larger principal curvature, without sign.
_CURVATURE = """
varying vec3 normal;
varying vec3 place;
uniform float radius;
void main() {
    vec3 n = normalize(normal);
    vec3 px = dFdx(place), py = dFdy(place), nx = dFdx(n), ny = dFdy(n);
    float E = dot(px, px), F = dot(px, py), G = dot(py, py);
    float e = dot(nx, px), f = 0.5 * (dot(nx, py) + dot(ny, px)), g = dot(ny, py);
    float area = max(E * G - F * F, 1e-30);
    float mean = 0.5 * (e * G - 2.0 * f * F + g * E) / area;
    float gauss = (e * g - f * f) / area;
    float largest = abs(mean) + sqrt(max(mean * mean - gauss, 0.0));
    float t = clamp(largest * radius, 0.0, 1.0);
    vec3 color = clamp(vec3(1.5 - abs(4.0 * t - 3.0), 1.5 - abs(4.0 * t - 2.0), 1.5 - abs(4.0 * t - 1.0)), 0.0, 1.0);
    vec3 view = gl_ProjectionMatrix[3][3] > 0.5 ? vec3(0.0, 0.0, -1.0) : normalize(place);
    gl_FragColor = vec4(color * (0.6 + 0.4 * abs(dot(n, view))), 1.0);
}
"""


def _program(fragment, parameters):
    program = coin.SoShaderProgram()
    vertex, pixel = coin.SoVertexShader(), coin.SoFragmentShader()
    for position, (shader, text) in enumerate(((vertex, _VERTEX), (pixel, fragment))):
        shader.sourceType = coin.SoShaderObject.GLSL_PROGRAM
        shader.sourceProgram = text
        program.shaderObject.set1Value(position, shader)
    for position, parameter in enumerate(parameters):
        pixel.parameter.set1Value(position, parameter)
    program.setName("SutureShading")
    return program


def _parameter(kind, name, value):
    parameter = kind()
    parameter.name, parameter.value = name, value
    return parameter


_stripes = _parameter(coin.SoShaderParameter1f, "stripes", 14.0)
_axis = _parameter(coin.SoShaderParameter3f, "axis", (0.0, 1.0, 0.0))
_radius = _parameter(coin.SoShaderParameter1f, "radius", 10.0)
_programs = {}


def node(kind):
    """The node that shades what follows it as ZEBRA or CURVATURE."""
    if kind not in _programs:
        _programs[kind] = (
            _program(_ZEBRA, [_stripes, _axis])
            if kind == ZEBRA
            else _program(_CURVATURE, [_radius])
        )
    return _programs[kind]


def set_stripes(count, degrees):
    """How many stripes half a turn has, and how far they are turned round the view."""
    _stripes.value = float(count)
    angle = math.radians(degrees)
    _axis.value = (math.sin(angle), math.cos(angle), 0.0)


def set_radius(radius):
    """The radius of curvature (mm) that is red; flat is blue."""
    _radius.value = float(radius)


def shown_on(obj):
    """How an object is shaded: NONE, ZEBRA or CURVATURE."""
    for _, parent in _face_sets(obj):
        for kind, program in _programs.items():
            if parent.findChild(program) >= 0:
                return kind
    return NONE


def show_on(obj, kind):
    """Shades an object, all of its parts, or with NONE gives it its own colours back."""
    for face_set, parent in _face_sets(obj):
        for program in _programs.values():
            if parent.findChild(program) >= 0:
                parent.removeChild(program)
        if kind != NONE:
            parent.insertChild(node(kind), parent.findChild(face_set))


def _face_sets(obj):
    """The nodes that draw the faces of an object, with the group that each of them is in."""
    search = coin.SoSearchAction()
    search.setType(coin.SoType.fromName("SoBrepFaceSet"))
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)  # through switches too: hidden now is shown later
    found, seen = [], set()
    for leaf in parts.leaf_objects(obj):
        view = leaf.ViewObject
        if view is None:
            continue
        search.reset()
        search.setType(coin.SoType.fromName("SoBrepFaceSet"))
        search.setInterest(coin.SoSearchAction.ALL)
        search.setSearchingAll(True)
        search.apply(view.RootNode)
        paths = search.getPaths()
        for index in range(paths.getLength()):
            path = paths[index]
            face_set, parent = path.getTail(), path.getNodeFromTail(1)
            key = int(parent.this) if hasattr(parent, "this") else id(parent)
            if key not in seen:
                seen.add(key)
                found.append((face_set, parent))
    return found
