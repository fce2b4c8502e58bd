"""Runs CTest over everything in build/release and sums up what its JUnit file says.

Every GoogleTest case and every Python test method is one test there. Arguments go to CTest.
"""

import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

BUILD = Path(__file__).resolve().parent.parent / "build" / "release"


def outcome(case):
    """passed, failed or skipped. Whatever is not known to have passed or been skipped has failed.

    CTest writes <skipped> for tests that it could not run as well: a program that is not there.
    """
    skipped = case.find("skipped")
    if case.get("status") == "disabled":
        return "skipped"
    if skipped is not None and skipped.get("message", "").startswith("SKIP_"):
        return "skipped"
    if case.get("status") == "run" and case.find("failure") is None:
        return "passed"
    return "failed"


def skip_reason(case):
    output = case.findtext("system-out") or ""
    found = re.search(r"^.*: Skipped\n(.*)$|^Skipped: (.*)$", output, re.MULTILINE)
    if found:
        return (found.group(1) or found.group(2) or "").strip() or "no reason given"
    return "disabled" if case.get("status") == "disabled" else "no reason given"


def read_results(junit):
    cases = list(ElementTree.parse(junit).getroot().iter("testcase"))
    counts = Counter({"passed": 0, "failed": 0, "skipped": 0})
    reasons, failures = Counter(), []
    for case in cases:
        result = outcome(case)
        counts[result] += 1
        if result == "skipped":
            reasons[skip_reason(case)] += 1
        elif result == "failed":
            failures.append(case.get("name"))
    return counts, reasons, failures


def summary(counts):
    line = f"{counts['passed']} passed, {counts['failed']} failed"
    return line + (f", {counts['skipped']} skipped" if counts["skipped"] else "")


def main(arguments):
    junit = BUILD / "tests.xml"
    junit.unlink(missing_ok=True)
    jobs = str(os.cpu_count() or 1)
    code = subprocess.run(
        ["ctest", "--test-dir", BUILD, "--parallel", jobs, "--output-on-failure"]
        + ["--no-tests=error", "--output-junit", junit]
        + arguments,
        stdin=subprocess.DEVNULL,
        check=False,
    ).returncode
    if not junit.exists():
        print("CTest ran no test.\n0 passed, 1 failed")
        return 1
    counts, reasons, failures = read_results(junit)
    for reason, count in reasons.most_common():
        print(f"skipped {count}: {reason}")
    for name in failures:
        print(f"failed: {name}")
    if counts["passed"] + counts["failed"] == 0 or (code != 0 and not failures):
        print(f"CTest ended with code {code}.")
        counts["failed"] += 1
    print(summary(counts))
    return 0 if counts["failed"] == 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
