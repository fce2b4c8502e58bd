"""Twelve models for each way of choosing borders and faces, whose result is known in closed form:
turned and moved, small and large, with edges and faces named in any order."""

import math
import unittest

from program import DONE, OUT_OF_TOLERANCE, Case, run

try:
    import wounds
    from wounds import Part, Read, V
except ImportError as error:  # no FreeCAD
    wounds = error

SCALES = (1.0, 1e-2, 1e2)
PI = math.pi
NEAR = 1e-6


class Model:
    """A shape, what is chosen of it, and what has to come of it.

    chosen   tells edges by their middle, faces by their centre of mass; None: all
    """

    def __init__(self, shape, chosen=None, *words, faces, area=None, volume=None, within=1e-9):
        self.shape, self.chosen, self.words = shape, chosen or (lambda p: True), words
        self.faces, self.area, self.volume, self.within = faces, area, volume, within


def at(**places):
    """Whether a point has these coordinates."""
    return lambda p: all(abs(getattr(p, axis) - value) < NEAR for axis, value in places.items())


def either(*tests):
    return lambda p: any(test(p) for test in tests)


def without(shape, wanted):
    """A shell of a shape's faces but those whose centre of mass is as wanted."""
    left = [f for f in shape.Faces if not wanted(f.CenterOfMass)]
    return Part.makeShell(left) if len(left) > 1 else left[0]


def both(*shapes):
    return Part.Compound(shapes)


def box(x=30, y=20, z=10, at=(0, 0, 0)):
    return Part.makeBox(x, y, z, V(*at))


def cylinder(radius=5, height=20, z=0, x=0, y=0):
    return Part.makeCylinder(radius, height, V(x, y, z))


def tube(z0, z1, radius=5):
    return cylinder(radius, z1 - z0, z0).Faces[0]


def ball(radius=6):
    return Part.makeSphere(radius)


def zone(z0, z1, radius=6):
    """The part of a sphere between two heights."""
    angles = (math.degrees(math.asin(z / radius)) for z in (z0, z1))
    return Part.makeSphere(radius, V(), V(0, 0, 1), *angles).Faces[0]


def cone_wall(r0, r1, z0, z1):
    wall = Part.makeCone(r0, r1, z1 - z0, V(0, 0, z0)).Faces
    return next(f for f in wall if "Cone" in f.Surface.TypeId)


def edge_where(shape, wanted):
    return [e for e in shape.Edges if wanted(e.valueAt(sum(e.ParameterRange) / 2))]


def plate(x0, x1, z=0.0, y0=0.0, y1=8.0):
    return wounds.sheet([(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)])


def step_length(run, rise):
    """Length of the cubic that leaves the ends of two plates, one above the other."""
    gap, count = math.hypot(run, rise), 20000
    total = 0.0
    for k in range(count):
        t = (k + 0.5) / count
        dx = run * 6 * t * (1 - t) + gap * (1 - 6 * t + 6 * t * t)
        total += math.hypot(dx, rise * 6 * t * (1 - t))
    return total / count


def boundaries():
    lines = wounds.polygon
    open_square = lines([(0, 0, 0), (9, 0, 0), (9, 4, 0), (0, 4, 0)])[:3]
    return {
        "triangle of lines": Model(
            both(*lines([(0, 0, 0), (4, 0, 0), (0, 3, 0)])), faces=1, area=6
        ),
        "pentagon that is not convex": Model(
            both(*lines([(0, 0, 0), (8, 0, 0), (8, 6, 0), (4, 2, 0), (0, 6, 0)])), faces=1, area=32
        ),
        "half disc": Model(
            both(Part.makeCircle(3, V(), V(0, 0, 1), 0, 180), *lines([(-3, 0, 0), (3, 0, 0)])[:1]),
            faces=1,
            area=4.5 * PI,
        ),
        "ellipse": Model(Part.Ellipse(V(), 5, 2).toShape(), faces=1, area=10 * PI),
        "square with a round island": Model(
            both(*lines([(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0)]), Part.makeCircle(2)),
            faces=1,
            area=100 - 4 * PI,
        ),
        # The curve goes straight on from both ends: it bulges by 6/5 of a parabola's arch.
        "side closed by a curve": Model(
            both(*open_square), None, "--connect", faces=1, area=36 + 16 / 5
        ),
        "window of a cylinder": Model(
            tube(0, 20).cut(box(9, 6, 4, (0, -3, 8))),
            lambda p: p.x > 0 and 8 - NEAR < p.z < 12 + NEAR and abs(p.y) < 3 + NEAR,
            faces=2,
            area=200 * PI,
        ),
        "octant of a sphere": Model(
            ball().Faces[0].cut(box(9, 9, 9)),
            lambda p: min(p.x, p.y, p.z) > -NEAR and max(p.x, p.y) > 1 and p.y > -NEAR,
            faces=2,
            area=144 * PI,
        ),
        "lid over four walls": Model(
            without(box(10, 10, 7), either(at(z=0), at(z=7))), at(z=7), faces=5, area=380
        ),
        "end of a tube": Model(tube(0, 20), at(z=0), faces=2, area=225 * PI),
        "last face of a wedge": Model(
            without(Part.makeWedge(0, 0, 0, 2, 2, 10, 8, 6, 7, 5), at(y=0)),
            at(y=0),
            faces=6,
            volume=Part.makeWedge(0, 0, 0, 2, 2, 10, 8, 6, 7, 5).Volume,
        ),
        "end of a cone": Model(
            cone_wall(6, 3, 0, 8), at(z=8), faces=2, area=9 * PI * math.hypot(8, 3) + 9 * PI
        ),
    }


def replacements():
    solid = box()
    chamfered = solid.makeChamfer(3, solid.Edges[:1])
    wedge = Part.makeWedge(0, 0, 0, 2, 2, 10, 8, 6, 7, 5)
    prism = Part.Face(
        Part.makePolygon([V(5 * math.cos(k * PI / 3), 5 * math.sin(k * PI / 3), 0) for k in range(7)])
    ).extrude(V(0, 0, 9))
    rod = cylinder()
    rim = rod.makeFillet(2, edge_where(rod, at(z=20)))
    filleted = solid.makeFillet(3, solid.Edges[:1])
    l_shape = box().fuse(box(10, 20, 30)).removeSplitter()  # 30 x 20 x 10 and 10 x 20 x 20
    return {
        "wall of a box": Model(solid, at(x=0), faces=6, volume=6000),
        "two walls that lie opposite": Model(
            solid, either(at(x=0), at(x=30)), faces=6, volume=6000
        ),
        "chamfer": Model(
            chamfered,
            lambda p: at(x=1)(p) or (p.x > NEAR and p.y > NEAR and p.x + p.y < 4),
            faces=7,
            volume=chamfered.Volume,
        ),
        "end of a cylinder": Model(cylinder(), at(z=20), faces=3, volume=500 * PI),
        "sloping wall of a wedge": Model(wedge, lambda p: p.x > 7, faces=6, volume=wedge.Volume),
        "side of a hexagonal prism": Model(
            prism, lambda p: at(z=4.5)(p) and p.x > 3 and p.y > 1, faces=8, volume=prism.Volume
        ),
        "ends of a hexagonal prism": Model(
            prism, either(at(z=0), at(z=9)), faces=8, volume=prism.Volume
        ),
        "fillet along an edge": Model(
            filleted, lambda p: p.x < 2.9 and p.y < 2.9, faces=7, volume=filleted.Volume, within=1e-6
        ),
        "fillet of a rim": Model(
            rim, lambda p: 18 < p.z < 19.99 and abs(p.x) < 1, faces=4, volume=rim.Volume, within=1e-6
        ),
        "step of a solid": Model(l_shape, at(z=30), faces=8, volume=6000 + 4000),
        "end of a truncated cone": Model(
            Part.makeCone(6, 3, 8), at(z=0), faces=3, volume=PI * 8 / 3 * (36 + 18 + 9)
        ),
        "wall of a bored box": Model(
            box().cut(cylinder(3, 10, x=9, y=9)), at(z=10), faces=7, volume=6000 - 90 * PI
        ),
    }


def removals():
    solid = box()
    edges = solid.Edges
    drilled = box().cut(cylinder(3, 10, x=9, y=9))
    blind = box().cut(cylinder(3, 6, 4, 9, 9))
    bored = box().cut(cylinder(2, 10, x=9, y=9)).cut(cylinder(4, 3, 7, 9, 9))
    pocket = box().cut(box(6, 5, 4, (9, 8, 6)))
    boss = box().fuse(cylinder(3, 4, 10, 9, 9))
    slot = box().cut(box(6, 20, 4, (9, 0, 6)))
    rib = box().fuse(box(4, 20, 5, (12, 0, 10))).removeSplitter()
    rod = cylinder()
    rim = rod.makeFillet(2, edge_where(rod, at(z=20)))
    bevel = rod.makeChamfer(2, edge_where(rod, at(z=20)))
    return {
        "fillet": Model(
            solid.makeFillet(2, edges[:1]), lambda p: p.x < 1.9 and p.y < 1.9, faces=6, volume=6000
        ),
        "fillets of two edges": Model(
            solid.makeFillet(2, [edges[0], edges[4]]),
            lambda p: min(p.x, 30 - p.x) < 1.9 and p.y < 1.9,
            faces=6,
            volume=6000,
        ),
        "chamfer": Model(
            solid.makeChamfer(2, edges[:1]), lambda p: p.x < 1.9 and p.y < 1.9, faces=6, volume=6000
        ),
        "bore": Model(drilled, at(x=9, y=9), faces=6, volume=6000),
        "blind hole": Model(blind, at(x=9, y=9), faces=6, volume=6000),
        "counterbore": Model(
            bored, lambda p: at(x=9, y=9)(p) and NEAR < p.z < 10 - NEAR, faces=6, volume=6000
        ),
        "pocket": Model(
            pocket,
            lambda p: 9 - NEAR < p.x < 15 + NEAR and 8 - NEAR < p.y < 13 + NEAR and 5.9 < p.z < 9.9,
            faces=6,
            volume=6000,
        ),
        "boss": Model(boss, lambda p: at(x=9, y=9)(p) and p.z > 10.1, faces=6, volume=6000),
        "slot": Model(
            slot, lambda p: at(y=10)(p) and 5.9 < p.z < 9.9 and 8.9 < p.x < 15.1, faces=6, volume=6000
        ),
        "rib": Model(rib, lambda p: p.z > 10.1, faces=6, volume=6000),
        "fillet of a rim": Model(
            rim, lambda p: 18 < p.z < 19.99, faces=3, volume=500 * PI
        ),
        "bevel of a rim": Model(bevel, lambda p: 18 < p.z < 19.99, faces=3, volume=500 * PI),
    }


def bridges():
    facing = either(at(x=10), at(x=20))
    u_sheet = wounds.sheet(
        [(0, 0, 0), (30, 0, 0), (30, 8, 0), (20, 8, 0), (20, 4, 0), (10, 4, 0), (10, 8, 0), (0, 8, 0)]
    )
    pipe = lambda z0, z1: without(box(10, 10, z1 - z0, (0, 0, z0)), either(at(z=z0), at(z=z1)))
    cup = lambda z, end: without(cylinder(5, 10, z), at(z=end))
    rims = either(at(z=10), at(z=20))
    strip = lambda z0: Part.makeCylinder(5, 10, V(0, 0, z0), V(0, 0, 1), 90).Faces[0]
    return {
        "plates in a plane": Model(both(plate(0, 10), plate(20, 30)), facing, faces=3, area=240),
        "plates of two widths": Model(
            both(plate(0, 10), plate(20, 30, y0=2, y1=6)), facing, faces=3, area=None
        ),
        "plates one above the other": Model(
            both(plate(0, 10), plate(20, 30, 5)), facing, faces=3, area=160 + 8 * step_length(10, 5),
            within=1e-6,
        ),
        "plates far above each other": Model(
            both(plate(0, 10), plate(20, 30, 30)), facing, faces=3,
            area=160 + 8 * step_length(10, 30), within=1e-6,
        ),
        "both arms of one sheet": Model(
            u_sheet, lambda p: p.y > 4.1 and p.y < 7.9 and 9 < p.x < 21, faces=2, area=240
        ),
        "pipes of one axis": Model(
            both(tube(0, 10), tube(20, 30)), rims, faces=3, area=300 * PI
        ),
        "cups of one axis": Model(
            both(cup(0, 10), cup(20, 20)), rims, faces=5, volume=750 * PI
        ),
        "square pipes": Model(both(pipe(0, 10), pipe(20, 35)), rims, faces=None, area=40 * 35),
        "cones of one tip": Model(
            both(cone_wall(10, 8, 0, 10), cone_wall(6, 4, 20, 30)),
            rims,
            faces=3,
            area=PI * 14 * math.hypot(6, 30),
        ),
        "zones of a sphere": Model(
            both(zone(-5, -2), zone(2, 4)), either(at(z=-2), at(z=2)), faces=3, area=12 * PI * 9
        ),
        "strips of a cylinder": Model(
            both(strip(0), strip(20)), rims, faces=3, area=2.5 * PI * 30, within=1e-6
        ),
        "pipes of two sizes": Model(
            both(tube(0, 10), tube(20, 30, 5.0001)), rims, faces=3, area=300 * PI, within=1e-4
        ),
    }


@unittest.skipIf(isinstance(wounds, ImportError), f"needs FreeCAD: {wounds}")
class Twelve(Case):
    def check(self, models, of, words):
        """Carries out every model; words: of the command line, from the numbers that were chosen."""
        self.assertEqual(len(models), 12)
        turn = wounds.placed(Part.Vertex(0, 0, 0)).Placement
        for index, (name, model) in enumerate(models.items()):
            scale = SCALES[index % len(SCALES)]
            with self.subTest(name, scale=scale):
                file = self.folder / "in.step"
                wounds.save(wounds.placed(model.shape, scale), file)
                move = turn.copy()
                move.Base = turn.Base * scale
                back = move.inverse()
                numbers = of(file, lambda p: model.chosen((back * p) * (1 / scale)))
                self.assertTrue(numbers)
                out = self.folder / "out.step"
                out.unlink(missing_ok=True)
                chosen = words(wounds.mixed(numbers, index))
                done = run(chosen[0], file, "-o", out, *chosen[1:], *model.words)
                self.assertIn(done.code, (DONE, OUT_OF_TOLERANCE), str(done))
                made = Read(out)
                self.assertTrue(made.valid)
                if model.faces:
                    self.assertEqual(made.faces, model.faces, str(done))
                if model.area:
                    self.assertAlmostEqual(made.area / scale**2 / model.area, 1, delta=model.within)
                if model.volume:
                    self.assertEqual(made.solids, 1)
                    self.assertAlmostEqual(made.volume / scale**3 / model.volume, 1, delta=model.within)

    def test_a_face_over_chosen_edges(self):
        self.check(boundaries(), wounds.edges_where, lambda n: ["fill", "--no-sew", "--boundary", n])

    def test_faces_replaced(self):
        self.check(replacements(), wounds.faces_where, lambda n: ["fill", "--replace-faces", n])

    def test_faces_removed(self):
        self.check(removals(), wounds.faces_where, lambda n: ["fill", "--remove-faces", n])

    def test_edges_bridged(self):
        self.check(bridges(), wounds.edges_where, lambda n: ["bridge", "--edges", n])


if __name__ == "__main__":
    unittest.main()
