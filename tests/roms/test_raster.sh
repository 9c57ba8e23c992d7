#!/bin/sh
# Programs for the raster head: each is complete when it says so, listens to its keys, draws the same
# twice, and does with retrace, line compare, look-up table and timing what it claims; without a raster
# head each says so. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/raster
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh
programs="pattern pageflip palette interlace heads aspect mask"
tube_of() { # PROGRAM: one that is quick to compute and whose monitor follows it
    case $1 in
    interlace) echo TV12M ;;
    aspect) echo COLOR17 ;;
    *) echo SLOT14 ;;
    esac
}
skip() { # NAME REASON
    number=$((number + 1))
    echo "ok $number - $1 # SKIP $2"
}

# ---- all of them --------------------------------------------------------------------------------------
film() { # OUT OPTIONS...
    out=$1
    shift
    "$KINESCOPE" capture "$@" --film --hash >"$work/$out" 2>"$work/said"
}
for program in $programs; do
    tube=$(tube_of "$program")
    film "$program.1" "roms/$program.elf" --tube "$tube" --at 0.4s --threads 1 &&
        film "$program.2" "roms/$program.elf" --tube "$tube" --at 0.4s --threads 2 &&
        cmp "$work/$program.1" "$work/$program.2" >>"$work/said" 2>&1
    report $? "$program: it is drawn, the same twice"
    "$KINESCOPE" run "roms/$program.elf" --tube "$tube" --headless --console --type q --for 2s \
        >"$work/said" 2>&1
    report $? "$program: q ends it"
done
if command -v qemu-system-riscv32 >/dev/null 2>&1; then
    for program in $programs; do
        timeout 20 qemu-system-riscv32 -M virt -bios none -nographic -cpu rv32,c=false,d=false \
            -kernel "roms/$program.elf" </dev/null >"$work/said" 2>&1
        [ $? = 1 ] && grep -qE "^$program: this board (has no raster head|does not have two heads)" "$work/said"
        report $? "$program: on a board without a raster head it says so"
    done
else
    skip "on a board without a raster head they say so" "no qemu-system-riscv32"
fi

# ---- board support --------------------------------------------------------------------------------------
"$KINESCOPE" run tests/roms/video.elf --tube SLOT14 --headless --console --for 2s >"$work/printed" \
    2>"$work/said" </dev/null
report $? "board support: all of it returns"
tr -d '\r' <"$work/printed" | diff tests/roms/video.txt - >"$work/said"
report $? "board support: timing, pages, retrace, line compare"
if command -v qemu-system-riscv32 >/dev/null 2>&1; then
    timeout 20 qemu-system-riscv32 -M virt -bios none -nographic -cpu rv32,c=false,d=false \
        -kernel tests/roms/video.elf </dev/null 2>&1 | tr -d '\r' >"$work/said"
    grep -q '^raster head: no, 0 by 0 um$' "$work/said" && grep -q '^off again: 0$' "$work/said"
    report $? "board support: without a raster head all of it returns"
else
    skip "board support: without a raster head all of it returns" "no qemu-system-riscv32"
fi

# ---- pattern --------------------------------------------------------------------------------------------
for n in 15 30; do
    film "still.$n" roms/pattern.elf --tube SLOT14 --when refresh:$n
done
cmp "$work/still.15" "$work/still.30" >"$work/said" 2>&1
report $? "pattern: one refresh is like the other"
for key in a b c g r f w k 1 2 3; do
    film "key.$key" roms/pattern.elf --tube SLOT14 --type $key --at 0.3s --allow-dark
done
[ "$(cat "$work"/key.* | sort -u | wc -l)" = 11 ]
report $? "pattern: eleven keys, eleven pictures"
for mode in 640x350@85 800x600@75 1280x1024@60; do
    film "mode" roms/pattern.elf --tube GRILLE17 --mode $mode --at 0.5s
    report $? "pattern: in $mode"
done
# Half of the rows white, or all of them at the level of 1/2.4: the same light on a tube of 2.4.
if command -v convert >/dev/null 2>&1; then
    light() { # X Y: mean light of 6 mm there
        "$KINESCOPE" capture roms/pattern.elf --tube MONO12 --set gun_exponent=2.4 --type g --at 0.4s \
            --closeup "$1,$2,6" --size 400x300 --depth 16 -o "$work/light.png" 2>"$work/said" &&
            convert "$work/light.png" -colorspace RGB -format '%[fx:mean.g]' info:
    }
    echo "$(light 54 233) $(light 98 233) $(light 542 107)" >"$work/said"
    awk '{ near = $2 / $1 - 1; far = $3 / $1 - 1 }
         END { exit !($1 > 0.1 && near * near < 0.005 ^ 2 && far < -0.015) }' "$work/said"
    report $? "pattern: the patch for 2.4 gives the light of its lines, the one for 2.3 does not"
else
    skip "pattern: the patch for 2.4 gives the light of its lines" "no ImageMagick"
fi

# ---- palette --------------------------------------------------------------------------------------------
# In 34 ms, two fields of 640x480@60: no pixel is stored; 240 colours a field, and one for each of the
# band's 124 rows, in the row before it.
"$KINESCOPE" trace roms/palette.elf --tube SLOT14 --what cpu --from 1s --for 34ms 2>"$work/said" |
    sed -n 's/^cpu \([0-9]*\) .* s[bhw] .* \[\(4[0-9a-f]*\)\]=\(.*\)/\1 \2 \3/p' >"$work/stores"
! grep -q ' 42' "$work/stores"
report $? "palette: no pixel is stored"
[ "$(grep -c ' 400203e8 ' "$work/stores")" -ge 247 ] && [ "$(grep -c ' 400200' "$work/stores")" -ge 126 ]
report $? "palette: colours are stored all the time"
"$KINESCOPE" trace roms/palette.elf --tube SLOT14 --what video --from 1s --for 34ms 2>>"$work/said" |
    sed -n 's/^video \([0-9]*\) row \([0-9]*\) begins$/\1 \2/p' >"$work/rows"
awk '$2 == "400203e8" { print $1, "store" }' "$work/stores" | sort -s -n -k1,1 - "$work/rows" |
    awk '$2 == "store" { if (stored[row]++ && row == last) twice++; if (row < 335 || row > 458) bad++
                         n++; last = row; next }
         { row = $2 } END { print n " stores, " bad + 0 " elsewhere, " twice + 0 " twice"
                            exit !(n >= 247 && !bad && !twice) }' >"$work/said"
report $? "palette: the band's colour is stored once in each row before one of the band"

# ---- interlace ------------------------------------------------------------------------------------------
rows() { # FROM: rows in the order of time
    "$KINESCOPE" trace roms/interlace.elf --tube TV12M --what video --from "$1" --for 51ms 2>"$work/said" |
        sed -n 's/^video [0-9]* row \([0-9]*\) begins$/\1/p'
}
rows 1s | awk 'NR > 1 && $1 > before && $1 != before + 2 { bad = 1 }
               $1 < before { fields++; first[$1] = 1 } { before = $1 }
               END { exit !(!bad && fields >= 2 && first[0] && first[1]) }'
report $? "interlace: fields of even and odd rows by turns"
rows 6s | awk 'NR > 1 && $1 > before && $1 != before + 1 { bad = 1 }
               $1 < before { fields++; if ($1 || before != 239) bad = 1 } { before = $1 }
               END { exit !(!bad && fields >= 2) }'
report $? "interlace: then fields of 240 rows"
"$KINESCOPE" run roms/interlace.elf --tube MONO12 --headless --console --for 1s >"$work/said" 2>&1 </dev/null
[ $? = 1 ] && grep -q 'follows no interlaced mode' "$work/said"
report $? "interlace: it tells of a monitor that cannot follow"

# ---- aspect, heads --------------------------------------------------------------------------------------
"$KINESCOPE" run roms/aspect.elf --tube SLOT14 --headless --console --for 1s >"$work/said" 2>&1 </dev/null
grep -q 'cannot follow 1280x1024' "$work/said"
report $? "aspect: it tells of a monitor that cannot follow"
"$KINESCOPE" trace roms/heads.elf --what dpu --for 100ms 2>"$work/said" | grep -c '^dpu ' >"$work/words"
[ "$(cat "$work/words")" -gt 500 ]
report $? "heads: the display processor draws, too"
echo "1..$number"
exit $failed
