#!/bin/sh
# Firmware that rewrites a display file while it is refreshed: no refresh is torn, the same every time,
# also over a thousand refreshes; stops are counted right.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/display
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# ---- tearing: both processors' accesses to display memory, by time ------------------------------------
accesses() { # FIRMWARE FOR
    {
        "$KINESCOPE" trace "$1" --what cpu --for "$2" |
            sed -n 's/^cpu \([0-9]*\) .* sh .* \[4100\(....\)\]=.*/store \1 \2/p' |
            awk '{ printf "store %s %o\n", $2, hex($3) }
                 function hex(text,    n, i) {
                     for (i = 1; i <= length(text); i++)
                         n = n * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
                     return n
                 }'
        "$KINESCOPE" trace "$1" --what dpu --for "$2" |
            sed -n 's/^dpu \([0-9]*\) DPC=\([0-7]*\) .*/fetch \1 \2/p'
    } 2>"$work/said" | sort -s -n -k2,2
}
whole() { # NAME
    accesses "roms/$1.elf" 150ms | awk -f tests/roms/tearing.awk >"$work/said"
    grep -qE '^refreshes ([6-9]|1[0-9]), shown [3-9] [3-9], torn 0$' "$work/said"
    report $? "$1: both parts are shown, none is torn"
}
whole clock
whole bounce
# What it looks like when it does tear: a store behind the beam's back; a part entered in its middle.
printf 'store 1 40000\nfetch 2 0\nfetch 3 40000\nfetch 4 40002\nstore 5 40004\nfetch 6 0\nfetch 7 60002\n' |
    awk -f tests/roms/tearing.awk >"$work/said"
[ "$(cat "$work/said")" = "refreshes 2, shown 1 1, torn 2" ]
report $? "torn refreshes are told"

# ---- a thousand refreshes, twice; a hundred where checks make everything slow -------------------------
case "${TEST_MODE:-rel}" in
rel | dbg) duration=16.7s refreshes=1000 ;;
*) duration=1.7s refreshes=100 ;;
esac
hashed() {
    "$KINESCOPE" trace roms/clock.elf --what dpu --for $duration 2>"$work/said" |
        awk '/ DPC=000000 / { n++ } { print } END { print n >"/dev/stderr" }' 2>"$work/refreshes" |
        sha256sum
}
hashed >"$work/first"
[ "$(cat "$work/refreshes")" -ge $refreshes ]
report $? "clock: at least $refreshes refreshes in $duration"
hashed >"$work/second"
cmp -s "$work/first" "$work/second"
report $? "clock: the words of $refreshes refreshes are the same twice"

# ---- stops ------------------------------------------------------------------------------------------------
"$KINESCOPE" run roms/stops.elf --headless --console --for 3s >"$work/said" 2>&1 </dev/null
status=$?
counted=$(sed -n 's/^\([0-9]*\) stops in a second.*/\1/p' "$work/said")
[ $status = 0 ] && [ "${counted:-0}" -gt 100 ]
report $? "stops: it counts them and ends well"
# The last one comes after the second is over and is not counted.
"$KINESCOPE" trace roms/stops.elf --what dpu --for 3s 2>"$work/said" | grep -c 'WORD=173400' >"$work/traced"
[ "$(cat "$work/traced")" = "$counted" ] || [ "$(cat "$work/traced")" = "$((counted + 1))" ]
report $? "stops: the display processor fetched as many stop words"
echo "1..$number"
exit $failed
