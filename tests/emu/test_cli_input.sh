#!/bin/sh
# --input and --record from outside: what a script that cannot be done is told, that nothing that is read is
# written over, that a record does the same again. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
LSAN_OPTIONS=suppressions=$(cd "$(dirname "$0")/../support" && pwd)/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
roms=$(cd "$(dirname "$0")/../../roms" && pwd)
work=$TEST_OUT/cli_input
rm -rf "$work"
mkdir -p "$work/folder"
cd "$work" || exit 1
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
        sed 's/^/# /' err
        failed=1
    fi
}

says() { # NAME STATUS PATTERN ARGUMENTS...: exit status, and the last line on stderr.
    what=$1 want=$2 pattern=$3
    shift 3
    timeout 60 "$KINESCOPE" "$@" >out 2>err </dev/null
    got=$?
    check "$what: status $got is $want" [ $got -eq "$want" ]
    tail -n 1 err >last
    check "$what: says so" grep -qE -- "$pattern" last
}

try() { # NAME STATEMENT PROGRAM PATTERN OPTIONS...: it is refused before anything runs
    printf '%s\n' "$2" >script
    what=$1 program=$3 pattern=$4
    shift 4
    says "$what" 2 "--input: nothing notices .*: $pattern" \
        run "$roms/$program" --headless --for 1ms --input script "$@"
}

# ---- scripts that are none
printf 'pen down\nfoo\n' >script
says "an error" 1 "script:2:1: 'foo' is not" run "$roms/spin.df" --headless --input script
says "a folder" 1 "folder is not a regular file" run "$roms/spin.df" --headless --input folder
says "none" 1 "nowhere cannot be opened" run "$roms/spin.df" --headless --input nowhere
printf '# nothing\n' >script
says "a comment" 0 "simulated" run "$roms/spin.df" --headless --for 1ms --input script

# ---- acts for devices that are not there
try "no pen" 'pen move 5 5' spin.df 'there is none \(--set pen=none\)' --set pen=none
try "no tablet" 'tablet near 5 5' spin.df 'there is none \(--set tablet=none\)' --set tablet=none
try "no mouse" 'mouse lift' spin.df 'there is none \(--set mouse=none\)' --set mouse=none
try "no keyboard" 'key A' hello.elf 'there is none \(--set keyboard=none\)' --set keyboard=none
try "no panel" 'touch 5 5' hello.elf 'there is none \(--set touch=none\)' --set touch=none
try "no head for the pen" 'pen raster move 5 5' spin.df 'spin.df has no firmware'
try "no head for the finger" 'touch 5 5' spin.df 'spin.df has no firmware'
try "no head for the knob" 'knob raster focus 1' spin.df 'spin.df has no firmware'
try "no such button" 'tablet press 3' spin.df 'the last button there is 0'
try "the wrong head" 'touch vector 5 5' hello.elf 'the touch panel is over the other head'
printf 'touch vector 5 5\ntablet press 3\n' >script
says "the right head and button" 3 "has not ended itself" run "$roms/hello.elf" --headless --for 1ms \
    --input script --set touch.screen=vector --set tablet.buttons=4
says "a device of a head" 2 "tablet belongs to no head" \
    run "$roms/spin.df" --headless --set raster.tablet=none

# ---- what is read is not written over
printf 'pen move 500 500\n' >script
cp script before
cp "$roms/hello.elf" program.elf
for command in "run --headless --record script" "run --headless --save-state script" \
    "trace --what input -o script" "capture -o script" "capture --from 0s --to 0.1s --y4m script"; do
    # shellcheck disable=SC2086 # words
    says "$command" 2 "script would be written over script" $command "$roms/spin.df" --input script
    check "$command: the script is as it was" cmp script before
done
says "a record of the program" 2 "program.elf would be written over" \
    run program.elf --headless --for 1ms --record program.elf
check "the program is as it was" cmp program.elf "$roms/hello.elf"

# ---- the moment of a picture: when the script is over, with its waits
printf 'pen move 500 500\nwait 2s\n' >script
timeout 60 "$KINESCOPE" capture "$roms/spin.df" --input script -o a.png 2>err
check "the picture was taken after the waits" sh -c \
    "tr -c '[:print:]' '\n' <a.png | grep -A3 'Simulated time' | grep -q '^2\.'"

# ---- a trace that begins later is the end of the whole one
for program in choice calibrate; do
    "$KINESCOPE" trace "$roms/$program.elf" --what input --input "$roms/$program.script" >whole 2>err
    at=$(awk '$2 ~ /^[0-9]+$/ { t[++n] = $2 } END { printf "%.0f", t[int(n / 2)] + 1 }' whole)
    "$KINESCOPE" trace "$roms/$program.elf" --what input --input "$roms/$program.script" \
        --from "${at}ps" >later 2>err
    check "$program: there is a later half" [ -s later ]
    tail -n "$(wc -l <later)" whole | cmp - later >err 2>&1
    check "$program: a trace from $at ps on" [ $? -eq 0 ]
done

# ---- a record does it again
printf 'at 1ms pen move 500 500\n+1ms pen down\ntype "a" in 5ms\nmouse click left in 2ms\n' >script
says "recorded" 0 'simulated' run "$roms/spin.df" --headless --for 1s --input script --record once
says "again" 0 'simulated' run "$roms/spin.df" --headless --for 1s --input once --record twice
check "a record of a record is the same" cmp once twice
echo "1..$number"
exit $failed
