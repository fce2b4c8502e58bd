#!/bin/sh
# Makes the pictures of docs/borders.md anew: ./docs/figures/borders.sh, from any folder. SUTURE names another
# program than ./suture. Needs Debian's freecad-python3, python3-numpy and python3-pil.
set -eu
cd "$(dirname "$0")/../.."
suture=${SUTURE:-./suture}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
/usr/bin/python3 docs/figures/border_models.py "$work" >"$work/chosen"

# chosen MODEL: the numbers of what is chosen of it
chosen() { sed -n "s/^$1 //p" "$work/chosen"; }

# picture MODEL VIEW COMMAND options...: before and after
picture() {
    model=$1
    view=$2
    command=$3
    shift 3
    "$suture" "$command" "$work/$model.step" -o "$work/${model}_after.step" "$@" >/dev/null
    docs/figures/render.py "$work/$model.step" "$work/${model}_after.step" "docs/figures/border_$model.png" \
        "--view=$view"
}

picture sheets 0.5,-0.6,1 fill --no-sew --boundary "$(chosen sheets)"
picture elbow 0.5,-1,0.5 bridge --edges "$(chosen elbow)"
picture corner 1,0.9,0.8 fill --replace-faces "$(chosen corner)"
picture fillet 1,0.9,0.8 fill --remove-faces "$(chosen fillet)"
picture leaning 0.5,-1,0.6 fill --no-sew --boundary "$(chosen leaning)" --support "$(chosen leaning)=1"
picture curve 0.5,-1,0.6 fill --through-edges "$(chosen curve)"
picture tin 1,-0.4,0.5 fill --merge
picture hull -0.8,-1,1.2 fill --all-loops --split auto
