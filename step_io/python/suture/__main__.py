# SPDX-License-Identifier: LGPL-2.1-or-later
"""`suture` and `python -m suture`: the program itself."""

import os
import sys

from .errors import ProgramMissing
from .program import find_program


def main():
    try:
        program = find_program()
    except ProgramMissing as error:
        sys.exit(f"error: {error}")
    os.execv(program, ["suture", *sys.argv[1:]])


if __name__ == "__main__":
    main()
