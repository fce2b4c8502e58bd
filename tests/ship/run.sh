#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs what is shipped into bare roots of Debian 12 and 13, as docs/ship.md says, and uses it there.
# Needs root, debootstrap, overlayfs, and 1 GB, 4 GB of memory for `library` and `workbench`.
#
#   run.sh roots           makes the bare roots (once, some minutes)
#   run.sh bundle          the bundle, without network, without root's rights
#   run.sh wheel           the wheel, by pip, without network
#   run.sh deb             the Debian packages, by apt, each in the root of the Debian that it was built on
#   run.sh library         libsuture-dev, and docs/examples/fill_a_model.cpp built with it
#   run.sh workbench       freecad-suture with Debian's FreeCAD, and a fill by the workbench
#   run.sh all             these in turn (the last two load a gigabyte each)
#
# SUTURE_ROOTS    where the bare roots are, by default ~/.cache/suture-bare
# SUTURE_DISTS    by default "bookworm trixie"
# SUTURE_MIRROR   the mirror, by default the first one that apt uses here
set -eu
source=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
ship=$source/build/release/ship
roots=${SUTURE_ROOTS:-$HOME/.cache/suture-bare}
dists=${SUTURE_DISTS:-bookworm trixie}
scratch=$(mktemp -d)
root=$scratch/root

mirror() {
    [ -n "${SUTURE_MIRROR-}" ] && echo "$SUTURE_MIRROR" && return
    apt-get indextargets --format '$(REPO_URI)' | grep -m1 '/debian/\?$'
}

make_roots() {
    mkdir -p "$roots"
    for dist in $dists; do
        [ -x "$roots/$dist/usr/bin/apt-get" ] ||
            debootstrap --variant=minbase "$dist" "$roots/$dist" "$(mirror)"
    done
}

# A fresh copy of a bare root, that leaves no trace in it.
fresh() {
    leave
    mkdir -p "$scratch/layer" "$root"
    mount -t tmpfs -o size=4g tmpfs "$scratch/layer"
    mkdir "$scratch/layer/upper" "$scratch/layer/work"
    mount -t overlay overlay -o \
        "lowerdir=$roots/$1,upperdir=$scratch/layer/upper,workdir=$scratch/layer/work" "$root"
    mount -t proc proc "$root/proc"
    mount --bind /dev "$root/dev"
    mkdir -p "$root/home/user"
    cp "$source/docs/examples/suitcase_corner.step" "$root/home/user/"
    cp "$source"/tests/ship/in_root/* "$root/home/user/"
}

leave() {
    for place in "$root/dev" "$root/proc" "$root" "$scratch/layer"; do
        ! mountpoint -q "$place" || umount -l "$place"
    done
}

# A user without rights and without network. $1 is what to run in the user's home.
as_user() {
    chroot "$root" chown -R nobody:nogroup /home/user
    unshare --net chroot --userspec=nobody:nogroup "$root" env -i HOME=/home/user LC_ALL=C.UTF-8 \
        PATH=/usr/bin:/bin sh -euc "cd /home/user; $1"
}

bundle() {
    for dist in $dists; do
        fresh "$dist"
        echo "=== bundle in $dist"
        # xz is not in a bare root, so it is unpacked from here.
        mkdir "$root/home/user/some where"
        tar -xJf "$ship"/suture-*-linux-x86_64.tar.xz -C "$root/home/user/some where"
        as_user 'sh use_program.sh "$PWD"/some*/suture-*/bin/suture'
    done
}

# What the user has of Debian beforehand, by the network.
given() {
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 sh -euc "apt-get -qq update
        apt-get -qq -o Dpkg::Use-Pty=0 install -y --no-install-recommends $* >/dev/null"
}

wheel() {
    for dist in $dists; do
        fresh "$dist"
        echo "=== wheel in $dist"
        given python3-venv
        cp "$ship"/suture-*.whl "$root/home/user/"
        as_user 'python3 -m venv venv && venv/bin/pip -q install --no-index suture-*.whl
            sh use_program.sh venv/bin/suture
            venv/bin/python use_python.py'
    done
}

# Each distribution has packages of its own: those of this one in ship, those of another in a folder of its name.
# Runs a command with the distribution's name where it has packages.
with_packages() {
    for dist in $dists; do
        packages=$ship
        [ "$dist" = "$(. /etc/os-release && echo "$VERSION_CODENAME")" ] || packages=$ship/$dist
        if ls "$packages"/suture_*.deb >/dev/null 2>&1; then
            fresh "$dist"
            echo "=== $1 in $dist"
            cp "$packages"/*.deb "$root/home/user/"
            "$1_in"
        else
            echo "=== $1 in $dist: there is none in $packages"
        fi
    done
}

deb_in() {
    given man-db bash-completion
    chroot "$root" sh -c 'dpkg --get-selections | sort' >"$scratch/before"
    given /home/user/suture_*.deb
    as_user 'sh use_program.sh /usr/bin/suture
        zcat /usr/share/man/man1/suture-fill.1.gz | grep -q continuity
        grep -q -e --edge-continuity /usr/share/bash-completion/completions/suture'
    chroot "$root" sh -euc 'apt="apt-get -qq -o Dpkg::Use-Pty=0"
        $apt purge -y suture >/dev/null && $apt autoremove --purge -y >/dev/null'
    left=$(chroot "$root" find /usr /etc -name "*suture*")
    [ -z "$left" ] || { echo "removing left $left"; exit 1; }
    chroot "$root" sh -c 'dpkg --get-selections | sort' | diff "$scratch/before" - ||
        { echo "removing left packages"; exit 1; }
    echo "removed: cleanly"
}

library_in() {
    given cmake ninja-build g++ /home/user/suture_*.deb /home/user/libsuture-dev_*.deb
    mkdir "$root/home/user/own"
    cp "$source/docs/examples/fill_a_model.cpp" "$root/home/user/own/"
    cat >"$root/home/user/own/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(Own LANGUAGES CXX)
find_package(Suture REQUIRED)
add_executable(fill_a_model fill_a_model.cpp)
target_link_libraries(fill_a_model PRIVATE suture::io)
CMAKE
    as_user 'cmake -S own -B built -G Ninja -DCMAKE_BUILD_TYPE=Release
        cmake --build built
        built/fill_a_model suitcase_corner.step by_library.step
        suture check by_library.step | tail -1'
}

workbench_in() {
    given /home/user/suture_*.deb /home/user/freecad-suture_*.deb
    as_user 'export QT_QPA_PLATFORM=offscreen
        freecadcmd use_workbench.py </dev/null | tee said
        grep -q "^used: well" said
        suture check by_workbench.step | tail -1'
}

trap 'leave; rm -rf "$scratch"' EXIT
case ${1-} in
    roots) make_roots ;;
    bundle | wheel) $1 ;;
    deb | library | workbench) with_packages "$1" ;;
    all) make_roots && bundle && wheel && for kind in deb library workbench; do with_packages $kind; done ;;
    *) sed -n '3,18s/^# \{0,1\}//p' "$0" >&2; exit 1 ;;
esac
