# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find holes: lists them, shows them, and hands the ticked ones to the fill panel."""

from .. import RESOURCES, places, tasks
from ..compat import QtWidgets, translate
from . import failures
from .holes_tree import HolesTree
from .progress import Watcher
from .widgets import Panel, Status, heading


class HolesPanel(Panel):
    """Task panel of the command Find holes."""

    icon = str(RESOURCES / "icons" / "Suture_FindHoles.svg")

    def __init__(self, item):
        self.title = translate("Find holes")
        super().__init__()
        self.item = item
        self.shape = places.local_shape(item.obj)
        self.tree = HolesTree(item, places.shown_at(item))
        self.fill_button = QtWidgets.QPushButton(translate("Fill ticked holes…"))
        self.fill_button.setObjectName("SutureFillTicked")
        self.fill_button.setEnabled(False)
        self.fill_button.clicked.connect(self._fill)
        self.watcher = Watcher(self._found, self._failed, self._advance)
        self.status = Status(self.watcher.cancel)
        self.layout.addWidget(heading(item.obj.Label))
        self.layout.addWidget(self.tree)
        self.layout.addWidget(self.status)
        self.layout.addWidget(self.fill_button)
        self.tree.ticked_changed.connect(self._count)
        self.status.plain(translate("Looking for holes…"))
        self.watcher.start(tasks.FindHoles(self.shape))

    def leave(self):
        self.watcher.cancel()
        self.tree.leave()

    def _advance(self, fraction, stage):
        self.status.advance(fraction, stage)

    def _found(self, found):
        self.tree.fill(found)
        text = found.report.verdict if found.report.holes else translate("There is no hole.")
        self.status.plain(text + ". " + translate("Click one to see it."))
        self._count()

    def _failed(self, error):
        failures.report(self.status, error, self.item)

    def _count(self):
        self.fill_button.setEnabled(bool(self.tree.ticked()))

    def _fill(self):
        from .fill_panel import FillPanel

        ids = {hole.id for hole in self.tree.ticked()}
        self.close()
        FillPanel(self.item, ticked=lambda hole: hole.id in ids).show(self.item.obj.Document)
