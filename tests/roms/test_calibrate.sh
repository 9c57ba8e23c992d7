#!/bin/sh
# The light pen of the raster head, calibrated by firmware in the machine (roms/calibrate.elf) with a pen
# that is put on the middle of each target: what is left at two dot clocks, and what was before against the
# time that the pen takes.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/calibrate
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# A sanitizer needs no second run of the same code.
case ${TEST_MODE:-rel} in
rel | dbg) runs='vga vga_late xga xga_late' modes='vga:25.175 xga:65' ;;
*) runs='vga vga_late' modes='vga:25.175' ;;
esac

hand() { # WIDTH HEIGHT: the script of roms/calibrate.script for another mode
    sed -n '/^[^#]/p' roms/calibrate.script |
        awk -v w="$1" -v h="$2" '{ for (i = 1; i <= NF; i++)
            if ($i == "move") { $(i + 1) = fit($(i + 1), 1024, w); $(i + 2) = fit($(i + 2), 768, h) }
            print }
            # The hundredth of the picture that the dot stands for, in the other mode.
            function fit(dot, of, to) { return int(int((dot + 1) * 100 / of) * to / 100) }'
}

calibrate() { # NAME WIDTH HEIGHT OPTION...
    name=$1 width=$2 height=$3
    shift 3
    hand "$width" "$height" >"$work/$name.script"
    "$KINESCOPE" run roms/calibrate.elf --headless --console --mode "${width}x$height" \
        --input "$work/$name.script" --for 12s "$@" 2>&1 </dev/null | tr -d '\r' >"$work/$name"
}

# Of rows of the table: how many, the largest distance after, least and most dots before.
figures() { # NAME KIND
    awk -v kind="$2" '$1 == kind && $2 ~ /^[0-9]+$/ {
        n++
        left = sqrt($10 * $10 + $11 * $11)
        if (left > worst) worst = left
        if (n == 1 || $8 + 0 < least) least = $8 + 0
        if (n == 1 || $8 + 0 > most) most = $8 + 0
    } END { print n + 0, worst + 0, least + 0, most + 0 }' "$work/$1"
}

said() { # NAME: for report
    cp "$work/$1" "$work/said"
}

# What a column says, within bounds.
within() { # VALUE LOW HIGH
    awk -v v="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(v != "" && v >= low && v <= high) }'
}

for run in $runs; do
    case $run in vga*) size='640 480' ;; *) size='1024 768' ;; esac
    case $run in *_late) late='--set pen.delay=0.8' ;; *) late= ;; esac
    calibrate "$run" $size $late
    said $run
    set -- $(figures $run target)
    checks=$(figures $run check)
    [ "$1" = 9 ] && within "$2" 0 1 && [ "${checks%% *}" = 4 ] && within "$(echo "$checks" | cut -d' ' -f2)" 0 1
    report $? "$run: nine targets and four checks, within 1 pixel when corrected"
done

# The pen is 0.3 us late by its delay, and some more until its signal has risen; 0.5 us more are 0.5 us of
# the dot clock more.
for mode in $modes; do
    set -- "${mode%:*}" "${mode#*:}"
    said "$1_late"
    before=$(figures "$1" target | cut -d' ' -f4) after=$(figures "$1_late" target | cut -d' ' -f4)
    within "$(awk -v a="$after" -v b="$before" -v mhz="$2" 'BEGIN { print (a - b) / mhz }')" 0.45 0.55
    report $? "$1: half a microsecond more is half a microsecond of dots before correction"
    for run in "$1 300" "$1_late 800"; do
        set -- $run
        said "$1"
        late=$(sed -n 's/^pen: sees .*, fires \([0-9]*\) ns late$/\1/p' "$work/$1")
        within "$late" "$2" $(($2 + 150))
        report $? "$1: told from the size of the pen, it is $2 ns late and up to 150 more"
    done
done

# What it sees: 3 mm and the width of the beam's spot on either side.
said vga
within "$(sed -n 's/^pen: sees \([0-9]*\) um.*/\1/p' "$work/vga")" 3000 5000
report $? "the pen sees its aperture and the spots at its edge"

# Another tube: one gun, a white phosphor that glows on longer.
calibrate mono 640 480 --tube MONO12
said mono
set -- $(figures mono target)
[ "$1" = 9 ] && within "$2" 0 1
report $? "one gun, phosphor P4: within 1 pixel"

# A pen that is not pressed, or not on a target, measures nothing.
printf 'at 0.5s pen raster move 122 168\nat 1s pen raster move 512 600\npen raster down\n' >"$work/idle.script"
"$KINESCOPE" run roms/calibrate.elf --headless --console --input "$work/idle.script" --for 2s \
    >"$work/said" 2>&1 </dev/null
! grep -q '^target' "$work/said" && grep -q '^calibrate: 1024 x 768' "$work/said"
report $? "a pen that is not pressed, or on black, measures nothing"
echo "1..$number"
exit $failed
