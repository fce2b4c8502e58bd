"""`suture patch`: a smooth surface from a control mesh."""

import math

from program import DONE, OUT_OF_TOLERANCE, UNREADABLE, USAGE, Case, run


def star(sides, layers, columns, size=1.0):
    """Vertices and faces of a star-shaped mesh of skew blocks, bent out of its plane."""
    angle = 2.0 * math.pi / sides
    vertices, faces, numbers = [], [], {}

    def vertex(x, y, side):
        c, s = math.cos(angle * side), math.sin(angle * side)
        x, y = c * x - s * y, s * x + c * y
        key = round(x, 6), round(y, 6)
        if key not in numbers:
            numbers[key] = len(vertices) + 1
            vertices.append((size * x, size * y, size * 0.5 * math.sin(0.3 * x) * math.cos(0.2 * y)))
        return numbers[key]

    cos, sin = math.cos(angle), math.sin(angle)
    first = (0.6 * (1.0 + cos), -0.6 * sin)
    last = (0.6 * (1.0 + cos), 0.6 * sin)
    for side in range(sides):
        count = columns[side % len(columns)]

        def middle(i, j, count=count):
            return i + first[0], first[1] + (last[1] - first[1]) * j / count

        def corner(i, j):
            return last[0] + i + j * cos, last[1] + j * sin

        for place, wide in ((middle, count), (corner, layers)):
            for i in range(layers):
                for j in range(wide):
                    loop = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                    faces.append([vertex(*place(*at), side) for at in loop])
    return vertices, faces


def write_obj(path, vertices, faces):
    lines = ["v {:.15g} {:.15g} {:.15g}".format(*v) for v in vertices]
    lines += ["f " + " ".join(f"{v}//1" for v in face) for face in faces]
    path.write_text("\n".join(["# a star", "vn 0 0 1", *lines]) + "\n")
    return path


class Patch(Case):
    def test_a_star_becomes_a_valid_shell(self):
        mesh = write_obj(self.folder / "star.obj", *star(5, 5, [1, 2]))
        out = self.folder / "star.step"
        document = self.expect(
            run("patch", mesh, "-o", out, "--tolerance", "1e-4", "--json"), DONE
        ).json
        self.assertEqual(document["sides"], 5)
        self.assertEqual(document["shape"]["faces"], 10)
        self.assertTrue(document["shape"]["valid"])
        self.assertLess(document["max_gap"], 1e-9)
        self.assertLess(document["max_angle_deg"], 1e-6)
        self.assertLess(document["fit_error"], 1e-4 * document["diameter"])
        self.assertLess(document["aperture"], document["aperture_bound"])
        checked = self.expect(run("check", out, "--json"), DONE).json
        self.assertEqual(checked["summary"]["sharp"], 0)
        self.assertEqual(checked["shape"]["shells"], 1)

    def test_a_mesh_of_the_fewest_layers_is_all_middle(self):
        mesh = write_obj(self.folder / "star.obj", *star(5, 4, [1]))
        out = self.folder / "star.step"
        finished = run("patch", mesh, "-o", out, "--tolerance", "1e-3", "--json")
        self.assertEqual(self.expect(finished, DONE).json["shape"]["faces"], 5)

    def test_the_middle_is_written_exactly_for_k_0_and_1(self):
        mesh = write_obj(self.folder / "star.obj", *star(5, 6, [2, 3]))
        out = self.folder / "star.step"
        for k in (0, 1):
            arguments = ("patch", mesh, "-o", out, "--force", "--k", k, "--json")
            document = self.expect(run(*arguments, "--exact"), DONE).json
            self.assertTrue(document["exact"])
            self.assertEqual(document["fit_error"], 0.0)
            self.assertTrue(document["shape"]["valid"])
            self.assertEqual(document["shape"]["shells"], 1)
            self.assertEqual(document["shape"]["free_edges"], 5)
            self.assertGreater(document["shape"]["faces"], 50)
            self.assertLess(document["max_gap"], 1e-9)
            if k == 1:
                self.assertLess(document["max_angle_deg"], 1e-5)
            self.assertLess(out.stat().st_size, 5e6)
            # Quads cannot follow the kinks: without the option it is the same.
            self.assertTrue(self.expect(run(*arguments), DONE).json["exact"])
        coarse = run(*arguments, "--tolerance", "0.1")
        self.assertFalse(self.expect(coarse, DONE).json["exact"])
        quads = self.expect(run(*arguments, "--quads"), OUT_OF_TOLERANCE).json
        self.assertFalse(quads["exact"])
        self.assertEqual(quads["shape"]["faces"], 10)
        self.assertRegex(quads["reasons"][0], "the middle is .* off, above")
        self.expect_refused(
            run("patch", mesh, "-o", out, "--force", "--k", "2", "--exact"), USAGE, "--exact"
        )
        self.expect_refused(
            run("patch", mesh, "-o", out, "--force", "--k", "1", "--exact", "--quads"), USAGE
        )

    def test_a_wrong_mesh_is_refused_by_its_vertex(self):
        vertices, faces = star(5, 5, [2])
        mesh = write_obj(self.folder / "star.obj", vertices, faces[:-1])
        out = self.folder / "star.step"
        self.expect_refused(run("patch", mesh, "-o", out), UNREADABLE)
        self.assertFalse(out.exists())
        mesh.write_text("v 0 0 0\nf 1 2 3\n")
        self.expect_refused(run("patch", mesh, "-o", out), UNREADABLE, "line 2")

    def test_a_mesh_without_area_is_told(self):
        vertices, faces = star(5, 5, [2])
        out = self.folder / "star.step"
        for flat, word in (((0, 0, 0), "one point"), ((1, 0, 0), "one line")):
            thin = [tuple(f * x for f, x in zip(flat, v)) for v in vertices]
            mesh = write_obj(self.folder / "star.obj", thin, faces)
            self.expect_refused(run("patch", mesh, "-o", out), UNREADABLE, word)

    def test_a_mesh_that_folds_is_told(self):
        vertices, faces = star(5, 5, [2])
        mesh = write_obj(self.folder / "star.obj", [(x, abs(y), z) for x, y, z in vertices], faces)
        out = self.folder / "star.step"
        document = self.expect(
            run("patch", mesh, "-o", out, "--tolerance", "0.1", "--json"), OUT_OF_TOLERANCE
        ).json
        self.assertIn("folds at (", document["reasons"][0])

    def test_too_few_layers_and_too_wide_apertures_are_refused(self):
        mesh = write_obj(self.folder / "star.obj", *star(5, 3, [1]))
        out = self.folder / "star.step"
        self.expect_refused(run("patch", mesh, "-o", out), UNREADABLE, "needs 4")
        mesh = write_obj(self.folder / "star.obj", *star(5, 4, [1]))
        self.expect_refused(
            run("patch", mesh, "-o", out, "--aperture", "2"), UNREADABLE, "aperture"
        )
        self.expect_refused(
            run("patch", mesh, "-o", out, "--aperture", "0"), USAGE, "--aperture"
        )
        self.expect_refused(run("patch", mesh, "-o", out, "--k", "7"), USAGE, "--k")
        self.expect_refused(run("patch", mesh, "-o", out, "--tolerance=-1"), USAGE, "--tolerance")
