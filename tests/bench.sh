#!/bin/sh
# bench.sh BENCH... — runs the benchmarks and names the machine. Figures are ratios within this run:
# machines differ and are noisy, so only compare what one run prints.
set -eu
cpu=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
echo "machine: ${cpu:-unknown processor}, $(nproc) cores, $(${CC:-gcc} --version | head -n 1)"
for bench in "$@"; do
    echo
    "$bench"
done

# Counted, not timed: the same on every machine.
echo
echo "drawing by firmware: instructions of the simulated processor, milliseconds at 50 MHz"
printf 'cost\nquit\n' | ./kinescope run --headless --console 2>/dev/null | tr -d '\r' | sed -n '/^8 bits/,/^>/p' |
    grep -v '^>'
