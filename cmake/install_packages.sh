#!/bin/sh
# install_packages.sh run|test|ship: installs what is missing of the packages in packages.txt. The only
# place that installs anything. Asks nothing, and touches no network when nothing is missing.
# SUTURE_NO_INSTALL=1 leaves the system as it is.
set -eu

here=$(dirname "$(readlink -f "$0")")
case ${1-} in
    run) kinds='run' ;;
    test) kinds='run|test' ;;
    ship) kinds='run|ship' ;;
    *) echo "usage: $0 run|test|ship" >&2; exit 1 ;;
esac
wanted=$(sed -nE "s/^($kinds) +//p" "$here/packages.txt" | while read -r package unless program; do
    [ -n "$unless" ] && command -v "$program" >/dev/null || echo "$package"
done)

if [ -n "${SUTURE_NO_INSTALL-}" ]; then
    exit 0
fi
if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "suture: this system has no apt-get. Install what these Debian 12 packages hold:" $wanted >&2
    echo "suture: then set SUTURE_NO_INSTALL=1 and run the same command again." >&2
    exit 1
fi

# What is installed, and what it stands for: Debian 13 has lib3mf1t64, which provides lib3mf1.
installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' |
    sed -n 's/^installed //p' | tr -d ' ' | tr ',' '\n' | sed 's/(.*//')
missing=$(for package in $wanted; do
    printf '%s\n' "$installed" | grep -qxF -e "$package" || echo "$package"
done)
if [ -z "$missing" ]; then
    exit 0
fi

echo "suture: installing Debian packages, once:" $missing >&2
if [ "$(id -u)" = 0 ]; then
    as_root=
elif command -v sudo >/dev/null; then
    as_root=sudo
else
    echo "suture: installing needs root, and there is no sudo. Run as root:" >&2
    echo "    apt-get install --no-install-recommends" $missing >&2
    exit 1
fi
apt="$as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300"
$apt update >&2 || echo "suture: apt-get update failed; going on with the lists there are" >&2
if ! $apt install -y --no-install-recommends $missing >&2; then
    echo "suture: apt-get could not install:" $missing >&2
    exit 1
fi
