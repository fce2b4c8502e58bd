"""Gives the program damaged files and sees that nothing breaks.

    python3 tests/fuzz/fuzz.py --count 10000 --jobs 2 --table docs/reliability.md
    python3 tests/fuzz/fuzz.py --kinds step iges --seed 7 --keep /tmp/found

SUTURE_PROGRAM names the program. What breaks something is kept, to become a file of tests/fuzz/corpus."""

import argparse
import concurrent.futures
import hashlib
import itertools
import os
import shutil
import subprocess
import tempfile
import time
from collections import Counter
from pathlib import Path

from mutate import mutate

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
EXAMPLES = ROOT / "docs" / "examples"
KINDS = ["step", "iges", "brep", "bbrep", "obj", "csv", "json"]
SECONDS = 20  # of a run
READING = 2  # seconds; whole, the largest of these files is read in 0.1
READER_CRASHED = b"OCCT's reader crashed"  # kept promise: it is contained, and exit code 2
GIGABYTES = 4
LONGEST_LINE = 300
GRACE = 10  # seconds, for a machine that has other things to do

class Seeds:
    """Whole files of every kind, small ones."""

    def __init__(self, program, folder):
        self.files = {kind: [] for kind in KINDS}
        for name in ("box_without_lid", "suitcase_corner", "table_corner"):
            source = EXAMPLES / f"{name}.step"
            if not source.exists():
                continue
            self.files["step"].append(source.read_bytes())
            for kind, ending in (("iges", ".igs"), ("brep", ".brep"), ("bbrep", ".bbrep"), ("bbrep", ".bin")):
                target = folder / (name + ending)
                subprocess.run([program, "convert", source, target], check=True, capture_output=True)
                self.files[kind].append(target.read_bytes())
        self.files["obj"].append((HERE / "seeds" / "star.obj").read_bytes())
        self.files["csv"].append(b"x,y,z\n10,10,25\n20 20 24\n30;15;25\n")
        self.files["json"].append((EXAMPLES / "table_corner.json").read_bytes())


def words_for(kind, file, output, number):
    """The command for an input; they take turns."""
    if kind == "obj":
        return ["patch", file, "-o", output, "--tolerance", 0.01]  # ten times as fast, and what is read is the same
    if kind == "json":
        return ["algebraic", file]
    if kind == "csv":
        return ["fill", EXAMPLES / "box_without_lid.step", "-o", output, "--through", file]
    limits = ["--read-timeout", READING]
    return [
        ["inspect", file, *limits],
        ["check", file, *limits],
        ["convert", file, output, *limits],
        ["fill", file, "-o", output, *limits],
    ][number % 4]


def fault_of(done, seconds, folder, allowed):
    """What a run did that it must not do; empty if nothing."""
    if done is None:
        return f"still running after {seconds:.0f} s"
    if done.returncode not in range(6):
        return f"exit code {done.returncode}"
    if b"crashed" in done.stderr and READER_CRASHED not in done.stderr:
        return "crashed: " + done.stderr.decode(errors="replace")[:200]
    if b"a bug in Suture" in done.stderr:
        return done.stderr.decode(errors="replace")[:200]
    try:
        lines = done.stderr.decode().splitlines()
        done.stdout.decode()
    except UnicodeDecodeError:
        return "its words are no UTF-8"
    if any(len(line) > LONGEST_LINE for line in lines):
        return "a line of more than 300 letters"
    if sum(line.startswith("error: ") for line in lines) > 1:
        return "more than one line of error"
    if done.returncode in (1, 2, 5) and not any(line.startswith("error: ") for line in lines):
        return "no word of error"
    left = set(os.listdir(folder)) - allowed
    return f"left {sorted(left)}" if left else ""


def run_one(program, kind, data, number, seconds=SECONDS):
    """Exit code or None, whether OCCT's reader crashed, seconds, fault."""
    folder = Path(tempfile.mkdtemp(prefix="suture-fuzz-"))
    try:
        file = folder / f"in.{kind}"
        file.write_bytes(data)
        words = [*words_for(kind, file, folder / "out.step", number), "--timeout", seconds, "--memory", GIGABYTES]
        start = time.monotonic()
        process = subprocess.Popen([str(word) for word in [program, *words]], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        try:
            out, err = process.communicate(timeout=seconds + GRACE)
            done = subprocess.CompletedProcess(words, process.returncode, out, err)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            done = None
        elapsed = time.monotonic() - start
        fault = fault_of(done, elapsed, folder, {file.name, "out.step"})
        if not fault and file.read_bytes() != data:
            fault = "the input is changed"
        crashed = done is not None and READER_CRASHED in done.stderr
        return (None if done is None else done.returncode), crashed, elapsed, fault
    finally:
        shutil.rmtree(folder, ignore_errors=True)


class Tally:
    def __init__(self):
        self.inputs, self.codes, self.crashes, self.slowest, self.faults = 0, Counter(), 0, 0.0, 0

    def add(self, code, crashed, seconds, fault):
        self.inputs += 1
        self.codes[code] += 1
        self.crashes += crashed
        self.slowest = max(self.slowest, seconds)
        self.faults += bool(fault)


def table_of(tallies, seed):
    rows = [f"| {kind} | {tally.inputs} | " + " | ".join(str(tally.codes[code]) for code in range(6)) +
            f" | {tally.crashes} | {tally.faults} | {tally.slowest:.1f} |" for kind, tally in tallies.items() if tally.inputs]
    total = sum(tally.inputs for tally in tallies.values())
    return "\n".join([
        f"{total} damaged inputs, seed {seed}, at most {SECONDS} s and {GIGABYTES} GB each:",
        "",
        "| kind | inputs | exit 0 | 1 | 2 | 3 | 4 | 5 | OCCT's reader crashed | broke a promise | slowest [s] |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
        *rows])


def fuzz(program, kinds, count, seed, jobs=1, seconds=None, keep=None):
    """Result: tallies by kind, and the faults as (kind, number, words)."""
    folder = Path(tempfile.mkdtemp(prefix="suture-fuzz-seeds-"))
    tallies, faults = {kind: Tally() for kind in kinds}, []
    deadline = time.monotonic() + seconds if seconds else None
    try:
        seeds = Seeds(program, folder)

        def work(task):
            kind, number = task
            if deadline and time.monotonic() > deadline:
                return None
            whole = seeds.files[kind][number // 4 % len(seeds.files[kind])]
            data = mutate(whole, f"{seed}/{kind}/{number}")
            return kind, number, data, run_one(program, kind, data, number)

        tasks = itertools.product(range(count), kinds)
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            for result in pool.map(work, ((kind, number) for number, kind in tasks)):
                if result is None:
                    continue
                kind, number, data, (code, crashed, elapsed, fault) = result
                tallies[kind].add(code, crashed, elapsed, fault)
                if fault:
                    faults.append((kind, number, fault))
                    if keep:
                        keep.mkdir(parents=True, exist_ok=True)
                        name = hashlib.sha256(data).hexdigest()[:10]
                        command = str(words_for(kind, "x", "y", number)[0])
                        (keep / f"{command}-{name}.{kind}").write_bytes(data)
                        print(f"{kind} {number}: {fault}", flush=True)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return tallies, faults


def put_table(text, file):
    """Between the two lines that mark the place."""
    begin, end = "<!-- table of fuzz.py -->", "<!-- end of table -->"
    before, rest = file.read_text().split(begin)
    file.write_text(before + begin + "\n" + text + "\n" + end + rest.split(end)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1000, help="inputs of each kind")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, help="begin no run after so many")
    parser.add_argument("--keep", type=Path, default=Path("fuzz-found"), help="folder for what breaks something")
    parser.add_argument("--table", type=Path, help="put the table into this file")
    options = parser.parse_args()
    tallies, faults = fuzz(os.environ["SUTURE_PROGRAM"], options.kinds, options.count, options.seed, options.jobs,
                           options.seconds, options.keep)
    table = table_of(tallies, options.seed)
    print(table)
    if options.table:
        put_table(table, options.table)
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
