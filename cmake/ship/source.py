# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packs the sources that git has, and the report's page as it was bundled: who builds needs no npm.

source.py PAGE ARCHIVE.tar.xz     PAGE: a folder with viewer.js and viewer.css
"""

import io
import subprocess
import sys
import tarfile
from pathlib import Path

import parts


def main(page, archive):
    name = f"suture-{parts.version()}"
    sources = subprocess.run(
        ["git", "-C", parts.SOURCE, "archive", f"--prefix={name}/", "HEAD"],
        check=True,
        capture_output=True,
    ).stdout
    archive.parent.mkdir(parents=True, exist_ok=True)
    with tarfile.open(archive, "w:xz") as packed:
        with tarfile.open(fileobj=io.BytesIO(sources)) as given:
            for entry in given:
                packed.addfile(entry, given.extractfile(entry) if entry.isfile() else None)
                when = entry.mtime
        for file in ("viewer.js", "viewer.css"):
            content = (page / file).read_bytes()
            entry = tarfile.TarInfo(f"{name}/report_page/{file}")
            entry.size, entry.mtime = len(content), when
            packed.addfile(entry, io.BytesIO(content))
    print(f"{archive}: {archive.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:3]))
