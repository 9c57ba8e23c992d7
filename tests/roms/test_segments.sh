#!/bin/sh
# The segmented display file in the machine: its properties under random operations; and, from outside,
# that each refresh draws each segment wholly old or wholly new while firmware moves, makes and deletes
# them (lesson "segments"), and that nothing is stored into the page of pixels that is shown.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/segments
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

"$KINESCOPE" run tests/roms/check_segments.elf --headless --console --for 3s >"$work/said" 2>&1 </dev/null
status=$?
[ $status = 0 ] && [ "$(tr -d '\r' <"$work/said" | grep -c ': holds$')" = 6 ]
report $? "random operations while the display processor runs: six properties hold"

# ---- both processors' accesses to display memory, by time -------------------------------------------------
accesses() { # PROGRAM KEYS FROM FOR
    {
        "$KINESCOPE" trace "$1" --type "$2" --what cpu --from "$3" --for "$4" |
            sed -n 's/^cpu \([0-9]*\) .* sh .* \[4100\(....\)\]=.*/\1 \2/p' |
            awk '{ printf "%s store %o\n", $1, hex($2) }
                 function hex(text,    n, i) {
                     for (i = 1; i <= length(text); i++)
                         n = n * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
                     return n
                 }'
        "$KINESCOPE" trace "$1" --type "$2" --what dpu --from "$3" --for "$4" |
            sed -n 's/^dpu \([0-9]*\) DPC=\([0-7]*\) WORD=\([0-7]*\) .*/\1 fetch \2 \3/p'
    } 2>"$work/said" | sort -s -n -k1,1
}
low=$((0140400 + 10)) # STAGE_FREE_LOW, and behind the root and the end
accesses roms/monitor.elf 'lesson segments\n' 3s 150ms >"$work/lesson"
awk -v low=$low -f tests/roms/segments.awk "$work/lesson" >"$work/said"
grep -qE '^refreshes [0-9]{1,}, segments drawn [0-9]{2,}, stores [0-9]{4,}, torn 0, entered elsewhere 0$' \
    "$work/said"
report $? "lesson: each segment is drawn wholly old or wholly new"
accesses tests/roms/check_segments.elf '\\n' 200ms 150ms >"$work/check"
awk -v low=$low -f tests/roms/segments.awk "$work/check" >"$work/said"
grep -qE '^refreshes [0-9]{1,}, segments drawn [0-9]{2,}, stores [0-9]{4,}, torn 0, entered elsewhere 0$' \
    "$work/said"
report $? "random operations: each segment is drawn wholly old or wholly new"
# What tearing is: a word stored within a segment that is being drawn; a segment entered in its middle.
printf '%s\n' '1 fetch 000000 170004' '2 fetch 140412 117124' '3 store 140414' '4 fetch 140414 117400' \
    '5 fetch 140416 160000' '6 store 140420' '7 fetch 140420 140404' '8 fetch 140404 114124' \
    '9 fetch 140426 040001' '10 fetch 140430 160000' '11 fetch 140432 140404' '12 fetch 000000 170004' |
    awk -v low=$low -f tests/roms/segments.awk >"$work/said"
[ "$(cat "$work/said")" = "refreshes 2, segments drawn 2, stores 2, torn 1, entered elsewhere 1" ]
report $? "torn segments are told"

# ---- pixels ---------------------------------------------------------------------------------------------------
{
    "$KINESCOPE" trace roms/monitor.elf --type 'lesson segments\n' --what cpu --from 3s --for 70ms |
        sed -n 's/^cpu \([0-9]*\) .* s[bhw] .* \[42\(......\)\]=.*/\1 store \2/p'
    "$KINESCOPE" trace roms/monitor.elf --type 'lesson segments\n' --what video --from 3s --for 70ms |
        sed -n 's/^video \([0-9]*\) \(row [0-9]* begins\)$/\1 \2/p
                s/^video \([0-9]*\) \(retrace base=\)/\1 \2/p'
} 2>"$work/said" | sort -s -n -k1,1 >"$work/pixels"
awk -v rows=480 -v size=307200 -f tests/roms/raster_tearing.awk "$work/pixels" >"$work/said"
grep -qE '^fields [3-9], pages 2, turns [1-9], stores [0-9]{5,}, into the shown page 0, torn 0$' "$work/said"
report $? "lesson: two pages by turns, none is changed while it is shown"
echo "1..$number"
exit $failed
