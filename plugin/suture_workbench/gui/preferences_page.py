# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page Suture in Edit > Preferences."""

from .. import program, settings
from ..compat import QtWidgets, translate
from ..errors import ProgramMissing
from .forms import find, load_form
from .widgets import limit_boxes


class PreferencesPage:
    """FreeCAD makes one when the preferences are opened, and asks it to load and to save."""

    def __init__(self, parent=None):
        self.form = load_form("preferences")
        self.form.setObjectName("SuturePreferences")
        self.form.setWindowTitle(translate("General"))
        self._child("SutureProgramPath", QtWidgets.QLineEdit).setPlaceholderText(translate("searched in the usual places"))
        self._child("SutureProgramPath", QtWidgets.QLineEdit).textChanged.connect(self._look)
        self._child("SutureBrowse").clicked.connect(self._browse)
        self._child("SutureGetProgram").clicked.connect(self._get)
        self._gap, self._angle, self._curvature = limit_boxes(self.form)

    def _child(self, name, kind=QtWidgets.QWidget):
        return find(self.form, name, kind)

    def loadSettings(self):
        self._child("SutureProgramPath", QtWidgets.QLineEdit).setText(settings.program())
        self._gap.setValue(settings.gap())
        self._angle.setValue(settings.angle())
        self._curvature.setValue(settings.curvature())
        choices = program.methods()
        self._child("SutureDefaultMethod", QtWidgets.QComboBox).clear()
        self._child("SutureDefaultMethod", QtWidgets.QComboBox).addItems(
            choices if settings.method() in choices else [*choices, settings.method()]
        )
        self._child("SutureDefaultMethod", QtWidgets.QComboBox).setCurrentText(settings.method())
        self._child("SutureShowPreview", QtWidgets.QCheckBox).setChecked(settings.preview())
        self._child("SutureTimeLimit", QtWidgets.QSpinBox).setValue(settings.time_limit())
        self._look()

    def saveSettings(self):
        settings.save(
            program=self._child("SutureProgramPath", QtWidgets.QLineEdit).text().strip(),
            gap=self._gap.value(),
            angle=self._angle.value(),
            curvature=self._curvature.value(),
            method=self._child("SutureDefaultMethod", QtWidgets.QComboBox).currentText(),
            preview=self._child("SutureShowPreview", QtWidgets.QCheckBox).isChecked(),
            time_limit=self._child("SutureTimeLimit", QtWidgets.QSpinBox).value(),
        )

    def _browse(self):
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.form, translate("Program suture"))
        if path:
            self._child("SutureProgramPath", QtWidgets.QLineEdit).setText(path)

    def _get(self):
        from .program_dialog import ProgramDialog

        ProgramDialog(self.form).run()
        self._child("SutureProgramPath", QtWidgets.QLineEdit).setText(settings.program())
        self._look()

    def _look(self, *_):
        """Says which program it would be."""
        try:
            text = translate("found: {}").format(program.find(self._child("SutureProgramPath", QtWidgets.QLineEdit).text().strip()))
        except ProgramMissing as error:
            text = str(error)
        self._child("SutureProgramFound", QtWidgets.QLabel).setText(text)
