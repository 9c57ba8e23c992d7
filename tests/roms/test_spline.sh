#!/bin/sh
# The curve editor in the machine: its script drags, adds, and chooses with the stylus of each kind of tablet;
# what it writes onto the console is where the hand was; text goes there and back; it is fast while dragging.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/spline
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# What the program prints: SCRIPT SETTING…
written() {
    script=$1
    shift
    "$KINESCOPE" run roms/spline.elf --headless --console --input "$script" --for 20s "$@" 2>"$work/errors" </dev/null |
        tr -d '\r'
}

# Points that are to lie within so many stage units: x y of each, in order.
near() { # FILE UNITS X Y …
    file=$1 units=$2
    shift 2
    awk -v units="$units" -v list="$*" '
        BEGIN { n = split(list, at) }
        $1 == "point" {
            dx = $2 - at[2 * count + 1]; dy = $3 - at[2 * count + 2]; count++
            if (dx * dx + dy * dy > units * units) exit wrong = 1
        }
        END { exit wrong || 2 * count != n }' "$file"
}

{ cat roms/spline.script && printf '+100ms tablet away\nkey W\n+200ms key Q\n'; } >"$work/script"
for kind in electrical sonic resistive; do
    written "$work/script" --set tablet=$kind >"$work/$kind"
    head -2 "$work/$kind" | grep -qx 'kind bezier knots uniform open' &&
        tail -1 "$work/$kind" | grep -qx end &&
        near "$work/$kind" 6 90 200 200 620 420 700 640 260 760 180 880 560 640 690
    report $? "$kind tablet: a point is dragged, one is added, the others stay"
done

# ---- text ---------------------------------------------------------------------------------------------------
# As keys of a script: LINES of a file.
keys() {
    awk '{ gsub(/"/, "\\\""); printf "+20ms type \"%s\\n\"\n", $0 }' "$1"
}
{
    echo 'at 0.5s key L'
    keys "$work/electrical"
    printf '+100ms key W\n+200ms key Q\n'
} >"$work/again"
written "$work/again" >"$work/said"
grep -qx 'loaded: 7 points' "$work/said" && sed 1d "$work/said" | cmp -s - "$work/electrical"
report $? "points that were written are loaded, and written the same"

printf '%s\n' 'spline 1' 'kind pieces knots uniform closed' 'point 100 100' 'point 5000 100' 'end' >"$work/wrong"
{
    echo 'at 0.5s key L'
    sed '$d' "$work/wrong" >"$work/cut" && keys "$work/cut"
    printf '+100ms key W\n+200ms key Q\n'
} >"$work/refuse"
written "$work/refuse" >"$work/said"
grep -qx 'not loaded: line 4: the point lies outside of the drawing area' "$work/said" &&
    grep -qx 'kind bezier knots uniform open' "$work/said" &&
    near "$work/said" 0.01 90 200 200 620 420 700 560 300 760 180 880 560
report $? "text that is wrong changes nothing"

# Its rest is no keys: 'e' would erase all, 'q' end.
printf '%s\n' 'at 0.5s key L' '+20ms type "spline 1\nkind none\npoint 1 2\nqqqeee end\n"' '+200ms key W' \
    '+200ms key Q' >"$work/rest"
written "$work/rest" >"$work/said"
grep -qx 'not loaded: line 2: expected: kind KIND knots KNOTS open|closed' "$work/said" &&
    near "$work/said" 0.01 90 200 200 620 420 700 560 300 760 180 880 560 &&
    grep -qx end "$work/said"
report $? "the rest of text that is wrong is passed over"

printf 'lspline 1\r\nkind none\r\n' |
    "$KINESCOPE" run roms/spline.elf --headless --console --for 1s >"$work/said" 2>"$work/errors"
grep -q '^not loaded: line 2: ' "$work/said"
report $? "lines that end as terminals end them are counted once"

# ---- keys and undo ------------------------------------------------------------------------------------------
printf '%s\n' 'at 0.5s type "p\t\tjjc"' '+50ms type "\e[A\e[A\e[C"' '+50ms type "w"' '+200ms type "uuuuuuw"' \
    '+200ms key Q' >"$work/typed"
written "$work/typed" >"$work/said"
grep -qx 'kind pieces knots uniform closed' "$work/said" && grep -qx 'point 204 628 corner' "$work/said" &&
    [ "$(tail -2 "$work/said" | head -1)" = 'point 880 560' ] && grep -qx 'kind pieces knots uniform open' "$work/said"
report $? "keys choose, change the joint, close and move; undo takes it back"

# ---- speed --------------------------------------------------------------------------------------------------
# Pictures a second while a point is dragged: how often another page is shown, over 0.9 s.
printf '%s\n' 'at 0.3s tablet near 130.7 116.7' 'tablet touch 130.7 116.7 in 60ms' \
    'tablet touch 149.3 107.3 in 1s' >"$work/drag"
"$KINESCOPE" trace roms/spline.elf --input "$work/drag" --what video --from 0.4s --for 0.9s 2>"$work/errors" |
    sed -n 's/^video [0-9]* retrace \(base=[^ ]*\) .*/\1/p' |
    awk '$1 != last { n++; last = $1 } END { exit n < 27 }'
report $? "dragging: thirty pictures a second"

"$KINESCOPE" capture roms/spline.elf --input roms/spline.script --at 3.4s --view both --size 600x300 \
    -o "$work/curve.png" >"$work/said" 2>&1
report $? "the script's picture"
echo "1..$number"
exit $failed
