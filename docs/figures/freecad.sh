#!/bin/sh
# Makes the pictures of docs/freecad.md anew: ./docs/figures/freecad.sh [PROGRAM], from any folder. It walks
# through FreeCAD's window on a screen of its own, as the test does. PROGRAM: by default what ./suture
# has built. Needs what ./test installs. Those in the repository are of FreeCAD 1.0:
#     tests/debian13/run.sh sh docs/figures/freecad.sh
set -eu
cd "$(dirname "$0")/../.."
program=${1:-$PWD/build/release/bin/suture}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
test=tests/plugin/test_gui.py
export SUTURE_SOURCE_DIR="$PWD" SUTURE_BINARY_DIR="$work" SUTURE_PROGRAM="$program" SUTURE_PICTURES="$work"
for case in a_user_closes_a_suitcase_corner_from_step_to_step failures_are_sentences_and_select_their_edges; do
    /usr/bin/python3 -B tests/support/run_python_test.py "$test" "Window.test_$case"
done
mv "$work/failures/refused.png" "$work/walk/9_refused.png"
for picture in "$work"/walk/*.png; do
    name=${picture##*/}
    mv "$picture" "docs/figures/freecad_${name#*_}"
done
