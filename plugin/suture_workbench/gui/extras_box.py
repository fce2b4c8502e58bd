# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of extras.py: what is merged or cut in two, how far it reaches, which holes by size."""

from .. import extras, words
from ..compat import QtCore, QtWidgets, translate


class ExtrasBox(QtWidgets.QWidget):
    """One line for each extra that a task has; those of faces to lean on are in the list of edges."""

    changed = QtCore.Signal()

    def __init__(self, task):
        super().__init__()
        self.setObjectName("SutureExtras")
        self._fields = {}
        layout = QtWidgets.QFormLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        for extra in extras.EXTRAS:
            if task in extra.tasks and not isinstance(extra.default, dict):
                self._add(layout, extra)

    def values(self):
        """{name: value} of what says something."""
        return extras.taken({name: _value(field) for name, field in self._fields.items()})

    def set(self, values):
        for extra in extras.EXTRAS:
            if extra.name in self._fields:
                _put(self._fields[extra.name], values.get(extra.name, extra.default))

    def _add(self, layout, extra):
        name = words.extra_name(extra.name)
        field = _field(extra, self.changed.emit)
        field.setObjectName(f"SutureExtra_{extra.name}")
        field.setToolTip(translate(extra.tip))
        self._fields[extra.name] = field
        label = QtWidgets.QLabel(name)
        label.setWordWrap(True)
        label.setToolTip(field.toolTip())
        label.setBuddy(field)
        if not isinstance(field, QtWidgets.QCheckBox):
            field.setMinimumWidth(60)
        layout.addRow(label, field)


def _field(extra, changed):
    if isinstance(extra.default, bool):
        field = QtWidgets.QCheckBox()
        field.toggled.connect(lambda *_: changed())
    elif isinstance(extra.default, str):
        field = QtWidgets.QLineEdit()
        field.setPlaceholderText("auto")
        field.editingFinished.connect(changed)
    else:
        whole = isinstance(extra.default, int)
        field = QtWidgets.QSpinBox() if whole else QtWidgets.QDoubleSpinBox()
        field.setRange(0, 1000 if whole else 1e6)
        if extra.name == "tension":
            field.setRange(0.05, 20.0)
            field.setSingleStep(0.1)
        elif whole:
            field.setSpecialValueText(translate("any"))
        else:
            field.setSuffix(" mm")
            field.setSpecialValueText(translate("any"))
        field.setKeyboardTracking(False)
        _put(field, extra.default)
        field.valueChanged.connect(lambda *_: changed())
    return field


def _value(field):
    if isinstance(field, QtWidgets.QCheckBox):
        return field.isChecked()
    return field.text().strip() if isinstance(field, QtWidgets.QLineEdit) else field.value()


def _put(field, value):
    field.blockSignals(True)
    if isinstance(field, QtWidgets.QCheckBox):
        field.setChecked(value)
    elif isinstance(field, QtWidgets.QLineEdit):
        field.setText(value)
    else:
        field.setValue(value)
    field.blockSignals(False)
