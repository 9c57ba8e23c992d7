#!/bin/sh
# kinescope measure: figures recomputed here by awk, formats that agree, what wrong use is told.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. "$(dirname "$0")/../support/tap.sh"
work=$TEST_OUT/measure
rm -rf "$work"
mkdir -p "$work"
subcommand=measure
. "$(dirname "$0")/../support/command.sh"

refuses "two formats at once" "exclude each other" resolution --csv --json
refuses "a format that film does not have" "exclude each other" resolution --csv --film
"$KINESCOPE" measure resolution >"$work/said" 2>&1
report $? "a raster tube by default"
says "the default is COLOR17 in its mode" '^COLOR17 in 1024x768@60: 320 x 240 mm'
# 1280 dots on the diagonal of 400 mm.
says "dots an inch from the diagonal" '1024 x 768 dots, 81.3 an inch'
# 320/0.445 and 240/0.445, rounded down.
says "spots side by side" 'vanishing current *0.445 mm *719 x 539'
says "the mode's limit" 'across addressed by the mode *1.600 lp/mm *768 TV lines'
says "the mask's limit" 'across sampled by the mask *2.062 lp/mm'

# e^(-2 pi^2 sigma^2 f^2), sigma at full current; corner 1.25 times.
"$KINESCOPE" measure resolution --csv --set spot_growth=0.075 >"$work/said" 2>&1 &&
    awk -F, 'NR == 1 { if ($0 != "lp_per_mm,tv_lines,centre_across,centre_up,corner_across,corner_up") bad = 1; next }
        { s = (0.445 / 2.0215356) ^ 2 + 0.075 ^ 2; x = 2 * 3.14159265358979 ^ 2 * s * $1 * $1
          d = $4 - exp(-x); e = $6 - exp(-x * 1.25 * 1.25)
          if (d * d > 1e-11 || e * e > 1e-11 || $2 != 480 * $1 || $3 > $4 + 1e-3) bad = 1; n++ }
        END { exit bad || n < 8 }' "$work/said"
report $? "CSV has the closed form, in the centre and in the corner"

"$KINESCOPE" measure resolution --json >"$work/said" 2>&1 &&
    [ "$(wc -l <"$work/said")" -eq 1 ] &&
    grep -q '"per_inch": 81.28, ' "$work/said" &&
    grep -q '"up_lp_per_mm": {"centre": 1.9[0-9]*, "corner": 1.5[0-9]*, "mode": 1.6, "mask": 3.5' "$work/said"
report $? "JSON has the figures"

"$KINESCOPE" measure resolution --csv --set bandwidth=5MHz >"$work/slow" 2>"$work/said" &&
    "$KINESCOPE" measure resolution --csv >"$work/fast" 2>"$work/said" &&
    paste -d, "$work/slow" "$work/fast" | awk -F, 'NR == 9 { exit !($3 < 0.7 * $9 && $4 == $10) }'
report $? "a slow amplifier blurs along the lines only"

"$KINESCOPE" measure resolution --tube SLOT14 --mode 800x600@60 >"$work/said" 2>&1
report $? "another tube in another mode"
says "its mode is named" '^SLOT14 in 800x600@60:'
"$KINESCOPE" measure resolution --tube COLOR17 --current 0 >"$work/said" 2>&1
says "without current the spot is its smallest" 'centre, current asked for *0.445 mm'

"$KINESCOPE" measure resolution --tube VR17 >"$work/said" 2>&1
report $? "vector tubes have a resolution, too"
says "units, not dots" '1024 x 1024 units'
"$KINESCOPE" measure resolution --tube VR17 --film >"$work/said" 2>&1 &&
    awk '$1 + 0 > 0 { n++; d = $2 - $3; if (d * d > 0.04) bad = 1 } END { exit bad || n != 6 }' "$work/said"
report $? "the film shows what the spot promises"

"$KINESCOPE" measure resolution --film --set spot_growth=0 >"$work/said" 2>&1 &&
    awk '$1 + 0 > 0 { n++; d = $3 - $4; e = $5 - $6; if (n < 6 && (d * d > 0.1 || e * e > 0.4)) bad = 1 }
        END { exit bad || n != 6 }' "$work/said"
report $? "scan lines on film show what spot and amplifier promise"

cat >"$work/my.ini" <<'EOF'
[tube MINE]
like = COLOR17
spot = 0.3
EOF
"$KINESCOPE" measure resolution --tubes "$work/my.ini" --tube MINE >"$work/said" 2>&1
says "tubes of a file" 'vanishing current *0.300 mm *1066 x 800'

refuses "nothing to measure" 'argument is missing'
refuses "something else" "'colour' cannot be measured; give resolution" colour
refuses "no such tube" "no tube called 'COLOR99'" resolution --tube COLOR99
refuses "a mode that the tube cannot follow" 'SLOT14 follows' resolution --tube SLOT14 --mode 1280x1024@60
refuses "a mode of a vector tube" 'is a vector tube' resolution --tube VR17 --mode 640x480@60
refuses "a figure of another kind" 'another kind of tube' resolution --set units_x=3
refuses "no such figure" "has no 'bandwith'" resolution --set bandwith=3
refuses "no number" "not a number\|expected" resolution --set bandwidth=fast
refuses "an impossible figure" 'must be' resolution --set spot=0.01
"$KINESCOPE" measure resolution --tubes "$work/none.ini" >"$work/said" 2>&1
[ $? -eq 1 ]
report $? "a file that is not there is the host's trouble"

echo "1..$number"
exit $failed
