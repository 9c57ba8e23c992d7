#!/bin/sh
# kinescope sweep: cells recomputed here by awk from the published formulas, lists really run, formats, and
# what wrong use is told. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. "$(dirname "$0")/../support/tap.sh"
work=$TEST_OUT/sweep
rm -rf "$work"
mkdir -p "$work"
subcommand=sweep
. "$(dirname "$0")/../support/command.sh"

# ---- the table ---------------------------------------------------------------------------------------

"$KINESCOPE" sweep >"$work/said" 2>&1
report $? "all phosphors by default"
[ "$(grep -c '^P[0-9]' "$work/said")" -eq "$("$KINESCOPE" list phosphors | grep -c '^P[0-9]')" ]
report $? "a row for each phosphor"
[ "$(awk '{ if (length($0) > 100) n++ } END { print n + 0 }' "$work/said")" -eq 0 ]
report $? "no line is longer than 100 columns"
says "P39 is steady at 50 Hz and above" '^P39 .* 10 30 50 70  10 30 50 70  steady       steady       steady$'
says "only wide fields see P31 at 60 Hz in part" '^P1 .* \. 30 50 70  steady$'
says "the model is named" 'Farrell, Benson and Haynie'

"$KINESCOPE" sweep --field 30 --phosphors p31,P39 --luminances 10,100 --rates 30,40,50,60,75,100 >"$work/said" 2>&1 &&
    [ "$(awk '{ if (length($0) > 100) n++ } END { print n + 0 }' "$work/said")" -eq 0 ] &&
    [ "$(grep -c ' Hz  ' "$work/said")" -ge 2 ] && [ "$(grep -c '^P39' "$work/said")" -eq 2 ]
report $? "many rates and luminances go on in a second block"
says "the 69.5 Hz of P31 at 100 cd/m2" '^ *100 69.5  +39.5 1.37'

# One exponential: C1 = 2/sqrt(1 + (2 pi f tau)^2), the CFF by iterating the published line, the index in
# closed form.
cat >"$work/own.ini" <<'INI'
[phosphor OWN]
term = 1 5ms
colour1 = 0.3 0.6
source = a test
INI
"$KINESCOPE" sweep --tubes "$work/own.ini" --phosphors OWN --luminances 5,250 --rates 25,60,90 --pupil 4 \
    --csv - >"$work/said" 2>&1 &&
    awk -F, '
        function off(a, b) { d = a - b; return d * d > 1e-12 * (1 + b * b) }
        function tanh(x) { return (exp(x) - exp(-x)) / (exp(x) + exp(-x)) }
        BEGIN { pi = 3.14159265358979
            m[10] = 14.6; n[10] = 7.00; m[30] = 13.83; n[30] = 8.31
            m[50] = 8.32; n[50] = 9.73; m[70] = 6.79; n[70] = 10.03 }
        NR == 1 { if ($0 != "phosphor,cd_m2,refresh_hz,field_deg,pupil_mm,c1,percent_flicker,flicker_index,cff_hz,margin_hz,limit_cd_m2,flickers,cff_ferry_porter_hz,ieee_1789,svm") bad = 1; next }
        { c1 = 2 / sqrt(1 + (2 * pi * $3 * 0.005) ^ 2); x = 1 / ($3 * 0.005); a = 1 / (1 - exp(-x))
          area = pi * 4
          f = 50; for (i = 0; i < 200; i++) f = (f + m[$4] + n[$4] * log($2 * area * 2 / sqrt(1 + (2 * pi * f * 0.005) ^ 2))) / 2
          limit = exp(($3 - m[$4]) / n[$4]) / (area * c1)
          if ($1 != "OWN" || $5 != 4 || off($6, c1) || off($7, 100 * tanh(x / 2)) || off($8, a - 1 / x - log(x * a) / x)) bad = 1
          if (off($9, f) || off($10, f - $3) || off($11, limit)) bad = 1
          if (off($13, 12 + 10 * log($2 * area) / log(10)) || $14 != "above the low-risk limit") bad = 1
          if ($3 < 80) { if ($15 != "") bad = 1 } else {
            v = 0; for (k = 1; k * $3 <= 2000; k++) { g = k * $3
              v += (2 / sqrt(1 + (2 * pi * g * 0.005) ^ 2) / (1 / (1 + exp(-0.00518 * (g - 306.6))) + 20 * exp(-g / 10))) ^ 3.7 }
            if (off($15, v ^ (1 / 3.7))) bad = 1 }
          if ($12 != ($3 < f ? "true" : "false") || $12 != ($2 > limit ? "true" : "false")) bad = 1 }
        END { exit bad || NR != 1 + 2 * 3 * 4 }' "$work/said"
report $? "CSV has the closed forms, for a phosphor of one's own"

refuses "a misspelt phosphor" 'did you mean P39' --phosphors P1,P390
refuses "an unknown phosphor" 'kinescope list phosphors' --phosphors xenon
refuses "a rate that is none" "rates: .*fast" --rates 50,fast
refuses "a negative luminance" "luminances: " --luminances -3
refuses "no rate at all" "is not a number" --rates ,
refuses "a field that is not published" "10|30|50|70" --field 20
refuses "a picture's size without a picture" "give -o" --size 640x480
refuses "something else than length" 'or length first' lenght
refuses "two things to standard output" "both go" --csv - -o -
"$KINESCOPE" sweep --csv "$work/no/folder.csv" >"$work/said" 2>&1
[ $? -eq 1 ] && grep -q 'cannot be written' "$work/said"
report $? "a folder that is not there"
"$KINESCOPE" sweep --phosphors P31 --csv "$work/p31.csv" >"$work/said" 2>&1 &&
    grep -q '^P31 ' "$work/said" && [ "$(wc -l <"$work/p31.csv")" -eq 21 ]
report $? "table and CSV at once"

"$KINESCOPE" sweep -o "$work/heat.png" >"$work/said" 2>&1 &&
    "$KINESCOPE" sweep -o "$work/again.png" >/dev/null 2>&1 && cmp -s "$work/heat.png" "$work/again.png"
report $? "the heat map is the same each time"
[ "$(head -c 8 "$work/heat.png" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]
report $? "and is a PNG"
"$KINESCOPE" sweep --field 50 --phosphors P1,P31 --projector --size 800x600 -o - 2>"$work/said" |
    od -An -tx1 -j16 -N8 | tr -d ' \n' | grep -q '^0000032000000258$'
report $? "a heat map of a size, to standard output alone"

# ---- length ------------------------------------------------------------------------------------------

"$KINESCOPE" sweep length >"$work/said" 2>&1
report $? "the longest lists of VR17 by default"
says "which viewer and light" '^VR17 with P39, lines of 100 cd/m2 at 60 Hz'
# 21.05 ms: 2 fetches of 1.5 us, set-up 2 us, 100 units of 0.1 us.
says "what a vector takes" 'vectors of 100 units, 22.9 mm *15.00 us'
[ "$(awk '{ if (length($0) > 100) n++ } END { print n + 0 }' "$work/said")" -eq 0 ]
report $? "nor is this wider than 100 columns"

# The list it writes is run: it holds the tick's rate; with one vector more it does not.
longest=$("$KINESCOPE" sweep length --csv - | awk -F, '$10 == "false" { n = $3 } END { print n }')
"$KINESCOPE" sweep length --write "$work/longest.df" --sync >"$work/said" 2>&1 &&
    head -3 "$work/longest.df" | grep -q "; $longest vectors of 100 units" &&
    "$KINESCOPE" trace "$work/longest.df" --summary >"$work/said" 2>&1
report $? "the longest list is written"
says "and runs at 60 Hz on the tube it is for" 'refresh rate *60 Hz, waiting for the sync tick'
says "fitting into the tick" 'the refresh fits, with [0-9.]* us to spare'
"$KINESCOPE" sweep length --write - --sync --items $((longest + 1)) >"$work/more.df" 2>"$work/said" &&
    "$KINESCOPE" trace "$work/more.df" --summary --for 3s >"$work/said" 2>&1
report $? "one vector more"
says "misses ticks" 'refreshes exceed it'

# Steps of the rate: 60, 30, 20 ... as refresh times of the CSV ask for.
"$KINESCOPE" sweep length --of short --length 63 --luminance 3 --csv - >"$work/said" 2>&1 &&
    awk -F, 'NR == 1 { next }
        { ticks = $4 * 60; k = int(ticks); if (k < ticks) k++
          if ($1 != "short vectors" || $2 != 63 || $5 > $4 || $6 < $4) bad = 1
          d = $7 * $4 - 1; if (d * d > 1e-12) bad = 1
          d = $9 * k - 60; if (d * d > 1e-9 && ticks - int(ticks) > 1e-3 && k - ticks > 1e-3) bad = 1
          if ($3 <= before) bad = 1; before = $3; if ($9 == 20) twenty = 1 }
        END { exit bad || !twenty || NR < 50 }' "$work/said"
report $? "CSV of growth: rates are one over the time, and steps of the tick"

"$KINESCOPE" sweep length "$(dirname "$0")/../programs/star.df" >"$work/said" 2>&1
report $? "a program is measured"
took=$("$KINESCOPE" trace "$(dirname "$0")/../programs/star.df" --summary | sed -n 's/.*refresh time *\([0-9.]* [mu]*s\),.*/\1/p')
says "its refresh takes what trace --summary says" "star.df takes $took a refresh"
says "how many times it could be shown" 'free running *[0-9.]* times as much'

refuses "a raster tube" 'is a raster tube' length --tube COLOR17
refuses "a short vector too long" 'at most 63' length --of short --length 64
refuses "a length beyond the screen" 'out of range' length --length 400mm
refuses "no number" 'length: ' length --length long
refuses "items without a list to write" 'for --write' length --items 3
refuses "more than the memory" 'fit into 64 KiB' length --write "$work/x.df" --items 40000
refuses "a program and a kind" 'leave it out' length --of points x.df
refuses "nothing steady to write" 'even the shortest' length --tube LAB31 --sync --write "$work/x.df"
[ ! -e "$work/x.df" ]
report $? "what was refused left no file"
"$KINESCOPE" sweep length "$work/none.df" >"$work/said" 2>&1
[ $? -eq 1 ]
report $? "a program that is not there"
"$KINESCOPE" sweep length -o "$work/length.png" >"$work/said" 2>&1 &&
    [ "$(head -c 8 "$work/length.png" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]
report $? "a plot of it"

for command in "sweep" "sweep length"; do
    "$KINESCOPE" $command --help >"$work/said" 2>&1 && grep -q '^  kinescope sweep' "$work/said" && grep -q -e '--csv' "$work/said"
    report $? "help of $command with examples"
done

echo "1..$number"
exit $failed
