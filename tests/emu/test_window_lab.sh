#!/bin/sh
# The flicker laboratory in the window: shutter, steps by strokes and scan lines, photodiode, why, pictures without
# flashes; figures and pictures are those of the command line. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
roms=$(cd "$(dirname "$0")/../../roms" && pwd)
work=$TEST_OUT/window_lab
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"

open_window() { # PROGRAM OPTIONS...
    program=$1
    shift
    "$KINESCOPE" run "$roms/$program" --size 300x300 "$@" 2>>log &
    viewer=$!
    until_true 30 title "$program"
    report $? "$program: a window opens"
    xdotool mousemove 150 150
    xdotool windowfocus "$(title "$program" | tail -n 1)" 2>/dev/null
}
close_window() {
    quick q
    wait $viewer
    report $? "$program: Right Ctrl Q ends it with status 0"
    viewer=
}
quick() { # KEY...: chords without long waits between them
    for key; do
        xdotool keydown Control_R key "$key" keyup Control_R
        sleep 0.1
    done
}
shots=0
# shoot: a screenshot; $shot is its name without .png, $at its time, $exposure its exposure.
shoot() {
    shots=$((shots + 1))
    shot=kinescope-$(printf %03d $shots)
    xdotool key F12
    until_true 5 test -s "$shot.png" || return
    at=$(tag "Simulated time" "$shot.png")
    exposure=$(tag Exposure "$shot.png")
}
# within A B PART: the numbers differ by less than that part of the second, and are there.
within() { echo "$1 $2 $3" | awk '{ d = $1 - $2; exit !(NF == 3 && (d < 0 ? -d : d) <= $3 * $2) }'; }
figure() { sed -n "s/.*\"$1\": \\([-0-9.e]*\\).*/\\1/p" "$2"; }

# ---- shutter, strokes, photodiode: a display file

open_window lander.df --tube VR17/P31 --set pen=none --shutter 50ms
sleep 0.7
for i in 1 2 3 4 5 6 7 8; do
    shoot
    within "$exposure" 0.05 0.15 && break
    sleep 0.3
done
within "$exposure" 0.05 0.15
report $? "a long shutter puts pictures together: $exposure s"
xdotool key F5
xdotool key F4
xdotool mousemove 193 250 click 1
sleep 0.3
shoot
test -s "$shot-probe.json" && test -s "$shot-probe.png"
report $? "with the photodiode on the glass a screenshot has figures and a curve beside it"
json=$shot-probe.json
"$KINESCOPE" probe "$roms/lander.df" --tube VR17/P31 --set pen=none --at "$(figure x "$json"),$(figure y "$json")" \
    --from "$(figure from_s "$json")s" --to "$(figure to_s "$json")s" >headless.json
same=0
for key in fundamental_hz c1 percent_flicker flicker_index mean_cd_m2 peak_cd_m2 cff_hz persistence_10_s; do
    within "$(figure $key "$json")" "$(figure $key headless.json)" 0.01 || same=1
done
[ $same -eq 0 ] && within "$(figure fundamental_hz "$json")" 60 0.001
report $? "the figures are those of kinescope probe"
quick Left
shoot
[ "$exposure" = 0.05 ] &&
    "$KINESCOPE" capture "$roms/lander.df" --tube VR17/P31 --set pen=none --at "${at}s" --exposure 50ms \
        --size 300x300 -o exact.png && "$KINESCOPE" compare "$shot.png" exact.png --tolerance 2 >/dev/null
report $? "after a step the shutter's time is exact, and the picture that of capture --exposure"
xdotool key F4
before=$at
quick w w Left
shoot
stroke=$at
quick Left Right
shoot
echo "$before $stroke" | awk '{ exit !($1 > $2 && $1 - $2 < 0.001) }' && [ "$at" = "$stroke" ]
report $? "a stroke back from $before s to $stroke s, another, and forward again"
close_window

# ---- why, scan lines: the raster head

open_window mask.elf --time-scale 0.2
sleep 1.5
xdotool mousemove 150 150 keydown Control_R click 1 keyup Control_R
sleep 0.4
xdotool key Escape
shoot
before=$at
quick w w Right Right
shoot
first=$at
quick Left
shoot
"$KINESCOPE" trace "$roms/mask.elf" --what video --for 40ms 2>/dev/null |
    awk '$3 == "hsync" && $4 == "high" { if (n++) print $2 - t; t = $2 }' | sort -n | tail -n 1 >line
echo "$first $at $(cat line)" | awk '{ d = ($1 - $2) * 1e12 - $3; exit !(NF == 3 && d < 2 && d > -2) }'
report $? "Right Ctrl with a click pauses; a scan line back is a scan line's time: $first s, $at s"
echo "$before $first" | awk '{ exit !($2 > $1 && $2 - $1 < 0.001) }'
report $? "and two forward from where it paused are less than a millisecond"
close_window

# ---- nothing flashes

# The mean light, three times in a row once it has come up: of a refresh in eight pictures seven are dark.
open_window rose.df --tube VR17/P31 --set pen=none --refresh 8 --no-flash
"$KINESCOPE" capture "$roms/rose.df" --tube VR17/P31 --set pen=none --refresh 8 --at 3s --exposure 1s \
    --size 300x300 -o mean.png
sleep 1.5
row=0
for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14; do
    shoot
    if "$KINESCOPE" compare "$shot.png" mean.png --tolerance 26 >/dev/null; then
        row=$((row + 1))
    else
        row=0
    fi
    [ $row -lt 3 ] || break
    sleep 0.1
done
[ $row -eq 3 ]
report $? "--no-flash: of 8 refreshes a second the mean light is seen, always"
close_window
[ ! -s log ] || sed 's/^/# /' log
[ ! -s log ]
report $? "nothing was complained about"
"$KINESCOPE" run "$roms/lander.df" --shutter 2s 2>usage
[ $? -eq 2 ] && grep -q '1us to 1s' usage
report $? "a shutter has limits"
finish
