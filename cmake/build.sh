#!/bin/sh
# build.sh run|test: packages, then the release build in build/release. `run` builds the program,
# `test` everything. Leaves build/release/built, whose time is that of the build's start: sources
# newer than it are not in the build.
set -eu

root=$(dirname "$(dirname "$(readlink -f "$0")")")
out=$root/build/release
what=$1

"$root/cmake/install_packages.sh" "$what"
mkdir -p "$out"
exec 9>"$out/lock"
flock 9 # two first uses at once: the second waits, and then has nothing to do

# Paths inside the project count relative to it: another checkout finds what this one compiled.
export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1

touch "$out/built.new"
fresh=
if [ -f "$out/CMakeCache.txt" ] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$out/CMakeCache.txt"; then
    fresh=--fresh # the checkout was moved or copied
fi
if [ "$what" = test ]; then
    cmake -S "$root" --preset release $fresh -DSUTURE_BUILD_TESTS=ON --log-level=NOTICE
    cmake --build "$out" -j "$(nproc)"
else
    if [ ! -f "$out/build.ninja" ] || [ -n "$fresh" ]; then
        echo "suture: building the program, once (some minutes)" >&2
        cmake -S "$root" --preset release $fresh -DSUTURE_BUILD_TESTS=OFF --log-level=NOTICE
    fi
    cmake --build "$out" -j "$(nproc)" --target suture
fi
mv "$out/built.new" "$out/built"
