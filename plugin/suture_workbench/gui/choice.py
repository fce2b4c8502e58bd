# SPDX-License-Identifier: LGPL-2.1-or-later
"""Combo boxes whose entries have a key, and a label that explains the chosen one."""

from ..compat import QtCore, QtWidgets
from .forms import find

_KEY = QtCore.Qt.UserRole


class Choice(QtCore.QObject):
    """What a combo box of a form offers: keys for us, names and explanations for the user.

    explained   the name of the label that explains, or None
    """

    changed = QtCore.Signal()

    def __init__(self, form, combo, explained, keys, name=str, text=None):
        super().__init__()
        self._form, self._combo_name, self._explained = form, combo, explained
        self._name, self._text = name, text or (lambda key: "")
        for key in keys:
            self._add(key)
        self._combo().currentIndexChanged.connect(self._explain)
        self._explain()

    def key(self):
        return self._combo().currentData(_KEY)

    def choose(self, key):
        """Chooses a key; one that is new (of a newer program) becomes an entry."""
        if self._combo().findData(key, _KEY) < 0:
            self._add(key)
        self._combo().setCurrentIndex(self._combo().findData(key, _KEY))

    def _combo(self):
        return find(self._form, self._combo_name, QtWidgets.QComboBox)

    def _add(self, key):
        combo = self._combo()
        combo.addItem(self._name(key), key)
        combo.setItemData(combo.count() - 1, self._text(key), QtCore.Qt.ToolTipRole)

    def _explain(self, *_):
        if self._explained is not None:
            text = self._text(self.key()) if self._combo().count() else ""
            label = find(self._form, self._explained, QtWidgets.QLabel)
            label.setText(f"<small>{text}</small>")
            label.setVisible(bool(text))
        self.changed.emit()
