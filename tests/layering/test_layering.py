"""The folders depend on each other one way only: in their includes, and in what CMake links."""

import os
import re
import tempfile
import unittest
from pathlib import Path

# Every folder of the flow with the folders that it may include, downwards as the flow runs.
CORE = ["platform", "base", "spline", "model", "fill"]
ALLOWED = {
    "platform": [],
    "base": ["platform"],
    "spline": ["base"],
    "model": ["base", "spline"],
    "fill": ["platform", "base", "spline", "model"],
    "occ": ["platform", "base", "spline", "model"],
    "detect": ["base", "spline", "model", "occ"],
    "edges": ["platform", "base", "occ", "detect"],
    "ribbon": ["base", "spline", "model", "occ", "detect"],
    "candidates": CORE + ["occ", "detect", "ribbon"],
    "occt_filling": CORE + ["occ", "detect", "ribbon"],
    "faces": ["base", "spline", "model", "occ", "detect", "ribbon"],
    "sew": ["base", "spline", "model", "occ", "detect", "faces"],
    "check": ["base", "occ"],
    "judge": ["base", "spline", "model", "occ", "check"],
    "choose": CORE
    + ["occ", "detect", "ribbon", "candidates", "occt_filling", "faces", "check", "judge"],
}
ALLOWED["flow"] = list(ALLOWED)
KERNEL = list(ALLOWED)
ALLOWED["kernel"] = KERNEL
ALLOWED["files"] = KERNEL + ["kernel"]
ALLOWED["report"] = KERNEL + ["kernel"]
ALLOWED["cli"] = KERNEL + ["kernel", "files", "report"]

# The check measures what the others made: it sees OCCT's shapes, and no code of the flow.
ONLY_HEADERS = {
    ("check", "occ"): {
        "suture/occ/guard.h",
        "suture/occ/handle.h",
        "suture/occ/topology.h",
    }
}
TARGET_OF_FOLDER = {"files": "suture_io"}

# What other systems have not, or in another way: a port is a port of one folder.
LINUX = re.compile(
    r"\b(signalfd\w*|prctl|O_TMPFILE|memfd_create|landlock_\w+|SYS_\w+|syscall|dl_iterate_phdr|dlinfo|dlopen"
    r"|epoll_\w+|inotify_\w+|timerfd_\w+|pidfd_\w+|eventfd)\b|<linux/|<sys/prctl|<link\.h>|\"/(proc|sys)/"
)
COMMENT = re.compile(r"//[^\n]*")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]', re.MULTILINE)
OCCT_HEADER = re.compile(r"\.(hxx|lxx|gxx)$")
OCCT_TOOLKIT = re.compile(r"^TK")


def folder_of_source(path):
    """The folder of the flow that a source file below kernel/ or step_io/ belongs to."""
    parts = path.parts
    if parts[0] == "kernel":
        return "kernel" if len(parts) == 3 else parts[2]
    return parts[1]


def folder_of_include(name):
    parts = name.split("/")
    if parts[0] == "suture":
        return "kernel" if len(parts) == 2 else parts[1]
    return parts[0]


def violations(root):
    """One sentence for each forbidden include in the tree at root."""
    found = []
    sources = [
        path
        for top in ("kernel", "step_io")
        for path in sorted((root / top).rglob("*"))
        if path.suffix in (".h", ".cpp")
    ]
    for source in sources:
        relative = source.relative_to(root)
        folder = folder_of_source(relative)
        text = source.read_text(encoding="utf-8")
        if folder != "platform":
            for call in LINUX.finditer(COMMENT.sub("", text)):
                found.append(f"{relative}: {call[0]} belongs into the folder platform")
        for quote, name in INCLUDE.findall(text):
            reason = forbidden(root, folder, quote, name)
            if reason:
                found.append(f"{relative}: includes {name}: {reason}")
    return found


def forbidden(root, folder, quote, name):
    if folder not in ALLOWED:
        return f"the folder {folder} has no place in the order of the flow"
    if quote == "<":
        if OCCT_HEADER.search(name) and folder in CORE:
            return f"{folder} knows nothing of OCCT"
        return None
    if not (root / "kernel" / name).exists() and not (root / "step_io" / name).exists():
        return "there is no such file below kernel/ or step_io/"
    other = folder_of_include(name)
    if other == folder:
        return None
    if other not in ALLOWED[folder]:
        return f"{folder} stands below {other} in the flow, or beside it"
    if name not in ONLY_HEADERS.get((folder, other), {name}):
        return f"{folder} may see only {', '.join(sorted(ONLY_HEADERS[folder, other]))}"
    return None


def read_links(file):
    links = {}
    for line in Path(file).read_text(encoding="utf-8").splitlines():
        target, _, linked = line.partition(": ")
        links[target] = [name for name in linked.split(";") if name]
    return links


def link_violations(links):
    folder_of = {TARGET_OF_FOLDER.get(name, f"suture_{name}"): name for name in ALLOWED}
    found = []
    for target, linked in links.items():
        if target not in folder_of:
            found.append(f"{target} has no place in the order of the flow")
            continue
        folder = folder_of[target]
        for name in linked:
            if name in folder_of and folder_of[name] not in ALLOWED[folder]:
                found.append(f"{target} links {name}")
            if OCCT_TOOLKIT.match(name) and folder in CORE:
                found.append(f"{target} links {name}, and knows nothing of OCCT")
    return found


class Includes(unittest.TestCase):
    root = Path(os.environ["SUTURE_SOURCE_DIR"])

    def test_every_include_points_down_the_flow(self):
        found = violations(self.root)
        if found:
            self.fail("\n" + "\n".join(found))

    def test_every_folder_in_the_order_exists(self):
        for folder in KERNEL:
            self.assertTrue((self.root / "kernel/suture" / folder).is_dir(), folder)
        for folder in ("files", "report", "cli"):
            self.assertTrue((self.root / "step_io" / folder).is_dir(), folder)


class ForbiddenIncludes(unittest.TestCase):
    """Each rule finds the include that breaks it, in a small tree made for that."""

    HEADERS = [
        "kernel/suture/base/result.h",
        "kernel/suture/model/ribbon.h",
        "kernel/suture/fill/fill.h",
        "kernel/suture/occ/guard.h",
        "kernel/suture/occ/convert.h",
        "kernel/suture/detect/find_loops.h",
        "kernel/suture/check/continuity.h",
        "kernel/suture/fill_holes.h",
        "step_io/files/read.h",
        "step_io/cli/command.h",
    ]

    def found_in(self, source, line):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for header in self.HEADERS:
                (root / header).parent.mkdir(parents=True, exist_ok=True)
                (root / header).write_text("#pragma once\n", encoding="utf-8")
            (root / source).parent.mkdir(parents=True, exist_ok=True)
            (root / source).write_text(line + "\n", encoding="utf-8")
            return violations(root)

    def assert_forbidden(self, source, line):
        found = self.found_in(source, line)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(source), found)

    def test_occt_in_the_core_is_found(self):
        self.assert_forbidden("kernel/suture/fill/plane.cpp", "#include <gp_Pnt.hxx>")
        self.assert_forbidden("kernel/suture/base/tolerance.h", "  #  include <gp_Pnt.hxx>")

    def test_an_include_up_the_flow_is_found(self):
        self.assert_forbidden("kernel/suture/model/ribbon.cpp", '#include "suture/fill/fill.h"')
        self.assert_forbidden("kernel/suture/detect/a.cpp", '#include "suture/fill_holes.h"')

    def test_the_check_sees_no_code_of_the_flow(self):
        self.assert_forbidden("kernel/suture/check/a.cpp", '#include "suture/model/ribbon.h"')
        self.assert_forbidden("kernel/suture/check/a.cpp", '#include "suture/occ/convert.h"')

    def test_files_in_the_kernel_are_found(self):
        self.assert_forbidden("kernel/suture/fill_holes.cpp", '#include "files/read.h"')

    def test_the_command_line_in_files_is_found(self):
        self.assert_forbidden("step_io/files/read.cpp", '#include "cli/command.h"')

    def test_calls_of_linux_alone_are_found_outside_of_their_folder(self):
        for line in (
            "#include <linux/landlock.h>",
            "const int file = signalfd(-1, &signals, SFD_CLOEXEC);",
            "prctl(PR_SET_PDEATHSIG, SIGKILL);",
            "open(folder, O_WRONLY | O_TMPFILE);",
            'execv("/proc/self/exe", words);',
        ):
            self.assert_forbidden("step_io/cli/a.cpp", line)
            self.assertEqual(self.found_in("kernel/suture/platform/a.cpp", line), [])
        self.assertEqual(self.found_in("step_io/cli/a.cpp", "// not signalfd(), nor /proc/self"), [])

    def test_an_include_of_nothing_is_found(self):
        self.assert_forbidden("kernel/suture/fill/plane.cpp", '#include "fill.h"')

    def test_a_folder_outside_the_order_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "kernel/suture/extra/a.h"
            source.parent.mkdir(parents=True)
            source.write_text("#include <vector>\n", encoding="utf-8")
            self.assertEqual(len(violations(Path(folder))), 1)

    def test_includes_down_the_flow_are_allowed(self):
        self.assertEqual(
            self.found_in("kernel/suture/check/a.cpp", '#include "suture/occ/guard.h"'), []
        )
        self.assertEqual(self.found_in("step_io/cli/a.cpp", '#include "files/read.h"'), [])
        self.assertEqual(self.found_in("kernel/suture/occ/a.cpp", "#include <gp_Pnt.hxx>"), [])


class Links(unittest.TestCase):
    file = Path(os.environ["SUTURE_BINARY_DIR"]) / "tests/layering/links.txt"

    def test_every_link_points_down_the_flow(self):
        found = link_violations(read_links(self.file))
        if found:
            self.fail("\n" + "\n".join(found))

    def test_every_library_is_looked_at(self):
        expected = {TARGET_OF_FOLDER.get(name, f"suture_{name}") for name in ALLOWED}
        self.assertEqual(set(read_links(self.file)), expected - {"suture_cli"})

    def test_forbidden_links_are_found(self):
        self.assertEqual(len(link_violations({"suture_model": ["suture_fill"]})), 1)
        self.assertEqual(len(link_violations({"suture_fill": ["TKernel"]})), 1)
        self.assertEqual(len(link_violations({"suture_faces": ["suture_io"]})), 1)
        self.assertEqual(len(link_violations({"suture_new": []})), 1)
        self.assertEqual(link_violations({"suture_ribbon": ["suture_detect", "TKBRep"]}), [])


if __name__ == "__main__":
    unittest.main()
