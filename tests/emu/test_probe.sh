#!/bin/sh
# kinescope probe from outside: figures recomputed here by awk, formats that agree, signals against the trace of
# the beam, what wrong use is told. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(dirname "$0")/../..
work=$TEST_OUT/probe
rm -rf "$work"
mkdir -p "$work"
. "$root/tests/support/tap.sh"
subcommand=probe
. "$root/tests/support/command.sh"

# value KEY [FILE]: of the flat JSON, as it stands there.
value() {
    sed -n "s/^[{ ]\"$1\": \(.*\)[,}]\$/\1/p" "${2:-$work/out}"
}

# near NAME KEY VALUE PART: the last output's figure, with a relative error of at most PART.
near() {
    awk -v got="$(value "$2")" -v want="$3" -v part="$4" \
        'BEGIN { d = got - want; if (d < 0) d = -d; w = want < 0 ? -want : want; exit !(got != "" && d <= part * w) }'
    status=$?
    [ $status -eq 0 ] || echo "$2 is $(value "$2"), not $3" >"$work/said"
    report $status "$1"
}

cat >"$work/dot.df" <<'END'
        .tube   "VR17"
        .start  again
again:  sync    italics=off
        point   i=7 pen=off blink=off line=solid
        plot    512, 512
        jump    again
END
cd "$work" || exit 1
case $0 in /*) ;; *) root=$OLDPWD/$root ;; esac
case $KINESCOPE in /*) ;; *) KINESCOPE=$OLDPWD/$KINESCOPE ;; esac
case $work in /*) ;; *) work=$OLDPWD/$work ;; esac

# ---- figures ----------------------------------------------------------------------------------------

# Phosphor, C1, percent flicker, flicker index at 60 Hz: known to as many digits as are here.
while read -r phosphor c1 percent index; do
    ask dot.df --at 512,512 --phosphor "$phosphor"
    awk -v a="$(value c1)" -v b="$(value percent_flicker)" -v c="$(value flicker_index)" \
        -v x="$c1" -v y="$percent" -v z="$index" 'function off(p, q) { return p < q ? q - p : p - q }
        function last(s) { n = index(s, "."); return n ? 0.51 * 10 ^ (n - length(s)) : 0.51 }
        BEGIN { exit !(a != "" && off(a, x) < last(x) && off(b, y) < last(y) && off(c, z) < last(z)) }'
    report $? "$phosphor at 60 Hz: C1 $c1, $percent %, index $index"
done <<'END'
P31 1.19 99 .50
P4 1.41 99.6 .59
P1 .445 61 .17
P43 1.96 100 .86
P53 1.31 99 .51
P39 .081 12.7 .032
END
value tube | grep -qx '"VR17"' && value phosphor | grep -qx '"P39"' && value head | grep -qx '"vector"' &&
    value periods | grep -qx 6 && value settled | grep -qx true && value svm | grep -qx '"not applicable"'
report $? "JSON names tube, phosphor and head"

# One exponential of t10/2.303: C1, tanh, and the CFF found here anew for 50 degrees, 200 cd/m2, 4 mm.
for hz in 30 50 75; do
    works "P39 at $hz Hz" dot.df --at 512,512 --phosphor P39 --refresh $hz --field 50 --pupil 4 --luminance 200
    near "its refresh rate" refresh_hz $hz 1e-6
    set -- $(awk -v f=$hz 'BEGIN { pi = 3.14159265358979; tau = 0.150 / log(10); x = 1 / (f * tau)
        c = 2 / sqrt(1 + (2 * pi * f * tau) ^ 2); e = exp(x)
        low = 1; high = 200
        for (i = 0; i < 100; i++) { h = (low + high) / 2
            if (8.32 + 9.73 * log(200 * pi * 4 * 2 / sqrt(1 + (2 * pi * h * tau) ^ 2)) > h) low = h; else high = h }
        printf "%.9g %.9g %.9g\n", c, 100 * (e - 1) / (e + 1), low }')
    near "its first harmonic" c1 "$1" 0.002
    near "its percent flicker" percent_flicker "$2" 0.01
    near "its fusion frequency" cff_hz "$3" 0.002
done

keys=$(sed -n 's/^[{ ]"\([a-z0-9_]*\)".*/\1/p' out | tr '\n' ' ')
[ "$keys" = "program tube phosphor head sensor x y area_mm from_s to_s periods settled refresh_hz repeats_hz \
fundamental_hz c1 c2 c3 c4 c5 c6 c7 c8 percent_flicker flicker_index mean_cd_m2 peak_cd_m2 least_cd_m2 \
persistence_10_s field_deg pupil_mm luminance_cd_m2 cff_hz cff_of_hz cff_harmonic cff_ferry_porter_hz flickers ieee_1789 svm " ]
report $? "keys are all there, in order"
! command -v python3 >/dev/null || python3 -m json.tool out >json.txt 2>said
report $? "JSON is JSON"
works "fast enough for a stroboscopic measure" dot.df --at 512,512 --phosphor P31 --refresh 100
value svm | grep -q '^[0-9.]*$'
report $? "which is then a number"
near "that of all harmonics up to 2 kHz" svm "$("$KINESCOPE" sweep --phosphors P31 --rates 100 --field 30 --csv - |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "svm") column = i } END { print $column }')" 1e-4

# ---- samples ----------------------------------------------------------------------------------------

works "samples" "$root/roms/rose.df" --at 512,690 --csv rose.csv
mean=$(awk -F, 'NR == 1 { if ($0 != "t_s,cd_m2") exit; next }
    NR > 2 { if ($1 <= t) bad = 1; a += ($2 + v) / 2 * ($1 - t) } NR == 2 { t0 = $1 } { t = $1; v = $2 }
    END { if (!bad) printf "%.9g", a / (t - t0) }' rose.csv)
near "their mean is the mean" mean_cd_m2 "$mean" 0.005
near "their peak is the peak" peak_cd_m2 "$(awk -F, 'NR > 1 && $2 > m { m = $2 } END { print m }' rose.csv)" 1e-3
works "even samples of two colours" dot.df --at 512,512 --phosphor P4 --from 0.5s --to 0.51s --csv - --rate 100000
awk -F, 'NR == 1 { exit $0 != "t_s,cd_m2,cd_m2_colour1,cd_m2_colour2" } ' out &&
    awk -F, 'NR > 1 { d = $1 - 0.5 - (NR - 2) * 1e-5; e = $2 - $3 - $4
        if (d * d > 1e-20 || e * e > 1e-12 * $2 * $2) bad = 1 } END { exit bad || NR != 1001 }' out
report $? "a hundred thousand a second, and colours add up"

# ---- plots ------------------------------------------------------------------------------------------

works "a plot" dot.df --at 512,512 -o a.png --csv a.csv
mv out a.json
works "the same again, by two threads" dot.df --at 512,512 -o b.png --csv b.csv --threads 2
cmp a.png b.png >said && cmp a.csv b.csv >said && cmp a.json out >said
report $? "has the same bytes"
works "large and by decades" dot.df --at 512,512 -o c.png --projector --log --size 640x480
od -A n -t u1 -j 16 -N 8 c.png | grep -q '0 *0 *2 *128 *0 *0 *1 *224'
report $? "in the size asked for"

# ---- sensors ----------------------------------------------------------------------------------------

works "a point of a list" "$root/roms/rose.df" --at 512,690
point=$(value c2)
works "the whole screen" "$root/roms/rose.df" --screen
awk -v a="$(value c2)" -v b="$point" 'BEGIN { exit !(a < 0.9 * b) }'
report $? "is steadier than a point"
[ "$(value sensor)" = '"screen"' ] && [ "$(value x)" = null ]
report $? "and has no place"
works "a small disc" dot.df --at 512,512 --area 0.01
near "sees what a point sees" mean_cd_m2 "$(value mean_cd_m2 a.json)" 0.001
works "a large disc" dot.df --at 512,512 --area 20
large=$(value mean_cd_m2)
works "one of twice the width" dot.df --at 512,512 --area 40
near "sees a quarter of it" mean_cd_m2 "$(awk -v m="$large" 'BEGIN { print m / 4 }')" 1e-4

# ---- programs, recordings, snapshots ----------------------------------------------------------------

works "the raster head" "$root/roms/pattern.elf" --at 512,384
[ "$(value head)" = '"raster"' ] && [ "$(value phosphor)" = '"P22"' ]
report $? "is found by itself"
near "its refresh" refresh_hz 60.003841 1e-6
works "rows of one field" "$root/roms/interlace.elf" --tube TV12M --at 110,180 --area 15
near "come half as often as fields" repeats_hz 29.97003 1e-6
one=$(value c1)
works "rows of both fields" "$root/roms/interlace.elf" --tube TV12M --at 440,180 --area 15
awk -v a="$(value c1)" -v b="$one" -v c="$(value c2)" 'BEGIN { exit !(a < 0.05 && b > 1 && c > 1) }'
report $? "have hardly a first harmonic, but a second"
[ "$(value cff_harmonic)" = 2 ]
report $? "which is the one that people may see"

"$KINESCOPE" trace "$root/roms/rose.df" --what beam -o rose.beam 2>said
works "a recording" rose.beam --at 512,690
recorded=$(value c1)
works "and its program" "$root/roms/rose.df" --at 512,690
near "have the same flicker" c1 "$recorded" 1e-5
kept=$(value mean_cd_m2)
works "a machine saved after a probe" dot.df --at 512,512 --to 0.6s --from 0.5s --save-state a.state
"$KINESCOPE" run dot.df --headless --for 0.6s --save-state b.state >said 2>&1 && cmp a.state b.state >said
report $? "has not noticed it"
"$KINESCOPE" capture "$root/roms/rose.df" --at 0.5s --save-state c.state --hash >said 2>&1
works "from a saved machine on" "$root/roms/rose.df" --at 512,690 --load-state c.state
near "the light goes on" mean_cd_m2 "$kept" 0.002

# ---- signals ----------------------------------------------------------------------------------------

works "signals of the vector head" "$root/roms/rose.df" --signal x,y,z --from 0.51s --to 0.53s --csv s.csv -o s.png
"$KINESCOPE" trace "$root/roms/rose.df" --what beam --from 0.51s --for 20ms -o s.beam 2>said
# Each stroke's ends are rows of the table at its times: the last one when it begins, the first one when it ends,
# as the beam may jump; and its drive is there.
awk -F '[ ,]' 'function same(a, b) { a -= b; return a * a < 1e-7 }
    FILENAME == "s.csv" { if (FNR == 1) { bad = $0 != "t_s,x_mm,y_mm,z"; next }
        t = sprintf("%.0f", $1 * 1e12); x1[t] = $2; y1[t] = $3; z1[t] = $4
        if (!(t in x0)) { x0[t] = $2; y0[t] = $3; z0[t] = $4 }; next }
    $1 == "s" && $3 < 530000000000 { n++
        if (!($2 in x0) || !($3 in x0) || !same(x1[$2], $4) || !same(y1[$2], $5) || !same(z1[$2], $8) ||
            !same(x0[$3], $6) || !same(y0[$3], $7) || !same(z0[$3], $8)) { bad = 1; print } }
    END { print n; exit bad || n < 500 }' s.csv s.beam >said
report $? "pass through the ends of each stroke when the trace says so"
works "signals of the raster head" "$root/roms/pattern.elf" --signal x,y --from 0.5s --to 0.52s --csv r.csv
# XGA at 60 Hz: 1344 dots of 65 MHz a line, 806 lines; sync of 136 dots and of 6 lines.
awk -F, 'NR > 2 && $2 < x { if (t) { n++; d = ($1 - t) - 1344 / 65e6; if (f && d * d > 1e-22) bad = 1 }; t = $1; f = 1 }
    NR > 2 && $3 > y + 1 { up++ } NR > 1 { x = $2; y = $3 } END { print n, up, bad; exit bad || n < 960 || up < 1 }' r.csv >said
report $? "fly back as often as there are lines"
works "signals, evenly" dot.df --signal z --csv - --rate 10000000
awk -F, 'NR == 1 { bad = $0 != "t_s,z"; next } $2 != 0 { on++ } END { exit bad || on < 9 || on > 11 }' out
report $? "a point is lit for a microsecond"

# ---- wrong use --------------------------------------------------------------------------------------

fails "no place" 2 "give --at X,Y or --screen" dot.df
fails "half a place" 2 "is not X,Y" dot.df --at 512
fails "no numbers" 2 "is not X,Y" dot.df --at a,b
fails "a place beside the screen" 1 "beside the screen" dot.df --at 9999,512
fails "a place on all of the screen" 2 "leave out --at" dot.df --at 1,1 --screen
fails "a signal that there is not" 2 "is not x, y or z" dot.df --signal x,w --csv -
fails "a signal at a place" 2 "leave out --at" dot.df --signal x --at 1,1 --csv -
fails "a signal for nobody" 2 "nothing is to be written" dot.df --signal x
fails "a rate without samples" 2 "--rate is for --csv" dot.df --at 512,512 --rate 1000
fails "too many samples" 2 "that would be 1e+11 samples" dot.df --signal x --csv - --rate 1e12 --from 0.5s --to 0.6s
fails "a size without a plot" 2 "are for -o" dot.df --at 512,512 --size 640x480
fails "one file for two" 2 "give two names" dot.df --at 512,512 --csv a -o a
fails "a time that ends before it begins" 2 "--to must be later" dot.df --at 512,512 --from 1s --to 0.5s
fails "two beginnings" 2 "exclude each other" dot.df --at 512,512 --from 1s --when stop:1
fails "two heads" 2 "give --view vector or --view raster" "$root/roms/heads.elf" --at 512,512
fails "a head that is not used" 2 "give --view raster" "$root/roms/pattern.elf" --at 512,384 --view vector
fails "the program written over" 2 "dot.df" dot.df --at 512,512 --csv dot.df
fails "no such folder" 1 "none/a.png" dot.df --at 512,512 -o none/a.png
fails "darkness" 1 "there is no light of dot.df" dot.df --at 5,5 -o dark.png
[ ! -e dark.png ]
report $? "which writes nothing"
works "darkness allowed" dot.df --at 5,5 --allow-dark -o dark.png
[ "$(value mean_cd_m2)" = 0 ] && [ "$(value c1)" = null ] && [ "$(value cff_hz)" = null ] && [ -s dark.png ]
report $? "has no figures but a picture"

echo "1..$number"
exit $failed
