#!/bin/sh
# capture --versus from outside: each side's light is that of the single capture, what is refused, sequences,
# film strips. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(dirname "$0")/../..
spin=$root/tests/programs/spin.df
work=$TEST_OUT/versus
rm -rf "$work"
mkdir -p "$work"
. "$root/tests/support/tap.sh"
subcommand=capture
. "$root/tests/support/command.sh"

hashes() { # FILE ARGUMENTS...
    to=$1
    shift
    "$KINESCOPE" capture "$@" --hash >"$work/$to" 2>>"$work/said"
}

: >"$work/said"
hashes both "$spin" --versus 'phosphor=p31;refresh=30;brightness=0.2;exposure=3ms' --at 0.7s
hashes left "$spin" --at 0.7s
hashes right "$spin" --phosphor P31 --refresh 30 --set brightness=0.2 --exposure 3ms --at 0.7s
cat "$work/left" "$work/right" | cmp -s - "$work/both"
report $? "two lines: the single captures' light"
! cmp -s "$work/left" "$work/right"
report $? "... which differ"

hashes both "$spin" --versus 'set.spot=0.6' --from 0.5s --to 0.55s --fps 50 --exposure 40ms
hashes left "$spin" --from 0.5s --to 0.55s --fps 50 --exposure 40ms
hashes right "$spin" --set spot=0.6 --from 0.5s --to 0.55s --fps 50 --exposure 40ms
paste -d '\n' "$work/left" "$work/right" | cmp -s - "$work/both" && [ "$(wc -l <"$work/both")" -eq 6 ]
report $? "sequences of overlapping exposures: left, right, left, right"

hashes both "$root/roms/heads.elf" --versus 'view=raster;mode=640x480@60' --view vector --at 0.3s
hashes left "$root/roms/heads.elf" --view vector --at 0.3s
hashes right "$root/roms/heads.elf" --view raster --mode 640x480@60 --at 0.3s
cat "$work/left" "$work/right" | cmp -s - "$work/both"
report $? "heads of firmware are compared"

# Words on either machine take the same time here: the events of the left one are the right one's instants.
hashes both "$spin" --versus 'refresh=30' --step refresh --count 2 --film
hashes left "$spin" --step refresh --count 2 --film
sed -n '1p;3p' "$work/both" | cmp -s - "$work/left"
report $? "steps are the left machine's"

"$KINESCOPE" capture "$spin" --versus phosphor=P31 --size 160x121 --from 0.5s --to 0.6s --fps 24000/1001 \
    --y4m "$work/strip.y4m" 2>"$work/said" && [ "$(grep -ac FRAME "$work/strip.y4m")" -eq 3 ] &&
    head -1 "$work/strip.y4m" | grep -q '^YUV4MPEG2 W352 H14[0-9] F24000:1001 '
report $? "one film strip of both halves, even in size, at the exact rate"

fails "a name that is none" 2 "did you mean phosphor" "$spin" --versus phosphr=P31 --hash
fails "nothing said" 2 "say what is different" "$spin" --versus ';' --hash
fails "a value that is none" 2 "there is no phosphor called 'P99'" "$spin" --versus phosphor=P99 --hash
fails "the sentence says that it is the other machine" 2 "--versus: --set: tube VR17: spot" "$spin" \
    --versus spot=-1 --hash
fails "not what is the same on both" 2 "there is no 'input'" "$spin" --versus input=x --hash
fails "no machine saved of two" 2 "--save-state is of one machine" "$spin" --versus refresh=30 \
    --save-state "$work/x" --hash
fails "a raster head for a display file" 2 "--versus:" "$spin" --versus view=raster --hash
fails "an exposure from before power-on" 2 "--versus: --exposure would begin" "$spin" --at 0.1s \
    --versus exposure=1s --hash

echo "1..$number"
exit $failed
