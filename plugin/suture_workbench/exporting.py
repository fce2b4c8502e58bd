# SPDX-License-Identifier: LGPL-2.1-or-later
"""What File > Export shows of it: a line in the report view, failures as FreeCAD shows them."""

import FreeCAD as App

from . import exporter
from .compat import translate
from .errors import Cancelled, SutureError


def on_export(objects, filename):
    try:
        verdict = exporter.export(objects, filename)
    except Cancelled:
        App.Console.PrintWarning(
            translate("Export stopped: {} was not written.").format(filename) + "\n"
        )
        return
    except SutureError as error:
        if not App.GuiUp:
            raise
        from .gui import failures

        failures.show(error)
        return
    App.Console.PrintMessage(f"{filename}: {verdict}\n")
