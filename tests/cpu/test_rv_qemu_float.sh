#!/bin/sh
# Float instructions under qemu-riscv32, whose arithmetic is another's, and emu/cpu/rv_float.h: every
# operation in every rounding mode, static and dynamic, on the same operands. Results and flags are equal.
# Needs $TEST_OUT; prints TAP. Skips when QEMU or the cross compiler is missing.
set -u
sets=100000 # of operands, a case
work=$TEST_OUT/qemu_float
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh
needed=riscv64-unknown-elf-gcc
. tests/cpu/qemu/tools.sh

cross -o "$work/guest" tests/cpu/qemu/float_guest.c tests/cpu/qemu/float_run.c >"$work/said" 2>&1
report $? "the program for RV32 compiles"
host -o "$work/host" tests/cpu/qemu/float_host.c tests/cpu/qemu/float_run.c emu/cpu/rv_float*.c >"$work/said" 2>&1
report $? "the program for the host compiles"
[ $failed -eq 0 ] || exit 1

"$work/host" $sets >"$work/ours" 2>"$work/ours.err" &
qemu-riscv32 "$work/guest" $sets >"$work/qemu" 2>"$work/said"
report $? "$sets sets of operands a case under QEMU"
wait $!
status=$?
cp "$work/ours.err" "$work/said"
report $status "and here"

# The first sets that the two do not agree on.
explain() { # CASE
    qemu-riscv32 "$work/guest" "$1" 0 $sets >"$work/qemu.sets"
    "$work/host" "$1" 0 $sets >"$work/ours.sets"
    paste -d '\n' "$work/qemu.sets" "$work/ours.sets" |
        awk 'NR % 2 { qemu = $0; next }
             qemu != $0 { print "qemu: " qemu "\nours: " $0; if (++n == 3) exit }'
}

# One result an operation; a name that only one side knows is a difference.
for operation in $(awk '{ print $2 }' "$work/ours" "$work/qemu" | sort -u); do
    grep " $operation " "$work/ours" >"$work/ours.op"
    grep " $operation " "$work/qemu" >"$work/qemu.op"
    if cmp -s "$work/ours.op" "$work/qemu.op"; then
        report 0 "$operation: $(wc -l <"$work/ours.op") cases"
    else
        diff "$work/qemu.op" "$work/ours.op" >"$work/difference"
        first=$(awk '/^[<>]/ { print $2; exit }' "$work/difference")
        { cat "$work/difference" && explain "$first"; } >"$work/said"
        report 1 "$operation"
    fi
done
# 13 operations that round in 10 ways, 6 that do not.
grep -c . "$work/ours" >"$work/said"
[ "$(cat "$work/said")" -eq 136 ]
report $? "136 cases"
echo "1..$number"
exit $failed
