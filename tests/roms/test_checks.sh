#!/bin/sh
# Properties of the drawing library on random cases, in the machine and on QEMU: each tests/roms/check_NAME.elf
# tells one a line and ends with status 0 when all hold. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/checks
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

for image in tests/roms/check_*.elf; do
    name=$(basename "$image" .elf)
    "$KINESCOPE" run "$image" --headless --console --for 20s </dev/null >"$work/$name.ours" 2>"$work/said"
    status=$?
    tr -d '\r' <"$work/$name.ours" | sed 's/^/# /'
    report $status "$name: every property holds"
    if command -v qemu-system-riscv32 >/dev/null 2>&1; then
        timeout 100 qemu-system-riscv32 -M virt -bios none -nographic -cpu rv32,c=false,d=false \
            -kernel "$image" </dev/null >"$work/$name.qemu" 2>"$work/said"
        # Speeds are told where there is a head to draw for.
        grep -v ' a second' "$work/$name.ours" | diff - "$work/$name.qemu" >>"$work/said" 2>&1
        report $? "$name: the same figures on QEMU"
    else
        number=$((number + 1))
        echo "ok $number - $name: the same figures on QEMU # SKIP no qemu-system-riscv32"
    fi
done
echo "1..$number"
exit $failed
