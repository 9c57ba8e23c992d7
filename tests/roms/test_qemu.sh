#!/bin/sh
# Console firmware prints the same bytes on kinescope and on QEMU's riscv32 "virt" board.
# tests/roms/tables.txt is what QEMU printed: where there is no QEMU, kinescope is still held to it.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/qemu
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

ours() { # IMAGE
    "$KINESCOPE" run "$1" --headless --console --for 20s 2>"$work/said"
}
theirs() { # IMAGE
    timeout 60 qemu-system-riscv32 -M virt -bios none -nographic -cpu rv32,c=false,d=false \
        -kernel "$1" 2>"$work/said"
}
skip() { # NAME
    number=$((number + 1))
    echo "ok $number - $1 # SKIP no qemu-system-riscv32 (Debian: qemu-system-misc)"
}
qemu() { command -v qemu-system-riscv32 >/dev/null 2>&1; }
same() { # A B
    diff "$1" "$2" >>"$work/said" 2>&1
}

ours roms/tables.elf </dev/null >"$work/tables.ours"
report $? "tables: kinescope's exit status is 0"
same tests/roms/tables.txt "$work/tables.ours"
report $? "tables: kinescope prints what QEMU printed"
if qemu; then
    theirs roms/tables.elf </dev/null >"$work/tables.qemu"
    report $? "tables: QEMU's exit status is 0"
    same "$work/tables.ours" "$work/tables.qemu"
    report $? "tables: kinescope and QEMU print the same"
else
    skip "tables: kinescope and QEMU print the same"
fi

# What a terminal sends: carriage returns, rubbing out, a line too long, the end of input.
printf 'one\rtwp\177o\r\rtab\there\n%0100d\rlast\004more\004\004' 7 >"$work/typed"
said() { sed -n '/^Type lines/,$p' "$1" >"$1.said"; }
ours roms/hello.elf <"$work/typed" >"$work/hello.ours"
report $? "hello: kinescope's exit status is 0"
grep -q '^Memory map 3, .* vector head: yes, raster head: yes' "$work/hello.ours"
report $? "hello: it knows where it is"
said "$work/hello.ours"
[ "$(grep -c '^You typed: ' "$work/hello.ours.said")" = 7 ]
report $? "hello: seven lines come back"
grep -q '^You typed: two' "$work/hello.ours.said"
report $? "hello: what was rubbed out is not among them"
if qemu; then
    theirs roms/hello.elf <"$work/typed" >"$work/hello.qemu"
    report $? "hello: QEMU's exit status is 0"
    said "$work/hello.qemu"
    same "$work/hello.ours.said" "$work/hello.qemu.said"
    report $? "hello: kinescope and QEMU print the same"
else
    skip "hello: kinescope and QEMU print the same"
fi
echo "1..$number"
exit $failed
