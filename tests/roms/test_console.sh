#!/bin/sh
# The monitor's console language: each script in console/NAME.in prints console/NAME.out, which was judged
# right line by line; the same firmware prints the same on QEMU's riscv32 "virt" board. Then what somebody
# types who means no harm, and somebody who does. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/console
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

ours() { # SCRIPT
    "$KINESCOPE" run --headless --console --for 120s <"$1" 2>"$work/said" | tr -d '\r'
}
theirs() { # SCRIPT: its end of input has to be typed
    { cat "$1" && printf '\004'; } | timeout 100 qemu-system-riscv32 -M virt -bios none -nographic \
        -cpu rv32,c=false,d=false -kernel roms/monitor.elf 2>"$work/said" | tr -d '\r'
}
skip() { # NAME
    number=$((number + 1))
    echo "ok $number - $1 # SKIP no qemu-system-riscv32 (Debian: qemu-system-misc)"
}

for script in tests/roms/console/*.in; do
    name=$(basename "$script" .in)
    ours "$script" >"$work/$name.ours"
    diff "tests/roms/console/$name.out" "$work/$name.ours" >>"$work/said" 2>&1
    report $? "$name: what it prints is what was judged right"
    if command -v qemu-system-riscv32 >/dev/null 2>&1; then
        theirs "$script" >"$work/$name.qemu"
        diff "$work/$name.ours" "$work/$name.qemu" >>"$work/said" 2>&1
        report $? "$name: QEMU prints the same"
    else
        skip "$name: QEMU prints the same"
    fi
done

# ---- every command, badly typed --------------------------------------------------------------------
printf 'help\n' | "$KINESCOPE" run --headless --console --for 5s 2>/dev/null | tr -d '\r' |
    sed -n 's/^  \([a-z0-9-]*\) .*/\1/p' | grep -vx quit >"$work/names"
[ "$(wc -l <"$work/names")" -gt 30 ]
report $? "help lists the commands"
while read -r name; do
    printf 'help %s\n' "$name"
done <"$work/names" | "$KINESCOPE" run --headless --console --for 20s 2>/dev/null | tr -d '\r' >"$work/helped"
[ "$(grep -cF -f "$work/names" "$work/helped")" -ge "$(wc -l <"$work/names")" ]
report $? "help NAME tells the form of each"
while read -r name; do
    for words in "frob" "1e30 1e30 1e30 1e30 1e30 1e30" "nan inf" "-1 -1 -1 -1 -1" "0 0 0 0 0 0 0 0 0" "1/0" \
        "99999999999 1" "at" "then" "on on on" "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20"; do
        printf '%s %s\nq\n' "$name" "$words"
    done
done <"$work/names" >"$work/bad"
printf 'quit 5\n' >>"$work/bad"
timeout 300 "$KINESCOPE" run --headless --console --for 300s <"$work/bad" >"$work/bad.out" 2>"$work/said"
[ $? -eq 5 ]
report $? "bad commands: the monitor lives to the end"
! grep -v '^>\|"' "$work/bad.out" | grep -qE '(^|[ (,=-])(inf|nan)([ ),]|$)'
report $? "bad commands: no infinity is printed"
# Noise from a fixed seed, all bytes but the end of input.
awk 'BEGIN { srand(7); for (i = 0; i < 20000; i++) { c = int(rand() * 255) + 1; if (c != 4) printf "%c", c } }' >"$work/noise"
{ LC_ALL=C tr -d '\004' <"$work/noise" && printf '\033\r\rq\rq\rquit 6\rquit 6\r'; } >"$work/noise.in"
timeout 300 "$KINESCOPE" run --headless --console --for 300s <"$work/noise.in" >"$work/noise.out" 2>"$work/said"
[ $? -eq 6 ]
report $? "noise: the monitor lives to the end"
echo "1..$number"
exit $failed
