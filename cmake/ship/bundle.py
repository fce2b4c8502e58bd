# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a folder that has the program and all that it needs but the C library.

bundle.py BUILD FOLDER

The program's run path is $ORIGIN/../lib/suture. It is a DT_RPATH, which holds for the libraries of
its libraries too and goes before LD_LIBRARY_PATH: the libraries are copied there as they are.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import parts

# Of glibc: they belong to the system's loader and to its kernel.
SYSTEM = (
    "ld-linux-x86-64.so",
    "libc.so",
    "libm.so",
    "libmvec.so",
    "libpthread.so",
    "libdl.so",
    "librt.so",
    "libresolv.so",
    "libutil.so",
    "libanl.so",
    "libnss_",
)
# What the program loads by name (kernel/suture/platform/on_demand.h), no module of ours among them.
LOADED_BY_NAME = ("libopenblas.so.0",)


def run(*command):
    return subprocess.run(
        [str(word) for word in command], check=True, capture_output=True, text=True
    ).stdout


def needed(file):
    """The libraries that the loader finds for a program or library: {name: path}."""
    found = {}
    for line in run("ldd", file).splitlines():
        name, arrow, rest = line.strip().partition(" => ")
        if arrow and rest.startswith("not found"):
            raise SystemExit(f"bundle: {file} needs {name}, which is not here")
        if arrow and not name.startswith(SYSTEM):
            found[name] = Path(rest.split(" (")[0])
    return found


def library_by_name(name):
    for line in run("/sbin/ldconfig", "-p").splitlines():
        if line.split(" ")[0].strip() == name and "x86-64" in line:
            return Path(line.split(" => ")[1])
    raise SystemExit(f"bundle: there is no {name}")


def collect(folder):
    """Copies the libraries that the installed program and its modules need. Result   {copy: original}"""
    here = folder / "lib/suture"
    wanted = {name: library_by_name(name) for name in LOADED_BY_NAME}
    for file in [folder / "bin/suture", *here.iterdir(), *wanted.values()]:
        wanted.update(needed(file))
    copies = {}
    for name, original in wanted.items():
        if here in original.parents:
            continue
        copy = here / name
        shutil.copyfile(original.resolve(), copy)
        copy.chmod(0o755 if os.access(original, os.X_OK) else 0o644)
        copies[copy] = original.resolve()
    return copies


def make(build, folder):
    shutil.rmtree(folder, ignore_errors=True)
    run("cmake", "--install", build, "--prefix", folder, "--component", "program", "--strip")
    copies = collect(folder)
    parts.write(build, folder, copies.values())


if __name__ == "__main__":
    make(*(Path(word).absolute() for word in sys.argv[1:3]))
