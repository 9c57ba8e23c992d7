#!/bin/sh
# A lesson's live commands in the window, under a virtual X server: pages follow each other, with captions; before
# what flashes a warning waits; with --no-flash nothing moves there. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
work=$TEST_OUT/window_lesson
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"

# bad NAME PATTERN 'live line': told with its place before a window opens.
bad() {
    printf 'title T\nsummary S\norder 1\nstep one One\nlive %s\n' "$3" >bad.lesson
    DISPLAY=:none "$KINESCOPE" lesson bad.lesson --live 2>told
    [ $? -eq 2 ] && grep -q "bad.lesson:5: .*$2" told && [ "$(wc -l <told)" -eq 1 ]
    report $? "$1"
}
bad "an option that is none" 'did you mean --phosphor' 'run roms/rose.df --phosphr P39'
bad "a phosphor that is none" 'P390' 'run roms/rose.df --phosphor P390'
bad "one of the other machine" 'versus' "run roms/rose.df --versus 'refrsh=30'"
bad "one that has no place there" 'leave it out' 'run roms/rose.df --headless'
bad "a window is no page's to open" 'one argument too many' 'run roms/rose.df roms/star.df'
sed 's/^live.*/live run nothing.df/' bad.lesson >none.lesson
DISPLAY=:none "$KINESCOPE" lesson none.lesson --live 2>told
[ $? -eq 1 ] && grep -q 'none.lesson:5: .*nothing.df' told
report $? "a program that is not there"
sed '/^live/d' bad.lesson >still.lesson
"$KINESCOPE" lesson still.lesson --live 2>told
[ $? -eq 2 ] && grep -q 'nothing to show live' told
report $? "a lesson that has nothing live"
"$KINESCOPE" lesson still.lesson --live -o x 2>told
[ $? -eq 2 ] && [ ! -e x ]
report $? "a window or a page"

mkdir beside
cat >beside/own.df <<'END'
        .tube   "VR17/P31"
        .start  line
line:   point   i=7 pen=off blink=off line=solid
        at      480, 512
        longv
        draw    64, 0
        sync    stop
END
cat >beside/small.lesson <<'END'
title Small
summary S
order 1
step rate A rate
figures calc refresh --line-rate 31.5kHz --lines 480 --json
live run own.df --time-scale 0.5 --shutter 100ms --set pen=none
caption {refresh_hz:.2} Hz
step flashing What flashes
picture capture roms/rose.df --tube VR17/P31 --at 1s --size 200x200
caption At rest
live run roms/rose.df --tube VR17/P31 --refresh 8 --versus 'refresh=9'
flashes 8 times a second
END
shots=0
open_lesson() { # OPTIONS...
    "$KINESCOPE" lesson beside/small.lesson --live --size 400x300 "$@" 2>>log &
    viewer=$!
    until_true 30 title 'Small  1 of 2'
    report $? "the window shows page 1 of 2"
    xdotool windowfocus "$(title 'Small.*' | tail -n 1)" 2>/dev/null
    sleep 0.3
}
quick() {
    for key; do
        xdotool keydown Control_R key "$key" keyup Control_R
        sleep 0.2
    done
}
close_lesson() {
    quick q
    wait $viewer
    report $? "Right Ctrl Q ends it with status 0"
    viewer=
}
# shoot: a screenshot of the glass, $shot.
shoot() {
    shots=$((shots + 1))
    shot=kinescope-$(printf %03d $shots).png
    xdotool key F12
    until_true 5 test -s "$shot"
}
# height FILE: of a picture.
height() { od -An -tu1 -j20 -N4 "$1" | awk '{ print $3 * 256 + $4 }'; }

open_lesson
sleep 0.5
xdotool key F5
shoot
[ "$(tag Exposure "$shot" | awk '{ print ($1 > 0.05 && $1 < 0.15) }')" = 1 ]
report $? "the shutter is that of the page's command"
with=$(height "$shot")
quick t
shoot
without=$(height "$shot")
[ "$without" -eq 300 ] && [ "$with" -gt 150 ] && [ "$with" -lt 270 ]
report $? "the caption leaves the picture free: $with of $without lines; Right Ctrl T hides it"
quick n
title 'Small  2 of 2' >/dev/null
report $? "Right Ctrl N shows page 2"
steady
report $? "... behind a warning: nothing moves"
xdotool key Escape key space key F12
sleep 0.3
[ ! -e kinescope-003.png ]
report $? "no key of the program's, nor a screenshot, ends the warning"
xdotool key F5
sleep 0.7
shoot
strings -n 3 "$shot" | grep -q rose.df && [ "$(tag "Simulated time" "$shot" | awk '{ print ($1 < 2) }')" = 1 ]
report $? "F5 does, and the program begins then"
quick p
title 'Small  1 of 2' >/dev/null
report $? "Right Ctrl P shows page 1 again"
quick n
shoot
strings -n 3 "$shot" | grep -q rose.df
report $? "the warning is shown once"
close_lesson

open_lesson --no-flash
cp Xvfb_screen0 live
quick n
title 'Small  2 of 2' >/dev/null && steady
report $? "--no-flash: of what flashes a picture, nothing moves"
cmp -s Xvfb_screen0 live
[ $? -eq 1 ]
report $? "... another than the page before"
quick p
sleep 0.5
steady
[ $? -eq 1 ]
report $? "... and the page before runs (its clock does)"
close_lesson
[ ! -s log ] || sed 's/^/# /' log
[ ! -s log ]
report $? "nothing was complained about"
finish
