#!/bin/sh
# A moving picture on the raster head (roms/pageflip): with sync nothing is stored into the page that is
# shown, and the pages take turns field by field; without it pixels change while the beam is on them.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/raster_tearing
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh
rom=roms/pageflip.elf

# A field and a little: from 1 ms before the first retrace after T, in ms.
around() { # T
    "$KINESCOPE" trace $rom --what video --from "$1ms" --for 18ms 2>"$work/said" |
        awk '$3 == "retrace" && !done { printf "%.3fms\n", $2 / 1e9 - 1; done = 1 }'
}
# Stores into the refresh buffer, rows of the picture and what is taken at retrace, in order of time.
events() { # FROM
    {
        "$KINESCOPE" trace $rom --what cpu --from "$1" --for 18ms |
            sed -n 's/^cpu \([0-9]*\) .* s[bhw] .* \[42\(......\)\]=.*/\1 store \2/p'
        "$KINESCOPE" trace $rom --what video --from "$1" --for 18ms |
            sed -n 's/^video \([0-9]*\) \(row [0-9]* begins\)$/\1 \2/p
                    s/^video \([0-9]*\) \(retrace base=\)/\1 \2/p'
    } 2>"$work/said" | sort -s -n -k1,1
}
events "$(around 2500)" >"$work/synced"
awk -f tests/roms/raster_tearing.awk "$work/synced" >"$work/said"
grep -qE '^fields 2, pages 2, turns 1, stores [0-9]{5,}, into the shown page 0, torn 0$' "$work/said"
report $? "with sync: two pages by turns, none is changed while it is shown"
events "$(around 1080)" >"$work/unsynced"
awk -f tests/roms/raster_tearing.awk "$work/unsynced" >"$work/said"
grep -qE '^fields 2, pages 1, turns 0, .*, torn 1' "$work/said"
report $? "without sync: one page, changed behind the beam and before it"
# What tearing is, in a picture of three rows of 16 bytes.
printf '%s\n' '1 retrace base=0 pitch=16 format=8' '2 row 0 begins' '3 row 1 begins' '4 store 000001' \
    '5 store 000020' '6 retrace base=0 pitch=16 format=8' '7 row 0 begins' '8 store 000030' |
    awk -v rows=3 -v size=48 -f tests/roms/raster_tearing.awk >"$work/said"
[ "$(cat "$work/said")" = "fields 2, pages 1, turns 0, stores 3, into the shown page 2, torn 1" ]
report $? "a torn field is told"

# ---- what is seen ---------------------------------------------------------------------------------------
# The t key: synced from the first turn on, and it stays so.
"$KINESCOPE" capture $rom --view raster --film --type t --at 1s --hash >"$work/said" 2>&1 &&
    cp "$work/said" "$work/first"
report $? "it is drawn"
"$KINESCOPE" capture $rom --view raster --film --type t --at 1s --hash >"$work/said" 2>&1
cmp -s "$work/said" "$work/first"
report $? "and the same twice"
for keys in t tt; do
    "$KINESCOPE" trace $rom --what video --type $keys --from 1s --for 60ms 2>"$work/said" |
        sed -n 's/.* retrace base=\([0-9a-f]*\) .*/\1/p' | sort -u | wc -l >"$work/$keys"
done
[ "$(cat "$work/t")" -eq 2 ] && [ "$(cat "$work/tt")" -eq 1 ]
report $? "t changes over, a second t back"
echo "1..$number"
exit $failed
