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

# ---- the end of input ----------------------------------------------------------------------------
printf 'line dda 0 0 4 5' | "$KINESCOPE" run --headless --console --for 5s 2>"$work/said" | tr -d '\r' >"$work/end"
[ "$(tail -n 1 "$work/end")" = "> " ] && grep -q "6 pixels" "$work/end" && [ ! -s "$work/said" ]
report $? "a line without its end is carried out, and the end is seen"
printf 'lesson lines\n\033' | "$KINESCOPE" run --headless --console --for 5s >"$work/end" 2>"$work/said" && [ ! -s "$work/said" ]
report $? "Escape, and the end of input behind it, leave a lesson and the monitor"
printf 'step on\nclip cohen-sutherland 10 10 40 40 5 8 60 45\n\033[Cqquit 4\n' |
    "$KINESCOPE" run --headless --console --for 5s >"$work/end" 2>"$work/said"
[ $? -eq 4 ] && grep -q "accepted" "$work/end"
report $? "clipping in step mode: a cursor key is one step"
printf 'step on\nclip polygon 0 0 4 4 2 -1 5 2 2 5 -1 2\nqquit 4\n' |
    "$KINESCOPE" run --headless --console --for 5s >"$work/end" 2>"$work/said"
[ $? -eq 4 ] && grep -q "corners" "$work/end"
report $? "clipping in step mode: q shows the rest"

# ---- every command, badly typed --------------------------------------------------------------------
printf 'help\n' | "$KINESCOPE" run --headless --console --for 5s 2>/dev/null | tr -d '\r' |
    sed -n 's/^  \([a-z0-9-]*\) .*/\1/p' | grep -vx quit >"$work/names"
[ "$(wc -l <"$work/names")" -gt 30 ]
report $? "help lists the commands"
while read -r name; do
    printf 'help %s\n' "$name"
done <"$work/names" | "$KINESCOPE" run --headless --console --for 20s 2>/dev/null | tr -d '\r' >"$work/helped"
# Behind each echoed line: "NAME FORM", and what it does.
awk 'NR == FNR { names++; next }
    /^> help / { name = $3; wanted = 1; next }
    wanted == 1 { wanted = index($0, name " ") == 1 ? 2 : 0; next }
    wanted == 2 && /^  [^ ]/ { told[name] = 1 }
    END { for (name in told) n++; exit n != names }' "$work/names" "$work/helped"
report $? "help NAME tells the form of each"
while read -r name; do
    for words in "frob" "1e30 1e30 1e30 1e30 1e30 1e30" "nan inf" "-1 -1 -1 -1 -1" "0 0 0 0 0 0 0 0 0" "1/0" \
        "99999999999 1" "at" "then" "on on on" "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20"; do
        printf '%s %s\nq\n' "$name" "$words"
    done
done <"$work/names" >"$work/bad"
printf 'quit 5\n' >>"$work/bad"
# Forms that are right, whose numbers are the largest that floats have, and those that most commands still take.
for most in 3e38 1000000; do
    sed "s/N/$most/g" tests/roms/far_numbers.txt
done >"$work/far"
cat "$work/bad" >>"$work/far"
timeout 300 "$KINESCOPE" run --headless --console --for 300s <"$work/far" >"$work/bad.out" 2>"$work/said"
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
