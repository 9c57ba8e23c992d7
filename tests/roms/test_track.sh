#!/bin/sh
# The tracking cross in the machine (roms/track.elf): the script's course, the static error, and how fast the
# pen may go at 30, 40 and 60 refreshes a second.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/track
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

track() { # SCRIPT OPTIONS…: what is said on the console goes to $work/said
    script=$1
    shift
    "$KINESCOPE" run roms/track.elf --input "$script" --headless --console --for 60s "$@" </dev/null 2>&1 |
        tr -d '\r' >"$work/said"
}

track roms/track.script
grep -v 'rests\|tip' "$work/said" | sed 's/ at .*//; s/refreshes.*found/found/; s/speed .*/speed/' >"$work/course"
[ "$(tr '\n' ';' <"$work/course")" = "track following;track searching;track lost;track following;track \
searching;track lost;track scans;track following;track found 3, lost 2;track greatest speed;" ]
report $? "taken up, lost by a flick, taken up again; lost, and found by a scan"
awk '/greatest/ { exit !($4 >= 480 && $4 <= 520) }' "$work/said"
report $? "the circle at 500 mm/s is followed at 500 mm/s"
grep -q '^track tip down at' "$work/said" && grep -q '^track tip up at' "$work/said"
report $? "the tip switch is told"

# Where it rests: the script's places, head units.
awk 'BEGIN { n = 0 }
     /rests/ { sub(",", "", $5); x[n] = $4; y[n] = $5; lx[n] = $8; ly[n] = $9; n++ }
     END {
         split("516 772 720 723 180 420", px); split("510 512 420 423 640 640", py)
         for (i = 0; i < n; i++) {
             near = 0
             for (k = 1; k <= 6; k++)
                 if ((x[i] - px[k]) ^ 2 + (y[i] - py[k]) ^ 2 <= 1.5 ^ 2 * 1.001) {
                     near++
                     late += (px[k] - lx[i]) + (py[k] - ly[i])
                 }
             good += near == 1
         }
         printf "%d of %d places, one way is late by %.1f\n", good, n, late / 2 / n
         exit !(good == n && n >= 5 && late / 2 / n > 4 && late / 2 / n < 9)
     }' "$work/said" >"$work/rests"
status=$?
cat "$work/rests" >>"$work/said"
report $status "static error 1.5 units at most; 4 to 9 each way with strokes of one way only"

# ---- how fast -----------------------------------------------------------------------------------------------
# To and fro across 700 units, 160.6 mm, each way within so many us.
sweep() { # MM_A_SECOND
    us=$((160600000 / $1))
    {
        echo "at 0.3s pen move 512 512"
        echo "+0.4s pen move 862 512 in $((us / 2))us"
        echo "pen move 162 512 in ${us}us"
        echo "pen move 862 512 in ${us}us"
        echo "pen move 162 512 in ${us}us"
        echo "+0.2s key q"
    } >"$work/sweep.script"
}
for case in 30:500:900 40:650:1200 60:1100:1800; do
    hz=${case%%:*}
    rest=${case#*:}
    slow=${rest%%:*}
    fast=${rest#*:}
    sweep "$slow"
    track "$work/sweep.script" --refresh "$hz"
    grep -q 'lost 0$' "$work/said" &&
        awk -v v="$slow" '/greatest/ { exit !($4 >= 0.9 * v && $4 <= 1.1 * v) }' "$work/said"
    report $? "$hz refreshes a second: $slow mm/s is followed, from rest and turning round"
    sweep "$fast"
    track "$work/sweep.script" --refresh "$hz"
    grep -q '^track lost' "$work/said"
    report $? "$hz refreshes a second: $fast mm/s is too fast"
done
# In the window the mouse begins as what the firmware names: its text is there, however short it is.
for name in track pick calibrate; do
    grep -q kinescope_hand "roms/$name.elf"
    report $? "$name.elf says what the mouse stands for"
done
echo "1..$number"
exit $failed
