#!/bin/sh
# demo.sh KINESCOPE — the tour in a window when there is a display; otherwise its pictures as PNGs.
set -eu
kinescope=$1
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && "$kinescope" run; then
    exit 0
fi
out=o/demo
mkdir -p $out
echo "No display: writing the tour's pictures into $out/"
sed -e 's/#.*//' tests/golden/list.txt | while IFS='|' read -r name program options; do
    name=$(echo "$name" | tr -d ' ')
    [ -n "$name" ] || continue
    # shellcheck disable=SC2086
    "$kinescope" capture $program $options --size 1024x1024 -o "$out/$name.png"
    echo "  $out/$name.png"
done
