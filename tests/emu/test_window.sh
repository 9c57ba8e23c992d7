#!/bin/sh
# The window under a virtual X server: its screenshot is the offscreen picture of the same instant, keys
# do what the help says, a changed file is loaded again. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
programs=$(cd "$(dirname "$0")/../programs" && pwd)
work=$TEST_OUT/window
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"

until_true 20 xdotool getdisplaygeometry
report $? "the virtual X server answers"
cp "$programs/spin.df" live.df
"$KINESCOPE" run live.df --tube LAB31 --size 500x500 --set pen=none 2>log &
viewer=$!
until_true 30 title live.df
report $? "a window opens, named after the program"
xdotool mousemove 250 250
xdotool windowfocus "$(title live.df | tail -n 1)" 2>/dev/null
sleep 1.5
press F5 F12
until_true 10 test -s kinescope-001.png
report $? "F12 writes a screenshot"
at=$(tag "Simulated time" kinescope-001.png) exposure=$(tag Exposure kinescope-001.png)
"$KINESCOPE" capture live.df --tube LAB31 --at "${at}s" --exposure "${exposure}s" --size 500x500 -o offscreen.png
report $? "the screenshot says when it was taken"
"$KINESCOPE" compare kinescope-001.png offscreen.png --tolerance 2 --diff diff.png
report $? "the screenshot is the offscreen picture of that instant"

press F6 F12
step=$(tag "Simulated time" kinescope-002.png) length=$(tag Exposure kinescope-002.png)
[ -n "$step" ] && [ "$step" != "$at" ]
report $? "F6 steps by a refresh"
[ "$(echo "$length" | cut -c1-3)" = "0.0" ]
report $? "a step is no longer than two ticks"
press F12
"$KINESCOPE" compare kinescope-002.png kinescope-003.png >/dev/null
report $? "a paused picture stands still"
[ "$(tag "Simulated time" kinescope-003.png)" = "$step" ]
report $? "a paused machine stands still"

chord b
for i in 1 2 3 4 5; do chord Up; done
press F6 F6 F12
"$KINESCOPE" compare kinescope-002.png kinescope-004.png >/dev/null
[ $? -eq 1 ]
report $? "the brightness knob acts"
chord 0
press F1 F7 F8 F9 F2 F1 Tab Escape a F5

cp "$programs/star.df" live.df
sleep 2
press F5 F6 F6 F12
"$KINESCOPE" capture live.df --tube LAB31 --size 500x500 -o star.png
# The exposure of a step is one refresh, not one tick: nearly the same picture.
difference() {
    "$KINESCOPE" compare "$1" "$2" --json | sed 's/.*"mean_difference": \([0-9.e-]*\).*/\1/'
}
echo "$(difference kinescope-005.png star.png) $(difference kinescope-004.png star.png)" |
    awk '{ exit !(NF == 2 && $1 < 0.2 * $2) }'
report $? "a changed file is loaded again"
# Another tube: the picture is of that tube.
{ echo '  .tube "RADAR7"' && cat "$programs/star.df"; } >other.df
"$KINESCOPE" run other.df --size 500x500 2>>log &
second=$!
until_true 30 title other.df
{ echo '  .tube "VR14"' && cat "$programs/star.df"; } >other.df
sleep 3
xdotool windowfocus "$(title other.df | tail -n 1)" 2>/dev/null
xdotool mousemove 250 250
sleep 0.5
press F5 F12
until_true 10 test -s kinescope-006.png
grep -aq "VR14" kinescope-006.png
report $? "a program for another tube is shown on it"
chord q
wait $second
echo "  nonsense" >>live.df
sleep 1
kill -0 $viewer
report $? "a file with errors does not end the show"
chord q
tries=0
while kill -0 $viewer 2>/dev/null && [ $tries -lt 50 ]; do sleep 0.1 && tries=$((tries + 1)); done
wait $viewer
report $? "Right Ctrl Q ends it with status 0"
viewer=
[ ! -s log ] || sed 's/^/# /' log
[ ! -s log ]
report $? "nothing was complained about"

"$KINESCOPE" run "$programs/star.df" --for 0.2s --size 300x300
report $? "--for ends the show"
"$KINESCOPE" run "$programs/star.df" --headless --for 1s --save-state one 2>/dev/null &&
    "$KINESCOPE" run "$programs/star.df" --load-state one --for 0.2s --size 300x300 --save-state more &&
    "$KINESCOPE" trace "$programs/star.df" --load-state more --for 1f |
    awk 'BEGIN { early = 1 } $1 == "dpu" { early = $2 < 1.2e12; exit } END { exit early }'
report $? "of a saved machine it counts from there"
"$KINESCOPE" run "$programs/star.df" --console 2>bad.log
[ $? -eq 2 ] && grep -q 'no firmware' bad.log
report $? "--console needs firmware"
printf '  frob 1\n' >bad.df
"$KINESCOPE" run bad.df 2>bad.log
[ $? -eq 1 ] && [ "$(grep -c 'bad.df:1:3: unknown' bad.log)" -eq 1 ]
report $? "errors of a program are printed once, before a window opens"
"$KINESCOPE" run "$programs/star.df" --for 0.1s --size 16384x16384
report $? "a window is no larger than the monitor"
mkdir roms
cp "$programs/star.df" "$programs/spin.df" roms
printf 'star.df - A star\nspin.df RADAR7 A hand\n' >roms/tour.txt
"$KINESCOPE" run --tour --roms roms --size 300x300 2>tour.log &
viewer=$!
until_true 30 title star.df
report $? "--tour: the tour"
xdotool mousemove 150 150
xdotool windowfocus "$(title star.df | tail -n 1)" 2>/dev/null
sleep 0.5
chord n
until_true 10 title spin.df
report $? "Right Ctrl N shows the next program"
chord q
wait $viewer
report $? "the tour ends with status 0"
# Keys that are not the host's go to the firmware's console; what runs without a FILE is the monitor.
"$KINESCOPE" run --size 300x300 2>typed.log &
viewer=$!
until_true 30 title monitor.elf
report $? "without a file: the monitor"
xdotool mousemove 150 150
xdotool windowfocus "$(title monitor.elf | tail -n 1)" 2>/dev/null
sleep 1
xdotool type --delay 80 "quit 78"
press BackSpace Return
sleep 1
chord q
wait $viewer
[ $? -eq 7 ]
report $? "what is typed into the window reaches the firmware"
viewer=
finish
