#!/bin/sh
# Debian 13 beside the system: FreeCAD 1.0, OCCT 7.8, g++ 14. Needs root, debootstrap, and about 5 GB.
#
#   run.sh make          makes the root with all packages (once, some minutes)
#   run.sh build         builds the program in it, from this checkout
#   run.sh workbench     the workbench's tests in it, without a window and in FreeCAD's
#   run.sh fill          fills the open corner with that program, and checks what it wrote
#   run.sh all           these in turn
#   run.sh sh COMMAND    anything else, in it
#
# SUTURE_DEBIAN13  the root, by default ~/.cache/suture-debian13
# SUTURE_MIRROR    the mirror, by default the first one that apt uses here
# SUTURE_PROGRAM   a program within the root to test the workbench with, by default the one built in it
set -eu
source=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
root=${SUTURE_DEBIAN13:-$HOME/.cache/suture-debian13}
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8

mirror() {
    [ -n "${SUTURE_MIRROR-}" ] && echo "$SUTURE_MIRROR" && return
    apt-get indextargets --format '$(REPO_URI)' | grep -m1 '/debian/\?$'
}

# What the system shows to the root: processes, devices, and the checkout under its own path.
attach() {
    mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
    mountpoint -q "$root/dev" || mount --bind /dev "$root/dev"
    mkdir -p "$root$source" "$root/build"
    mountpoint -q "$root$source" || mount --bind "$source" "$root$source"
}

detach() {
    for place in "$root$source" "$root/dev" "$root/proc"; do
        ! mountpoint -q "$place" || umount -l "$place"
    done
}

within() {
    attach
    chroot "$root" "$@"
}

make_root() {
    command -v debootstrap >/dev/null || {
        echo "debian13: install debootstrap first" >&2
        exit 1
    }
    mkdir -p "$root"
    [ -x "$root/usr/bin/apt-get" ] ||
        debootstrap --variant=minbase --include=ca-certificates trixie "$root" "$(mirror)"
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    wanted="freecad-python3 procps python3-jsonschema python3-pivy python3-pyside2.qtwidgets
        libgl1-mesa-dri libgtest-dev xauth xvfb
        $(sed -nE 's/^run +([^ ]+).*/\1/p' "$source/cmake/packages.txt")"
    within apt-get -q update
    within apt-get -q install -y --no-install-recommends $wanted </dev/null
}

build() {
    # The report's npm packages, where ./suture has fetched them already: no network is needed then.
    node=$source/build/release/step_io/report/node
    if [ -x "$node/node_modules/.bin/esbuild" ]; then
        mkdir -p "$root/build/step_io/report"
        cp -r "$node" "$root/build/step_io/report/"
        offline="export SUTURE_NO_INSTALL=1"
    fi
    fresh= # the root may have been used by another checkout
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$source" "$root/build/CMakeCache.txt" || fresh=--fresh
    within sh -c "${offline-}
        export CCACHE_DIR=/build/ccache CCACHE_BASEDIR='$source' CCACHE_NOHASHDIR=1
        cmake -S '$source' -B /build $fresh -G Ninja -DCMAKE_BUILD_TYPE=Release -DSUTURE_BUILD_TESTS=OFF \
            --log-level=NOTICE
        cmake --build /build --target suture -j ${SUTURE_JOBS:-$(nproc)}"
}

fill() {
    within sh -ec "cd /tmp
        /build/bin/suture --version
        /build/bin/suture fill '$source/docs/examples/suitcase_corner.step' -o debian13.step
        /build/bin/suture check debian13.step"
}

# Every test by itself: a FreeCAD that ends without a word would take the others with it.
workbench() {
    within sh -c "cd '$source/tests/plugin'
        export SUTURE_SOURCE_DIR='$source' SUTURE_BINARY_DIR=/build/window PYTHONPATH=../support
        export SUTURE_PROGRAM=${SUTURE_PROGRAM:-/build/bin/suture}
        export SUTURE_TEST_SLOWDOWN=${SUTURE_TEST_SLOWDOWN:-1}
        failed=0 count=0
        for file in test_*.py; do
            for case in \$(python3 ../support/run_python_test.py --list \$file); do
                count=\$((count + 1))
                if timeout 600 python3 -B ../support/run_python_test.py \$file \$case >/tmp/case.txt 2>&1
                then echo \"ok      \$file \$case\"
                else
                    failed=\$((failed + 1))
                    echo \"FAILED  \$file \$case\"
                    tail -20 /tmp/case.txt
                fi
            done
        done
        echo \"\$((count - failed)) of \$count passed in FreeCAD \$(freecadcmd --version 2>&1 </dev/null | tail -1)\"
        [ \$failed = 0 ]"
}

trap detach EXIT
case ${1-} in
    make) make_root ;;
    build) build ;;
    workbench) workbench ;;
    fill) fill ;;
    all) make_root && build && fill && workbench ;;
    sh) shift && within "$@" ;;
    *) sed -n '2,15s/^# \{0,1\}//p' "$0" >&2; exit 1 ;;
esac
