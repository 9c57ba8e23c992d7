#!/bin/sh
# kinescope why: its light is that of kinescope probe, lines are those of the sources (marked in them, and
# found by grep), stores those of a trace of instructions; what wrong use is told.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. "$(dirname "$0")/../support/tap.sh"
work=$TEST_OUT/why
rm -rf "$work"
mkdir -p "$work"

# says NAME PATTERN: the last output has the pattern.
says() {
    tr '\n' ' ' <"$work/said" | tr -s ' ' | grep -q -e "$2"
    report $? "$1"
}

# refuses STATUS NAME PATTERN ARGUMENTS...: that exit status and a sentence with the pattern.
refuses() {
    status=$1 name=$2 pattern=$3
    shift 3
    "$KINESCOPE" why "$@" >"$work/said" 2>&1
    [ $? -eq "$status" ] && [ "$(wc -l <"$work/said")" -eq 1 ] && grep -q -e "$pattern" "$work/said"
    report $? "$name"
}

# answers NAME ARGUMENTS...: an answer, for says.
answers() {
    name=$1
    shift
    "$KINESCOPE" why "$@" >"$work/said" 2>&1
    report $? "$name"
}

# line FILE MARK: the number of the line with that mark.
line() { grep -n "$2" "$1" | cut -d: -f1; }

# as_probed NAME FILE PLACE TIME MORE...: shares, what is hidden and what is older sum to what the probe sees.
as_probed() {
    name=$1 file=$2 place=$3 time=$4
    shift 4
    "$KINESCOPE" why "$file" --at "$place" --time "${time}ms" --json --all "$@" >"$work/said" 2>&1 &&
        "$KINESCOPE" probe "$file" --at "$place" --from "${time}ms" --to "$((time + 1))ms" --rate 1000 --csv - "$@" >"$work/probed" 2>>"$work/said" &&
        sum=$(grep -o '"[a-z_]*cd_m2": [-+0-9.e]*' "$work/said" |
            awk '/"cd_m2"/ && !first { first = 1; shown = $2; next } { sum += $2 } END { printf "%.12g %.12g", sum, shown }') &&
        awk -F, -v sum="$sum" 'NR == 2 { split(sum, s, " "); d = s[1] / $2 - 1; e = s[2] / $2 - 1
            good = d * d < 1e-10 && e * e < 1e-10 && $2 > 0 } END { exit !good }' "$work/probed"
    report $? "$name"
}

# ---- display files ----

mkdir "$work/parts"
cat >"$work/parts/part.inc" <<'END'
; what is included
        .macro  tick x, y
        at      x, y
        longv
        draw    0, 40           ; IN THE MACRO
        point
        .endm
END
cat >"$work/cross.df" <<'END'
        .tube   "VR17/P31"
        .include "parts/part.inc"
a:      sync
        point   i=7
        at      400, 512
        longv
        draw    200, 0          ; ACROSS
        point
        tick    500, 492
        at      800, 800
        longv
        draw    20, 20          ; ELSEWHERE
        jump    a
END
across=$(line "$work/cross.df" ACROSS) macro=$(line "$work/parts/part.inc" MACRO)
elsewhere=$(line "$work/cross.df" ELSEWHERE)
answers "a display file" "$work/cross.df" --at 500,512 --time 100ms
says "both lines that cross, of the file and of what it includes" \
    "% from line \($across of [^ ]*cross.df.* from line $macro of [^ ]*part.inc\|$macro of [^ ]*part.inc.* from line $across of [^ ]*cross.df\)"
says "the words as statements" '[0-7]\{6\}: 0[0-7]\{5\} 000000 draw 200, 0 '
answers "beside the crossing" "$work/cross.df" --at 450,512 --time 100ms
says "all is from one of them" "all of it from line $across of"
answers "a dark place" "$work/cross.df" --at 815,700 --time 100ms
says "it is said to be dark" 'is dark at 0.1 s: nothing glows there'
says "and what came nearest" "nearest with line $elsewhere of [^ ]*cross.df, [0-9.]* mm away"
"$KINESCOPE" why "$work/cross.df" --at 500,512 --time 100ms --json >"$work/said" 2>&1 &&
    [ "$(grep -c "\"line\": \($across\|$macro\)[,}]" "$work/said")" -eq 2 ]
report $? "JSON has the lines"
if command -v python3 >/dev/null; then
    python3 -m json.tool "$work/said" >/dev/null 2>>"$work/said"
    report $? "and is JSON"
fi
"$KINESCOPE" why "$work/cross.df" --at 500,512 --time 100ms --order time --all --least 1 >"$work/said" 2>&1 &&
    awk '/^ +[0-9.]+ % / && $5 ~ /^[um]s$/ { t = $4 * ($5 == "us" ? 1 : 1000); if (t < last) bad = 1; last = t; n++ } END { exit bad || n < 2 }' "$work/said"
report $? "the latest first, each by itself"
says "small ones are summed up" '[0-9]\+ others, each too small'
as_probed "the light of a vector is what the probe sees" "$work/cross.df" 500,512.4 103
as_probed "also when it has nearly faded, on P7" "$work/cross.df" 470,513 116 --phosphor P7

"$KINESCOPE" asm "$work/cross.df" -o "$work/cross.oct" 2>"$work/said" &&
    "$KINESCOPE" why "$work/cross.oct" --at 450,512 --time 100ms --tube VR17 --phosphor P31 >"$work/said" 2>&1 &&
    grep -q "from display word [0-7]*" "$work/said" && ! grep -q 'line [0-9]' "$work/said"
report $? "octal words have no source"

"$KINESCOPE" trace "$work/cross.df" --what beam --for 100ms -o "$work/cross.beam" 2>"$work/said" &&
    "$KINESCOPE" why "$work/cross.beam" --at 450,512 --time 100ms >"$work/said" 2>&1 &&
    grep -q "all of it from word [0-7]* of the recording" "$work/said"
report $? "a recording has the words' addresses"

# ---- firmware ----

pixel=tests/roms/pixel
first=$(line $pixel.c '; .. FIRST') second=$(line $pixel.c '; .. SECOND')
answers "a pixel" $pixel.elf --at 320,240 --time 80ms
says "the line of C that stored it" "all of it from scan line 240 (.*stored by first+0x[0-9a-f]*, $pixel.c:$first)"
says "who called it" "called by main+0x[0-9a-f]*, $pixel.c:"
answers "another store over it" $pixel.elf --at 320,240 --time 140ms
says "the latter line" "stored by second+0x[0-9a-f]*, $pixel.c:$second)"
"$KINESCOPE" why $pixel.elf --at 320,240 --when mark:1 --json --all >"$work/said" 2>&1 &&
    "$KINESCOPE" why $pixel.elf --at 320,240 --time 140ms --json >"$work/later" 2>&1 &&
    grep -q '"symbol": "first"' "$work/said" && ! grep -q '"symbol": "second"' "$work/said"
report $? "before the next frame the light is still the first one's"
pc=$(sed -n 's/.*"store": {"pc": "\([0-9a-f]*\)", "symbol": "second".*/\1/p' "$work/later" | tail -1)
t=$(sed -n 's/.*"store": {"pc": "[0-9a-f]*", "symbol": "second".*"t_s": 0\.\([0-9]*\), "cycle".*/\1/p' "$work/later" | tail -1)
t=$(echo "$t" | sed 's/^0*//')
"$KINESCOPE" trace $pixel.elf --what cpu --from "$((t))ps" --for 1us >"$work/said" 2>&1 &&
    grep -q "^cpu $t PC=$pc WORD=[0-9a-f]* sb .*\]=80$" "$work/said"
report $? "a trace has that store at that time"
as_probed "the light of a pixel is what the probe sees" $pixel.elf 320,240 84
"$KINESCOPE" why $pixel.elf --at 10,10 --time 80ms >"$work/said" 2>&1
says "who left a pixel black" 'is dark at .*passed there .* scan line 10, dot 10, byte 0x00280a of the buffer, to which nobody'
answers "long after a line of a quick phosphor" roms/interlace.elf --at 320,200
says "what was there, and what it comes to" 'is dark at .* It was lit [0-9.]* ms ago and has faded since: .* a mean of [0-9.]* cd/m2'
"$KINESCOPE" capture "$work/cross.df" --at 100ms --hash --save-state "$work/state" >"$work/said" 2>&1 &&
    "$KINESCOPE" why "$work/cross.df" --load-state "$work/state" --at 500,512 --time 130ms >"$work/said" 2>&1
report $? "from a saved state"
says "what is older is told apart" '[0-9.]* % from more than 30.00 ms ago, before what is remembered'
as_probed "and sums with the rest" "$work/cross.df" 500,512 130 --load-state "$work/state"
"$KINESCOPE" why roms/clock.elf --at 512,700 --time 300ms >"$work/said" 2>&1
says "a word that firmware wrote" 'from display word [0-7]* (.*stored by put+0x'

# ---- wrong use ----

refuses 2 "no place" "no place is given" "$work/cross.df"
refuses 2 "half a place" "'12' is not X,Y" "$work/cross.df" --at 12
refuses 2 "a place that is no number" "is not a number\|--at:" "$work/cross.df" --at 12,up
refuses 2 "no time at all" "above zero" "$work/cross.df" --at 1,1 --time 0s
refuses 2 "a raster head without firmware" "has no firmware" "$work/cross.df" --at 1,1 --view raster
refuses 2 "a time before the saved state" "begins at 100.0 ms" "$work/cross.df" --load-state "$work/state" --at 1,1 --time 50ms
refuses 1 "no such file" "cannot be opened" "$work/none.df" --at 1,1
refuses 1 "symbols of what has none" "is for firmware" "$work/cross.df" --at 1,1 --symbols $pixel.elf
refuses 1 "symbols that are none" "part.inc" $pixel.elf --at 1,1 --symbols "$work/parts/part.inc"
refuses 2 "two heads" "give --view vector or --view raster" roms/heads.elf --at 1,1
refuses 2 "before the raster head is on" "not switched the raster head on\|beam" $pixel.elf --at 1,1 --view raster --time 1us
echo "1..$number"
exit $failed
