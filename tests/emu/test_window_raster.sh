#!/bin/sh
# The window with two heads under a virtual X server: F2 goes from view to view, and each screenshot is the
# offscreen picture of the same instant. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
roms=$(cd "$(dirname "$0")/../../roms" && pwd)
work=$TEST_OUT/window_raster
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"

until_true 20 xdotool getdisplaygeometry
report $? "the virtual X server answers"
"$KINESCOPE" run "$roms/heads.elf" --tube MONO12 --size 640x300 2>log &
viewer=$!
until_true 30 title heads.elf
report $? "a window opens"
xdotool mousemove 250 250
xdotool windowfocus "$(title heads.elf | tail -n 1)" 2>/dev/null
moment() { # NUMBER: when screenshot NUMBER was taken
    press F12
    until_true 10 test -s "kinescope-00$1.png"
    at=$(tag "Simulated time" "kinescope-00$1.png")
    exposure=$(tag Exposure "kinescope-00$1.png")
}
sleep 4 # until both heads are on
press F5
number_of=0
for view in both vector raster; do
    number_of=$((number_of + 1))
    moment $number_of
    "$KINESCOPE" capture "$roms/heads.elf" --tube MONO12 --at "${at}s" --exposure "${exposure}s" \
        --view $view --size 640x300 -o $view.png 2>capture.log
    report $? "$view: the screenshot says when it was taken"
    "$KINESCOPE" compare kinescope-00$number_of.png $view.png --tolerance 2 --diff diff-$view.png
    report $? "$view: the screenshot is the offscreen picture of that instant"
    press F2
done
strings -n 3 kinescope-003.png | grep -q '^MONO12$'
report $? "the raster head's picture names its tube alone"
"$KINESCOPE" compare kinescope-002.png kinescope-003.png >/dev/null
[ $? -eq 1 ]
report $? "the views differ"
xdotool key --clearmodifiers Control_R+q
finish
