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


def stripes():
    """How many zebra stripes there are."""
    return _group().GetInt("Stripes", 14)


def direction():
    """How far the zebra stripes are turned, in degrees."""
    return _group().GetInt("StripesDirection", 0)


def radius():
    """The radius of curvature (mm) that the map of curvature shows red."""
    return _group().GetFloat("CurvatureRadius", 5.0)


def save_shading(stripes, direction, radius):
    """Keeps the sliders of zebra and curvature."""
    group = _group()
    group.SetInt("Stripes", stripes)
    group.SetInt("StripesDirection", direction)
    group.SetFloat("CurvatureRadius", radius)


def save_program(path):
    """Keeps where the program is; "" for the usual places."""
    _group().SetString("Program", str(path))


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
