"""What is said of a fill and of a check, the forms and their translations."""

import ast
import json
import math
import re
import unittest
import xml.etree.ElementTree as ElementTree
from types import SimpleNamespace

from headless import ROOT, Case, example  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api, compat, facing, readout, said, words  # noqa: E402
from suture_workbench.errors import SutureError  # noqa: E402

PLUGIN = ROOT / "plugin/suture_workbench"


class Words(Case):
    def test_only_the_sides_that_fail_are_named(self):
        filled = api.fill(self.add(example()), method="occt")
        self.assertFalse(filled.WithinTolerance)
        from suture_workbench import reports

        report = reports.fill(json.loads(filled.Report))
        (hole,) = report.holes
        good = hole.sides[0]._replace(angle=0.001, gap=1e-6)
        report = report._replace(
            holes=[hole._replace(sides=[good, *hole.sides[1:]], findings=[])]
        )
        text = words.shortfall(report)
        self.assertNotIn(f"Edge{good.edge}:", text)
        for side in hole.sides[1:]:
            self.assertIn(f"Edge{side.edge}: angle", text)
        self.assertIn("at most 0.01", text)

    def test_findings_of_the_program_are_said_where_it_has_some(self):
        from suture_workbench import reports

        found = {
            "kind": "angle",
            "severity": "poor",
            "value": 0.25,
            "limit": 0.01,
            "unit": "deg",
            "edge": 9,
            "before": False,
            "text": "angle 0.25 deg on edge 9",
        }
        others = [
            found | {"severity": "good", "edge": 10},
            found | {"before": True, "edge": 11},
            found | {"severity": "near", "value": 0.02, "edge": 12},
            found | {"kind": "fold", "severity": "bad", "edge": None},
            found | {"kind": "new to us", "edge": 13, "text": "odd at edge 13"},
        ]
        filled = api.fill(self.add(example()), method="occt")
        document = json.loads(filled.Report)
        document["holes"][0]["findings"] = [found, *others]
        report = reports.fill(document)
        text = words.shortfall(report)
        for said in ("Edge9: angle 0.25° (at most 0.01)", "Edge12: angle 0.02", "face folds"):
            self.assertIn(said, text)
        self.assertIn("odd at Edge13", text)
        for unsaid in ("Edge10", "Edge11"):
            self.assertNotIn(unsaid, text)
        doubts = words.doubts(report)
        self.assertIn("Edge9", doubts)
        self.assertIn("folds", doubts)
        self.assertNotIn("Edge12", doubts)

    def test_a_join_in_position_only_has_no_angle_to_miss(self):
        limits = {"gap_mm": 0.001, "angle_deg": 0.01, "curvature_percent": 2.0}
        side = SimpleNamespace(edge=1, wanted="G0", gap=1e-6, angle=90.0, curvature=1.0)
        self.assertEqual(words.side_faults(side, limits), [])
        self.assertEqual(words.side_reached(side, limits), "G0")
        side.wanted = "G1"
        self.assertEqual(words.side_faults(side, limits), [("angle", 90.0, 0.01)])
        side.gap = 0.5
        self.assertEqual(words.side_reached(side, limits), "")
        side = SimpleNamespace(edge=1, wanted="G2", gap=0.0, angle=0.0, curvature=0.5)
        self.assertEqual(words.side_faults(side, limits), [("curvature", 50.0, 2.0)])
        self.assertEqual(words.side_reached(side, limits), "G1")

    def test_an_open_shape_is_not_said_to_be_well(self):
        text, well = words.check_summary(api.check(self.add(example())))
        self.assertFalse(well)
        self.assertIn("3 free edges", text)
        text, well = words.check_summary(api.check(self.add(Part.makeBox(1, 2, 3))))
        self.assertTrue(well, text)

    def test_doubts_arise_from_what_is_far_off_only(self):
        fine = api.fill(self.add(example()), method="mvs")
        bad = api.fill(self.add(example()), method="occt")
        from suture_workbench import reports

        self.assertEqual(words.doubts(reports.fill(json.loads(fine.Report))), "")
        self.assertIn("Edge", words.doubts(reports.fill(json.loads(bad.Report))))

    def test_a_lost_reference_is_an_error_and_no_number(self):
        self.assertEqual(compat.element_of("Body.Pad.;g233;SKT.Face6"), "Face6")
        with self.assertRaises(SutureError) as caught:
            compat.element_of("Body.Pad.?Edge6")
        self.assertIn("Edge6", str(caught.exception))

    def test_a_new_face_is_as_transparent_as_its_object(self):
        for alpha in (0.0, 1.0):  # 0.20 and 1.x
            view = SimpleNamespace(ShapeColor=(0.8, 0.7, 0.6, alpha), Transparency=25)
            self.assertEqual(compat.plain_color(view), (0.8, 0.7, 0.6, 0.25))

    def test_gap_angle_and_radii_are_read_off_at_a_point(self):
        box = Part.makeBox(10, 10, 10)
        solid = box.makeFillet(2, [box.Edges[0]])
        edges = {"tangent": [], "sharp": []}
        for number, edge in enumerate(solid.Edges, 1):
            middle = edge.valueAt(sum(edge.ParameterRange) / 2)
            gap, angle, radii = readout.at_edge(solid, number, middle)
            self.assertLess(gap, 1e-9)
            if angle < 1e-6:
                edges["tangent"].append(sorted(radii))
            else:
                self.assertAlmostEqual(angle, 90.0, delta=1e-6)
                edges["sharp"].append(number)
        self.assertEqual(len(edges["tangent"]), 2)
        for radii in edges["tangent"]:
            self.assertAlmostEqual(radii[0], 2.0, delta=1e-9)
            self.assertEqual(radii[1], math.inf)
        ball = Part.makeSphere(7)
        for radius in readout.at_face(ball, 1, App.Vector(7, 0, 0)):
            self.assertAlmostEqual(radius, 7.0, delta=1e-9)
        self.assertIn("7 mm, 7 mm", readout.text(ball, "Face", 1, App.Vector(7, 0, 0)))

    def test_a_hole_faces_outwards(self):
        corner = example()
        (hole,) = api.find_holes(self.add(corner)).report.holes
        outward = facing.outward(corner, hole.edges, hole.faces)
        middle = sum((corner.Edges[n - 1].CenterOfMass for n in hole.edges), App.Vector()) / 3
        away = (middle - corner.BoundBox.Center).normalize()
        self.assertGreater(outward.normalize().dot(away), 0.9)
        box = Part.makeBox(10, 10, 10)
        lidless = Part.Shell([face for index, face in enumerate(box.Faces) if index != 5])
        (hole,) = api.find_holes(self.add(lidless)).report.holes
        lid = box.Faces[5].normalAt(0, 0)
        self.assertGreater(facing.outward(lidless, hole.edges, hole.faces).dot(lid), 0.99)


def texts_of(language):
    """{(context, text): translation}"""
    root = ElementTree.parse(PLUGIN / f"resources/translations/Suture_{language}.ts").getroot()
    return {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation")
        for context in root.iter("context")
        for message in context.iter("message")
    }


class ProgramsWords(Case):
    """Sentences of the program, as a user in German reads them."""

    ENGLISH = re.compile(r"\b(the|of|its?|is|are|has|no|not|and|with|lies?|edges?|faces?|holes?|all)\b")

    def setUp(self):
        super().setUp()
        known = texts_of("de")
        before = said.translate_in
        said.translate_in = lambda context, text: known.get((context, text)) or text
        self.addCleanup(setattr, said, "translate_in", before)

    def assert_german(self, text):
        self.assertIsNone(self.ENGLISH.search(text), text)

    def refusals(self, shape, **options):
        with self.assertRaises(SutureError) as caught:
            api.fill(self.add(shape), **options)
        return str(caught.exception)

    def test_why_a_loop_is_a_hole_or_none(self):
        disc = Part.makeCylinder(2, 1, App.Vector(5, 5, -0.5))
        shape = Part.Compound([Part.makePlane(10, 10).cut(disc), example("pipe_elbow")])
        holes = api.find_holes(self.add(shape)).report.holes
        self.assertGreater(len(holes), 3)
        for hole in holes:
            self.assert_german(hole.reason)
        self.assertIn("die Schale dreht sich daran um", holes[0].reason)

    def test_refusals_of_every_method(self):
        for name, methods in (
            ("bump_window", ("plane", "quad", "loft", "manifold")),
            ("suitcase_corner", ("extend", "quad", "loft")),
        ):
            for method in methods:
                text = self.refusals(example(name), method=method)
                self.assert_german(text.split("refused: ", 1)[1])
        text = self.refusals(example("dome_window"), method="concentric", own={"axis": "basic"})
        self.assert_german(text.split("refused: ", 1)[1])
        text = self.refusals(example(), method="plane")
        self.assertRegex(text, r"das Loch ist nicht eben: Edge\d+ \(Face\d+\) verlässt")
        self.assert_german(self.refusals(example(), edges=[1]))
        self.assert_german(self.refusals(example(), method="mvs", own={"tall": 1}))

    def test_sides_stages_and_what_was_recognised(self):
        from suture_workbench import reports

        filled = api.fill(self.add(example()), method="auto")
        for hole in reports.fill(json.loads(filled.Report)).holes:
            for side in hole.sides:
                self.assert_german(side.reason)
        self.assertEqual(said.in_your_language("filling holes, 3 of 7 done"), "füllt Löcher, 3 von 7 fertig")
        text = said.in_users_words("torus R = 12, r = 3, tangent to faces 4, 7")
        self.assertEqual(text, "Torus R = 12, r = 3, tangential zu Face4, Face7")

    def test_options_of_the_methods(self):
        from suture_workbench import program

        for method in program.methods():
            for option in program.options_of(method):
                self.assert_german(said.in_your_language(option["text"]))

    def test_what_nobody_has_translated_stays(self):
        self.assertEqual(said.in_your_language("a sentence of tomorrow"), "a sentence of tomorrow")
        self.assertEqual(
            said.in_your_language("a sentence of tomorrow: OCCT's filling found no surface"),
            "a sentence of tomorrow: die Füllung von OCCT fand keine Fläche",
        )


class Translations(unittest.TestCase):
    def texts(self, language):
        return texts_of(language)

    def test_german_is_complete(self):
        known = self.texts("de")
        empty = [text for (_, text), translation in known.items() if not translation]
        self.assertEqual(empty, [])
        for (_, text), translation in known.items():
            holes = re.findall(r"\{[^}]*\}", text)
            self.assertEqual(sorted(re.findall(r"\{[^}]*\}", translation)), sorted(holes), text)

    def test_every_text_of_sources_and_forms_is_in_it(self):
        import importlib.util

        path = PLUGIN / "resources/translations/update.py"
        spec = importlib.util.spec_from_file_location("update", path)
        update = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(update)
        self.assertEqual(set(update.texts()), set(self.texts("de")))
        forms = {text for context, text in update.texts() if context == "Suture"}
        for form in (PLUGIN / "resources/ui").glob("*.ui"):
            for string in ElementTree.parse(form).getroot().iter("string"):
                if string.text and any(c.isalpha() for c in string.text) and string.get("notr") != "true":
                    self.assertIn(string.text, forms | {"limits", "more", "surfacePlace"}, form.name)

    def test_forms_are_in_the_context_of_our_texts(self):
        for form in (PLUGIN / "resources/ui").glob("*.ui"):
            self.assertEqual(ElementTree.parse(form).getroot().findtext("class"), "Suture", form.name)

    def test_all_texts_for_the_user_are_marked(self):
        """What is set as a text is no bare string with words in it."""
        setters = {"setText", "setToolTip", "setWindowTitle", "setPlaceholderText", "addItem"}
        for path in PLUGIN.rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Call) and getattr(node.func, "attr", "") in setters:
                    for argument in node.args:
                        if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                            bare = argument.value not in ("", "Suture") and " " in argument.value
                            self.assertFalse(bare, f"{path.name}: {argument.value}")


if __name__ == "__main__":
    unittest.main()
