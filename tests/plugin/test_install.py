"""Getting the program: from a bundle or a wheel, and what must not be taken for one."""

import io
import os
import stat
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

from headless import PROGRAM, Case, example  # first: it makes FreeCAD importable

from suture_workbench import api, install, program  # noqa: E402
from suture_workbench.errors import SutureError  # noqa: E402

SCRIPT = f'#!/bin/sh\nexec "{PROGRAM}" "$@"\n'


class Install(Case):
    def setUp(self):
        super().setUp()
        self.bundles = 0
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        home = mock.patch.object(install, "home", lambda: self.folder / "user" / "program")
        home.start()
        self.addCleanup(home.stop)

    def bundle(self, script=SCRIPT, name="suture-1-linux/bin/suture", more=()):
        self.bundles += 1
        path = self.folder / f"suture-{self.bundles}.tar.xz"
        with tarfile.open(path, "w:xz") as file:
            entry = tarfile.TarInfo(name)
            entry.size, entry.mode = len(script.encode()), 0o755
            file.addfile(entry, io.BytesIO(script.encode()))
            for other in more:
                file.addfile(other)
        return path

    def wheel(self):
        path = self.folder / "suture-1-py3-none-linux_x86_64.whl"
        with zipfile.ZipFile(path, "w") as file:
            entry = zipfile.ZipInfo("suture/bundle/bin/suture")
            entry.external_attr = (stat.S_IFREG | 0o755) << 16
            file.writestr(entry, SCRIPT)
            file.writestr("suture/__init__.py", "")
        return path

    def test_a_bundle_and_a_wheel_are_installed_and_used(self):
        for archive in (self.bundle(), self.wheel()):
            path = install.install(archive)
            self.assertTrue(os.access(path, os.X_OK))
            addon = {"SUTURE_EXE": "/no", "PATH": ""}
            with mock.patch.dict(os.environ, addon):
                with mock.patch.object(program, "ADDON", self.folder / "none"):
                    self.assertEqual(program.find(), str(path))
                    self.assertTrue(api.fill(self.add(example())).Closed)

    def test_what_is_no_suture_is_refused_and_what_was_there_stays(self):
        good = install.install(self.bundle())
        text = self.folder / "notes.txt"
        text.write_text("nothing")
        broken = self.folder / "broken.tar.xz"
        broken.write_bytes(b"not an archive")
        for archive, word in (
            (text, "neither a bundle"),
            (broken, "cannot be unpacked"),
            (self.bundle("#!/bin/sh\necho something else\n"), "is not Suture"),
            (self.bundle("#!/bin/sh\necho no library >&2; exit 127\n"), "no library"),
            (self.bundle(name="suture-1/share/readme"), "holds no program"),
        ):
            with self.assertRaises(SutureError) as caught:
                install.install(archive)
            self.assertIn(word, str(caught.exception))
            self.assertEqual(install.installed(), good)
            self.assertEqual(list((self.folder / "user").glob("new-*")), [])

    def test_nothing_is_unpacked_outside_of_its_folder(self):
        link = tarfile.TarInfo("suture-1/out")
        link.type, link.linkname = tarfile.SYMTYPE, "../../../../etc"
        device = tarfile.TarInfo("suture-1/device")
        device.type = tarfile.CHRTYPE
        for archive in (
            self.bundle(name="../../evil/bin/suture"),
            self.bundle(more=[link]),
            self.bundle(more=[device]),
        ):
            with self.assertRaises(SutureError):
                install.install(archive)
            self.assertIsNone(install.installed())
            self.assertFalse((self.folder / "evil").exists())
        wheel = self.folder / "evil.whl"
        with zipfile.ZipFile(wheel, "w") as file:
            file.writestr("../evil/bin/suture", SCRIPT)
        self.assertRaises(SutureError, install.install, wheel)
        self.assertFalse((self.folder / "user" / "evil").exists())

    def test_the_program_in_a_wheel_of_freecads_python_is_found(self):
        package = self.folder / "site" / "suture"
        (package / "bundle" / "bin").mkdir(parents=True)
        (package / "__init__.py").touch()
        file = package / "bundle" / "bin" / install.NAME
        file.write_text(SCRIPT)
        self.assertIsNone(install.in_python())
        with mock.patch("sys.path", [str(package.parent), *__import__("sys").path]):
            self.assertIsNone(install.in_python(), "not to be executed")
            file.chmod(0o755)
            self.assertEqual(install.in_python(), file)


if __name__ == "__main__":
    unittest.main()
