#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# describe.sh SUTURE TO: man pages and completions, from the program's own definitions.
set -eu
suture=$1
to=$2
share=$to/share
rm -rf "$share"
mkdir -p "$share/man/man1" "$share/bash-completion/completions" "$share/zsh/vendor-completions" \
    "$share/fish/vendor_completions.d"
"$suture" describe man | gzip -9n >"$share/man/man1/suture.1.gz"
for command in $("$suture" describe commands); do
    "$suture" describe man "$command" | gzip -9n >"$share/man/man1/suture-$command.1.gz"
done
"$suture" describe bash >"$share/bash-completion/completions/suture"
"$suture" describe zsh >"$share/zsh/vendor-completions/_suture"
"$suture" describe fish >"$share/fish/vendor_completions.d/suture.fish"
touch "$to/stamp"
