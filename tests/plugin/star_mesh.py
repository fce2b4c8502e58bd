"""A control mesh for `suture patch`."""

import math
from pathlib import Path


def star(path, sides=5, layers=5):
    """A control mesh in the plane: blocks of quads around a hole of so many sides."""
    turn = 2.0 * math.pi / sides
    cos, sin = math.cos(turn), math.sin(turn)
    first, last = (0.6 * (1 + cos), -0.6 * sin), (0.6 * (1 + cos), 0.6 * sin)
    vertices, lines, faces = {}, [], []

    def vertex(x, y, side):
        c, s = math.cos(turn * side), math.sin(turn * side)
        place = (round(c * x - s * y, 6), round(s * x + c * y, 6))
        if place not in vertices:
            vertices[place] = len(vertices) + 1
            lines.append(f"v {place[0]} {place[1]} 0")
        return vertices[place]

    for side in range(sides):
        for i in range(layers):
            strip = [
                vertex(first[0] + k, first[1] + (last[1] - first[1]) * j, side)
                for k, j in ((i, 0), (i + 1, 0), (i + 1, 1), (i, 1))
            ]
            faces.append(strip)
            for j in range(layers):
                faces.append(
                    [
                        vertex(last[0] + a + b * cos, last[1] + b * sin, side)
                        for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                    ]
                )
    lines += ["f " + " ".join(map(str, face)) for face in faces]
    Path(path).write_text("\n".join(lines) + "\n", encoding="ascii")
    return path
