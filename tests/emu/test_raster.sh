#!/bin/sh
# The raster head from outside: modes and tubes that fit or do not, views, the refresh buffer as a picture,
# the video trace against DMT figures to the picosecond, snapshots. Needs $KINESCOPE and $TEST_OUT; prints
# TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(dirname "$0")/../..
pattern=$root/roms/pattern.elf
heads=$root/roms/heads.elf
mask=$root/roms/mask.elf
work=$TEST_OUT/raster
rm -rf "$work"
mkdir -p "$work"
. "$root/tests/support/tap.sh"

kinescope() { # exit status in $got
    timeout 120 "$KINESCOPE" "$@" >"$work/out" 2>"$work/said" </dev/null
    got=$?
}

fails() { # NAME STATUS SENTENCE ARGUMENTS...
    name=$1 want=$2 sentence=$3
    shift 3
    kinescope "$@"
    [ $got -eq "$want" ] && grep -qF -- "$sentence" "$work/said"
    report $? "$name"
}

works() { # NAME ARGUMENTS...
    name=$1
    shift
    kinescope "$@"
    [ $got -eq 0 ]
    report $? "$name"
}

# ---- what fits and what does not ------------------------------------------------------------------

fails "a mode beyond the monitor is refused with the figures" 2 "COLOR17 follows" \
    capture "$pattern" --mode 1600x1200@85 --hash
grep -qF "106.25 kHz" "$work/said"
report $? "... which are 106.25 kHz"
fails "a mode that is none" 2 "--mode" capture "$pattern" --mode 640by480 --hash
fails "two tubes for one head" 2 "two tubes for the raster head" \
    capture "$pattern" --tube COLOR17 --tube SLOT14 --hash
fails "one colour for three guns" 2 "three" capture "$pattern" --tube COLOR17/P31 --hash
fails "a display file has no raster head" 2 "has no firmware" \
    capture "$root/roms/rose.df" --view raster --hash
fails "a close-up of both heads" 2 "give --view vector or --view raster" \
    capture "$heads" --closeup 512,512,10 --hash
fails "a figure of the other kind of tube" 2 "COLOR17 has no vector_unit" \
    capture "$pattern" --set raster.vector_unit=1us --hash
fails "what belongs to no head" 2 "memory belongs to no head; leave out 'raster.'" \
    capture "$pattern" --set raster.memory=16K --hash
fails "limits of a figure without a unit" 2 "it must be between 0.01 and 1" \
    capture "$pattern" --set field_duty=0 --hash
[ "$(tail -c 3 "$work/said")" = " 1" ] && ! grep -q "1 1" "$work/said"
report $? "... name none"
fails "the buffer needs no tube" 2 "--buffer" capture "$pattern" --buffer --film --hash
fails "a hash in the middle of a picture" 2 "--hash prints to standard output" \
    capture "$pattern" --hash -o -
fails "a hash in the middle of a film strip" 2 "--hash prints to standard output" \
    capture "$pattern" --hash --from 0.5s --to 0.52s --y4m -
works "the test pattern in amber, in another mode, as README has it" \
    capture "$pattern" --tube MONO12/P134 --mode 720x400@70 --hash
works "an amber tube and a vector tube, a figure of each" capture "$heads" --tube VR14 \
    --tube MONO12/P134 --mode 640x480@60 --set raster.spot=0.5 --set vector.spot=0.6 --hash

# ---- views ----------------------------------------------------------------------------------------

size() { # FILE: WIDTHxHEIGHT of a PNG
    od -An -j16 -N8 -tu1 "$1" | awk '{ print $1 * 16777216 + $2 * 65536 + $3 * 256 + $4 "x" \
                                             $5 * 16777216 + $6 * 65536 + $7 * 256 + $8 }'
}
for view in vector raster both auto; do
    works "film of view $view" capture "$heads" --view $view --film -o "$work/$view.png"
done
v=$(size "$work/vector.png") r=$(size "$work/raster.png") b=$(size "$work/both.png")
echo "$v $r $b" >"$work/said"
[ "${b%x*}" -eq $((${v%x*} + ${r%x*} + 16)) ]
report $? "both are side by side, a gap of 16 between them"
cmp -s "$work/both.png" "$work/auto.png"
report $? "auto is both for a program that uses both"
works "glass of both in a given size" capture "$heads" --view both --size 900x400 -o "$work/glass.png"
[ "$(size "$work/glass.png")" = 900x400 ]
report $? "... which it has"

# ---- the refresh buffer ---------------------------------------------------------------------------

works "the buffer as a picture" capture "$mask" --buffer -o "$work/buffer.png"
[ "$(size "$work/buffer.png")" = 1024x768 ]
report $? "... a pixel a dot"
works "its hash" capture "$mask" --buffer --hash
mv "$work/out" "$work/hash"
works "the same on another tube" capture "$mask" --buffer --hash --tube GRILLE17 --mode 1024x768@60
cmp -s "$work/out" "$work/hash"
report $? "... is the same buffer"

# ---- timing ---------------------------------------------------------------------------------------

# XGA: 65 MHz, 1344 dots a line, sync from 1048 to 1184; 806 lines, sync from 771 to 777; 768 rows.
# A dot is 200000/13 ps. The first row seen gives the origin to a line; everything else must fit it to
# the picosecond.
works "a trace of three frames" trace "$pattern" --what video --for 51ms -o "$work/video"
awk '
    function at(dot) { return origin + int(dot * 200000 / 13) }
    function fit(t, dot, what) {
        if (t != at(dot)) { print what " at " t " is not " at(dot); bad = 1; exit }
    }
    # The program switched it on at a cycle of 20 ns: of all such origins one fits the first row.
    NR == 1 { next }
    $3 == "row" && $5 == "begins" && !found {
        for (n = 0; n < 2000 && !found; n++) {
            dot = (n * 806 + $4) * 1344
            candidate = $2 - int(dot * 200000 / 13)
            if (candidate % 20000 == 0 && candidate > 0) { origin = candidate; found = 1; first = n }
        }
        if (!found) { print "no origin fits " $2; bad = 1; exit }
        frame = first; row = $4; lines = first * 806 + $4
    }
    !found { next }
    $3 == "row" && $5 == "begins" { if ($4 < last) frame++; last = $4
                                    fit($2, (frame * 806 + $4) * 1344, "row " $4); rows++ }
    $3 == "row" && $5 == "ends" { fit($2, (frame * 806 + $4) * 1344 + 1024, "end of row " $4) }
    $3 == "hsync" && $4 == "high" { if (!h++) line = lines; else line++
                                    fit($2, line * 1344 + 1048, "hsync") }
    $3 == "hsync" && $4 == "low" && h { fit($2, line * 1344 + 1184, "end of hsync") }
    $3 == "vsync" && $4 == "high" { fit($2, (frame * 806 + 771) * 1344, "vsync"); v++ }
    $3 == "vsync" && $4 == "low" { fit($2, (frame * 806 + 777) * 1344, "end of vsync") }
    END { if (!bad && (rows < 2300 || v < 3 || h < 2400)) { print rows, h, v; bad = 1 } exit bad }
' "$work/video" >"$work/said"
report $? "rows and sync pulses of XGA to the picosecond"

fails "no summary of a program without strokes" 1 "--summary measures the vector head" \
    trace "$pattern" --summary
[ ! -s "$work/out" ]
report $? "... and no figures of a head that is not used"
fails "nor a recording of its strokes" 1 "--what beam writes the strokes of the vector head" \
    trace "$pattern" --what beam -o "$work/none.beam"
works "a program of both heads has strokes" trace "$heads" --what beam -o "$work/heads.beam"

# ---- snapshots ------------------------------------------------------------------------------------

fails "a run saved in the middle of a frame" 3 "has not ended itself" run "$pattern" --headless \
    --for 400ms --save-state "$work/state"
works "a picture after going on" capture "$pattern" --view raster --at 450ms --hash \
    --load-state "$work/state"
mv "$work/out" "$work/on"
works "the same without interruption" capture "$pattern" --view raster --at 450ms --hash
cmp -s "$work/out" "$work/on"
report $? "... is the same picture"
fails "another raster tube cannot go on" 1 "made with another raster tube" \
    capture "$pattern" --at 450ms --hash --load-state "$work/state" --tube SLOT14
fails "nor another mode" 1 "raster tube" \
    capture "$pattern" --at 450ms --hash --load-state "$work/state" --mode 800x600@60

echo "1..$number"
exit $failed
