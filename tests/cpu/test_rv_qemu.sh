#!/bin/sh
# Random programs on the processor and under qemu-riscv32: every instruction of RV32IMF, Zicsr and Zifencei
# that an application may execute, every rounding mode; afterwards registers, fcsr and memory are equal, in
# each of the processor's loops. Needs $TEST_OUT; prints TAP. Skips when QEMU is missing.
set -u
seed=1
count=6000
work=$TEST_OUT/qemu
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh
. tests/cpu/qemu/tools.sh

snapshot="crt/state.c crt/error.c" # with these the processor is saved
# shellcheck disable=SC2086
host -o "$work/blocks" tests/cpu/qemu/block*.c tests/cpu/qemu/insn_table.c emu/cpu/*.c $snapshot >"$work/said" 2>&1
report $? "the tool compiles"
[ $failed -eq 0 ] || exit 1

# both SEED [COUNT]: makes the blocks, runs them under QEMU, then here.
both() {
    "$work/blocks" make "$work/blocks.elf" "$@" && chmod +x "$work/blocks.elf" || return 1
    qemu-riscv32 "$work/blocks.elf" >"$work/qemu.out"
    "$work/blocks" compare "$work/qemu.out" "$@"
}

both $seed $count >"$work/result" 2>&1
tail -n 1 "$work/result" >"$work/said"
grep -q "^0 of $count blocks differ" "$work/said"
same=$?
if [ $same -ne 0 ]; then
    # The first block again, item by item.
    grep -vE '^[a-z.]+ +[0-9]+( |$)' "$work/result" >"$work/said"
    both "$(sed -n 's/^first: //p' "$work/result")" >>"$work/said" 2>&1
fi
report $same "$count random programs do the same here and under QEMU"

tail -n 1 "$work/result" >"$work/said"
grep -q '; 0 instructions or roundings were never executed$' "$work/said"
report $? "each instruction was executed, with each rounding mode"
rm -f "$work/blocks.elf" "$work/qemu.out" # they are large

echo "# executed: times; of those rounding rne rtz rdn rup rmm, then the same by frm"
grep -E '^[a-z.]+ +[0-9]+( |$)' "$work/result" | sed 's/^/#   /'
grep 'float arithmetic' "$work/result" | sed 's/^/# /'
echo "1..$number"
exit $failed
