# SPDX-License-Identifier: LGPL-2.1-or-later
"""Waits for a task: in the window with a progress dialog and a living event loop, else asleep."""

import time

import FreeCAD as App

_POLL_SECONDS = 0.02


def run(task):
    """The task's result; Cancelled if the user stopped it."""
    if App.GuiUp:
        from .gui.progress import run_with_dialog

        return run_with_dialog(task)
    task.start()
    try:
        while task.running():
            time.sleep(_POLL_SECONDS)
    except BaseException:  # Ctrl-C in FreeCADCmd: leave no process behind
        task.kill()
        raise
    return task.result()
