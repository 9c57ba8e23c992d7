#!/bin/sh
# kinescope probe --along from outside: widths and dips of Gaussian spots against their closed forms, worked out here
# by awk; figures that agree with the CSV and with a photodiode at a place; what wrong use is told. Needs $KINESCOPE
# and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$TEST_OUT/probe_along
rm -rf "$work"
mkdir -p "$work"
. "$root/tests/support/tap.sh"
subcommand=probe
. "$root/tests/support/command.sh"
case $KINESCOPE in /*) ;; *) KINESCOPE=$PWD/$KINESCOPE ;; esac
case $work in /*) ;; *) work=$PWD/$work ;; esac
cd "$work" || exit 1

value() { # KEY: of the flat JSON
    sed -n "s/^[{ ]\"$1\": \(.*\)[,}]\$/\1/p" out
}

# near NAME KEY VALUE ERROR: the last output's figure, with an absolute error of at most ERROR.
near() {
    awk -v got="$(value "$2")" -v want="$3" -v most="$4" \
        'BEGIN { d = got - want; exit !(got != "" && got != "null" && want != "" && d * d <= most * most) }'
    status=$?
    [ $status -eq 0 ] || echo "$2 is $(value "$2"), not $3" >said
    report $status "$1"
}

list() { # FILE X...: points at X,512, all in one refresh
    file=$1
    shift
    {
        printf '        .tube   "VR17"\n        .start  again\nagain:  sync    italics=off\n'
        printf '        point   i=7 pen=off blink=off line=solid\n'
        for x; do
            echo "        plot    $x, 512"
        done
        echo "        jump    again"
    } >"$file"
}

# ---- one spot ---------------------------------------------------------------------------------------

# A Gaussian is 2·sqrt(2·ln(1/p)) sigma wide at a share p of its crest; the row's spot is its width at 60 %.
pitch=$(awk 'BEGIN { print 234.95 / 1024 }')
list dot.df 512
for spot in 0.3 0.9; do
    works "a spot of $spot mm" dot.df --at 480,512 --along 544,512 --set spot=$spot --set spot_growth=0
    near "is that wide at 60 %" width60_mm $spot 0.0005
    near "and at half" width50_mm "$(awk -v s=$spot 'BEGIN { print s * sqrt(log(2) / -log(0.6)) }')" 0.0005
    near "in its middle" crest_mm "$(awk -v p="$pitch" 'BEGIN { print 32 * p }')" 0.02
    # Its whole light along the line is crest·sigma·sqrt(2 pi).
    near "with the light of a Gaussian" mean_cd_m2 "$(awk -v s=$spot -v c="$(value crest_cd_m2)" \
        -v l="$(value length_mm)" 'BEGIN { print c * s / (2 * sqrt(-2 * log(0.6))) * sqrt(8 * atan2(1, 1)) / l }')" \
        "$(awk -v c="$(value mean_cd_m2)" 'BEGIN { print 2e-4 * c }')"
done
[ "$(value crests)" = 1 ] && [ "$(value dip_cd_m2)" = null ] && [ "$(value dip_modulation)" = 0 ] &&
    [ "$(value apart_mm)" = null ]
report $? "one crest has no dip"
works "aslant" dot.df --at 490,490 --along 534,534 --set spot_growth=0
near "it is as wide" width60_mm 0.508 0.0005
near "the line is as long as its ends are apart" length_mm \
    "$(awk -v p="$pitch" 'BEGIN { print 44 * sqrt(2) * p }')" 0.001
works "a line that ends at the crest" dot.df --at 512,512 --along 534,512
[ "$(value width60_mm)" = null ] && [ "$(value width50_mm)" = null ] && [ "$(value crest_mm)" = 0 ]
report $? "has no width there"

# ---- two spots --------------------------------------------------------------------------------------

# In sigma, d apart: between them 2·exp(-d²/8); the crests where x = d·g/(1 + g), g = exp((2xd - d²)/2).
for units in 4 5 6 8; do
    list two.df 500 $((500 + units))
    set -- $(awk -v u=$units -v p="$pitch" 'BEGIN { s = 0.508 / (2 * sqrt(-2 * log(0.6))); d = u * p / s
        for (i = 0; i < 500; i++) { g = exp((2 * x * d - d * d) / 2); x = d * g / (1 + g) }
        c = exp(-x * x / 2) + exp(-(x - d) * (x - d) / 2); m = 2 * exp(-d * d / 8)
        printf "%.6f %.6f %.6f\n", (c - m) / (c + m), (d - 2 * x) * s, m / c }')
    works "two spots $units units apart" two.df --at 490,512 --along $((510 + units)),512 --set spot_growth=0 \
        --csv two.csv
    near "their dip" dip_modulation "$1" 0.002
    near "their crests' distance" apart_mm "$2" 0.03
    near "the light in between" dip_cd_m2 "$(awk -v c="$(value crest_cd_m2)" -v r="$3" 'BEGIN { print c * r }')" \
        "$(awk -v c="$(value crest_cd_m2)" 'BEGIN { print 0.003 * c }')"
    [ "$(value crests)" = 2 ]
    report $? "two crests"
done
# Closer than two sigma they are one (Sparrow's limit): sigma is 1.1 units here.
list two.df 500 502
works "two spots 2 units apart" two.df --at 490,512 --along 512,512 --set spot_growth=0
[ "$(value crests)" = 1 ] && [ "$(value apart_mm)" = null ]
report $? "are one crest"
list three.df 496 502 508
works "three spots" three.df --at 486,512 --along 518,512 --set spot_growth=0
[ "$(value crests)" = 3 ]
report $? "are three crests"

# ---- files and other probes -------------------------------------------------------------------------

list two.df 500 505
works "a table and a plot" two.df --at 490,512 --along 515,512 --csv a.csv -o a.png --from 1s --to 1.1s
mv out a.json
works "the same again, by two threads" two.df --at 490,512 --along 515,512 --csv b.csv -o b.png --from 1s --to 1.1s \
    --threads 2
cmp a.json out >said && cmp a.csv b.csv >said && cmp a.png b.png >said
report $? "has the same bytes"
awk -F, -v crest="$(value crest_cd_m2)" -v mean="$(value mean_cd_m2)" -v length_mm="$(value length_mm)" '
    NR == 1 { bad = $0 != "mm,cd_m2"; next }
    NR > 2 { if ($1 <= x) bad = 1; sum += ($2 + v) / 2 * ($1 - x) } { x = $1; v = $2; if (v > top) top = v }
    function off(a, b) { return (a - b) * (a - b) > 1e-10 * b * b }
    END { exit bad || NR != 502 || off(top, crest) || off(x, length_mm) || off(sum / x, mean) }' a.csv
report $? "the table has the figures"
[ "$(od -A n -t x1 -N 8 a.png | tr -d ' ')" = 89504e470d0a1a0a ]
report $? "the plot is a PNG"
echo old >kept.png
echo old >kept.csv
for kept in png csv; do # a disk that is full after a block
    case $kept in png) option=-o ;; *) option=--csv ;; esac
    (
        trap '' XFSZ
        ulimit -f 1
        exec "$KINESCOPE" probe two.df --at 490,512 --along 515,512 $option kept.$kept >out 2>said </dev/null
    )
    [ $? -eq 1 ] && [ "$(cat kept.$kept)" = old ] && [ ! -s out ] && [ "$(wc -l <said)" -eq 1 ]
    report $? "a full disk leaves the old $kept"
done
middle=$(awk -F, 'NR == 252 { print $2 }' a.csv)
works "a photodiode in the middle" two.df --at 502.5,512 --from 1s --to 1.1s
near "sees the middle of the table" mean_cd_m2 "$middle" "$(awk -v m="$middle" 'BEGIN { print 1e-3 * m }')"
works "the table alone" two.df --at 490,512 --along 515,512 --csv - --from 1s --to 1.1s
cmp a.csv out >said
report $? "is what goes to standard output"
works "the other way round" two.df --at 515,512 --along 490,512 --csv c.csv --from 1s --to 1.1s
awk -F, 'FNR == 1 { next } FILENAME == "a.csv" { v[FNR] = $2; if ($2 > top) top = $2; next }
    { n++; d = $2 - v[504 - FNR]; if (d * d > 1e-10 * top * top) bad = 1 } END { exit bad || n != 501 }' a.csv c.csv >said
report $? "is the same table backwards"
works "the raster head" "$root/roms/pattern.elf" --at 512,380 --along 512,390 --from 0.5s --to 0.501s
awk -v c="$(value crests)" -v m="$(value dip_modulation)" 'BEGIN { exit !(c >= 1 && m >= 0 && m <= 1) }'
report $? "has a profile"

# ---- wrong use --------------------------------------------------------------------------------------

fails "no beginning" 2 "give --at X,Y" dot.df --along 5,5
fails "half an end" 2 "is not X,Y" dot.df --at 490,512 --along 5
fails "the same place twice" 2 "the same place" dot.df --at 490,512 --along 490.0,512
fails "of a disc" 2 "leave out --screen and --area" dot.df --at 490,512 --along 510,512 --area 2
fails "of a viewer" 2 "leave out --field, --pupil" dot.df --at 490,512 --along 510,512 --pupil 4
fails "of samples" 2 "--rate" dot.df --at 490,512 --along 510,512 --csv a.csv --rate 1000
fails "of a signal" 2 "leave out --at, --along" dot.df --signal x --along 510,512 --csv a.csv
fails "no such folder" 1 "none/a.csv" dot.df --at 490,512 --along 510,512 --csv none/a.csv
fails "darkness" 1 "there is no light of dot.df along that line" dot.df --at 5,5 --along 50,5 --csv dark.csv -o dark.png
[ ! -e dark.csv ] && [ ! -e dark.png ]
report $? "which writes nothing"
works "darkness allowed" dot.df --at 5,5 --along 50,5 --allow-dark
[ "$(value crest_cd_m2)" = 0 ] && [ "$(value crests)" = 0 ] && [ "$(value width60_mm)" = null ]
report $? "has no crest"

echo "1..$number"
exit $failed
