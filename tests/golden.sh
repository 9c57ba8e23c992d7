#!/bin/sh
# golden.sh [--regenerate] KINESCOPE — event traces (exact) and film (hash and samples, exact) of
# every program in roms/, as listed in tests/golden/list.txt. Prints TAP.
# With --regenerate the goldens are written instead: look at every picture before committing it.
# On a failure the got and diff pictures stay in $TEST_OUT.
set -u
regenerate=no
if [ "${1:-}" = --regenerate ]; then
    regenerate=yes
    shift
fi
kinescope=${1:-$KINESCOPE}
golden=tests/golden
out=${TEST_OUT:-o/test-out}/golden
mkdir -p "$out"
n=0
report() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" = 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}
# What a program's events are: the words of the first refresh; of the raster head, whose rows would be
# many, sync and what is taken at retrace; of a program that a script works ("input"), what is done and what
# the devices report.
events() { # PROGRAM TUBE HEAD
    if [ "$3" = input ]; then
        "$kinescope" trace "$1" --tube "$2" --what input --input "${1%.*}.script"
    elif [ "$3" = raster ]; then
        "$kinescope" trace "$1" --tube "$2" --what video --for 100ms >"$out/video" &&
            grep -E 'vsync|retrace' "$out/video"
    else
        "$kinescope" trace "$1" --tube "$2" --what dpu
    fi
}
while IFS='|' read -r name program tube at head <&3; do
    name=$(echo "$name" | tr -d ' ')
    program=$(echo "$program" | tr -d ' ')
    tube=$(echo "$tube" | tr -d ' ')
    at=$(echo "$at" | tr -d ' ')
    head=$(echo "$head" | tr -d ' ')
    case "$name" in '' | '#'*) continue ;; esac
    set -- --at "$at"
    [ "$at" = end ] && set -- # when the script is over, and the program has answered it
    [ "$head" = input ] && set -- "$@" --input "${program%.*}.script" --view both
    to=$out
    [ $regenerate = yes ] && to=$golden
    if ! "$kinescope" capture "$program" --tube "$tube" "$@" --film --depth 8 --hash -o "$to/$name.png" >"$to/$name.hash"; then
        report 1 "$name: capture"
        continue
    fi
    if ! events "$program" "$tube" "$head" >"$to/$name.trace"; then
        report 1 "$name: trace"
        continue
    fi
    if [ $regenerate = yes ]; then
        echo "$name: $(cat "$to/$name.hash")"
        continue
    fi
    cmp -s "$golden/$name.trace" "$out/$name.trace"
    status=$?
    [ $status = 0 ] || diff "$golden/$name.trace" "$out/$name.trace" | head -n 10
    report $status "$name: trace of the first refresh"
    cmp -s "$golden/$name.hash" "$out/$name.hash"
    status=$?
    [ $status = 0 ] || "$kinescope" compare "$golden/$name.png" "$out/$name.png" --diff "$out/$name-diff.png"
    report $status "$name: film hash"
    "$kinescope" compare "$golden/$name.png" "$out/$name.png" >/dev/null
    report $? "$name: film samples as in the golden picture"
done 3<$golden/list.txt
if [ $regenerate = no ]; then
    # A program without a golden is a program nobody looked at.
    missing=
    for program in roms/*.df $(ls roms/*.script 2>/dev/null | sed 's/\.script$/.elf/'); do
        grep -q "| *$program *|" $golden/list.txt || missing="$missing $program"
    done
    [ -z "$missing" ] || echo "# no golden for:$missing"
    [ -z "$missing" ]
    report $? "every program in roms/ has a golden"
    echo "1..$n"
fi
