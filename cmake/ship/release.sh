#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# release.sh: makes everything that a release has, in build/release/ship, with its checksums, and tries each
# in a bare root (as root; tests/ship/run.sh). SUTURE_NO_TRY=1 makes it only.
set -eu
root=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
out=$root/build/release
cd "$root"
[ -z "$(git status --porcelain)" ] || { echo "release: commit your changes first" >&2; exit 1; }
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
"$root/cmake/install_packages.sh" ship
cmake -S . --preset release --log-level=NOTICE
rm -rf "$out/ship"
cmake --build "$out" --target suture describe bundle wheel source_archive
(cd "$out" && cpack -G DEB --config CPackConfig.cmake)
lintian --allow-root --fail-on error "$out"/ship/*.deb
# Debian 13's, where that root can be made (docs/ship.md).
[ -n "${SUTURE_NO_DEBIAN13-}" ] || { "$root/tests/debian13/run.sh" make && "$root/tests/debian13/run.sh" build &&
    "$root/tests/debian13/run.sh" deb; }
cd "$out/ship"
cp suture-*-linux-x86_64/share/doc/suture/suture.spdx.json "$(basename suture-*-linux-x86_64.tar.xz .tar.xz).spdx.json"
find . -maxdepth 2 \( -name "*.tar.xz" -o -name "*.whl" -o -name "*.deb" -o -name "*.spdx.json" \) \
    -not -path "./suture-*/*" -exec sha256sum {} + | sort -k 2 >SHA256SUMS
[ -n "${SUTURE_NO_TRY-}" ] || "$root/tests/ship/run.sh" all
cat SHA256SUMS
