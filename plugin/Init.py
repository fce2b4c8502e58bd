# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this at every start, with or without a window."""

import FreeCAD

FreeCAD.addExportType("STEP with holes filled (*.step *.stp)", "suture_workbench.export_step")
FreeCAD.addExportType("IGES with holes filled (*.iges *.igs)", "suture_workbench.export_iges")
