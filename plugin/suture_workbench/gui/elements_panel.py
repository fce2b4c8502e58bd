# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels that work on chosen edges or faces: a face over edges, a bridge, faces that go."""

from types import SimpleNamespace

from .. import RESOURCES, feature, places
from ..compat import element_of, translate
from ..errors import SutureError
from ..parts import kind_and_number
from ..sources import Sources
from .elements_list import ElementsList
from .fill_panel import FillPanel


class ElementsPanel(FillPanel):
    """As the panel of the command Fill holes, but the user says what is filled."""

    kind = "Edge"

    def __init__(self, items, edited=None):
        """items   places.Selected, the first one that of the base"""
        self._items = items
        super().__init__(items[0], edited=edited)

    @classmethod
    def edit(cls, obj):
        """The panel with what an object has; OK changes it."""
        request = feature.Request.of(obj)
        sources = Sources([request.base, *request.others])
        items = [
            places.Selected(source, edges, [], source, "")
            for source, edges in sources.by_object(request.options.edges)
        ]
        items[0].faces.extend(request.options.faces)
        panel = cls(items, edited=obj)
        panel._show_instead(obj, sources.objects)
        panel._set(request.options, obj)
        supports = request.options.extras.get("supports", {})
        panel.tree.set_supports(
            {sources.origin(edge): sources.face_origin(face) for edge, face in supports.items()}
        )
        panel.tree.connect_box().setChecked(request.options.connect)
        return panel

    def watched(self):
        objects = [obj for obj, _ in [*self.tree.chosen(), *self.tree.supports().values()]]
        return [*dict.fromkeys([*super().watched(), *objects])]

    def clicked_in_view(self, top, sub, point):
        """An edge or a face clicked in the view is taken, or given back if it was taken before; a face
        where edges are wanted is what the new face leans on at the edges whose rows are selected."""
        fits = places.has_faces if self.kind == "Face" else places.has_shape
        leaf, _, element = places.resolve(top, sub)
        kind, number = kind_and_number(element)
        if self.kind == "Edge" and kind == "Face" and leaf is not self.edited:
            self.tree.lean(leaf, number)
            return
        if kind_and_number(element)[0] != self.kind or leaf is self.edited or not fits(leaf):
            return
        if self.kind == "Face" and leaf is not self.item.obj:
            return
        self.tree.toggle(leaf, kind_and_number(element)[1])

    def _make_list(self, placement):
        return ElementsList(self.kind, self._items, self.task == "Boundary", self._hint())

    def _begin(self):
        self.child("SutureOneFace").hide()
        self._choose_sides()

    def _sources(self):
        named = [*self.tree.chosen(), *self.tree.supports().values()]
        return Sources([self.item.obj, *(obj for obj, _ in named)])

    def _chosen(self):
        chosen = self.tree.chosen()
        if not chosen:
            raise SutureError(self._hint())
        if self.kind == "Face":
            return {"task": self.task, "faces": [number for _, number in chosen]}
        sources = self._sources()
        return {
            "task": self.task,
            "edges": [sources.number(obj, number) for obj, number in chosen],
            "connect": self.task == "Boundary" and self.tree.connect_box().isChecked(),
            "supports": {
                sources.number(*edge): sources.face_number(*face)
                for edge, face in self.tree.supports().items()
            },
        }

    def request(self):
        options = self.options()
        sources = self._sources()
        base, *others = sources.objects
        points = places.points_through(self.through.references, base)
        return feature.Request(base, options.with_points(points), sources.shape, others)

    def _choose_sides(self):
        sources = self._sources() if self.kind == "Edge" else None
        edges = [sources.number(*pair) for pair in self.tree.chosen()] if sources else []
        self.tree.know(sources)
        self.sides.show_holes([SimpleNamespace(edges=edges)])
        self.sides.setVisible(self.task != "Remove")
        self._changed()

    def _previewed(self, filled):
        if self.kind == "Face":  # which edges they have is known now
            edges = [side.edge for hole in filled.report.holes for side in hole.sides]
            self.sides.show_holes([SimpleNamespace(edges=edges)])
        super()._previewed(filled)

    def _hint(self):
        return {
            "Boundary": translate(
                "Click the edges around the new face, in any order; with an edge's row selected, a face "
                "to be tangent to there."
            ),
            "Bridge": translate("Click the edges of both sides, in any order."),
            "Replace": translate("Click the faces that are to be made anew."),
            "Remove": translate("Click the faces that are to go."),
        }[self.task]


class BorderPanel(ElementsPanel):
    task = "Boundary"
    icon = str(RESOURCES / "icons" / "Suture_FillEdges.svg")


class BridgePanel(ElementsPanel):
    task = "Bridge"
    icon = str(RESOURCES / "icons" / "Suture_Bridge.svg")


class ReplacePanel(ElementsPanel):
    task, kind = "Replace", "Face"
    icon = str(RESOURCES / "icons" / "Suture_ReplaceFaces.svg")


class RemovePanel(ElementsPanel):
    task, kind = "Remove", "Face"
    icon = str(RESOURCES / "icons" / "Suture_RemoveFaces.svg")


PANELS = {
    panel.task: panel for panel in (BorderPanel, BridgePanel, ReplacePanel, RemovePanel)
}
