# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD calls this for File > Export > STEP with holes filled."""

from .exporting import on_export


def export(objects, filename, options=None):
    on_export(objects, filename)
