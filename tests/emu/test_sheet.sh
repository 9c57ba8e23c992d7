#!/bin/sh
# capture --sheet from outside: how many pictures are computed, sizes, what is refused, the same bytes.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(dirname "$0")/../..
spin=$root/tests/programs/spin.df
work=$TEST_OUT/sheet
rm -rf "$work"
mkdir -p "$work"
. "$root/tests/support/tap.sh"

fails() { # NAME SENTENCE ARGUMENTS...
    name=$1 sentence=$2
    shift 2
    timeout 60 "$KINESCOPE" capture "$spin" "$@" >"$work/out" 2>"$work/said" </dev/null
    [ $? -eq 2 ] && [ "$(wc -l <"$work/said")" -eq 1 ] && grep -qF -- "$sentence" "$work/said"
    report $? "$name"
}

# Big-endian width and height of the first chunk.
size_of() {
    od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4, $7 * 256 + $8 }'
}

sequence="--from 0.5s --to 0.6s --fps 200 --exposure 5ms"
"$KINESCOPE" capture "$spin" $sequence --film --sheet 4x2 -o "$work/a.png" --hash >"$work/hashes" 2>"$work/said"
report $? "a sheet of 8 out of 20 pictures"
"$KINESCOPE" capture "$spin" $sequence --hash >"$work/all" 2>"$work/said"
# 0, 19/7, 2·19/7 … rounded down, counted from 1.
sed -n '1p;3p;6p;9p;11p;14p;17p;20p' "$work/all" | cmp -s - "$work/hashes"
report $? "... evenly chosen, the first and the last among them, and no other computed"
size_of "$work/a.png" >"$work/said"
awk '{ exit !($1 <= 2400 && $1 > 2300 && $2 < 1400 && $2 > 1100) }' "$work/said"
report $? "at most 2400 pixels wide, two rows"

"$KINESCOPE" capture "$spin" $sequence --film --sheet 4x2 -o "$work/b.png" --threads 1 2>"$work/said" &&
    cmp -s "$work/a.png" "$work/b.png"
report $? "the same bytes with one thread"

"$KINESCOPE" capture "$spin" $sequence --size 100x90 --sheet 8x9 -o "$work/c.png" 2>"$work/said" &&
    size_of "$work/c.png" >"$work/said"
awk '{ exit !($1 == 8 * 110 + 10 && $2 > 3 * 90 && $2 < 4 * 120) }' "$work/said"
report $? "pictures of a size that was asked for keep it; rows as needed"

"$KINESCOPE" capture "$spin" --versus phosphor=P31 --step refresh --film --sheet 2x2 -o "$work/d.png" --hash \
    2>"$work/said" >"$work/hashes" && [ "$(wc -l <"$work/hashes")" -eq 8 ]
report $? "steps on a sheet are as many as it has places; both halves in each"

fails "a sheet is no size" "such as 8x4" $sequence --sheet 8by4 -o "$work/x.png"
fails "too many places" "are more than" $sequence --sheet 100x100 -o "$work/x.png"
fails "a sheet needs a file" "--sheet is one picture" $sequence --sheet 8x4 --hash
fails "a sheet is of 8 bits" "--sheet is one picture" $sequence --sheet 8x4 --depth 16 -o "$work/x.png"
fails "a sheet needs a sequence" "a sequence needs" --sheet 8x4 -o "$work/x.png"
[ ! -e "$work/x.png" ]
report $? "nothing is left of those"

echo "1..$number"
exit $failed
