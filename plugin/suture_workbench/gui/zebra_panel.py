# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zebra stripes and curvature on one object, with their sliders."""

from .. import RESOURCES
from ..compat import translate
from .forms import put
from .panel import Panel
from .surface_box import SurfaceBox
from .widgets import show_heading


class ZebraPanel(Panel):
    """Task panel of the command Zebra stripes; closing it leaves the stripes."""

    icon = str(RESOURCES / "icons" / "Suture_Zebra.svg")

    def __init__(self, item):
        self.title = translate("Zebra and curvature")
        super().__init__("zebra")
        self.item = item
        show_heading(self.child("SutureHeading"), item.obj.Label)
        self.surface = put(self.form, "surfacePlace", SurfaceBox([item.obj], keep=True))

    def leave(self):
        self.surface.leave()
