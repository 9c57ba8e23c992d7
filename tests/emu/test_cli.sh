#!/bin/sh
# The kinescope command from outside: help, exit statuses, what bad input is told, determinism.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
programs=$(dirname "$0")/../programs
work=$TEST_OUT/cli
rm -rf "$work"
mkdir -p "$work"
number=0
failed=0

report() { # ok|not-ok NAME
    number=$((number + 1))
    if [ "$1" = ok ]; then
        echo "ok $number - $2"
    else
        echo "not ok $number - $2"
        failed=1
    fi
}

# check NAME COMMAND...: passes when the command does.
check() {
    name=$1
    shift
    if "$@"; then report ok "$name"; else report not-ok "$name"; fi
}

# says NAME STATUS PATTERN ARGUMENTS...: exit status, and one line on stderr that matches.
says() {
    name=$1 want=$2 pattern=$3
    shift 3
    timeout 60 "$KINESCOPE" "$@" >"$work/out" 2>"$work/err" </dev/null
    got=$?
    lines=$(wc -l <"$work/err")
    if [ $got -eq "$want" ] && grep -qE -- "$pattern" "$work/err" && [ "$lines" -eq 1 ]; then
        report ok "$name"
    else
        echo "# kinescope $*"
        echo "# status $got, wanted $want and one line like: $pattern"
        sed 's/^/# /' "$work/err"
        report not-ok "$name"
    fi
}

same() { # A B: equal and not empty
    [ -n "$1" ] && [ "$1" = "$2" ]
}

differs() {
    [ -n "$1" ] && [ -n "$2" ] && [ "$1" != "$2" ]
}

star=$programs/star.df
spin=$programs/spin.df
square=$programs/square.oct

# ---- help ---------------------------------------------------------------------------------------
for sub in run capture asm disasm trace list compare measure sweep probe why lesson calc; do
    "$KINESCOPE" $sub --help >"$work/help" 2>"$work/err"
    status=$?
    grep -q "^Examples:" "$work/help" && grep -q "kinescope $sub " "$work/help" && [ $status -eq 0 ] &&
        [ ! -s "$work/err" ]
    check "$sub --help has an example" [ $? -eq 0 ]
    check "help $sub says the same" same "$("$KINESCOPE" help $sub)" "$(cat "$work/help")"
done
check "without arguments: help" same "$("$KINESCOPE")" "$("$KINESCOPE" help)"
check "--version" same "$("$KINESCOPE" --version | cut -d' ' -f1)" kinescope

# ---- usage: status 2 ----------------------------------------------------------------------------
says "misspelt subcommand" 2 "did you mean capture" captur
says "unknown subcommand" 2 "no subcommand" xyzzyplugh
says "misspelt option" 2 "did you mean --exposure" capture "$star" --exposre 1ms
says "missing argument" 2 "usage: kinescope trace FILE" trace
says "one argument too many" 2 "too many" asm "$star" b.df
says "nothing to write" 2 "nothing is to be written" capture "$star"
says "negative time" 2 "negative" capture "$star" --at -1s -o "$work/x.png"
says "time that is no number" 2 "not a time" capture "$star" --at nan -o "$work/x.png"
says "time without unit" 2 "needs a unit" capture "$star" --at 1 -o "$work/x.png"
says "absurd time" 2 "one hour" capture "$star" --at 999999s -o "$work/x.png"
says "absurd ticks" 2 "hour" capture "$star" --at 99999999f -o "$work/x.png"
says "power-on" 2 "above zero" capture "$star" --at 0s -o "$work/x.png"
says "no exposure" 2 "above zero" capture "$star" --exposure 0s -o "$work/x.png"
says "impossible size" 2 "not possible" capture "$star" --size 0x0 -o "$work/x.png"
says "huge size" 2 "not possible" capture "$star" --size 99999x99999 -o "$work/x.png"
says "impossible depth" 2 "not one of 8.16" capture "$star" --depth 12 -o "$work/x.png"
says "film and glass" 2 "exclude" capture "$star" --film --glass -o "$work/x.png"
says "sequence into one file" 2 "%04d" capture "$star" --from 1s --to 2s -o "$work/x.png"
says "sequence backwards" 2 "later" capture "$star" --from 2s --to 1s -o "$work/%04d.png"
says "half a sequence" 2 "needs --from" capture "$star" --from 2s -o "$work/%04d.png"
says "too many pictures" 2 "pictures" capture "$star" --from 0s --to 3600s --fps 99999 --y4m "$work/x.y4m"
says "no such tube" 2 "did you mean VR17" capture "$star" --tube VR71 -o "$work/x.png"
says "no such phosphor" 2 "no phosphor" capture "$star" --phosphor P99x -o "$work/x.png"
says "unknown figure" 2 "did you mean fetch" capture "$star" --set fetsh=1 -o "$work/x.png"
says "figure out of range" 2 "spot" capture "$star" --set spot=-1 -o "$work/x.png"
says "figure that is no number" 2 "not a number" capture "$star" --set spot=nan -o "$work/x.png"
says "no memory" 2 "display memory" capture "$star" --set memory=0 -o "$work/x.png"
says "odd event" 2 "not an event" capture "$star" --when moon:3 -o "$work/x.png"
says "event of firmware" 2 "needs firmware" capture "$star" --when console:READY -o "$work/x.png"
says "event zero" 2 "out of range" capture "$star" --when refresh:0 -o "$work/x.png"
says "bad close-up" 2 "X,Y,WIDTH_MM" capture "$star" --closeup 1,2 -o "$work/x.png"
says "close-up of nothing" 2 "out of range" capture "$star" --closeup 1,2,0 -o "$work/x.png"
says "bad gain" 2 "gain" capture "$star" --gain -3 -o "$work/x.png"
says "list what?" 2 "did you mean|cannot be listed" list tube
says "bad threads" 2 "out of range" capture "$star" --threads 0 -o "$work/x.png"
says "bad rate" 2 "rate" run "$star" --refresh 0 --headless

# ---- files: status 1 ----------------------------------------------------------------------------
says "no such file" 1 "missing.df" capture "$work/missing.df" -o "$work/x.png"
says "a directory" 1 "directory|regular" capture "$work" -o "$work/x.png"
mkfifo "$work/pipe.df"
says "a pipe" 1 "not a regular file" capture "$work/pipe.df" -o "$work/x.png"
says "a device" 1 "not a regular file" capture /dev/zero --base 0 -o "$work/x.png"
"$KINESCOPE" trace "$star" >/dev/full 2>"$work/err"
check "a full disk" [ $? -eq 1 -a -s "$work/err" ]
echo hello >"$work/note.txt"
says "unknown kind" 1 "\.df source" capture "$work/note.txt" -o "$work/x.png"
printf '\177ELF' >"$work/prog.elf"
says "an ELF file cut short" 1 "prog.elf" run "$work/prog.elf" --headless
printf '1000\n9\n' >"$work/bad.oct"
says "malformed octal" 1 "bad.oct:2" trace "$work/bad.oct"
: >"$work/empty.df"
says "empty source" 1 "empty.df" run "$work/empty.df" --headless
says "unwritable picture" 1 "nowhere" capture "$star" --film -o "$work/nowhere/x.png"
printf 'beam 1\ntube VR17\ntick 60/1\ns 5 4 0 0 1 1 1\n' >"$work/bad.beam"
says "malformed recording" 1 "bad.beam:4" capture "$work/bad.beam" -o "$work/x.png"
printf 'beam 1\ntube VR17\ntick 60/1\n' >"$work/none.beam"
says "empty recording" 1 "no strokes" capture "$work/none.beam" -o "$work/x.png"
says "bad INI" 1 "note.txt:1" capture "$star" --tubes "$work/note.txt" -o "$work/x.png"

# ---- what is written ----------------------------------------------------------------------------
says "not an hour of seconds before power-on" 2 "before power-on" capture "$star" --at 1s --exposure 2s -o "$work/x.png"
says "words are not source" 2 "disasm" asm "$square"
cp "$star" "$work/own.df"
cp "$square" "$work/own.oct"
ln -s own.df "$work/link.df"
says "a picture over its program" 2 "written over" capture "$work/own.df" -o "$work/own.df"
says "the same through a link" 2 "written over" capture "$work/own.df" -o "$work/link.df"
says "a strip over its program" 2 "written over" capture "$work/own.df" --from 0s --to 1s --y4m "$work/own.df"
says "a trace over its program" 2 "written over" trace "$work/own.df" -o "$work/own.df"
says "words over their source" 2 "written over" asm "$work/own.df" -o "$work/own.df"
says "source over its words" 2 "written over" disasm "$work/own.oct" -o "$work/own.oct"
check "the program is as it was" cmp -s "$star" "$work/own.df"
check "the words are as they were" cmp -s "$square" "$work/own.oct"
says "words into no folder" 1 "nowhere/a.oct cannot be written" asm "$star" -o "$work/nowhere/a.oct"
says "source into a folder" 1 "is a directory" disasm "$square" -o "$work"
says "trace into no folder" 1 "nowhere/a cannot be written" trace "$star" -o "$work/nowhere/a"
says "words onto a full disk" 1 "/dev/full cannot be written" asm "$star" -o /dev/full
echo before >"$work/link-target.oct"
ln -s link-target.oct "$work/link.oct"
"$KINESCOPE" asm "$star" -o "$work/link.oct"
check "a link stays a link" test -L "$work/link.oct"
check "what it points to is replaced" grep -q "^=" "$work/link-target.oct"

# Ctrl-C half-way: what was there stays, and nothing is left beside it.
mkdir "$work/stopped"
echo before >"$work/stopped/a.y4m"
echo before >"$work/stopped/a.txt"
for kind in "capture --from 0s --to 600s --size 64x64 --y4m $work/stopped/a.y4m" \
    "trace --for 600s -o $work/stopped/a.txt"; do
    # Not by a shell's own background job, which would ignore SIGINT.
    # shellcheck disable=SC2086
    timeout -s INT 1 "$KINESCOPE" ${kind%% *} "$star" ${kind#* } 2>/dev/null
done
check "Ctrl-C leaves a film strip as it was" same "$(cat "$work/stopped/a.y4m")" before
check "Ctrl-C leaves a trace as it was" same "$(cat "$work/stopped/a.txt")" before
check "Ctrl-C leaves nothing beside them" same "$(ls "$work/stopped" | tr '\n' ' ')" "a.txt a.y4m "

# ---- one sentence for one trouble ---------------------------------------------------------------
"$KINESCOPE" capture "$star" --film -o - >/dev/full 2>"$work/err"
check "a picture onto a full disk: status" [ $? -eq 1 ]
check "one sentence" [ "$(wc -l <"$work/err")" -eq 1 ]
"$KINESCOPE" capture "$star" --film -o "$work/one.png"
"$KINESCOPE" compare "$work/one.png" "$work/one.png" >/dev/full 2>"$work/err"
check "compare: a full disk is trouble, not a difference" [ $? -eq 2 ]
check "compare: one sentence" [ "$(wc -l <"$work/err")" -eq 1 ]
says "compare: the difference over a picture" 2 "written over" compare "$work/one.png" "$work/one.png" --diff "$work/one.png"

says "a refresh of many ticks has a hint" 0 "refresh takes .* ms here .*--exposure [0-9]+ms gathers all" capture "$star" --tube TYPE30 --film -o "$work/slow.png"

# The hand waits for the first tick, at 16.7 ms.
says "too early for light" 1 "at 1.000 ms would be black" capture "$spin" --at 1ms -o "$work/x.png"
says "an event that has no time to come" 3 "refresh:3 has not come" capture "$spin" --when refresh:3 --timeout 1ms -o "$work/x.png"
check "a sequence may begin in the dark" "$KINESCOPE" capture "$spin" --from 0s --to 5ms --fps 1000 --size 64x64 -o "$work/dark%d.png"

says "a run of no time" 2 "no time" run "$spin" --headless --for 0s
"$KINESCOPE" run "$spin" --headless --for 1ms 2>/dev/null
check "a short run is no trouble" [ $? -eq 0 ]
check "a short trace is no trouble" [ "$("$KINESCOPE" trace "$spin" --what beam --for 1ms | wc -l)" -gt 0 ]
says "a place that cannot be written, at once" 1 "nowhere/x.png cannot be written" capture "$spin" --film --at 3599s -o "$work/nowhere/x.png"

printf '  point\n  plot 2000, 5\n  frob 3\n' >"$work/bad.df"
"$KINESCOPE" asm "$work/bad.df" >"$work/out" 2>"$work/err"
check "asm: status of bad source" [ $? -eq 1 ]
check "asm: all errors in one go" [ "$(grep -cE 'bad.df:[23]:[0-9]+: ' "$work/err")" -eq 2 ]
"$KINESCOPE" run --headless "$work/bad.df" 2>"$work/err2"
check "run: status of bad source" [ $? -eq 1 ]
check "run prints the same errors" same "$(cat "$work/err")" "$(cat "$work/err2")"

# ---- programs in trouble: status 1 --------------------------------------------------------------
printf '@1000\n114000\n040144\n000144\n134000\n' >"$work/hang.oct"
says "illegal word" 1 "illegal word 134000 at address 001006" capture "$work/hang.oct" -o "$work/x.png"
says "illegal word, headless" 1 "" run "$work/bad.oct" --headless
printf '@1000\n114000\n040144\n000144\n160000\n040000\n' >"$work/out.oct"
says "bus time-out" 1 "times out at address 040000" capture "$work/out.oct" --set memory=16K -o "$work/x.png"
says "words that run out of memory" 1 "runs out of memory: .* stop word" capture "$work/out.oct" --set memory=16K -o "$work/x.png"
printf '@1000\n114000\n040144\n000144\n160000\n100000\n' >"$work/jump.oct"
says "a jump out of memory" 1 "jumps out of memory: the bus times out at address 100000" capture "$work/jump.oct" --set memory=16K -o "$work/x.png"
printf '@7000\n114000\n040144\n000144\n172000\n' >"$work/high.oct"
says "words beyond memory" 1 "beyond the display memory" capture "$work/high.oct" --set memory=2K -o "$work/x.png"
says "--base for source" 1 "leave out --base" capture "$star" --base 2000 -o "$work/x.png"
head -c 2000 /dev/zero >"$work/zeros.bin"
says "raw image of zeros" 1 "lights the beam|times out|does not light" capture "$work/zeros.bin" --base 0 -o "$work/x.png"
printf '@1000\n164000\n160000\n001000\n' >"$work/loop.oct"
says "loop without beam" 1 "never lights the beam: it goes round" capture "$work/loop.oct" -o "$work/x.png"
says "summary of a loop without beam" 1 "never lights the beam" trace "$work/loop.oct" --summary
printf '@1000\n172000\n' >"$work/dark.oct"
says "stop without beam" 1 "never lights the beam: it runs" capture "$work/dark.oct" -o "$work/x.png"
says "light that has faded" 1 "black" capture "$square" --on-stop halt --phosphor P31 --at 20s --film -o "$work/x.png"
says "trace of a hang ends" 1 "illegal" trace "$work/hang.oct"
check "no picture was left behind" [ ! -e "$work/x.png" ]
"$KINESCOPE" capture "$work/dark.oct" --film --allow-dark -o "$work/dark.png" 2>"$work/err"
check "--allow-dark writes it" [ $? -eq 0 -a -s "$work/dark.png" ]
says "too late" 3 "has not come" capture "$square" --when stop:999 --timeout 1s -o "$work/x.png"
says "hang before the event" 1 "illegal" capture "$work/hang.oct" --when stop:1 --timeout 1s -o "$work/x.png"

# ---- the same light, whatever else --------------------------------------------------------------
film() {
    "$KINESCOPE" capture "$@" --film --hash
}
reference=$(film "$star")
check "twice the same film" same "$reference" "$(film "$star")"
for n in 1 2 4; do
    check "same film with $n threads" same "$reference" "$(film "$star" --threads $n)"
done
check "same film from the baseline kernels" same "$reference" "$(film "$star" --simd baseline)"
if grep -qw avx2 /proc/cpuinfo 2>/dev/null; then
    check "same film from the AVX2 kernels" same "$reference" "$(film "$star" --simd avx2)"
else
    number=$((number + 1))
    echo "ok $number - same film from the AVX2 kernels # SKIP no AVX2 here"
fi
check "the hash is SHA-256" [ "$(printf %s "$reference" | tr -d 0-9a-f)" = "" -a ${#reference} -eq 64 ]
check "another phosphor is another film" differs "$reference" "$(film "$star" --phosphor P31)"
check "another depth is another film" differs "$reference" "$(film "$star" --depth 16)"
check "brightness is another film" differs "$reference" "$(film "$star" --set brightness=0.2)"
check "spot is another film" differs "$reference" "$(film "$star" --set spot=0.9)"

at=$(film "$spin" --at 0.5s)
check "--at and the first of --from are the same" same "$at" \
    "$(film "$spin" --from 0.5s --to 0.51s --fps 60)"
check "--at and the last of --from are the same" same "$at" \
    "$(film "$spin" --from 0.3s --to 0.501s --fps 10 | tail -n 1)"
check "overlapping exposures too" same "$at" \
    "$(film "$spin" --from 0.48s --to 0.501s --fps 200 | tail -n 1)"
check "--when refresh and its time are the same" same "$(film "$square" --when refresh:30)" \
    "$(film "$square" --when stop:30)"

"$KINESCOPE" trace "$star" --what beam >"$work/star.beam"
check "a recording gives the same film" same "$reference" "$(film "$work/star.beam")"
"$KINESCOPE" trace "$spin" --what beam --for 0.7s --tube RADAR7 -o "$work/spin.beam"
check "a recording at another time and tube" same "$(film "$spin" --tube RADAR7 --at 0.65s)" \
    "$(film "$work/spin.beam" --at 0.65s)"
"$KINESCOPE" trace "$work/star.beam" --what beam >"$work/again.beam"
check "the trace of a recording is the recording" cmp -s "$work/star.beam" "$work/again.beam"

# ---- pictures -----------------------------------------------------------------------------------
"$KINESCOPE" capture "$star" --film -o "$work/a.png" && "$KINESCOPE" capture "$star" --film -o "$work/b.png"
check "the same PNG, byte for byte" cmp -s "$work/a.png" "$work/b.png"
"$KINESCOPE" compare "$work/a.png" "$work/b.png" >/dev/null
check "compare: same is 0" [ $? -eq 0 ]
"$KINESCOPE" capture "$star" --film --at 1ms -o "$work/c.png"
"$KINESCOPE" compare "$work/a.png" "$work/c.png" --json --diff "$work/diff.png" >"$work/json"
check "compare: different is 1" [ $? -eq 1 -a -s "$work/diff.png" ]
check "compare: JSON" grep -qE '^\{"same": false, "same_shape": true, .*\}$' "$work/json"
"$KINESCOPE" compare "$work/a.png" "$work/c.png" --tolerance 255 >/dev/null
check "compare: within the tolerance is 0" [ $? -eq 0 ]
says "compare: trouble is 2" 2 "missing.png" compare "$work/a.png" "$work/missing.png"
says "compare: not a PNG" 2 "note.txt" compare "$work/a.png" "$work/note.txt"
check "text chunks" [ "$(strings -n 4 "$work/a.png" | grep -cE 'star.df|VR17|Simulated time')" -ge 3 ]

"$KINESCOPE" capture "$star" --closeup 512,540,6 --size 96x64 -o "$work/close.png"
check "close-up" [ "$(od -An -tu1 -j16 -N8 "$work/close.png" | tr -s ' ')" = " 0 0 0 96 0 0 0 64" ]

"$KINESCOPE" capture "$spin" --film --set spot=2 --from 0.1s --to 0.35s --fps 20 -o "$work/f%02d.png"
check "a sequence has its pictures" [ "$(ls "$work"/f0[0-4].png | wc -l)" -eq 5 -a ! -e "$work/f05.png" ]
"$KINESCOPE" capture "$spin" --film --set spot=2 --from 0s --to 0.2s --fps 20 --y4m - >"$work/x.y4m"
head=$(head -n 1 "$work/x.y4m")
width=$(echo "$head" | sed 's/.* W\([0-9]*\).*/\1/') height=$(echo "$head" | sed 's/.* H\([0-9]*\).*/\1/')
check "a film strip has exactly its bytes" \
    [ "$(wc -c <"$work/x.y4m")" -eq $((${#head} + 1 + 4 * (6 + 3 * width * height))) ]

# ---- words --------------------------------------------------------------------------------------
"$KINESCOPE" asm "$star" -o "$work/star.oct" && "$KINESCOPE" disasm "$work/star.oct" -o "$work/star2.df" &&
    "$KINESCOPE" asm "$work/star2.df" -o "$work/star2.oct"
check "asm, disasm, asm" cmp -s "$work/star.oct" "$work/star2.oct"
"$KINESCOPE" asm "$star" --listing >"$work/listing"
check "listing" grep -q "A STAR" "$work/listing"
"$KINESCOPE" trace "$square" >"$work/trace"
check "trace: form of a line" [ "$(grep -cvE '^dpu [0-9]+ DPC=[0-7]{6} WORD=[0-7]{6} MPR=[0-7]{6} XPR=[0-7]{6} YPR=[0-7]{6}$' "$work/trace")" -eq 0 ]
check "trace: one refresh" [ "$(wc -l <"$work/trace")" -eq 9 ]
"$KINESCOPE" trace "$square" --summary >"$work/summary"
check "summary" grep -q "refresh time" "$work/summary"

check "summary of the first refresh says so" grep -q "the first refresh" "$work/summary"
"$KINESCOPE" trace "$programs/../../roms/growing.df" --summary --for 4s >"$work/summary"
late=$("$KINESCOPE" trace "$programs/../../roms/growing.df" --summary --for 1.5s | grep -c "exceed")
check "summary counts the refreshes that miss the tick" grep -qE "[1-9][0-9]* of [0-9]+ refreshes exceed it, the first is number [0-9]+ at" "$work/summary"
check "summary: none yet" [ "$late" -eq 0 ]

# 1000 instructions at 33.33 us each are 30 refreshes a second.
{
    echo "@0"
    echo 114000
    i=1
    while [ $i -lt 499 ]; do printf '040144\n000144\n164000\n' && i=$((i + 1)); done
    printf '164000\n164000\n172000\n'
} >"$work/thousand.oct"
"$KINESCOPE" trace "$work/thousand.oct" --summary --set dpu.average=33.33us >"$work/summary"
check "1000 instructions at 33.33 us" grep -qE "instructions +1000 a refresh" "$work/summary"
check "take 33.33 ms" grep -qE "refresh time +33.33 ms" "$work/summary"

# ---- lists and headless runs --------------------------------------------------------------------
check "list tubes" [ "$("$KINESCOPE" list tubes | grep -cE '^(VR14|VR17|RADAR7|TYPE30)')" -eq 4 ]
check "list tubes --why names sources" [ "$("$KINESCOPE" list tubes --why | grep -c estimate)" -gt 20 ]
check "list phosphors" [ "$("$KINESCOPE" list phosphors | grep -c '^P')" -ge 20 ]
mkdir "$work/roms"
printf '# tour\nstar.df VR14 A star\n\nspin.df - A hand\n' >"$work/roms/tour.txt"
check "list roms" [ "$("$KINESCOPE" list roms --roms "$work/roms" | grep -c "A star$")" -eq 1 ]
check "list roms names files from here" same "$(cd "$work" && "$KINESCOPE" list roms --roms "$work/roms" | cut -d' ' -f1 | tr '\n' ' ')" "roms/star.df roms/spin.df "
printf 'star.df\n' >"$work/roms/tour.txt"
says "a tour without tubes" 1 "tour.txt:1" list roms --roms "$work/roms"
printf '../star.df VR17 x\n' >"$work/roms/tour.txt"
says "a tour out of its folder" 1 "same folder" list roms --roms "$work/roms"
says "no tour" 1 "cannot be opened" list roms --roms "$work"
"$KINESCOPE" run "$star" --headless --for 10s 2>"$work/err"
check "run --headless" [ $? -eq 0 ]
check "run --headless says how fast" grep -q "simulated seconds a second" "$work/err"
echo quit | "$KINESCOPE" run --headless --console >"$work/out" 2>"$work/err"
check "run without FILE: the monitor" grep -q "kinescope monitor" "$work/out"
says "run without FILE, and no monitor there" 1 "monitor.elf cannot be opened" run --headless --roms "$work/roms"
says "run --tour takes no FILE" 2 "leave out FILE" run --tour "$star"
says "run --tour is for a window" 2 "leave out --headless" run --tour --headless
env -u DISPLAY -u WAYLAND_DISPLAY "$KINESCOPE" run "$star" >"$work/out" 2>"$work/err"
check "no display: status 1" [ $? -eq 1 ]
check "no display: says what to use instead" grep -q "capture" "$work/err"

echo "1..$number"
exit $failed
