# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packs a folder: pack.py FOLDER ARCHIVE.tar.xz"""

import os
import sys
import tarfile
from pathlib import Path


def epoch():
    """The time that all files of an archive have: the same sources make the same archive."""
    return int(os.environ.get("SOURCE_DATE_EPOCH", 0))


def pack(folder, archive):
    def plain(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = "root"
        entry.mtime = epoch()
        return entry

    partial = archive.with_name(archive.name + ".part")
    with tarfile.open(partial, "w:xz", preset=6) as file:
        for path in [folder, *sorted(folder.rglob("*"))]:
            file.add(path, path.relative_to(folder.parent), recursive=False, filter=plain)
    partial.replace(archive)


if __name__ == "__main__":
    folder, archive = (Path(word).absolute() for word in sys.argv[1:3])
    pack(folder, archive)
    print(f"{archive}: {archive.stat().st_size / 1e6:.1f} MB")
