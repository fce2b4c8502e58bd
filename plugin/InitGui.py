# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this when its window starts."""

import FreeCADGui


class SutureWorkbench(FreeCADGui.Workbench):
    """The workbench; what it consists of is loaded when it is first used."""

    def __init__(self):
        from suture_workbench import RESOURCES, feature
        from suture_workbench.compat import translate
        from suture_workbench.gui.preferences_page import PreferencesPage
        from suture_workbench.gui.view_provider import FilledShapeView

        feature.show_with(FilledShapeView)
        FreeCADGui.addLanguagePath(str(RESOURCES / "translations"))
        FreeCADGui.updateLocale()
        FreeCADGui.addIconPath(str(RESOURCES / "icons"))
        FreeCADGui.addPreferencePage(PreferencesPage, "Suture")
        self.__class__.MenuText = "Suture"
        self.__class__.ToolTip = translate("Close holes with smooth faces, and check how smooth")
        self.__class__.Icon = str(RESOURCES / "icons" / "Suture.svg")

    def Initialize(self):
        from suture_workbench.gui import commands

        commands.register()
        self.commands = commands.NAMES
        self.appendToolbar("Suture", self.commands)
        self.appendMenu("Suture", self.commands)

    def ContextMenu(self, recipient):
        self.appendContextMenu("Suture", self.commands[:10])

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(SutureWorkbench())
