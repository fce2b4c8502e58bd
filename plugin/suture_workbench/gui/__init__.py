# SPDX-License-Identifier: LGPL-2.1-or-later
"""What needs FreeCAD's window: commands, panels and what they draw."""
