#!/bin/sh
# The kinescope command from outside, with firmware: exit statuses, what is said when something never
# comes, figures of a run that goes on from a snapshot. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
root=$(dirname "$0")/../..
hello=$root/roms/hello.elf
stops=$root/roms/stops.elf
clock=$root/roms/clock.elf
work=$TEST_OUT/cli_firmware
rm -rf "$work"
mkdir -p "$work"
number=0
failed=0

check() { # NAME COMMAND...: passes when the command does.
    name=$1
    shift
    number=$((number + 1))
    if "$@"; then
        echo "ok $number - $name"
    else
        echo "not ok $number - $name"
        sed 's/^/# /' "$work/err"
        failed=1
    fi
}

kinescope() { # exit status in $got
    timeout 60 "$KINESCOPE" "$@" >"$work/out" 2>"$work/err" </dev/null
    got=$?
}

says() { # NAME STATUS PATTERN ARGUMENTS...: exit status, and the last line on stderr.
    what=$1 want=$2 pattern=$3
    shift 3
    kinescope "$@"
    check "$what: status $got is $want" [ $got -eq "$want" ]
    tail -n 1 "$work/err" >"$work/last"
    check "$what: says so" grep -qE -- "$pattern" "$work/last"
}

# ---- what never comes ---------------------------------------------------------------------------
# hello.elf draws nothing: it prints, and waits for lines until the end of input.
says "text that has no time to come" 3 "console:zork has not come within 100.0 ms" \
    capture "$hello" --when console:zork --timeout 100ms -o "$work/x.png"
says "a mark that has no time to come" 3 "mark:9 has not come within 100.0 ms" \
    capture "$hello" --when mark:9 --timeout 100ms -o "$work/x.png"
says "text that the program ends without" 1 "console:zork never comes: .* ended itself .* status 0" \
    capture "$hello" --type '\n\x04' --when console:zork -o "$work/x.png"
says "a refresh that the program ends without" 1 "refresh:9999 never comes" \
    capture "$stops" --when refresh:9999 -o "$work/x.png"
says "a picture of a program that has ended in the dark" 1 \
    "hello.elf has ended itself with status 0 and has not lit the beam" \
    capture "$hello" --type '\n\x04' --at 1s -o "$work/x.png"
check "no picture was left behind" [ ! -e "$work/x.png" ]

# ---- traps --------------------------------------------------------------------------------------
# The first instruction overwritten with zeros, which are none.
cp "$hello" "$work/trap.elf"
offset=$(readelf -lW "$hello" 2>/dev/null | awk '$1 == "LOAD" && $3 == "0x80000000" { print $2 }')
if [ -n "$offset" ]; then
    head -c 4 /dev/zero | dd of="$work/trap.elf" bs=1 seek=$((offset)) conv=notrunc 2>/dev/null
    says "a trap nobody handles" 1 "nobody handles the trap at pc 80000000 \(_start\): illegal" \
        run "$work/trap.elf" --headless
    check "registers as csrr reads them" grep -q "mstatus 00001800  mtvec 00000000" "$work/err"
else
    number=$((number + 1))
    echo "ok $number - a trap nobody handles # SKIP readelf is not installed"
fi

# ---- snapshots ----------------------------------------------------------------------------------
figures() { # refreshes and instructions that a run tells of
    sed -n 's/.*strokes, \([0-9]*\) refreshes$/\1/p; s/.*: \([0-9]*\) instructions.*/\1/p' "$work/err" |
        tr '\n' ' '
}
# run's figures are the run's own, not since power-on.
kinescope run "$clock" --headless --for 1s --save-state "$work/one.state"
first=$(figures)
kinescope run "$clock" --headless --for 2s
both=$(figures)
kinescope run "$clock" --headless --for 1s --load-state "$work/one.state"
second=$(figures)
check "figures of a run that goes on: $first+ $second= $both" \
    [ "$(echo "$first$second" | awk '{ print $1 + $3, $2 + $4, "" }')" = "$both" ]
check "there are figures" [ "$(echo "$both" | wc -w)" -eq 2 ]
says "a summary goes on from nothing" 2 "measures from power-on" \
    trace "$clock" --summary --load-state "$work/one.state"

cp "$clock" "$work/own.elf"
says "a snapshot over its program" 2 "written over" \
    run "$work/own.elf" --headless --for 1ms --save-state "$work/own.elf"
says "a snapshot over its firmware" 2 "written over" run "$root/tests/programs/star.df" \
    --firmware "$work/own.elf" --headless --for 1ms --save-state "$work/own.elf"
check "the program is as it was" cmp -s "$clock" "$work/own.elf"
cp "$work/one.state" "$work/kept.state"
says "a picture over the snapshot it begins with" 2 "written over" \
    capture "$clock" --load-state "$work/kept.state" --at 2s -o "$work/kept.state"
check "the snapshot is as it was" cmp -s "$work/one.state" "$work/kept.state"
says "a snapshot over the trace" 2 "where the output goes" \
    trace "$clock" --what cpu -o "$work/t" --save-state "$work/t"
says "a snapshot into no folder, at once" 1 "nowhere/x cannot be written" \
    run "$clock" --headless --for 3600s --save-state "$work/nowhere/x"

# ---- words --------------------------------------------------------------------------------------
says "firmware is no display file" 1 "stops.elf is firmware" disasm "$stops"
kinescope trace "$stops" --summary
check "what a refresh is: as firmware declares it" grep -q "238 Hz, as its firmware declares it" "$work/out"
kinescope trace "$root/tests/programs/square.oct" --summary
check "who starts a refresh again: the sync tick" grep -q "at the sync tick after its stop word" "$work/out"

echo "1..$number"
exit $failed
