#!/bin/sh
# demo.sh KINESCOPE — the tour in a window when there is a display; otherwise its pictures as PNGs.
set -eu
kinescope=$1
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && "$kinescope" run --tour; then
    exit 0
fi
out=o/demo
mkdir -p $out
echo "No display: writing the tour's pictures into $out/"
while IFS='|' read -r name program tube at head <&3; do
    name=$(echo "$name" | tr -d ' ')
    case "$name" in '' | '#'*) continue ;; esac
    program=$(echo "$program" | tr -d ' ')
    at=$(echo "$at" | tr -d ' ')
    set -- --at "$at"
    [ "$at" = end ] && set --
    case "$head" in *input*) set -- "$@" --input "${program%.*}.script" --view both --size 1200x600 ;; *) set -- "$@" --size 1024x1024 ;; esac
    # shellcheck disable=SC2086
    "$kinescope" capture $program --tube $tube "$@" -o "$out/$name.png"
    echo "  $out/$name.png"
done 3<tests/golden/list.txt
