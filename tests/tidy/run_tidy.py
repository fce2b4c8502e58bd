"""Runs clang-tidy on our sources, each as the build compiles it; what g++ has precompiled is parsed.

    run_tidy.py BUILD_FOLDER [FOLDER...]    sources below these folders of the project; none: all

A file that was found clean is not looked at again as long as neither it nor a header of ours that it
includes, the settings or its compile command change: clean results are kept, as empty files, in
$XDG_CACHE_HOME/suture-tidy (~/.cache/suture-tidy).
"""

import concurrent.futures
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
INCLUDE_ROOTS = [ROOT / "kernel", ROOT / "step_io", ROOT / "tests"]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
PRECOMPILED = ROOT / "kernel/suture/occ/pch.h"
TIDY = "clang-tidy"
SKIPPED = 77


def without_gch(command):
    """The arguments of a compile command with the plain header in the place of g++'s precompiled one."""
    kept, words = [], iter(shlex.split(command))
    for word in words:
        if word == "-include":
            header = next(words)
            kept += [word, str(PRECOMPILED) if header.endswith("cmake_pch.hxx") else header]
        elif word not in ("-Winvalid-pch", "-fpch-preprocess"):
            kept.append(word)
    return kept


def read_commands(build, folders):
    """{source: arguments} for every source of ours that the build compiles."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        source = Path(entry["file"]).resolve()
        if not source.is_relative_to(ROOT) or source.is_relative_to(build):
            continue
        if folders and not any(source.is_relative_to(folder) for folder in folders):
            continue
        commands[source] = without_gch(entry["command"])
    return commands


def with_headers(source):
    """The source and every header of ours that it includes, directly or not."""
    seen, waiting = set(), [source]
    while waiting:
        file = waiting.pop()
        if file in seen:
            continue
        seen.add(file)
        for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            waiting += [root / name for root in INCLUDE_ROOTS if (root / name).is_file()]
    return sorted(seen)


def fingerprint(source, arguments, settings):
    """Equal for equal files, settings and arguments, wherever the project lies."""
    digest = hashlib.sha256(settings)
    digest.update(" ".join(arguments).replace(str(ROOT), "").encode())
    for file in [PRECOMPILED, *with_headers(source)]:
        digest.update(str(file.relative_to(ROOT)).encode())
        digest.update(file.read_bytes())
    return digest.hexdigest()


def settings_for(source):
    """What clang-tidy reads for a source: the file in the root, and what the folders below add."""
    folders = [folder for folder in source.parents if folder.is_relative_to(ROOT)]
    files = [folder / ".clang-tidy" for folder in reversed(folders)]
    return b"".join(file.read_bytes() for file in files if file.is_file())


def tidy(source, database):
    done = subprocess.run(
        [TIDY, "-p", str(database), "--quiet", str(source)],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.returncode == 0, done.stdout


def main(build, folders):
    version = subprocess.run([TIDY, "--version"], capture_output=True, check=True).stdout
    if folders and not re.search(rb"version 14\b", version):
        print("Skipped: clang-tidy is not 14, whose checks are ours")
        return SKIPPED
    commands = read_commands(build, [(ROOT / folder).resolve() for folder in folders])
    if not commands:
        raise SystemExit(f"{build}: no source of ours is compiled there, in {folders or 'any folder'}")
    database = build / "tidy" / hashlib.sha256(" ".join(folders).encode()).hexdigest()[:12]
    database.mkdir(parents=True, exist_ok=True)
    entries = [
        {"directory": str(build), "file": str(source), "arguments": arguments}
        for source, arguments in commands.items()
    ]
    (database / "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")

    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "suture-tidy"
    cache.mkdir(parents=True, exist_ok=True)
    stamps = {
        source: cache / fingerprint(source, arguments, settings_for(source) + version)
        for source, arguments in commands.items()
    }
    waiting = [source for source, stamp in stamps.items() if not stamp.exists()]

    bad = 0
    jobs = 1 if folders else os.cpu_count()  # for one folder CTest runs several of these at once
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = pool.map(lambda source: tidy(source, database), waiting)
        for source, (clean, output) in zip(waiting, results):
            if clean:
                stamps[source].touch()
            else:
                bad += 1
                print(output)
            print(source.relative_to(ROOT), "clean" if clean else "NOT CLEAN", flush=True)
    known = len(commands) - len(waiting)
    print(f"clang-tidy: {len(commands)} files, {known} of them known to be clean, {bad} not clean")
    return 1 if bad else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve(), sys.argv[2:]))
