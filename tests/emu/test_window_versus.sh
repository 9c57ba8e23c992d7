#!/bin/sh
# Two machines in one window under a virtual X server: its screenshot is that of capture --versus, at rest, after
# steps and after what a hand did in either half. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
roms=$(cd "$(dirname "$0")/../../roms" && pwd)
work=$TEST_OUT/window_versus
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"
other='phosphor=P31;refresh=30'

until_true 20 xdotool getdisplaygeometry
report $? "the virtual X server answers"

# as_captured SCREENSHOT: halves of 532x278 pixels less the strip and the gap.
as_captured() {
    at=$(tag "Simulated time" "$1.png")
    exposure=$(tag Exposure "$1.png")
    "$KINESCOPE" capture "$roms/testcard.df" --tube VR17/P39 --versus "$other" --input hand.script --at "${at}s" \
        --exposure "${exposure}s" --size 250x250 -o "$1-again.png" 2>capture.log &&
        "$KINESCOPE" compare "$1.png" "$1-again.png" --tolerance 2 --diff "$1-diff.png"
}

"$KINESCOPE" run "$roms/testcard.df" --tube VR17/P39 --versus "$other" --size 532x278 --record hand.script 2>log &
viewer=$!
until_true 30 title testcard.df
report $? "a window opens"
xdotool windowfocus "$(title testcard.df | tail -n 1)" 2>/dev/null
sleep 1
for place in '60 60' '125 153' '340 120' '407 153'; do
    xdotool mousemove $place
    sleep 0.3
done
sleep 0.5
press F5 F12
until_true 10 test -s kinescope-001.png
report $? "F12 writes a screenshot"
chord w
chord Right
chord Right
chord Left
press F12
press F6
press F12
until_true 10 test -s kinescope-003.png
report $? "steps of both machines"
chord q
wait $viewer
report $? "Right Ctrl Q ends it with status 0"
viewer=
[ "$(grep -c 'pen vector move' hand.script)" -ge 4 ]
report $? "the hand is recorded in either half"
as_captured kinescope-001
report $? "the screenshot is the picture of capture --versus"
as_captured kinescope-002
report $? "... after steps by words"
as_captured kinescope-003
report $? "... after a refresh"
cmp -s kinescope-002.png kinescope-003.png
[ $? -eq 1 ]
report $? "... which is another one"

"$KINESCOPE" run "$roms/testcard.df" --versus 'phosphr=P31' 2>log
[ $? -eq 2 ] && grep -q 'did you mean phosphor' log
report $? "a name that is none is told before a window appears"
"$KINESCOPE" run "$roms/testcard.df" --headless --versus "$other" 2>log
[ $? -eq 2 ] && grep -q 'leave out --headless' log
report $? "two machines need a window"
finish
