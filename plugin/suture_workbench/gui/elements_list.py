# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of the edges or faces that the user has chosen, and their drawing in the view."""

from .. import meshes, places
from ..compat import QtCore, QtWidgets, translate
from . import overlay, pick

_GREEN = (0.10, 0.85, 0.25)
_ROLE = QtCore.Qt.UserRole


class ElementsList(QtWidgets.QWidget):
    """Edges of any object, or faces of one; a click in the view adds one or takes it away."""

    ticked_changed = QtCore.Signal()

    def __init__(self, kind, items, with_gaps, hint):
        """items   places.Selected with what is chosen; with_gaps: offer to bridge gaps; hint: what to do"""
        super().__init__()
        self._kind = kind
        self._base, self._sources = items[0].obj, None
        self._drawings = {}
        self._supports = {}  # (object, edge) -> (object, face)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        label = QtWidgets.QLabel(hint)
        label.setWordWrap(True)
        layout.addWidget(label)
        self._list = QtWidgets.QListWidget()
        self._list.setObjectName("SutureElements")
        self._list.setFixedHeight(90)
        self._list.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        layout.addWidget(self._list)
        row = QtWidgets.QHBoxLayout()
        self._remove = QtWidgets.QPushButton(translate("Take away"))
        self._remove.setObjectName("SutureTakeAway")
        self._remove.setToolTip(translate("Takes the rows that are selected out of the list"))
        self._remove.clicked.connect(self._take_selected)
        row.addWidget(self._remove)
        row.addStretch(1)
        layout.addLayout(row)
        self._connect = QtWidgets.QCheckBox(translate("Bridge gaps by curves"))
        self._connect.setObjectName("SutureConnect")
        self._connect.setToolTip(
            translate("Where edges do not meet, a smooth curve from one to the next closes the border")
        )
        self._connect.toggled.connect(lambda *_: self.ticked_changed.emit())
        self._connect.setVisible(with_gaps)
        layout.addWidget(self._connect)
        for item in items:
            for number in item.edges if kind == "Edge" else item.faces:
                self._add(item.obj, number)
        self._list.itemClicked.connect(self._select)
        self._draw()

    def lean(self, obj, face):
        """The new face is to be tangent to a face at the edges of the rows that are selected; to no
        face, if it is that one already."""
        rows = self._list.selectedItems()
        for row in rows:
            edge = row.data(_ROLE)
            if self._supports.get(edge) == (obj, face):
                del self._supports[edge]
            else:
                self._supports[edge] = (obj, face)
            self._name(row)
        if rows:
            self.ticked_changed.emit()
        return bool(rows)

    def supports(self):
        """{(object, edge): (object, face)} of the edges that are chosen."""
        chosen = self.chosen()
        return {edge: face for edge, face in self._supports.items() if edge in chosen}

    def set_supports(self, supports):
        self._supports = dict(supports)
        for index in range(self._list.count()):
            self._name(self._list.item(index))

    def connect_box(self):
        return self._connect

    def chosen(self):
        """[(object, number), ...] in the order in which they were chosen."""
        rows = (self._list.item(index) for index in range(self._list.count()))
        return [row.data(_ROLE) for row in rows]

    ticked = chosen

    def toggle(self, obj, number):
        """Takes an element into the list, or out of it."""
        chosen = self.chosen()
        if (obj, number) in chosen:
            self._list.takeItem(chosen.index((obj, number)))
        else:
            self._add(obj, number)
        self._changed()

    # -- what the table of sides asks for

    def know(self, sources):
        """sources   Sources in whose numbers the sides are; None: in those of the base"""
        self._sources = sources

    def number(self, edge):
        """The base's own number of an edge; None for one of another object, or one that was made."""
        if self._sources is None:
            return edge or None
        obj, number = self._sources.origin(edge) if edge else (None, 0)
        return number if obj is self._base else None

    def name(self, edge):
        if not edge:
            return translate("curve")
        if self.number(edge):
            return f"Edge{edge}"
        obj, number = self._sources.origin(edge)
        return _name(obj, "Edge", number)

    def leave(self):
        for drawing in self._drawings.values():
            drawing.close()
        self._drawings = {}

    def _add(self, obj, number):
        row = QtWidgets.QListWidgetItem()
        row.setData(_ROLE, (obj, number))
        self._name(row)
        self._list.addItem(row)

    def _name(self, row):
        text = self._name_of(self._kind, *row.data(_ROLE))
        support = self._supports.get(row.data(_ROLE))
        if support is not None:
            text = translate("{}, tangent to {}").format(text, self._name_of("Face", *support))
        row.setText(text)

    def _name_of(self, kind, obj, number):
        return f"{kind}{number}" if obj is self._base else _name(obj, kind, number)

    def _take_selected(self):
        for row in self._list.selectedItems():
            self._list.takeItem(self._list.row(row))
        self._changed()

    def _changed(self):
        self._draw()
        self.ticked_changed.emit()

    def _select(self, row):
        obj, number = row.data(_ROLE)
        pick.select_elements(places.Selected(obj, [], [], obj, ""), self._kind, [number])

    def _draw(self):
        """Green lines along what is chosen: edges, or the borders of faces."""
        by_object = {}
        for obj, number in self.chosen():
            by_object.setdefault(obj, []).append(number)
        for obj, drawing in list(self._drawings.items()):
            drawing.clear()
        for obj, numbers in by_object.items():
            if obj not in self._drawings:
                self._drawings[obj] = overlay.Overlay(places.to_document(obj))
            shape = places.local_shape(obj)
            fine = meshes.fineness(shape)
            edges = (
                [shape.Edges[n - 1] for n in numbers]
                if self._kind == "Edge"
                else [edge for n in numbers for edge in shape.Faces[n - 1].Edges]
            )
            lines = [meshes.outline(edge, fine) for edge in edges if not edge.Degenerated]
            self._drawings[obj].lines(lines, _GREEN, 5.0)


def _name(obj, kind, number):
    return f"{obj.Label}: {kind}{number}"
