"""Time limits of the Python tests: like CTest's, those of a release build times SUTURE_TEST_SLOWDOWN."""

import os

SLOWDOWN = float(os.environ.get("SUTURE_TEST_SLOWDOWN", "1"))


def limit(seconds):
    """What a release build has `seconds` for may take so long in the build that is tested."""
    return seconds * SLOWDOWN
