# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options that one fill method has and others have not, as the program tells them."""

from .. import program, words
from ..compat import QtCore, QtWidgets
from ..said import in_users_words


class MethodOptions(QtWidgets.QWidget):
    """One line for each option of the method; what is left empty is the method's default."""

    changed = QtCore.Signal()

    def __init__(self, show_heading):
        super().__init__()
        self._show_heading = show_heading  # told whether there are options
        self._method, self._fields = "", {}
        self._values = {}  # by method and key: they come back when the method does
        self._layout = QtWidgets.QFormLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)

    def show_method(self, method):
        """Shows the options of a method."""
        self._method, self._fields = method, {}
        while self._layout.rowCount():
            self._layout.removeRow(0)
        for option in program.options_of(method):
            key, choices = option["key"], option["value"].split("|")
            field = self._choice(choices) if len(choices) > 1 else self._line(option["value"])
            field.setObjectName(f"SutureOption_{key}")
            text = in_users_words(option["text"])
            field.setToolTip(text)
            self._fields[key] = field
            self._put(key, self._values.get((method, key), ""))
            name = words.option_name(key)
            self._layout.addRow(name, field)
            self._layout.labelForField(field).setToolTip(f"{key}: {text}")
        self.setVisible(bool(self._fields))
        self._show_heading(bool(self._fields))

    def values(self):
        """{key: value} of what is filled in."""
        read = ((key, self._text(field)) for key, field in self._fields.items())
        return {key: text for key, text in read if text}

    def set(self, values):
        for key, value in values.items():
            self._values[self._method, key] = value
            if key in self._fields:
                self._put(key, value)

    def _line(self, hint):
        field = QtWidgets.QLineEdit()
        field.setMinimumWidth(60)
        field.setPlaceholderText(hint)
        field.editingFinished.connect(self._keep)
        return field

    def _choice(self, choices):
        field = QtWidgets.QComboBox()
        field.addItems(["", *choices])
        field.currentIndexChanged.connect(self._keep)
        return field

    def _text(self, field):
        return (
            field.currentText() if isinstance(field, QtWidgets.QComboBox) else field.text().strip()
        )

    def _put(self, key, value):
        field = self._fields[key]
        field.blockSignals(True)
        if isinstance(field, QtWidgets.QComboBox):
            field.setCurrentText(value)
        else:
            field.setText(value)
        field.blockSignals(False)

    def _keep(self, *_):
        now = {(self._method, key): self._text(field) for key, field in self._fields.items()}
        before = {pair: self._values.get(pair, "") for pair in now}
        self._values.update(now)
        if now != before:  # a line that was only left has not changed
            self.changed.emit()
