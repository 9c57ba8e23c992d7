#!/bin/sh
# Mouse and keys in the window under a virtual X server: what is done is recorded, and done again offscreen it
# gives the very screenshot; F9 goes from device to device. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
support=$(cd "$(dirname "$0")/../support" && pwd)
roms=$(cd "$(dirname "$0")/../../roms" && pwd)
work=$TEST_OUT/window_input
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$support/window.sh"

until_true 20 xdotool getdisplaygeometry
report $? "the virtual X server answers"

# Moves in steps, as a hand would.
drag() { # X0 Y0 X1 Y1
    i=0
    while [ $i -le 6 ]; do
        xdotool mousemove $(($1 + ($3 - $1) * i / 6)) $(($2 + ($4 - $2) * i / 6))
        sleep 0.05
        i=$((i + 1))
    done
}
shown() { # PROGRAM: the picture that the script makes at the time of the last screenshot
    at=$(tag "Simulated time" "$1.png")
    exposure=$(tag Exposure "$1.png")
    "$KINESCOPE" capture "$2" --input "$1.script" --at "${at}s" --exposure "${exposure}s" --size 500x500 \
        --tube VR17/P31 --view vector -o "$1-again.png" 2>capture.log
    "$KINESCOPE" compare "$1.png" "$1-again.png" --tolerance 2 --diff "$1-diff.png"
}
over() {
    chord q
    wait $viewer
    report $? "$1: Right Ctrl Q ends it with status 0"
    viewer=
}

# ---- a light pen on a display file

"$KINESCOPE" run "$roms/testcard.df" --tube VR17/P31 --size 500x500 --record pen.script 2>log &
viewer=$!
until_true 30 title testcard.df
report $? "pen: a window opens"
xdotool windowfocus "$(title testcard.df | tail -n 1)" 2>/dev/null
sleep 1
drag 100 100 250 250
xdotool mousedown 1
sleep 0.3
xdotool mouseup 1
drag 250 250 257 256
sleep 1
press F5 F12
until_true 10 test -s kinescope-001.png
mv kinescope-001.png pen.png
over pen
grep -q 'pen vector move' pen.script && grep -q 'pen vector down' pen.script && grep -q 'pen vector up' pen.script
report $? "pen: what the hand did is recorded"
shown pen "$roms/testcard.df"
report $? "pen: done again offscreen it gives the screenshot"
"$KINESCOPE" trace "$roms/testcard.df" --tube VR17/P31 --what input --input pen.script | grep -q 'pen vector fires'
report $? "pen: it saw the beam"

# ---- keys for the monitor, and every device in turn

"$KINESCOPE" run --size 500x500 --view vector --record keys.script --latency 2>late &
viewer=$!
until_true 30 title monitor.elf
report $? "keys: the monitor's window opens"
xdotool windowfocus "$(title monitor.elf | tail -n 1)" 2>/dev/null
sleep 2
xdotool type --delay 60 'circle 0 0 8'
xdotool key Return
drag 200 200 260 240
press F9
drag 260 240 300 300
press F9
drag 300 300 200 300
xdotool mousedown 3
sleep 0.2
xdotool mouseup 3
press F9
drag 200 300 250 250
sleep 2
press F5 F12
until_true 10 test -s kinescope-001.png
mv kinescope-001.png keys.png
over keys
for what in 'key down C' 'key up C' 'tablet move' 'mouse move' 'pen vector move' 'mouse press right'; do
    grep -q "$what" keys.script
    report $? "keys: '$what' is recorded"
done
shown keys "$roms/monitor.elf"
report $? "keys: done again offscreen it gives the screenshot"
"$KINESCOPE" run --headless --input keys.script --record again.script --for 60s 2>/dev/null
cmp keys.script again.script
report $? "keys: recorded once more it is the same script"
# ---- what one would do first with the drawing program: draw, choose from its menu, undo, drag

# Places are those of the program's picture, 640 x 480 dots; "s" prints the drawing on the console.
"$KINESCOPE" run "$roms/sketch.elf" --size 640x480 --view raster --record sketch.script --console \
    </dev/null >sketch.text 2>sketch.log &
viewer=$!
until_true 30 title sketch.elf
report $? "sketch: a window opens"
xdotool windowfocus "$(title sketch.elf | tail -n 1)" 2>/dev/null
sleep 3
pull() { # X0 Y0 X1 Y1: press, drag, release
    xdotool mousemove "$1" "$2"
    sleep 0.5
    xdotool mousedown 1
    sleep 0.5
    drag "$@"
    sleep 0.5
    xdotool mouseup 1
    sleep 0.7
}
choose() { # X Y: an item of the menu
    xdotool mousemove "$1" "$2"
    sleep 0.5
    xdotool mousedown 1
    sleep 0.5
    xdotool mouseup 1
    sleep 0.7
}
saved=0
save() { # the drawing so far, in sketch.N
    saved=$((saved + 1))
    xdotool key s
    until_true 20 sh -c "[ \$(grep -c 'sketch: end' sketch.text) -ge $saved ]"
    awk -v n=$saved '/sketch: begin/ { k++ } k == n { print } /sketch: end/ && k == n { exit }' sketch.text |
        tr -d '\r' >"sketch.$saved"
}
count() { # WORD: statements of it in the last drawing
    grep -c "^$1 " "sketch.$saved"
}
pull 100 200 300 350
save
[ "$(count line)" = 1 ]
report $? "sketch: a line is drawn"
choose 541 67 # Circle
pull 300 150 340 150
save
[ "$(count line)" = 1 ] && [ "$(count circle)" = 1 ]
report $? "sketch: the menu's circle is drawn"
choose 541 252 # Undo
save
[ "$(count line)" = 1 ] && [ "$(count circle)" = 0 ]
report $? "sketch: the menu undoes it"
xdotool key m # Move
sleep 0.7
pull 300 350 400 250
save
[ "$(count line)" = 1 ] && ! cmp -s sketch.3 sketch.4
report $? "sketch: its end is picked and dragged"
over sketch
"$KINESCOPE" run "$roms/sketch.elf" --headless --console --input sketch.script --for 60s </dev/null 2>/dev/null |
    tr -d '\r' >again.text
tr -d '\r' <sketch.text | cmp - again.text
report $? "sketch: done again headless it prints the same"

grep -q 'pictures showed what was done' late
report $? "--latency says how late hands were seen: $(cat late)"
[ ! -s log ] || sed 's/^/# /' log
[ ! -s log ]
report $? "nothing was complained about"
finish
