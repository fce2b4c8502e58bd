# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows the quality of surfaces: stripes, curvature, and the sliders for both."""

from .. import places, settings
from ..compat import QtWidgets, translate
from . import shading
from .choice import Choice
from .forms import find, load_form, put
from .widgets import number_box


class SurfaceBox(QtWidgets.QWidget):
    """Shades objects while it is there.

    also     told the kind, for what is no object (a preview)
    keep     leaves the objects shaded in the end
    """

    def __init__(self, objects, also=None, keep=False):
        super().__init__()
        self._objects, self._also, self._keep = objects, also, keep
        self._before = [(obj, shading.shown_on(obj)) for obj in objects]
        self.form = load_form("surface")
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.form)
        self.kind = Choice(
            self.form,
            "SutureShading",
            None,
            [shading.NONE, shading.ZEBRA, shading.CURVATURE],
            name=lambda kind: {
                shading.NONE: translate("Own colours"),
                shading.ZEBRA: translate("Zebra stripes"),
                shading.CURVATURE: translate("Curvature"),
            }[kind],
        )
        self._radius = put(
            self.form,
            "radiusPlace",
            number_box(settings.radius(), "mm", translate("Radius that is red"), 1e6),
        )
        self._slider("SutureStripes").setValue(settings.stripes())
        self._slider("SutureDirection").setValue(settings.direction())
        if self._before:
            self.kind.choose(self._before[0][1])
        self._adjust()
        self.kind.changed.connect(self.apply)
        for changed in (
            self._slider("SutureStripes").valueChanged,
            self._slider("SutureDirection").valueChanged,
            self._radius.valueChanged,
        ):
            changed.connect(self._adjust)
        self.apply()

    def apply(self, *_):
        kind = self.kind.key()
        for name in (shading.ZEBRA, shading.CURVATURE):
            find(self.form, name).setVisible(kind == name)
        for obj in self._objects:
            shading.show_on(obj, kind)
        if self._also is not None:
            self._also(kind)

    def leave(self):
        """Gives the objects back what they had before."""
        settings.save_shading(
            self._slider("SutureStripes").value(),
            self._slider("SutureDirection").value(),
            self._radius.value(),
        )
        if not self._keep:
            for obj, kind in self._before:
                if places.exists(obj) and places.in_window(obj):
                    shading.show_on(obj, kind)

    def _slider(self, name):
        return find(self.form, name, QtWidgets.QSlider)

    def _adjust(self, *_):
        shading.set_stripes(
            self._slider("SutureStripes").value(), self._slider("SutureDirection").value()
        )
        shading.set_radius(self._radius.value())
