#!/bin/sh
# kinescope list modes: the table, one mode in full, modes by formula, what is no mode.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. "$(dirname "$0")/../support/tap.sh"
work=$TEST_OUT/modes
rm -rf "$work"
mkdir -p "$work"

list() {
    "$KINESCOPE" list modes "$@" >"$work/said" 2>&1
}

list
[ $? -eq 0 ] && [ "$(grep -c '^[0-9]*[x/][0-9]*[@i]*[0-9p]*' "$work/said")" -ge 31 ]
report $? "the table has its modes"
awk 'length($0) > 100 { wide = 1 } END { exit wide }' "$work/said"
report $? "no line is wider than 100 columns"
# Name, MHz, kHz, Hz, dots = sum, lines = sum, polarity.
awk '$6 == "=" && $9 == "=" {
    n++
    split($5, h, "+"); split($8, v, "+")
    bad += h[1] + h[2] + h[3] + h[4] != $7 || v[1] + v[2] + v[3] + v[4] != $10 || NF != 11
    lines = $4 * $10 / ($1 ~ /i$/ ? 2000 : 1000) - $3
    bad += lines > 0.001 || lines < -0.001
} END { exit n != 31 || bad > 0 }' "$work/said"
report $? "parts add up, rates agree"
grep -qE '^1024x768@60 +65\.000 +48\.363 +60\.004 +1024\+24\+136\+160 = 1344 +768\+3\+6\+29 = 806 +--$' "$work/said"
report $? "XGA as VESA has it"
grep -qE '^525/60i +13\.500 +15\.734 +59\.940 ' "$work/said"
report $? "television as SMPTE has it"
grep -qE '^1024x768@43i +44\.900 +35\.522 +86\.958 .*\+\+$' "$work/said"
report $? "the interlaced mode of VESA"

list --why
[ $? -eq 0 ] && [ "$(grep -c '^  source ' "$work/said")" -eq 31 ] &&
    [ "$(grep -c '^  source .*\(VESA DMT\|IBM VGA\|SMPTE\)' "$work/said")" -eq 31 ]
report $? "--why: a source for every mode"
list 640x480@60
grep -q 'line lasts 31.7776 us' "$work/said" && grep -q 'sync 3.813 us, negative' "$work/said"
report $? "one mode in full"
list 1024x768
grep -q '^1024x768@60 ' "$work/said"
report $? "60 Hz is taken for granted"
list 1400x1050@75
grep -q '156.000 MHz' "$work/said" && grep -q 'CVT' "$work/said"
report $? "a mode by formula"
list 525/60i
grep -q 'two make a frame, 29.9700 Hz' "$work/said"
report $? "frames of an interlaced mode"
for bad in vga 1366x768@60 9999x9@60 640x480@0; do
    "$KINESCOPE" list modes $bad >"$work/out" 2>"$work/said"
    [ $? -eq 2 ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/said")" -eq 1 ]
    report $? "$bad is none: one sentence, status 2"
done
"$KINESCOPE" list moods >"$work/out" 2>"$work/said"
[ $? -eq 2 ] && grep -q modes "$work/said"
report $? "moods: modes is meant"
echo "1..$number"
exit $failed
