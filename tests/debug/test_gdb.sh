#!/bin/sh
# Sessions of a real gdb-multiarch with firmware that runs headless.
set -u
. tests/support/tap.sh
work=$TEST_OUT/gdb
mkdir -p "$work"

if ! command -v gdb-multiarch >/dev/null; then
    echo "ok 1 - sessions of gdb-multiarch # SKIP gdb-multiarch is not installed"
    echo "1..1"
    exit 0
fi

# Starts kinescope with a ROM; $port is where it waits.
start() { # ROM OPTIONS...
    rom=roms/$1.elf
    shift
    : >"$work/stderr"
    timeout 60 "$KINESCOPE" run "$rom" --headless --gdb 127.0.0.1:0 --for 100s "$@" >"$work/stdout" 2>"$work/stderr" &
    machine=$!
    port=
    for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        port=$(sed -n 's/^waiting for gdb at 127\.0\.0\.1:\([0-9]*\);.*/\1/p' "$work/stderr")
        [ -n "$port" ] && break
        sleep 0.1
    done
}

# One command of gdb's an argument. What it says is in "said".
debug() {
    for command in "$@"; do
        shift
        set -- "$@" -ex "$command"
    done
    timeout 60 gdb-multiarch -batch -nx "$rom" -ex 'set remotetimeout 10' \
        -ex "target remote 127.0.0.1:$port" "$@" >"$work/said" 2>&1 </dev/null
}

# Lets the machine come to its end; its exit status is in $status.
finish() {
    wait "$machine"
    status=$?
    cat "$work/stderr" >>"$work/said"
}

said() { # REGULAR EXPRESSIONS, each of a line of its own
    for line in "$@"; do
        grep -qE "$line" "$work/said" || {
            echo "missing: $line" >>"$work/said"
            return 1
        }
    done
}

# ---- break, floats, watch, step ----

# bounce moves its body by a 120th of a second each time: place.x = -0.45, speed 0.83 a second.
start bounce
debug 'print $pc == (void (*)()) _start' 'break body_move' continue 'print $fa0' 'print $fa0 == 1.0f / 120' \
    'info registers fa0' 'info float' 'set $body = $a0' 'watch *(float *) $body' continue 'delete 2' continue \
    'print *(float *) $body' 'stepi' 'print $pc == (char *) body_move + 8' 'print (int) $sp % 16' 'monitor time' \
    'info registers mstatus' 'x/i $pc' 'set $fa0 = 0.25' 'print $fa0' kill
finish
said '^\$1 = 1$' '^Breakpoint 1, 0x[0-9a-f]+ in body_move' '^\$2 = 0\.00833333' '^\$3 = 1$' \
    '^fa0 +0\.00833333.*raw 0x3c088889'
report $? "break in firmware; a float argument"
said '^frm +0x0.*RNE' '^fcsr ' '^ft11 '
report $? "info float"
said '^Hardware watchpoint 2:' '^Old value = -0\.4' '^New value = -0\.44308' '^\$4 = -0\.44308'
report $? "a watchpoint sees the float change"
said '^\$5 = 1$' '^\$6 = 0$' '^[0-9.]+ s, cycle [0-9]+, [0-9]+ instructions' '^mstatus ' '^\$7 = 0\.25$'
report $? "step, registers, monitor, a register is set"
[ $status -eq 0 ]
report $? "kill ends the run"

# ---- back ----

start bounce
debug 'break body_move' continue 'set $body = $a0' continue continue 'print *(float *) $body' 'print $pc' \
    reverse-continue 'print *(float *) $body' reverse-stepi 'print $pc == (char *) body_move' reverse-stepi \
    stepi stepi 'print $pc == $2' delete 'watch *(float *) $body' reverse-continue 'print *(float *) $body' \
    delete 'break body_move' continue 'print *(float *) $body' reverse-continue delete reverse-continue \
    'print $pc == (char *) _start' 'monitor past' kill
finish
said '^\$1 = -0\.43616' '^\$3 = -0\.44308' '^\$4 = 1$' '^\$5 = 1$'
report $? "reverse-continue to a breakpoint, reverse-stepi from there"
said '^Old value = -0\.44308' '^New value = -0\.4[45]0?' '^\$6 = -0\.4[45]' '^\$7 = -0\.44308'
report $? "reverse-continue undoes a watched store; forward again it is the same"
said 'No more reverse-execution history' '^\$8 = 1$' '^remembered from 0\.0 s on'
report $? "back to power-on, and no further"

# ---- interrupt, detach ----

start bounce
gdb-multiarch -batch -nx "$rom" -ex 'set remotetimeout 10' -ex "target remote 127.0.0.1:$port" \
    -ex 'break body_init' -ex continue -ex delete -ex 'echo off\n' -ex continue -ex 'print $pc != 0' \
    -ex detach >"$work/said" 2>&1 </dev/null &
gdb=$!
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    grep -q '^off' "$work/said" && break
    sleep 0.05
done
sleep 0.2 # of the second or so that the 100 simulated ones take
kill -INT $gdb
wait $gdb
finish
said 'body_init' 'SIGINT' '^\$1 = 1$' 'detached'
report $? "^C interrupts, detach lets go"
[ $status -eq 3 ] && said 'has not ended itself within 100\.0 s'
report $? "after detach the machine ran on to its end"

# ---- the end of a program ----

start stops
debug 'break board_mark' continue 'print $a0' 'delete' continue
finish
said '^\$1 = 1$' 'exited normally'
report $? "gdb is told of the end"
[ $status -eq 0 ]
report $? "the exit status is the firmware's"

start bounce --for 1s
debug continue
finish
said 'terminated with signal SIGTERM'
report $? "or that the run was over before"

# ---- traps nobody handles; code is written, ROM or not ----

start bounce
debug 'break body_move' continue 'set $mtvec = 0' 'set *(unsigned *) $pc = 0' 'x/xw $pc' stepi 'print $mcause' detach
finish
said '0x00000000$' 'SIGILL'
report $? "an illegal instruction that nobody handles is SIGILL"
[ $status -eq 1 ] && said 'illegal instruction'
report $? "and trouble when the debugger has gone"

start bounce
debug 'break body_move' continue 'set $mtvec = 0' 'set $a0 = 0x80000001' continue
finish
said 'SIGBUS|SIGSEGV'
report $? "a bad pointer is SIGBUS or SIGSEGV"

# ---- devices ----

start bounce
debug 'break body_move' continue 'x/4xh 0x40000000' 'x/4xh 0x41000000' 'x/xb 0x10000000' 'monitor dpu' \
    'monitor lines' 'monitor cpu' 'monitor nonsense' 'set {short}0x41000100 = 0x1234' 'x/xh 0x41000100' kill
finish
said '^0x40000000:.*0x' '^0x41000000:.*0x' 'Cannot access memory at address 0x10000000' '^running|^waiting|^stopped' \
    '^1 stop ' '^pc 8000' 'no such command: nonsense' '^0x41000100:.*0x1234'
report $? "display memory and registers are seen, the UART is left alone"

# ---- where it may listen ----

refused() { # STATUS TEXT OPTIONS...
    want=$1 text=$2
    shift 2
    timeout 20 "$KINESCOPE" run --headless "$@" >"$work/said" 2>&1
    [ $? -eq "$want" ] && grep -q -- "$text" "$work/said"
}
refused 2 '--gdb-anywhere' roms/bounce.elf --gdb 0.0.0.0:0
report $? "other machines are kept out"
refused 2 'ADDRESS:PORT' roms/bounce.elf --gdb 1234
report $? "a place without an address is a mistake"
refused 2 'no firmware' roms/rose.df --gdb :0
report $? "a display file alone has nothing to debug"

echo "1..$number"
exit $failed
