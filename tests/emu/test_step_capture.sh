#!/bin/sh
# capture --step from outside: steps against the trace's times, exposures that add up, gain by the peak,
# captions, what is refused. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LC_ALL=C
export LC_ALL
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(dirname "$0")/../..
spin=$root/tests/programs/spin.df
pattern=$root/roms/pattern.elf
work=$TEST_OUT/step
rm -rf "$work"
mkdir -p "$work"
. "$root/tests/support/tap.sh"
subcommand=capture
. "$root/tests/support/command.sh"

# The exact simulated times of numbered pictures, from their text chunks.
moments() {
    for picture in "$@"; do
        tr -d '\n' <"$picture" | tr '\000' '\n' | grep -a -A1 'Simulated time$' | tail -1 |
            sed 's/ s.*/ s/'
    done
}

steps() { # WHAT FILE COUNT MORE...
    what=$1 file=$2 count=$3
    shift 3
    "$KINESCOPE" capture "$file" --step "$what" --count "$count" --film -o "$work/$what%02d.png" "$@" \
        >"$work/hashes" 2>"$work/said"
}

seconds() { # picoseconds to text
    awk '{ t = sprintf("%013.0f", $1); n = length(t) - 12; print substr(t, 1, n) "." substr(t, n + 1) " s" }' |
        sed 's/0* s$/ s/'
}

# Words end where the next is fetched.
"$KINESCOPE" trace "$spin" --for 105ms >"$work/trace" 2>"$work/said"
steps word "$spin" 20 --at 50ms --allow-dark
report $? "20 display words, step by step"
awk '$1 == "dpu" && $2 > 50000000000 { print $2 }' "$work/trace" | head -20 | seconds >"$work/wanted"
moments "$work"/word??.png >"$work/got"
paste "$work/got" "$work/wanted" >"$work/said"
# A refresh ends within these; its last word is over long before the tick that lets the next be fetched.
awk -F '\t' '$1 == $2 { n++ } END { exit !(NR == 20 && n >= 18) }' "$work/said"
report $? "... end where the next word is fetched"

# Line after line: 48.363 kHz of 1024x768@60, 1344 dots at 65 MHz.
steps line "$pattern" 3 --at 0.4s
report $? "3 scan lines"
moments "$work"/line??.png >"$work/said"
awk 'NR > 1 { d = ($1 - last) * 1e6 - 1344 / 65; if (d * d > 1e-8) bad = 1 } { last = $1 } END { exit bad || NR != 3 }' \
    "$work/said"
report $? "... one line's time apart"

# The light of single steps is that of the sequence with those exposures.
steps refresh "$spin" 2 --at 0.5s --hash
cp "$work/hashes" "$work/two"
set -- $(moments "$work"/refresh??.png | sed 's/ s//')
awk -v a="$1" -v b="$2" 'BEGIN { printf "%.12fs\n", b - a }' >"$work/length"
"$KINESCOPE" capture "$spin" --at "$2s" --exposure "$(cat "$work/length")" --hash >"$work/single" 2>"$work/said"
tail -1 "$work/two" | cmp -s - "$work/single"
report $? "a refresh's picture gathers the light from its begin to its end"

steps stroke "$spin" 6 --at 0.5s --exposure 1us --hash --gain peak
report $? "strokes with a shutter of a microsecond, gain by the peak"
[ "$(sort -u "$work/hashes" | wc -l)" -eq 6 ]
report $? "... six different pictures"
"$KINESCOPE" capture "$spin" --at 0.5s --exposure 1us --film --gain peak -o "$work/peak.png" 2>"$work/said" &&
    "$KINESCOPE" capture "$spin" --at 0.5s --exposure 1us --film --gain peakx1000 -o "$work/bright.png" 2>"$work/said" &&
    ! "$KINESCOPE" compare "$work/peak.png" "$work/bright.png" >"$work/said"
report $? "peakx1000 is brighter"

steps instruction "$root/roms/hello.elf" 2 --at 0.01s --captions --allow-dark
report $? "instructions, with captions"
"$KINESCOPE" capture "$spin" --step word --count 30 --size 64x64 --fps 24000/1001 --y4m - >"$work/strip" \
    2>"$work/said" && [ "$(grep -ac FRAME "$work/strip")" -eq 30 ] && grep -aq 'F24000:1001' "$work/strip"
report $? "steps as a film strip"
"$KINESCOPE" capture "$spin" --from 0.2s --to 1.2s --fps 59.94 --exposure 0.1s --size 64x64 --y4m - >"$work/strip" \
    2>"$work/said" && [ "$(grep -ac FRAME "$work/strip")" -eq 60 ] && grep -aq ' F2997:50 ' "$work/strip"
report $? "a second at 59.94 is 60 pictures, each longer than its place"

fails "steps begin at a moment" 2 "leave out --from" "$spin" --step word --from 0s --to 1s --hash
fails "a count of what" 2 "--count is for --step" "$spin" --count 3 --hash
fails "a step that is none" 2 "'words' is not one of" "$spin" --step words --hash
fails "a display file has no lines" 2 "--step line is for firmware" "$spin" --step line --hash
fails "a numbered name" 2 "put %04d" "$spin" --step word -o "$work/x.png"
fails "too long a shutter" 2 "take longer steps" "$spin" --step word --count 300 --exposure 0.4s --hash
fails "steps that do not come" 1 "no word comes within a second" "$root/roms/hello.elf" --step word --at 0.1s \
    --hash
fails "gain by something else" 2 "is not peak or peakx2" "$spin" --gain peaky --hash

echo "1..$number"
exit $failed
