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

# beside MODEL NAME options...: reflection lines on two fills of a model, by mvs and by OCCT
beside() {
    model=$1
    name=$2
    shift 2
    ./suture fill "$model" -o "$work/mvs.step" --force --method mvs --continuity G1 >/dev/null || [ $? = 4 ]
    ./suture fill "$model" -o "$work/occt.step" --force --method occt --continuity G1 >/dev/null || [ $? = 4 ]
    docs/figures/render.py "$model" "$work/mvs.step" "docs/figures/$name.png" --zebra \
        --beside "$work/occt.step" --names "mvs,OCCT's filling" "$@"
}

/usr/bin/python3 docs/examples/make_examples.py "$work" half_round >/dev/null
beside docs/examples/suitcase_corner.step zebra_corner --view 1.1,0.9,0.8 --near 54,44,34 --size 26
beside docs/examples/dome_window.step zebra_dome --view 0.3,-0.5,1 --near 0,0,46 --size 34
beside docs/examples/bump_window.step zebra_bump --view 0.3,-0.5,1 --near 0,0,22 --size 56 --stripes 50
beside docs/examples/pipe_elbow.step zebra_elbow --view 0.6,-1,-0.5
beside "$work/half_round.step" zebra_half_round --view 1,-0.6,0.5 --near 0,0,30 --size 50

# The maps of docs/methods/concentric.md, by a program that the tests build.
build=${SUTURE_BUILD:-build/release}
"$build/tests/kernel/core/concentric/suture_concentric_maps" | docs/figures/concentric.py docs/figures
docs/figures/concentric_caps.py ./suture docs/figures/concentric_caps.png

# Those of docs/methods/tube.md.
docs/figures/tube.sh

# The patches of docs/methods/manifold.md.
docs/figures/patches.py ./suture docs/figures/manifold.png

# The paper's two surfaces of docs/methods/algebraic.md.
docs/figures/algebraic.py ./suture docs/figures/algebraic.png

# The lost face of docs/methods/recognise.md.
docs/figures/recognised.py ./suture docs/figures/recognised.png

# Those of docs/borders.md.
docs/figures/borders.sh
