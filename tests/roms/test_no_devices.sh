#!/bin/sh
# Programs that people point with, on a board without heads and input devices (QEMU's virt) and on one
# without a tablet, panel, mouse and keyboard: they come up, take keys from the console, and end.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/no_devices
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

virt() { # IMAGE; keys once it is up
    { sleep 1 && printf 'wq'; } | timeout 60 qemu-system-riscv32 -M virt -bios none -nographic \
        -cpu rv32,c=false,d=false -kernel "$1" 2>"$work/errors" | tr -d '\r' >"$work/said"
}
for name in pick spline digitise choice track calibrate; do
    case $name in
    pick) last='pick ends' ;;
    spline) last='end' ;;
    digitise) last='# end' ;;
    choice) last='choice: pages 1 to 3, menu A to F, Tab + - sliders, q ends' ;;
    track) last='track: this board has no vector head.' ;;
    calibrate) last='calibrate: this board has no light pen at a raster head.' ;;
    esac
    if command -v qemu-system-riscv32 >/dev/null 2>&1; then
        virt roms/$name.elf
        [ "$(tail -n 1 "$work/said")" = "$last" ] && ! grep -q terminating "$work/errors"
        report $? "$name on a board with nothing"
    else
        number=$((number + 1))
        echo "ok $number - $name on a board with nothing # SKIP no qemu-system-riscv32 (Debian: qemu-system-misc)"
    fi
done

for name in pick spline digitise choice; do
    printf 'wq' | "$KINESCOPE" run roms/$name.elf --headless --console --for 5s --set tablet=none --set touch=none \
        --set mouse=none --set keyboard=none >"$work/said" 2>"$work/errors"
    report $? "$name with no device but the console"
done
echo "1..$number"
exit $failed
