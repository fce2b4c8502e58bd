#!/bin/sh
# Debian 13 beside the system: FreeCAD 1.0, OCCT 7.8, g++ 14. Needs root, debootstrap, and about 6 GB.
#
#   run.sh make              makes the root (once, some minutes), with what the tests need
#   run.sh build             ./suture in it: builds the program from this checkout
#   run.sh fill              fills the open corner with that program, and checks what it wrote
#   run.sh workbench [WORD]  the workbench's tests in it, without a window and in FreeCAD's; those whose name has WORD
#   run.sh test [OPTIONS]    ./test in it: builds and runs everything; options of CTest
#   run.sh deb               the Debian packages, built on it, into build/release/ship/trixie
#   run.sh all               these in turn
#   run.sh sh COMMAND        anything else, in it, in the checkout
#
# SUTURE_DEBIAN13  the root, by default ~/.cache/suture-debian13
# SUTURE_MIRROR    the mirror, by default the first one that apt uses here
# SUTURE_PROGRAM   a program within the root to test the workbench with, by default the one built in it
set -eu
source=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
root=${SUTURE_DEBIAN13:-$HOME/.cache/suture-debian13}
# Where the root has the checkout: the same place for every checkout, so that ccache knows what it compiled.
there=/src/suture
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8

mirror() {
    [ -n "${SUTURE_MIRROR-}" ] && echo "$SUTURE_MIRROR" && return
    apt-get indextargets --format '$(REPO_URI)' | grep -m1 '/debian/\?$'
}

# What the system shows to the root: processes, devices, the checkout, and the test data beside it. The build
# folder is the root's own. All of it in a namespace of this run, so that it ends with it.
if [ -z "${SUTURE_ATTACHED-}" ] && [ $# -gt 0 ]; then
    exec env SUTURE_ATTACHED=1 unshare --mount --propagation private "$0" "$@"
fi

attach() {
    mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
    mountpoint -q "$root/dev" || mount --rbind /dev "$root/dev"
    mountpoint -q "$root$there" && return
    mkdir -p "$root$there" "$root/build" "$source/build"
    # OCCT 7.8 crashes where it writes AP203 and the host's name has no address.
    grep -q " $(hostname)\$" "$root/etc/hosts" 2>/dev/null || echo "127.0.0.1 $(hostname)" >>"$root/etc/hosts"
    mount --bind "$source" "$root$there"
    mount --bind "$root/build" "$root$there/build"
    if [ -d "$source/../shared" ]; then
        mkdir -p "$root/src/shared"
        mount --bind "$source/../shared" "$root/src/shared"
    fi
}

within() {
    attach
    chroot "$root" env -i HOME=/root PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        DEBIAN_FRONTEND=noninteractive SUTURE_TEST_SLOWDOWN="${SUTURE_TEST_SLOWDOWN:-1}" \
        sh -euc "cd $there; $1" sh "$@" </dev/null
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
    within 'cmake/install_packages.sh test
        apt-get -q install -y --no-install-recommends git procps python3-pivy python3-pyside2.qtwidgets'
}

# The report's npm packages, where ./suture has fetched them already: no network is needed then.
lend_node() {
    node=build/release/step_io/report/node
    if [ -e "$source/$node/installed" ] && [ ! -e "$root/$node/installed" ]; then
        mkdir -p "$root/$(dirname $node)"
        cp -a "$source/$node" "$root/$(dirname $node)/"
    fi
}

build() {
    lend_node
    within './suture --version -v'
}

fill() {
    within './suture fill docs/examples/suitcase_corner.step -o /tmp/debian13.step
        ./suture check /tmp/debian13.step'
}

run_tests() {
    lend_node
    within 'git config --global --replace-all safe.directory "*"; shift; exec ./test "$@"' "$@"
}

# As cmake/ship/release.sh makes them here.
deb() {
    within 'cmake/install_packages.sh run
        apt-get -q install -y --no-install-recommends dpkg-dev file
        cmake --build build/release --target suture describe
        rm -f build/release/ship/*.deb
        cd build/release && cpack -G DEB --config CPackConfig.cmake'
    mkdir -p "$source/build/release/ship/trixie"
    cp "$root"/build/release/ship/*.deb "$source/build/release/ship/trixie/"
}

# Every test by itself: a FreeCAD that ends without a word would take the others with it.
workbench() {
    within "cd tests/plugin
        export SUTURE_SOURCE_DIR=$there SUTURE_BINARY_DIR=$there/build/window PYTHONPATH=../support
        export SUTURE_PROGRAM=${SUTURE_PROGRAM:-$there/build/release/bin/suture}"'
        failed=0 count=0
        for file in test_*.py; do
            for case in $(python3 -B ../support/run_python_test.py --list $file | grep -e "${2-}"); do
                count=$((count + 1))
                if timeout 600 python3 -B ../support/run_python_test.py $file $case >/tmp/case.txt 2>&1
                then echo "ok      $file $case"
                elif [ $? = 77 ]
                then echo "skipped $file $case: $(tail -1 /tmp/case.txt)"
                else
                    failed=$((failed + 1))
                    echo "FAILED  $file $case"
                    tail -20 /tmp/case.txt
                fi
            done
        done
        echo "$((count - failed)) of $count passed in FreeCAD $(freecadcmd --version 2>&1 </dev/null | tail -1)"
        [ $failed = 0 ]' "$@"
}

case ${1-} in
    make) make_root ;;
    build) build ;;
    workbench) shift && workbench "$@" ;;
    fill) fill ;;
    test) shift && run_tests "$@" ;;
    deb) deb ;;
    all) make_root && build && fill && run_tests && deb ;;
    sh) within "$2" ;;
    *) sed -n '2,18s/^# \{0,1\}//p' "$0" >&2; exit 1 ;;
esac
