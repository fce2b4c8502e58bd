#!/bin/sh
# Makes every picture of docs/figures anew: ./docs/figures/make.sh, from any folder. Needs, besides what
# ./suture installs, Debian's freecad-python3, python3-numpy and python3-pil.
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture EXAMPLE NAME options...: the example before and after `suture fill`
picture() {
    example=$1
    name=$2
    shift 2
    ./suture fill "docs/examples/$example.step" -o "$work/$example.step" --force >/dev/null
    docs/figures/render.py "docs/examples/$example.step" "$work/$example.step" "docs/figures/$name.png" "$@"
}

picture dome_window extend
picture box_without_lid plane
picture suitcase_corner mvs --zebra --view 1.1,0.9,0.8 --near 54,44,34 --size 26
