#!/bin/sh
# Stepping in the window: Right Ctrl with Left goes back by a refresh, a display word, an instruction; what is
# shown then is what an uninterrupted run shows at that instant. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
roms=$(cd "$(dirname "$0")/../../roms" && pwd)
work=$TEST_OUT/window_step
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"

until_true 20 xdotool getdisplaygeometry
report $? "the virtual X server answers"
"$KINESCOPE" run "$roms/clock.elf" --size 400x400 --time-scale 0.5 2>log &
viewer=$!
until_true 30 title clock.elf
report $? "a window opens, named after the firmware"
xdotool mousemove 200 200
xdotool windowfocus "$(title clock.elf | tail -n 1)" 2>/dev/null
sleep 3
shots=0
# shoot: a screenshot; $shot is its name, $at its time.
shoot() {
    shots=$((shots + 1))
    shot=kinescope-$(printf %03d $shots).png
    press F12
    until_true 10 test -s "$shot"
    sleep 0.3
    at=$(tag "Simulated time" "$shot")
}
# apart A B LOW HIGH: A is later than B by LOW to HIGH seconds.
apart() { echo "$1 $2 $3 $4" | awk '{ d = $1 - $2; exit !(NF == 4 && d >= $3 && d <= $4) }'; }
# as_it_was: the screenshot is the offscreen picture of that instant.
as_it_was() {
    "$KINESCOPE" capture "$roms/clock.elf" --at "${at}s" --exposure "$(tag Exposure "$shot")s" --size 400x400 \
        -o offscreen.png && "$KINESCOPE" compare "$shot" offscreen.png --tolerance 2 >/dev/null
}

press F5
shoot
paused=$at
chord Left
shoot
first=$at
apart "$paused" "$first" 0 0.034
report $? "back by a refresh, from $paused s to $first s"
as_it_was
report $? "it is shown as it was then"
for i in 1 2 3; do chord Left; done
shoot
apart "$first" "$at" 0.049 0.051
report $? "three more are three ticks"
as_it_was
report $? "it is shown as it was then, too"
for i in 1 2 3; do chord Right; done
shoot
[ "$at" = "$first" ] && "$KINESCOPE" compare kinescope-002.png "$shot" >/dev/null
report $? "forward again: the same instant, the same picture"
chord w
chord Left
shoot
apart "$first" "$at" 0 0.0002
report $? "back by a display word"
word=$at
chord Left
shoot
apart "$word" "$at" 0.0000001 0.0002
report $? "and by another"
chord Right
shoot
[ "$at" = "$word" ]
report $? "forward by one: the same instant"
chord w
chord Left
shoot
before=$at
chord Left
shoot
apart "$before" "$at" 0.00000001 0.017
report $? "back by an instruction"
chord Right
shoot
[ "$at" = "$before" ]
report $? "forward by one: the same instant again"
kill -0 $viewer
report $? "the window is still there"
chord q
tries=0
while kill -0 $viewer 2>/dev/null && [ $tries -lt 50 ]; do sleep 0.1 && tries=$((tries + 1)); done
wait $viewer
report $? "it ends with status 0"
viewer=

# The raster head alone: Right Ctrl with S has nothing to skip, and the window stays alive.
"$KINESCOPE" run "$roms/palette.elf" --size 400x300 --time-scale 0.5 2>log &
viewer=$!
until_true 30 title palette.elf
report $? "a window with the raster head alone"
xdotool mousemove 200 150
xdotool windowfocus "$(title palette.elf | tail -n 1)" 2>/dev/null
sleep 4
press F5
shoot
before=$at
chord s
shoot
apart "$at" "$before" -0.001 0.02
report $? "skipping dark time does not run on: from $before s to $at s"
chord q
tries=0
while kill -0 $viewer 2>/dev/null && [ $tries -lt 50 ]; do sleep 0.1 && tries=$((tries + 1)); done
wait $viewer
report $? "it ends with status 0, too"
viewer=
[ ! -s log ] || sed 's/^/# /' log
[ ! -s log ]
report $? "nothing was complained about"
finish
