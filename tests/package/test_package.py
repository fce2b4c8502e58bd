"""The installed package serves a project outside of this one, and knows nothing of the build."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["SUTURE_SOURCE_DIR"])
BINARY = Path(os.environ["SUTURE_BINARY_DIR"])


def run(*command, **options):
    done = subprocess.run(
        [str(word) for word in command],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        **options,
    )
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def flags():
    """Those the build was asked for: libraries with a sanitizer serve only programs with it."""
    cache = (BINARY / "CMakeCache.txt").read_text(encoding="utf-8")
    compiler = re.search(r"^CMAKE_CXX_FLAGS:\w+=(.*)$", cache, re.MULTILINE)[1]
    # AddressSanitizer's dlopen is called by its own library: a program's DT_RUNPATH is not for that.
    linker = "-Wl,--disable-new-dtags" if "-fsanitize=address" in compiler else ""
    return f"-DCMAKE_CXX_FLAGS={compiler}", f"-DCMAKE_EXE_LINKER_FLAGS={linker}"


class InstalledPackage(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="suture_package_"))
        self.addCleanup(shutil.rmtree, self.folder)
        installed = self.folder / "installed"
        run("cmake", "--install", BINARY, "--prefix", installed)
        # Moved after installing: nothing may depend on the place.
        self.prefix = self.folder / "moved"
        installed.rename(self.prefix)

    def test_an_outside_project_builds_with_it_and_runs(self):
        built = self.folder / "consumer"
        run(
            *("cmake", "-S", SOURCE / "tests/package/consumer", "-B", built, "-G", "Ninja"),
            *(f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release"),
            f"-DEXAMPLE={SOURCE}/docs/examples/fill_a_model.cpp",
            *flags(),
        )
        run("cmake", "--build", built)

        methods = run(built / "core_consumer").split()
        self.assertIn("plane", methods)
        self.assertIn("extend", methods)

        valid, solids, faces, free_edges, volume = run(built / "kernel_consumer").split()
        self.assertEqual([valid, solids, faces, free_edges], ["1", "1", "6", "0"])
        self.assertAlmostEqual(float(volume), 6.0, places=9)

        step = self.folder / "head.step"
        step.write_text("ISO-10303-21;\nHEADER;\n", encoding="utf-8")
        self.assertIn("STEP", run(built / "io_consumer", step))
        # By a module, which is looked for where the package lies.
        self.assertEqual(run(built / "io_consumer", self.write_iges()).split(), ["IGES", "1"])

        filled = self.folder / "filled.step"
        said = run(built / "example", SOURCE / "docs/examples/suitcase_corner.step", filled)
        self.assertIn("0 free edges", said)
        self.assertIn('"solids": 1', run(self.prefix / "bin/suture", "check", filled, "--json"))

        linked = run("ldd", built / "core_consumer")
        self.assertNotIn("libTK", linked, "the core knows nothing of OCCT")

    def test_it_names_no_folder_of_the_build_and_no_flag_of_ours(self):
        files = list(self.prefix.rglob("*.cmake"))
        self.assertGreaterEqual(len(files), 3)
        for file in files:
            text = file.read_text(encoding="utf-8")
            for path in (str(SOURCE), str(BINARY), str(self.folder)):
                self.assertNotIn(path, text, file)
            for flag in ("suture_flags", "-Werror", "-Wall", "-ffp-contract"):
                self.assertNotIn(flag, re.sub(r"BUILD_INTERFACE:suture_flags", "", text), file)

    def test_the_installed_headers_are_those_that_the_one_for_users_needs(self):
        include = self.prefix / "include"
        needed, new = set(), {include / "suture/suture.h"}
        while new:
            header = new.pop()
            needed.add(header)
            for name in re.findall(r'#include "([^"]+)"', header.read_text(encoding="utf-8")):
                found = [root / name for root in (include, include / "suture/step_io") if (root / name).exists()]
                self.assertTrue(found, f"{header.relative_to(include)} includes {name}")
                new |= {found[0]} - needed
        self.assertEqual(set(include.rglob("*.h")), needed)

    def test_the_program_is_installed_and_runs(self):
        self.assertRegex(run(self.prefix / "bin/suture", "--version"), r"\d+\.\d+\.\d+")

    def test_the_installed_program_finds_its_modules_and_no_others(self):
        self.write_iges()
        modules = sorted((self.prefix / "lib").rglob("suture/suture_*"))
        self.assertEqual(
            [module.name for module in modules],
            ["suture_gltf.so", "suture_grow", "suture_iges.so", "suture_occt_filling", "suture_zip.so"],
        )
        for module in modules:
            module.unlink()
        with self.assertRaisesRegex(AssertionError, "suture_iges.so"):
            self.write_iges()

    def write_iges(self):
        iges = self.folder / "lid.igs"
        example = sorted((SOURCE / "docs/examples").glob("*.step"))[0]
        run(self.prefix / "bin/suture", "convert", example, iges)
        return iges


if __name__ == "__main__":
    unittest.main()
