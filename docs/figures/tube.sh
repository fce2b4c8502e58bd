#!/bin/sh
# Makes the pictures of docs/methods/tube.md anew, after the paper's figures: ./docs/figures/tube.sh, from
# any folder. SUTURE names another program than ./suture. Needs Debian's freecad-python3, python3-numpy and
# python3-pil.
set -eu
cd "$(dirname "$0")/../.."
suture=${SUTURE:-./suture}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
/usr/bin/python3 docs/figures/tube_models.py "$work" >/dev/null
cp docs/examples/suitcase_corner.step "$work/suitcase.step"

# fill MODEL NAME options...: the model's hole closed by a tube, in NAME.step
fill() {
    model=$1
    name=$2
    shift 2
    "$suture" fill "$work/$model.step" -o "$work/$name.step" --force --method tube --continuity G1 --angle 0.1 "$@" \
        >/dev/null || [ $? = 4 ]
}

# beside MODEL FIRST SECOND PICTURE NAMES options...
beside() {
    model=$1
    first=$2
    second=$3
    picture=$4
    names=$5
    shift 5
    docs/figures/render.py "$work/$model.step" "$work/$first.step" "docs/figures/$picture.png" \
        --beside "$work/$second.step" --names "$names" "$@"
}

# Figures 8, 9, 11 and 12: a five-sided hole between cylinders of radius 16, closed above their common point.
pole="--option pole=0,0,16 --option normal=0,0,1"
f2="$pole --option energy=F2"
fill pentagon great $f2 --option magnitude=10
fill pentagon none $f2 --option magnitude=0
fill pentagon faired $f2
fill pentagon moved $f2 --option move-pole=1
view="--view 0.5,-1,1.1 --near 0,0,12 --size 34"
beside pentagon great none tube_8_9 "tangents of 10,tangents of 0" $view
beside pentagon faired moved tube_11_12 "F2,F2 and the closing point moved" $view

# Figure 10: the corner of a suitcase with tangents given, and as the plate wants it.
fill suitcase given --option energy=F2 --option magnitude=4
fill suitcase plate
beside suitcase given plate tube_10 "tangents of 4,plate" --view 1.1,0.9,0.8 --near 54,44,34 --size 26 --zebra

# Figures 13 and 14: the corner of a house with tangents given, and bent at the closing point.
house="--option pole=-2.928932,0.857864,0.857864 --option normal=1.41421356,1,1 --option energy=F2"
fill house given $house --option magnitude=6
fill house bent $house --option curvature=-0.5
fill house hollow $house --option curvature=0.5
view="--view 1.2,0.5,0.9 --near=-3,0,0 --size 38"
beside house given bent tube_13_14 "tangents of 6,curvature -0.5" $view
beside house bent hollow tube_14 "curvature -0.5,curvature 0.5" $view
