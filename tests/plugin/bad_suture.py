#!/usr/bin/env python3
"""Stands in for the program where a test needs one that behaves badly.

Everything but `fill` goes to the real program, SUTURE_PROGRAM. SUTURE_BEHAVIOUR says what `fill`
does: slow (takes a minute, and leaves a child behind that ignores SIGTERM, as it does itself),
crash, count (a line in SUTURE_RUNS for each fill, then as the real one), garbage (no JSON), damaged (an output that is cut short), empty (JSON without its keys). With
`options` mvs has an option `bend`, of which the real program knows nothing; 0.5 is all it takes.
"""

import json
import os
import signal
import subprocess
import sys
import time

PROGRAM = os.environ["SUTURE_PROGRAM"]


def slow():
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    subprocess.Popen(
        [
            sys.executable,
            "-c",
            "import signal,time; signal.signal(15, signal.SIG_IGN); time.sleep(60)",
        ]
    )
    for step in range(600):
        said = {"progress": step / 600, "stage": "filling hole 1"}
        print(json.dumps(said), file=sys.stderr, flush=True)
        time.sleep(0.1)


def damaged():
    done = subprocess.run([PROGRAM, *sys.argv[1:]], check=False)
    out = sys.argv[sys.argv.index("-o") + 1]
    with open(out, "r+b") as file:
        file.truncate(os.path.getsize(out) // 2)
    sys.exit(done.returncode)


def count():
    """Writes a line for each fill, waits a moment, and lets the real program do it."""
    with open(os.environ["SUTURE_RUNS"], "a", encoding="ascii") as file:
        file.write("fill\n")
    time.sleep(1.0)
    os.execv(PROGRAM, [PROGRAM, *sys.argv[1:]])


def options():
    words = sys.argv[1:]
    if words[0] == "methods":
        answer = json.loads(subprocess.run([PROGRAM, *words], capture_output=True).stdout)
        for method in answer["methods"]:
            if method["id"] == "mvs":
                method["options"] = [
                    {"key": "bend", "value": "NUMBER", "text": "how much it bends"}
                ]
        print(json.dumps(answer))
        return
    if "--option" in words:
        place = words.index("--option")
        if words[place + 1] != "bend=0.5":
            sys.exit(f"what is {words[place + 1]}?")
        del words[place : place + 2]
    os.execv(PROGRAM, [PROGRAM, *words])


def main():
    behaviour = os.environ.get("SUTURE_BEHAVIOUR", "slow")
    if behaviour == "options":
        options()
        return
    if sys.argv[1] != "fill":
        os.execv(PROGRAM, [PROGRAM, *sys.argv[1:]])
    if behaviour == "count":
        count()
    elif behaviour == "slow":
        slow()
    elif behaviour == "crash":
        os.kill(os.getpid(), signal.SIGSEGV)
    elif behaviour == "garbage":
        print('{"schema": 1, "holes": [')
    elif behaviour == "empty":
        print('{"schema": 1, "exit_code": 0, "verdict": "all is well"}')
    elif behaviour == "damaged":
        damaged()
    else:
        sys.exit(f"no behaviour {behaviour}")


main()
