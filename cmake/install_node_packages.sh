#!/bin/sh
# install_node_packages.sh FROM TO: installs the npm packages that FROM/package-lock.json names into
# TO/node_modules, for the build's bundler. Asks nothing, runs no script of a package, and touches no
# network when they are there. SUTURE_NO_INSTALL=1 takes what is there, or says what is missing.
set -eu

from=$1
to=$2
mkdir -p "$to"
if [ -e "$to/installed" ] && cmp -s "$from/package-lock.json" "$to/package-lock.json"; then
    touch "$to/installed"
    exit 0
fi
cp "$from/package.json" "$from/package-lock.json" "$to/"
if [ -n "${SUTURE_NO_INSTALL-}" ]; then
    if [ -x "$to/node_modules/.bin/esbuild" ] && [ -d "$to/node_modules/three" ]; then
        touch "$to/installed"
        exit 0
    fi
    echo "suture: the report's npm packages are missing. Install them and build again:" >&2
    echo "    npm ci --ignore-scripts --prefix $to" >&2
    exit 1
fi
if ! npm ci --ignore-scripts --prefer-offline --no-audit --no-fund --loglevel=error --prefix "$to" \
    </dev/null >&2; then
    echo "suture: npm could not install the packages of $from/package-lock.json" >&2
    exit 1
fi
touch "$to/installed"
