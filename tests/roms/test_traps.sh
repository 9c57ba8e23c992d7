#!/bin/sh
# Firmware that traps where nobody handles it: the report names the place and the reason, whatever the
# program was doing; on another board the board support says what it can.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/traps
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

trap_of() { # LETTER WHERE REASON
    printf %s "$1" | "$KINESCOPE" run tests/roms/traps.elf --headless --console --for 2s \
        >"$work/printed" 2>"$work/said"
    status=$?
    [ $status = 1 ] && grep -q "nobody handles the trap at pc [0-9a-f]* ($2[+)].*: $3" "$work/said" &&
        grep -q '^Now\.' "$work/printed" && ! grep -q 'did not' "$work/printed"
    report $? "$2: $3"
}
trap_of l load "load access fault, address 50000000"
trap_of n load_narrow "load access fault, address 40000000"
trap_of m load_misaligned "load address misaligned"
trap_of c store_constant "store access fault, address 8"
trap_of t store_code "store access fault, address 80000000"
trap_of i illegal "illegal instruction"
trap_of r no_such_register "illegal instruction"
trap_of b breakpoint "breakpoint"
trap_of e call_nobody "environment call"
trap_of o deeper "store access fault, address 8000"
trap_of h in_callback "illegal instruction"
trap_of p held_off "illegal instruction"

printf j | "$KINESCOPE" run tests/roms/traps.elf --headless --console --for 2s >/dev/null 2>"$work/said"
grep -q 'nobody handles the trap at pc 00001000: instruction access fault' "$work/said"
report $? "a jump to where no code is"
printf x | "$KINESCOPE" run tests/roms/traps.elf --headless --console --for 2s >"$work/said" 2>&1 &&
    grep -q '^It did not trap\.' "$work/said"
report $? "without a trap all is well"

if command -v qemu-system-riscv32 >/dev/null 2>&1; then
    printf i | timeout 20 qemu-system-riscv32 -M virt -bios none -nographic \
        -cpu rv32,c=false,d=false -kernel tests/roms/traps.elf >"$work/said" 2>&1
    [ $? = 1 ] && tr -d '\r' <"$work/said" |
        grep -qE '^Unhandled trap: illegal instruction, cause 00000002, pc 8[0-9a-f]{7}, value '
    report $? "another board: the board support tells"
else
    number=$((number + 1))
    echo "ok $number - another board: the board support tells # SKIP no qemu-system-riscv32"
fi
echo "1..$number"
exit $failed
