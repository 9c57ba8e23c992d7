#!/bin/sh
# Digitising in the machine: the script's leaf, with each kind of tablet: area, length and every point against
# the outline that the hand followed; warm air; heights; a puck's buttons.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/digitise
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# What the program prints: SCRIPT SETTING…
written() {
    script=$1
    shift
    "$KINESCOPE" run roms/digitise.elf --headless --console --input "$script" --for 60s "$@" 2>"$work/errors" </dev/null |
        tr -d '\r'
}

{ cat roms/digitise.script && printf 'key W\n+3s key Q\n'; } >"$work/script"
# The corners of the outline, on the tablet, mm.
sed -n '/^# outline$/,/^# outline ends$/s/^tablet touch \([0-9.]*\) \([0-9.]*\) .*/\1 \2/p' roms/digitise.script \
    >"$work/outline"

# The table against the outline. The paper's origin is at 38 32 on the tablet, and the paper is turned by 10
# degrees. The points are apart from the outline by noise, by the tolerance, and by corners that lie between two
# reports.
compare() { # FILE AREA-PER-CENT APART-MM
    awk -v percent="$2" -v most="$3" '
        function to_segment(px, py, i,    dx, dy, l, t) {
            dx = x[i + 1] - x[i]; dy = y[i + 1] - y[i]; px -= x[i]; py -= y[i]
            l = dx * dx + dy * dy
            t = l > 0 ? (px * dx + py * dy) / l : 0
            t = t < 0 ? 0 : t > 1 ? 1 : t
            return sqrt((px - t * dx) ^ 2 + (py - t * dy) ^ 2)
        }
        FNR == NR { x[++n] = $1; y[n] = $2; next }
        /^1,/ {
            split($0, f, ","); c = cos(atan2(0, -1) / 18); s = sin(atan2(0, -1) / 18)
            px = 38 + f[3] * c - f[4] * s; py = 32 + f[3] * s + f[4] * c
            least = 1e9
            for (i = 1; i < n; i++) {
                d = to_segment(px, py, i)
                if (d < least) least = d
            }
            if (least > worst) worst = least
            points++
        }
        /^# line 1:/ && /closed, gaps 0,/ { match($0, /area [0-9.]+/); area = substr($0, RSTART + 5, RLENGTH - 5) }
        END {
            for (i = 1; i < n; i++) {
                sum += (x[i] * y[i + 1] - x[i + 1] * y[i]) / 2
                length_of += sqrt((x[i + 1] - x[i]) ^ 2 + (y[i + 1] - y[i]) ^ 2)
            }
            sum = sum < 0 ? -sum : sum
            printf "area %.1f of %.1f mm2, %d points, worst %.3f mm\n", area, sum, points, worst
            off = area > sum ? area - sum : sum - area
            exit !(points > 30 && points < 120 && off < sum * percent / 100 && worst < most)
        }' "$work/outline" "$1"
}

for kind in electrical sonic resistive; do
    written "$work/script" --set tablet=$kind >"$work/$kind"
    grep -q "^# tablet $kind, 0.100 mm a count, 60.00 reports a second, lost 0\$" "$work/$kind" &&
        compare "$work/$kind" 0.3 0.5 >"$work/said"
    report $? "$kind tablet: area, and each point, of the leaf"
done
: >"$work/said"
grep -qx 'line,point,x_mm,y_mm,z_mm,samples,s_mm,gap' "$work/electrical" && tail -1 "$work/electrical" | grep -qx '# end'
report $? "the table has a heading with units, and an end"

# ---- what reference points take out ------------------------------------------------------------------------
written "$work/script" --set tablet=sonic --set tablet.temperature=35 >"$work/warm"
compare "$work/warm" 0.3 0.5 >"$work/said"
report $? "sonic tablet in warm air: the paper's marks take the speed of sound out"
scale() {
    sed -n 's/^# paper .*, \([0-9.]*\) mm a count, .*/\1/p' "$1"
}
awk -v cold="$(scale "$work/sonic")" -v warm="$(scale "$work/warm")" \
    'BEGIN { r = warm / cold; exit !(r > 1.046 && r < 1.056) }' # it works with squares: 308.15 / 293.15 = 1.0512
report $? "… which the scale tells"

# ---- a puck, heights ----------------------------------------------------------------------------------------
# Three marks; a square of 50 mm by button 0, a point too many deleted by 2, closed by 3; then a stair of three
# points with heights.
press() { # X Y Z BUTTON
    printf 'tablet move %s %s %s in 100ms\n+300ms tablet press %s\n+300ms tablet release %s\n+60ms ' "$@" "$4"
}
{
    printf 'at 0.3s '
    press 20 20 0 0
    press 220 20 0 0
    press 20 170 0 0
    printf 'key L\n'
    press 70 70 0 0
    press 120 70 0 0
    press 120 120 0 0
    press 70 120 0 0
    press 200 200 0 0
    press 200 200 0 2
    press 200 200 0 3
    press 100 100 3 0
    press 103 100 7 0
    press 106 100 11 0
    printf 'key W\n+1s key Q\n'
} | sed 's/^+60ms $//' >"$work/puck"
written "$work/puck" --set tablet=electrical --set tablet.buttons=4 >"$work/said"
sed -n 's/^# line 1: 4 points, closed, gaps 0, length \([0-9.]*\) mm, .* area \([0-9.]*\) mm2$/\1 \2/p' "$work/said" |
    awk '{ n++; exit !($1 > 199.5 && $1 < 200.5 && $2 > 2488 && $2 < 2512) } END { if (!n) exit 1 }'
report $? "a puck's buttons: enter, delete, close; the square"
sed -n 's/^# line 2: 3 points, open, gaps 0, length \([0-9.]*\) mm, with heights \([0-9.]*\) mm, .*/\1 \2/p' "$work/said" |
    awk '{ n++; exit !($1 > 5.6 && $1 < 6.4 && $2 > 8 && $2 < 12) } END { if (!n) exit 1 }'
report $? "heights lengthen a stair"
awk -F, '/^1,/ { n++; if ($6 < 10 || $7 <= 0 || $7 > 0.4) exit wrong = 1 } END { exit wrong || n != 4 }' "$work/said"
report $? "each point is a mean, and says how it scattered"

"$KINESCOPE" capture roms/digitise.elf --input roms/digitise.script --at 3s --view raster --size 320x240 \
    -o "$work/leaf.png" >"$work/said" 2>&1
report $? "the script's picture"
echo "1..$number"
exit $failed
