# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page Suture in Edit > Preferences."""

from .. import program, settings
from ..compat import QtWidgets, translate
from ..errors import ProgramMissing
from .widgets import number_box


class PreferencesPage:
    """FreeCAD makes one when the preferences are opened, and asks it to load and to save."""

    def __init__(self, parent=None):
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("SuturePreferences")
        self.form.setWindowTitle(translate("General"))
        self._program = QtWidgets.QLineEdit()
        self._program.setObjectName("SutureProgramPath")
        self._program.setPlaceholderText(
            translate("searched: the addon's own build, then the PATH")
        )
        self._program.textChanged.connect(self._look)
        browse = QtWidgets.QPushButton("…")
        browse.clicked.connect(self._browse)
        self._found = QtWidgets.QLabel()
        self._found.setObjectName("SutureProgramFound")
        self._found.setWordWrap(True)
        self._gap = number_box(
            0.001, "mm", translate("Largest gap between a new face and its neighbours")
        )
        self._angle = number_box(0.01, "°", translate("Largest angle of tangent joins"))
        self._curvature = number_box(2.0, "%", translate("Largest curvature mismatch of G2 joins"))
        self._method = QtWidgets.QComboBox()
        self._method.setToolTip(translate("The fill method to begin with"))
        self._preview = QtWidgets.QCheckBox(translate("Show a preview unasked"))
        self._limit = QtWidgets.QSpinBox()
        self._limit.setRange(0, 86400)
        self._limit.setSuffix(" s")
        self._limit.setSpecialValueText(translate("none"))
        self._limit.setToolTip(translate("Give a run up after so long"))
        path = QtWidgets.QHBoxLayout()
        path.addWidget(self._program)
        path.addWidget(browse)
        rows = QtWidgets.QFormLayout()
        for text, entry in (
            (translate("Program suture"), path),
            ("", self._found),
            (translate("Largest gap"), self._gap),
            (translate("Largest angle"), self._angle),
            (translate("Largest curvature mismatch"), self._curvature),
            (translate("Default method"), self._method),
            (translate("Preview"), self._preview),
            (translate("Time limit"), self._limit),
        ):
            rows.addRow(text, entry)
        layout = QtWidgets.QVBoxLayout(self.form)
        layout.addLayout(rows)
        layout.addStretch()

    def loadSettings(self):
        self._program.setText(settings.program())
        self._gap.setValue(settings.gap())
        self._angle.setValue(settings.angle())
        self._curvature.setValue(settings.curvature())
        choices = program.methods()
        self._method.clear()
        self._method.addItems(
            choices if settings.method() in choices else [*choices, settings.method()]
        )
        self._method.setCurrentText(settings.method())
        self._preview.setChecked(settings.preview())
        self._limit.setValue(settings.time_limit())
        self._look()

    def saveSettings(self):
        settings.save(
            program=self._program.text().strip(),
            gap=self._gap.value(),
            angle=self._angle.value(),
            curvature=self._curvature.value(),
            method=self._method.currentText(),
            preview=self._preview.isChecked(),
            time_limit=self._limit.value(),
        )

    def _browse(self):
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.form, translate("Program suture"))
        if path:
            self._program.setText(path)

    def _look(self, *_):
        """Says which program it would be."""
        try:
            text = translate("found: {}").format(program.find(self._program.text().strip()))
        except ProgramMissing as error:
            text = str(error)
        self._found.setText(text)
