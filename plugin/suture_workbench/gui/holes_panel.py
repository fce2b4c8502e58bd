# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find holes: lists them, shows them, and hands the ticked ones to the fill panel."""

from .. import RESOURCES, places, tasks, words
from ..compat import translate
from . import failures
from .holes_tree import HolesTree
from .forms import put
from .panel import Panel
from .progress import Watcher
from .widgets import Status, show_heading


class HolesPanel(Panel):
    """Task panel of the command Find holes."""

    icon = str(RESOURCES / "icons" / "Suture_FindHoles.svg")

    def __init__(self, item):
        self.title = translate("Find holes")
        super().__init__("holes")
        self.item = item
        self.shape = places.local_shape(item.obj)
        show_heading(self.child("SutureHeading"), item.obj.Label)
        self.tree = put(self.form, "holesPlace", HolesTree(item, places.shown_at(item)))
        self.child("SutureFillTicked").setEnabled(False)
        self.child("SutureFillTicked").clicked.connect(self._fill)
        self.watcher = Watcher(self._found, self._failed, self._advance)
        self.status = put(self.form, "statusPlace", Status(self.watcher.cancel))
        self.tree.ticked_changed.connect(self._count)
        self.status.advance(0.0, translate("Looking for holes…"))
        self.watcher.start(tasks.FindHoles(self.shape))

    def picked(self, kind, number, point):
        self.tree.show_element(kind, number)

    def leave(self):
        self.watcher.cancel()
        self.tree.leave()

    def _advance(self, fraction, stage):
        self.status.advance(fraction, stage)

    def _found(self, found):
        self.tree.fill(found)
        self.status.plain(words.holes_summary(found.report))
        self._count()

    def _failed(self, error):
        failures.report(self.status, error, self.item)

    def _count(self):
        self.child("SutureFillTicked").setEnabled(bool(self.tree.ticked()))

    def _fill(self):
        from .fill_panel import FillPanel

        ids = {hole.id for hole in self.tree.ticked()}
        self.close()
        FillPanel(self.item, ticked=lambda hole: hole.id in ids).show(self.item.obj.Document)
