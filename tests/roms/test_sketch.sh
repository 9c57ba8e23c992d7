#!/bin/sh
# The drawing program in the machine: roms/sketch.script draws a bridge with the stylus and saves it; the text
# is what it is to be, loading it gives the same text, and text that is not right changes nothing.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/sketch
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh
said=$work/said

sketch() { # SECONDS ARGUMENTS; the console's input from standard input
    seconds=$1
    shift
    "$KINESCOPE" run roms/sketch.elf --headless --console --for "$seconds" "$@" 2>"$work/errors" | tr -d '\r'
}
saved() { # what lies between the marks, the last time
    awk '/^---- sketch: begin/ { text = ""; within = 1; next } /^---- sketch: end/ { within = 0; next }
         within { text = text $0 "\n" } END { printf "%s", text }' "$1"
}

sketch 20s --input roms/sketch.script >"$work/drawn" </dev/null
saved "$work/drawn" >"$work/bridge"
diff tests/roms/test_sketch.txt "$work/bridge" >"$said"
report $? "the script draws the bridge: grid, gravity, constraint, copies, delete, undo, save"

{ printf l; cat "$work/bridge"; printf s; } | sketch 4s >"$work/loaded"
saved "$work/loaded" >"$work/again"
cp "$work/loaded" "$said"
[ -s "$work/again" ] && cmp -s "$work/bridge" "$work/again"
report $? "what was saved and loaded is saved as the same text"

# The seventh line names a point that is not there; then the drawing of before is saved.
{ printf l; cat "$work/bridge"; printf l; sed '7s/.*/circle 1 99/' "$work/bridge"; printf s; } | sketch 6s >"$work/refused"
saved "$work/refused" >"$work/kept"
cp "$work/refused" "$said"
grep -q '^load: Line 7: there is no such point in this picture; the drawing is as it was$' "$work/refused" &&
    cmp -s "$work/bridge" "$work/kept"
report $? "text that is not right is told by its line, and changes nothing"

{ printf l; sed 's/^end$//' "$work/bridge"; } | sketch 4s >"$work/unended"
cp "$work/unended" "$said"
grep -q '^load: The text ended before "end". The drawing is as it was.$' "$work/unended"
report $? "text without an end is not waited for for ever"

# Its rest is no commands: s would save.
printf 'at 2s key Escape\n' >"$work/escape"
{ printf 'lsketch 1\n' && yes 'ssssssss' | head -n 8000; } | sketch 4s --input "$work/escape" >"$work/left"
cp "$work/left" "$said"
grep -q '^load: Loading was left off.' "$work/left" && ! grep -q 'sketch: begin' "$work/left"
report $? "Escape leaves off loading while text comes, and the rest of it is passed over"

# Undo on the console, as many times as it takes, and again.
{ printf l; cat "$work/bridge"; printf 'usrs'; } | sketch 4s >"$work/undone"
cp "$work/undone" "$said"
[ "$(grep -c '^sketch 1$' "$work/undone")" = 2 ] && [ "$(grep -c '^copy' "$work/undone")" = 7 ]
report $? "loading is a step that can be taken back and done again"
echo "1..$number"
exit $failed
