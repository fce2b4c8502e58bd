"""The parametric object: placements, containers, saving, undo."""

import os
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from headless import CORNER, PROGRAM, TURNED, Case, example  # first: it makes FreeCAD importable

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from suture_workbench import api, parts, places  # noqa: E402
from suture_workbench.errors import NothingToDo  # noqa: E402


class Objects(Case):
    def test_a_filled_shape_follows_its_base(self):
        base = self.add(example())
        filled = api.fill(base, method="mvs")
        volume = filled.Shape.Volume
        larger = example()
        larger.scale(2)
        base.Shape = larger
        self.document.recompute()
        self.assertAlmostEqual(filled.Shape.Volume, 8 * volume, delta=0.01 * volume)
        self.assertTrue(filled.Closed)

    def test_it_is_saved_opened_and_recomputed(self):
        filled = api.fill(self.add(example()))
        key, volume = filled.InputKey, filled.Shape.Volume
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.FCStd")
            self.document.saveAs(path)
            App.closeDocument(self.document.Name)
            again = App.openDocument(path).getObject("Filled")
            again.touch()
            self.misbehave("crash")  # nothing to compute: nothing to run
            again.Document.recompute()
            self.assertEqual(again.State, ["Up-to-date"])
            self.assertEqual((again.InputKey, again.Shape.Volume), (key, volume))
            os.environ["SUTURE_EXE"] = PROGRAM
            again.Method = "mvs"
            again.Document.recompute()
            self.assertNotEqual(again.InputKey, key)
            self.assertTrue(again.Closed)

    def test_moving_the_base_moves_the_result_without_a_run(self):
        base = self.add(example())
        filled = api.fill(base)
        self.misbehave("crash")
        base.Placement = TURNED
        self.document.recompute()
        self.assertEqual(filled.State, ["Up-to-date"])
        self.assert_same_face(base.Shape.Faces[2], filled.Shape.Faces[2])

    def test_placed_shapes_have_the_same_numbers(self):
        base = self.add(example())
        base.Placement = TURNED
        self.assertEqual(api.find_holes(base).report.holes[0].edges, CORNER)
        filled = api.fill(base, edges=[19], method="mvs")
        self.assert_same_face(base.Shape.Faces[0], filled.Shape.Faces[0])
        self.assertTrue(filled.Closed)

    def test_the_result_stands_in_the_part_of_its_base(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = TURNED
        base = self.add(example())
        part.addObject(base)
        base.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(0, 0, 90))
        filled = api.fill(base)
        self.assertEqual(filled.getParentGeoFeatureGroup(), part)
        self.assert_same_face(base.Shape.Faces[4], filled.Shape.Faces[4])

    def test_a_body_is_filled_beside_it(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        body.Placement = TURNED
        inside = self.document.addObject("PartDesign::Feature", "Imported")
        body.addObject(inside)
        inside.Shape = example()
        body.Tip = inside
        self.document.recompute()
        filled = api.fill(inside)
        self.assertEqual(filled.Base[0], body)
        self.assertIsNone(filled.getParentGeoFeatureGroup())
        self.assert_same_face(Part.getShape(body).Faces[4], filled.Shape.Faces[4])
        self.assertTrue(filled.Closed)

    def test_a_feature_inside_a_body_is_filled_beside_the_body(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        body.Placement = TURNED
        inside, tip = (self.document.addObject("PartDesign::Feature", name) for name in "AB")
        for feature, shape in ((inside, example()), (tip, Part.makeBox(1, 1, 1))):
            body.addObject(feature)
            feature.Shape = shape
        body.Tip = tip
        filled = api.fill(inside)
        self.assertIsNone(filled.getParentGeoFeatureGroup())
        there = inside.Shape.Faces[4].CenterOfMass
        self.assertLess((filled.Shape.Faces[4].CenterOfMass - TURNED.multVec(there)).Length, 1e-7)

    def test_a_link_is_filled_where_it_stands(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.add(example())
        link.Placement = TURNED
        self.document.recompute()
        filled = api.fill(link)
        self.assert_same_face(Part.getShape(link).Faces[4], filled.Shape.Faces[4])

    def test_a_selection_is_traced_to_its_object_and_instance(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(10, 0, 0))
        base = self.add(example())
        part.addObject(base)
        base.Placement = App.Placement(App.Vector(0, 0, 9), App.Rotation(0, 0, 90))
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement = TURNED
        self.document.recompute()
        for top, outer in ((part, part.Placement), (link, TURNED)):
            sub = (f"{base.Name}.Edge9", f"{base.Name}.Face3")
            (found,) = places.selection([SimpleNamespace(Object=top, SubElementNames=sub)])
            self.assertEqual((found.obj, found.edges, found.faces), (base, [9], [3]))
            wanted = outer.multiply(base.Placement)
            for point in (App.Vector(), App.Vector(1, 0, 0), App.Vector(0, 1, 0)):
                apart = places.shown_at(found).multVec(point) - wanted.multVec(point)
                self.assertLess(apart.Length, 1e-9, top.Name)

    def group_of_two(self, kind):
        """A container with two open corners."""
        container = self.document.addObject(kind, "Container")
        members = [self.add(example(), name) for name in ("First", "Second")]
        members[1].Placement = App.Placement(App.Vector(40, 0, 0), App.Rotation(0, 0, 90))
        if kind == "App::LinkGroup":
            container.ElementList = members
        else:
            for part in members:
                container.addObject(part)
        container.Placement = TURNED
        self.document.recompute()
        return container, members

    def test_what_is_shown_does_not_change_what_is_computed(self):
        for kind in ("App::Part", "App::LinkGroup"):
            container, members = self.group_of_two(kind)
            link = self.document.addObject("App::Link", "LinkToIt")
            link.LinkedObject = container
            self.document.recompute()
            before = places.local_shape(container).exportBrepToString()
            linked = places.local_shape(link).exportBrepToString()
            filled = api.fill(container, method="mvs")
            self.assertEqual((len(filled.Shape.Solids), filled.Closed), (2, True), kind)
            for hidden in (*members, container):
                hidden.Visibility = False
                self.assertEqual(places.local_shape(container).exportBrepToString(), before, kind)
                self.assertEqual(places.local_shape(link).exportBrepToString(), linked, kind)
                filled.touch()
                self.document.recompute()
                self.assertEqual((filled.State, len(filled.Shape.Solids)), (["Up-to-date"], 2))
            wanted = container.Placement.multiply(members[1].Placement)
            there = wanted.multVec(example().Faces[4].CenterOfMass)
            count = len(example().Faces)
            found = filled.Shape.Faces[count + 1 + 4].CenterOfMass
            self.assertLess((found - there).Length, 1e-7, kind)

    def test_elements_of_a_container_are_named_through_its_parts(self):
        for kind in ("App::Part", "App::LinkGroup"):
            container, members = self.group_of_two(kind)
            edges = len(example().Edges)
            path = f"{members[1].Name}."
            name = parts.element_path(container, "Edge", edges + 9)
            self.assertEqual(name, path + "Edge9")
            self.assertEqual(parts.number_of(container, path, "Edge", 9), edges + 9)
            item = places.Selected(container, [], [], container, "")
            self.assertEqual(places.element_in(item, container, name), ("Edge", edges + 9))
            ours = places.shape_of(container).Edges[edges + 8].CenterOfMass
            theirs = container.getSubObject(name).CenterOfMass
            self.assertLess((ours - theirs).Length, 1e-9)

    def test_what_another_part_was_made_from_does_not_count(self):
        part = self.document.addObject("App::Part", "Part")
        box, tool = (self.document.addObject("Part::Box", name) for name in ("Box", "Tool"))
        tool.Length = 3
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, tool
        standing = self.document.addObject("Part::Box", "Standing")
        support = "AttachmentSupport" if hasattr(standing, "AttachmentSupport") else "Support"
        if not hasattr(standing, support):
            standing.addExtension("Part::AttachExtensionPython")
        setattr(standing, support, (cut, ["Face1"]))
        for obj in (box, tool, cut, standing):
            part.addObject(obj)
        self.document.recompute()
        found = sorted(path for path, _ in parts.leaves(part))
        self.assertEqual(found, ["Cut.", "Standing."])

    def test_a_hole_is_known_by_its_place_when_numbers_change(self):
        corner, other = example(), Part.makeBox(3, 4, 5).translated(App.Vector(60, 0, 0))
        base = self.add(Part.Compound([other, corner]))
        shift = len(other.Edges)
        filled = api.fill(base, edges=[shift + 9], sides={shift + 19: "G0"}, method="mvs")
        base.Shape = Part.Compound([corner, other])
        self.document.recompute()
        self.assertEqual((filled.State, len(filled.Shape.Solids)), (["Up-to-date"], 2))
        from suture_workbench import feature

        options = feature.Request.of(filled).options
        self.assertEqual((options.edges, options.sides), ([9], {19: "G0"}))
        filled.Base = (base, ["Edge19"])  # the user's own choice counts as it is
        self.assertEqual(feature.Request.of(filled).options.edges, [19])

    def test_the_result_is_one_step_of_undo(self):
        self.document.UndoMode = 1
        base = self.add(example())
        self.document.clearUndos()
        api.fill(base)
        self.assertEqual(self.document.UndoCount, 1)
        self.document.undo()
        self.assertEqual(self.document.Objects, [base])

    def test_loose_faces_are_sewn_into_an_object_that_stands_where_they_did(self):
        base = self.add(Part.Compound([face.copy() for face in example().Faces]))
        base.Placement = TURNED
        self.document.UndoMode = 1
        self.document.clearUndos()
        sewn = api.sew(base)
        self.assertEqual((sewn.Shape.ShapeType, self.document.UndoCount), ("Shell", 1))
        self.assertEqual(len(sewn.Shape.Edges), len(example().Edges))
        self.assertLess((sewn.Shape.BoundBox.Center - base.Shape.BoundBox.Center).Length, 1e-6)
        self.assertRaises(NothingToDo, api.sew, sewn)
        self.assertEqual(len(self.document.Objects), 2)

    def test_loose_faces_are_sewn_and_edges_still_found(self):
        base = self.add(Part.Compound([face.copy() for face in example().Faces]))
        found = api.find_holes(base)
        self.assertTrue(found.report.sewn)
        (hole,) = found.report.holes
        for number in hole.edges:
            sewn, loose = found.shape.Edges[number - 1], base.Shape.Edges[found.edges[number] - 1]
            self.assertLess((sewn.CenterOfMass - loose.CenterOfMass).Length, 1e-6)
        filled = api.fill(base, edges=[found.edges[hole.edges[0]]], method="mvs")
        self.assertEqual((filled.Shape.ShapeType, filled.Closed), ("Solid", True))


if __name__ == "__main__":
    unittest.main()
