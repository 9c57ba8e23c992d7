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

# Stores into the refresh buffer, rows of the picture and what is taken at retrace, in order of time.
events() { # FROM FOR
    {
        "$KINESCOPE" trace $rom --what cpu --from "$1" --for "$2" |
            sed -n 's/^cpu \([0-9]*\) .* s[bhw] .* \[42\(......\)\]=.*/\1 store \2/p'
        "$KINESCOPE" trace $rom --what video --from "$1" --for "$2" |
            sed -n 's/^video \([0-9]*\) \(row [0-9]* begins\)$/\1 \2/p
                    s/^video \([0-9]*\) \(retrace base=\)/\1 \2/p'
    } 2>"$work/said" | sort -s -n -k1,1
}
events 2.1s 60ms >"$work/synced"
awk -f tests/roms/raster_tearing.awk "$work/synced" >"$work/said"
grep -qE '^fields [3-9], pages 2, turns [2-9], stores [0-9]{5,}, into the shown page 0, torn 0$' "$work/said"
report $? "with sync: two pages by turns, none is changed while it is shown"
events 1.1s 60ms >"$work/unsynced"
awk -f tests/roms/raster_tearing.awk "$work/unsynced" >"$work/said"
grep -qE '^fields [3-9], pages 1, turns 0, .*, torn [1-9]' "$work/said"
report $? "without sync: one page, changed behind the beam and before it"
# What tearing is, in a picture of three rows of 16 bytes.
printf '1 retrace base=0 pitch=16 format=8\n2 row 0 begins\n3 store 000001\n4 row 1 begins\n5 store 000020\n6 retrace base=0 pitch=16 format=8\n' |
    awk -v rows=3 -v size=48 -f tests/roms/raster_tearing.awk >"$work/said"
[ "$(cat "$work/said")" = "fields 2, pages 1, turns 0, stores 2, into the shown page 2, torn 1" ]
report $? "a torn field is told"

# ---- what is seen ---------------------------------------------------------------------------------------
# The t key: synced from the first turn on, and it stays so.
"$KINESCOPE" capture $rom --view raster --film --type t --at 1s --hash >"$work/said" 2>&1 &&
    cp "$work/said" "$work/first"
report $? "it is drawn"
"$KINESCOPE" capture $rom --view raster --film --type t --at 1s --hash >"$work/said" 2>&1
cmp -s "$work/said" "$work/first"
report $? "and the same twice"
for last in t tt; do
    "$KINESCOPE" trace $rom --what video --type $last --from 1s --for 60ms 2>"$work/said" |
        grep -c 'retrace base' >"$work/$last"
done
[ "$(cat "$work/t")" -ge 3 ] && [ "$(cat "$work/tt")" = 0 ]
report $? "t changes over, a second t back"
echo "1..$number"
exit $failed
