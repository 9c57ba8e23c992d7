#!/bin/sh
# What colour costs: changes × colour_switch, told by the trace and measured by the summary; and the
# command's --personality.
set -u
work=$TEST_OUT/colour_cost
mkdir -p "$work"
. tests/support/tap.sh

trace() { # PROGRAM OPTION...
    "$KINESCOPE" trace "$@" >"$work/trace" 2>"$work/said"
}
# Fetch time, ps, of the last word of the first refresh, the jump's address.
last() { sed -n 's/^dpu \([0-9]*\) .*/\1/p' "$work/trace" | tail -n 1; }
# How often the colour after a word is another than before it; green to begin with.
changes() {
    sed -n 's/^dpu .* COLOUR=\([a-z]*\)$/\1/p' "$work/trace" |
        awk 'BEGIN { was = "green" } $1 != was { n++; was = $1 } END { print n + 0 }'
}

for program in colours:3 unsorted:92; do
    name=${program%:*}
    trace "roms/$name.df"
    with=$(last)
    count=$(changes)
    echo "$count changes" >"$work/said"
    [ "$count" -eq "${program#*:}" ]
    report $? "$name.df changes the colour ${program#*:} times in its first refresh"
    trace "roms/$name.df" --set colour_switch=0
    [ $((with - $(last))) -eq $((count * 100000000)) ]
    report $? "$name.df: the changes take 100 us each and nothing else does"
    trace "roms/$name.df" --set colour_switch=35us
    without=$(last)
    [ $((with - without)) -eq $((count * 65000000)) ]
    report $? "$name.df: or as long as --set colour_switch says"
done

# Same strokes in both, whatever their order: place, drive and colour.
for name in colours unsorted; do
    "$KINESCOPE" trace "roms/$name.df" --what beam --for 50ms |
        awk '$1 == "s" { print $4, $5, $6, $7, $8, $10 }' | sort >"$work/$name.strokes"
done
sort -u "$work/colours.strokes" >"$work/colours.all"
sort -u "$work/unsorted.strokes" | comm -3 - "$work/colours.all" >"$work/said"
[ "$(wc -l <"$work/colours.all")" -gt 4000 ] && [ ! -s "$work/said" ]
report $? "both draw the same picture"

"$KINESCOPE" trace roms/unsorted.df --summary >"$work/said" 2>&1
grep -qE '^ *colours +92 a refresh, with the beam off for 9\.200 ms' "$work/said"
report $? "the summary tells"
"$KINESCOPE" trace roms/lander.df --summary >"$work/said" 2>&1
grep -q strokes "$work/said" && ! grep -q colours "$work/said"
report $? "but not where there are none"
fits() { "$KINESCOPE" trace "roms/$1.df" --summary --for 0.2s >"$work/said" 2>&1; }
fits colours
grep -q 'the refresh fits' "$work/said" && grep -qE '^ *refresh rate +60 Hz' "$work/said"
report $? "sorted, it is refreshed at every tick"
fits unsorted
grep -q 'refreshes exceed it' "$work/said" && grep -qE '^ *refresh rate +30 Hz' "$work/said"
report $? "unsorted, at every second"

# In the steady state the sorted one changes four times, at its begin from red to green, too.
trace roms/colours.df --for 66ms
[ "$(changes)" -eq 11 ]
report $? "sorted: four changes a refresh from the second on, 3 + 4 + 4"

# Personality: by the tube, or as said; a VT11 ignores the words.
trace roms/colours.df --personality vt11
vt11=$(last)
! grep -q COLOUR "$work/trace"
report $? "a VT11 traces no colour"
trace roms/colours.df --set colour_switch=0
[ "$vt11" = "$(last)" ]
report $? "and takes no time for it"
trace roms/colours.df --tube VR17
! grep -q COLOUR "$work/trace"
report $? "on a tube of one colour the display processor is a VT11 by default"
trace roms/colours.df --tube VR17 --personality vs60
grep -q 'COLOUR=red$' "$work/trace" && [ "$vt11" = "$(last)" ]
report $? "with --personality vs60 it has colours there, which take no time"
trace roms/lander.df --what beam --for 50ms
grep -q '^s ' "$work/trace" && ! grep -qE ' (red|orange|yellow|green)$' "$work/trace"
report $? "strokes of a VT11 have no level"
trace roms/colours.df --personality vt12 && false
[ $? -ne 0 ] && grep -q 'vt11' "$work/said"
report $? "no other personality"

# A recording has the colours in it.
"$KINESCOPE" trace roms/colours.df --what beam --for 70ms -o "$work/colours.beam" >"$work/said" 2>&1 &&
    "$KINESCOPE" capture "$work/colours.beam" --at 60ms --film --hash -o "$work/beam.png" >"$work/hash" 2>>"$work/said" &&
    "$KINESCOPE" capture roms/colours.df --at 60ms --film --hash -o "$work/df.png" >>"$work/hash" 2>>"$work/said"
[ "$(sort -u "$work/hash" | wc -l)" -eq 1 ] && [ "$(wc -l <"$work/hash")" -eq 2 ]
report $? "a recording gives the same film as its program"

# Words, text and words again.
"$KINESCOPE" asm roms/unsorted.df -o "$work/a.oct" >"$work/said" 2>&1 &&
    "$KINESCOPE" disasm "$work/a.oct" >"$work/a.df" 2>>"$work/said" &&
    "$KINESCOPE" asm "$work/a.df" -o "$work/b.oct" >>"$work/said" 2>&1 &&
    grep -q 'colour  *orange' "$work/a.df" && cmp -s "$work/a.oct" "$work/b.oct"
report $? "disassembled and assembled again, the words are the same"

"$KINESCOPE" capture roms/colours.df --phosphor P31 -o "$work/x.png" >"$work/said" 2>&1
[ $? -ne 0 ] && grep -q 'needs a phosphor of two layers' "$work/said"
report $? "a phosphor of one layer is refused"
"$KINESCOPE" trace roms/colours.df --set kv_red=9 >"$work/said" 2>&1
[ $? -eq 2 ] && grep -q 'they must rise' "$work/said"
report $? "voltages must rise"

echo "1..$number"
exit $failed
