# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the preferences page of Suture holds."""

import FreeCAD as App

PATH = "User parameter:BaseApp/Preferences/Mod/Suture"


def _group():
    return App.ParamGet(PATH)


def program():
    """Where the user says that the program is, or ""."""
    return _group().GetString("Program", "")


def gap():
    """Largest gap in mm."""
    return _group().GetFloat("Gap", 0.001)


def angle():
    """Largest angle of tangent joins in degrees."""
    return _group().GetFloat("Angle", 0.01)


def curvature():
    """Largest curvature mismatch of G2 joins in percent."""
    return _group().GetFloat("Curvature", 2.0)


def method():
    """The fill method to begin with."""
    return _group().GetString("Method", "auto") or "auto"


def preview():
    """Whether the fill panel shows a preview unasked."""
    return _group().GetBool("Preview", True)


def time_limit():
    """Seconds after which a run is given up; 0: never."""
    return _group().GetInt("TimeLimit", 0)


def save(program, gap, angle, curvature, method, preview, time_limit):
    """Keeps what the page shows."""
    group = _group()
    group.SetString("Program", program)
    group.SetFloat("Gap", gap)
    group.SetFloat("Angle", angle)
    group.SetFloat("Curvature", curvature)
    group.SetString("Method", method)
    group.SetBool("Preview", preview)
    group.SetInt("TimeLimit", time_limit)
