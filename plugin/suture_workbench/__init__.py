# SPDX-License-Identifier: LGPL-2.1-or-later
"""Suture in FreeCAD: finds, fills and checks holes by running the program `suture`.

`suture_workbench.api` has every command as a function, for scripts and for FreeCADCmd. Nothing
outside the folder `gui` needs a window.
"""

from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ADDON = FOLDER.parent.parent  # the repository
RESOURCES = FOLDER / "resources"
