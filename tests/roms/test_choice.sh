#!/bin/sh
# Menus in the machine (roms/choice.elf): stylus, finger, pen, mouse and keys each choose what roms/choice.script
# means them to; a light pen finds its place on black by the blue field, and not without.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/choice
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

choose() { # SCRIPT TIME
    "$KINESCOPE" run roms/choice.elf --headless --console --input "$1" --for "$2" 2>"$work/errors" </dev/null |
        tr -d '\r' >"$work/said"
}

choose roms/choice.script 12.5s
printf '%s\n' 'Transfer by TABLET' 'Turned by TABLET' 'PROBE by TOUCH' 'Sun panels by TOUCH' 'Antenna by PEN' \
    'Beacon by PEN' 'Attitude by MOUSE' 'Camera by PEN' 'Engine by KEYS' 'SIGNALS by KEYS' >"$work/expected"
sed -n 's/^choice: \(.* by [A-Z]*\):.*/\1/p' "$work/said" | cmp -s - "$work/expected"
report $? "every device, the pens of both heads too, chooses what it points at"

# Pressed on black at dot 102, line 280: nothing; with the blue field within three pixels.
cat >"$work/black.script" <<'END'
at 0.5s key 3
at 1s pen raster move 102 280
+0.1s pen raster tap in 0.3s
END
choose "$work/black.script" 2s
! grep -q 'by PEN' "$work/said"
report $? "on black a light pen has no place"
cat >>"$work/black.script" <<'END'
at 2s key B
at 2.5s pen raster tap in 0.3s
at 3.2s pen raster away
at 4s pen raster move 250 330
pen raster tap in 0.2s
END
choose "$work/black.script" 5s
sed -n 's/^choice: Place by PEN: dot \([0-9]*\) line \([0-9]*\) .*/\1 \2/p' "$work/said" |
    awk 'NR == 1 { ok = near($1 - 5, 102) && near($2, 280) } NR == 2 { ok = ok && near($1 - 5, 250) && near($2, 330) }
         END { exit !(ok && NR == 2) }
         function near(a, b) { return a - b <= 3 && b - a <= 3 }'
report $? "the blue field finds it, a tap of 0.2 s as well"
echo "1..$number"
exit $failed
