# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the Python wheel, which carries the bundle, with setuptools and without network.

wheel.py BUNDLE SCRATCH TO
"""

import shutil
import subprocess
import sys
from pathlib import Path

import parts

SETUP = '''
from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel


class Binary(Distribution):
    def has_ext_modules(self):
        return True


class Platform(bdist_wheel):
    """A program of one platform, for every Python 3."""

    def get_tag(self):
        return "py3", "none", "linux_x86_64"


setup(
    name="suture",
    version="{version}",
    description="Closes the holes of CAD models with smooth faces",
    long_description=open("README.md", encoding="utf-8").read(),
    long_description_content_type="text/markdown",
    license="LGPL-2.1-or-later",
    python_requires=">=3.9",
    packages=["suture"],
    package_data={{"suture": ["py.typed", *{files}]}},
    entry_points={{"console_scripts": ["suture = suture.__main__:main"]}},
    distclass=Binary,
    cmdclass={{"bdist_wheel": Platform}},
)
'''


def main(bundle, scratch, to):
    shutil.rmtree(scratch, ignore_errors=True)
    package = scratch / "suture"
    shutil.copytree(
        parts.SOURCE / "step_io/python/suture",
        package,
        ignore=shutil.ignore_patterns("__pycache__"),
    )
    shutil.copytree(bundle, package / "bundle")
    shutil.copy(parts.SOURCE / "README.md", scratch)
    shutil.copy(parts.SOURCE / "LICENSE", scratch)
    files = sorted(
        str(file.relative_to(package)) for file in (package / "bundle").rglob("*") if file.is_file()
    )
    (scratch / "setup.py").write_text(SETUP.format(version=parts.version(), files=files))
    done = subprocess.run(
        [sys.executable, "setup.py", "-q", "bdist_wheel", "--dist-dir", to.absolute()],
        cwd=scratch,
        check=False,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    if done.returncode != 0:
        raise SystemExit(done.stdout)
    shutil.rmtree(scratch)
    for wheel in to.glob(f"suture-{parts.version()}-*.whl"):
        print(f"{wheel}: {wheel.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:4]))
