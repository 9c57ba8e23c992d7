#!/bin/sh
# Both pens pick in the village (roms/pick.elf): what is said on the console is what the script points at.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/pick
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

"$KINESCOPE" run roms/pick.elf --input roms/pick.script --headless --console --for 40s \
    </dev/null 2>&1 | tr -d '\r' >"$work/said"
[ "$(tail -n 1 "$work/said")" = "pick ends" ]
report $? "the script ends the program by its light button"

# What was selected and dropped, without places.
sed -n 's/^\(pick\|drop\) \(vector\|raster\) \(.*\) at .*/\1 \2 \3/p; s/^\(pick [a-z]* nothing\)$/\1/p' \
    "$work/said" >"$work/picked"
cat >"$work/expected" <<'END'
pick vector lamp 2 (light)
pick vector clock 1 (face)
pick vector boat 2 (sail)
drop vector clock 1 (face)
pick vector nothing
pick vector door 1 (wood)
pick raster cloud 1
pick raster sun 1 (disc)
pick raster nothing
pick raster house 1
pick raster right window 1 (pane)
drop raster cloud 1
pick raster car 1 (body)
pick vector button forget
pick vector button end
END
diff "$work/expected" "$work/picked" >"$work/said.diff"
status=$?
[ $status = 0 ] || cp "$work/said.diff" "$work/said"
report $status "each press picks what is there, on both heads, and nothing in the dark"

# Places: within what the pen sees, 3 mm, of where it points; stage units.
near() { # LINE X Y UNITS
    awk -v line="$1" -v x="$2" -v y="$3" -v most="$4" '
        index($0, line) == 1 { dx = $(NF - 1) - x; dy = $NF - y; found = dx * dx + dy * dy <= most * most }
        END { exit !found }' "$work/said"
}
near "pick vector boat" 1032 300 10 && near "pick vector door" 295 330 10
report $? "vector head: XPR and YPR are where the pen points"
near "pick raster sun" 1080 690 4 && near "pick raster house" 230 270 4 && near "pick raster cloud" 250 690 4
report $? "raster head: so are line and dot, less the delay"
echo "1..$number"
exit $failed
