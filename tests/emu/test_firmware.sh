#!/bin/sh
# Firmware from outside: exit statuses, console and pipes, moments, traces against objdump, snapshots on the
# command line, bad input. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/firmware
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# says NAME STATUS PATTERN ARGUMENTS...: exit status, and one line on stderr that matches.
says() {
    name=$1 want=$2 pattern=$3
    shift 3
    timeout 60 "$KINESCOPE" "$@" >"$work/out" 2>"$work/said" </dev/null
    got=$?
    [ $got -eq "$want" ] && [ "$(wc -l <"$work/said")" -eq 1 ] && grep -qE -- "$pattern" "$work/said"
    report $? "$name"
}
is() { [ -n "$1" ] && [ "$1" = "$2" ]; }
hash_of() { "$KINESCOPE" capture "$@" --film --hash 2>"$work/said"; }
hello=roms/hello.elf clock=roms/clock.elf

# ---- console --------------------------------------------------------------------------------------
printf 'one\ntwo\n' | "$KINESCOPE" run $hello --headless --console >"$work/pipe" 2>"$work/said"
report $? "the firmware's exit status 0 is the command's"
grep -q 'You typed: two' "$work/pipe" && [ ! -s "$work/said" ]
report $? "a pipe is typed on the console"
printf 'one\ntwo\n' | (sleep 0.3 && "$KINESCOPE" run $hello --headless --console) >"$work/late" 2>"$work/said"
cmp "$work/pipe" "$work/late" >>"$work/said"
report $? "the same, whenever the host has it"
{ printf 'on' && sleep 0.4 && printf 'e\ntw' && sleep 0.3 && printf 'o\n'; } |
    "$KINESCOPE" run $hello --headless --console >"$work/slow" 2>"$work/said"
cmp "$work/pipe" "$work/slow" >>"$work/said"
report $? "the same from a hesitant pipe"
# Two pipes: whoever answers waits for the question first.
mkfifo "$work/to" "$work/from"
timeout 30 "$KINESCOPE" run $hello --headless --console <"$work/to" >"$work/from" 2>"$work/said" &
guest=$!
exec 3>"$work/to" 4<"$work/from"
(
    while read -r line <&4; do case $line in *'control-D ends'*) break ;; esac; done
    echo Joe >&3
    while read -r line <&4; do case $line in *'You typed: Joe'*) exit 0 ;; esac; done
    exit 1
)
report $? "a dialogue over two pipes"
exec 3>&- 4<&-
wait $guest 2>/dev/null
"$KINESCOPE" run $hello --headless --console --type 'one\ntwo\n' </dev/null >"$work/typed" 2>"$work/said"
cmp "$work/pipe" "$work/typed" >>"$work/said"
report $? "--type types the same"
says "--type knows its escapes" 2 "is no escape" run $hello --headless --console --type 'a\q'

# ---- exit statuses --------------------------------------------------------------------------------
says "firmware that hangs is bounded by --for, with status 3" 3 "has not ended itself within 100" \
    run $clock --headless --console --for 100ms
echo x | timeout 60 "$KINESCOPE" run tests/roms/traps.elf --headless --console >"$work/out" 2>"$work/said"
report $? "firmware that is asked for no trap ends well"
# A finisher store of another status, by hand: lui a0,0x100; li a1,7<<16|0x3333; sw a1,0(a0).
printf '.globl _start\n_start: lui a0,0x100\nli a1,0x73333\nsw a1,0(a0)\n1: j 1b\n' >"$work/seven.S"
if command -v riscv64-unknown-elf-gcc >/dev/null; then
    riscv64-unknown-elf-gcc -march=rv32i -mabi=ilp32 -nostdlib -Wl,-n,-Ttext=0x80000000 -o "$work/seven.elf" \
        "$work/seven.S" 2>"$work/said"
    "$KINESCOPE" run "$work/seven.elf" --headless --console </dev/null 2>"$work/said"
    [ $? -eq 7 ]
    report $? "the firmware's exit status 7 is the command's"
else
    number=$((number + 1))
    echo "ok $number - the firmware's exit status 7 # SKIP no riscv64-unknown-elf-gcc"
fi

# ---- moments --------------------------------------------------------------------------------------
first=$(hash_of roms/stops.elf --when refresh:40)
is "$first" "$(hash_of roms/stops.elf --when refresh:40)"
report $? "--when refresh:N of firmware"
[ "$first" != "$(hash_of roms/stops.elf --when stop:60)" ]
report $? "--when stop:N is another moment"
hash_of $clock --when mark:1 >"$work/hash" && [ -s "$work/hash" ]
report $? "--when mark:N waits for the firmware's mark"
hash_of roms/stops.elf --when 'console:stops in a second' >"$work/hash" && [ -s "$work/hash" ]
report $? "--when console:TEXT waits for what the firmware prints"
says "a mark that never comes" 3 "mark:77 has not come within" capture $clock --when mark:77 --timeout 1s \
    -o "$work/x.png"
says "text that never comes" 3 "has not come within" capture $hello --when console:Nonsense --timeout 1s \
    -o "$work/x.png"
says "marks want firmware" 2 "needs firmware" capture roms/rose.df --when mark:1 -o "$work/x.png"

# ---- traces ---------------------------------------------------------------------------------------
"$KINESCOPE" trace $clock --what cpu --for 200us -o "$work/cpu.trace" 2>"$work/said"
[ $? -eq 0 ] && [ "$(wc -l <"$work/cpu.trace")" -eq 10000 ]
report $? "a line an instruction: 10000 in 200 us at 50 MHz"
awk '{ if ($2 != (NR - 1) * 20000) bad = 1 } END { exit bad }' "$work/cpu.trace"
report $? "each begins 20 ns after the one before"
if command -v riscv64-unknown-elf-objdump >/dev/null; then
    # Every executed address with its word must stand in the disassembly of the image.
    riscv64-unknown-elf-objdump -d $clock | awk '$1 ~ /^[0-9a-f]+:$/ { print substr($1, 1, 8), $2 }' |
        sort >"$work/words.objdump"
    sed 's/.*PC=\([0-9a-f]*\) WORD=\([0-9a-f]*\) .*/\1 \2/' "$work/cpu.trace" | sort -u >"$work/words.ours"
    [ -s "$work/words.ours" ] && [ -z "$(comm -23 "$work/words.ours" "$work/words.objdump")" ]
    report $? "addresses and words are those that objdump finds in the image"
else
    number=$((number + 1))
    echo "ok $number - addresses and words # SKIP no riscv64-unknown-elf-objdump"
fi
"$KINESCOPE" trace $clock --what cpu --from 100us --for 100us -o "$work/late.trace" 2>"$work/said"
tail -n 5000 "$work/cpu.trace" | cmp - "$work/late.trace" >>"$work/said"
report $? "--from begins later with the same lines"
"$KINESCOPE" trace roms/stops.elf --what irq --for 50ms >"$work/irq.trace" 2>"$work/said"
"$KINESCOPE" trace roms/stops.elf --what dpu --for 50ms >"$work/dpu.trace" 2>>"$work/said"
stops=$(grep -cE 'WORD=17[2-3][0-7]{3} ' "$work/dpu.trace") lines=$(grep -c 'stop high' "$work/irq.trace")
[ "$lines" -ge 8 ] && [ $((stops - lines)) -ge 0 ] && [ $((stops - lines)) -le 1 ]
report $? "the stop line rises once a stop word ($lines of $stops)"
says "cpu traces want firmware" 2 "needs firmware" trace roms/rose.df --what cpu

# ---- snapshots ------------------------------------------------------------------------------------
"$KINESCOPE" run $clock --headless --for 700ms --save-state "$work/clock.state" 2>"$work/said"
[ $? -eq 3 ] && [ -s "$work/clock.state" ]
report $? "run saves its state"
is "$(hash_of $clock --at 1.1s)" "$(hash_of $clock --at 1.1s --load-state "$work/clock.state")"
report $? "a capture that goes on from it has the same film"
whole=$("$KINESCOPE" trace $clock --what dpu --from 700ms --for 20ms | sha256sum)
is "$whole" "$("$KINESCOPE" trace $clock --what dpu --load-state "$work/clock.state" --for 20ms | sha256sum)"
report $? "a trace that goes on from it has the same lines"
"$KINESCOPE" capture $clock --load-state "$work/clock.state" --at 0.9s --save-state "$work/later.state" \
    -o "$work/later.png" 2>"$work/said"
is "$(hash_of $clock --at 1.1s)" "$(hash_of $clock --at 1.1s --load-state "$work/later.state")"
report $? "capture saves its state, too, and so on"
says "a picture from before the snapshot" 2 "is as of 700" capture $clock --load-state "$work/clock.state" \
    --at 0.705s -o "$work/x.png"
says "another program's snapshot" 1 "another program" capture roms/bounce.elf --load-state "$work/clock.state" \
    -o "$work/x.png"
head -c 5000 "$work/clock.state" >"$work/short.state"
says "a snapshot cut short" 1 "short.state" capture $clock --load-state "$work/short.state" -o "$work/x.png"
says "a snapshot that is none" 1 "rose.df" capture $clock --load-state roms/rose.df -o "$work/x.png"
says "nowhere to save" 1 "no/such" run $clock --headless --console --for 1ms --save-state "$work/no/such/x"

# ---- bad input ------------------------------------------------------------------------------------
says "a console without firmware" 2 "no firmware" run roms/rose.df --headless --console
says "a debugger without firmware" 2 "no firmware" run roms/rose.df --headless --gdb 127.0.0.1:0
says "firmware for firmware" 1 "is for display files" run $hello --firmware $hello --headless
says "firmware that is not there" 1 "nothing.elf" run roms/rose.df --firmware "$work/nothing.elf" --headless
cp /bin/true "$work/host.elf"
says "a program for another machine" 1 "host.elf" run "$work/host.elf" --headless
head -c 900 $hello >"$work/cut.elf"
says "an image cut short" 1 "cut.elf" run "$work/cut.elf" --headless

# ---- the tube that firmware names ------------------------------------------------------------------
"$KINESCOPE" capture --view vector -o "$work/named.png" 2>"$work/said" && grep -aq "P31" "$work/named.png"
report $? "firmware names the vector head's tube"
"$KINESCOPE" capture --view vector --tube VR14 -o "$work/asked.png" 2>"$work/said" &&
    grep -aq "VR14" "$work/asked.png" && ! grep -aq "P31" "$work/asked.png"
report $? "--tube goes before it"

echo "1..$number"
exit $failed
