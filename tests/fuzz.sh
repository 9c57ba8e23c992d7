#!/bin/sh
# fuzz.sh SECONDS FUZZER... — runs fuzzers (tests/fuzz/fuzz_NAME.c or NAME) for SECONDS each.
#
# Builds with clang's libFuzzer, AddressSanitizer and UndefinedBehaviorSanitizer into o/fuzz, starts
# from the kept corpus tests/corpus/NAME, adds the inputs that cover more to it (short ones, 4 KiB at most),
# and prints the coverage as the fuzzer states it. Findings are left in o/fuzz/NAME-findings; exit
# status 1 when there is any. FUZZ_MAX_LEN overrides the length of inputs while fuzzing.
set -eu
if [ $# -lt 2 ]; then
    echo "usage: tests/fuzz.sh SECONDS FUZZER..." >&2
    exit 2
fi
seconds=$1
shift
command -v clang >/dev/null || {
    echo "fuzz: clang is not installed; install the package clang and try again" >&2
    exit 1
}
out=o/fuzz
mkdir -p "$out"
# The macro is libFuzzer's usual one: limits that only cost time are lower with it.
flags="-std=c11 -D_POSIX_C_SOURCE=200809L -DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
       -ffp-contract=off -O1 -g -I. -pthread
       -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"

# Objects are rebuilt when the source, any header or this script (the flags) is newer: there is no make
# in between.
newest_header=$(ls -t crt/*.h display_file/*.h emu/*.h emu/*/*.h raster/*.h input/*.h tests/support/*.h tests/fuzz/*.h 2>/dev/null | head -n 1)
object() { # SOURCE EXTRA-FLAGS
    o="$out/$1.o"
    if [ ! -f "$o" ] || [ "$1" -nt "$o" ] || [ "$newest_header" -nt "$o" ] || [ "$0" -nt "$o" ]; then
        mkdir -p "$(dirname "$o")"
        case "$1" in *_avx2.c) simd=-mavx2 ;; *) simd= ;; esac
        clang $flags $simd "$2" -c -o "$o" "$1"
    fi
}

# The device folders and what emu/ has besides main() and windows; unused members are left out by the linker.
sources=$(ls crt/*.c display_file/*.c raster/*.c input/*.c emu/*.c emu/*/*.c 2>/dev/null | grep -v '^emu/main\.c$')
[ "$(uname -m)" = x86_64 ] || sources=$(echo "$sources" | grep -v '_avx2\.c$')
objects=
for source in $sources; do
    object "$source" -fsanitize=fuzzer-no-link
    objects="$objects $out/$source.o"
done
rm -f "$out/lib.a"
ar rcs "$out/lib.a" $objects

status=0
for fuzzer in "$@"; do
    name=$(basename "$fuzzer" .c)
    name=${name#fuzz_}
    source=tests/fuzz/fuzz_$name.c
    corpus=tests/corpus/$name
    program=$out/fuzz_$name
    work=$out/$name-work
    findings=$out/$name-findings
    object "$source" -fsanitize=fuzzer
    clang $flags -fsanitize=fuzzer -o "$program" "$out/$source.o" "$out/lib.a" \
        -lglfw -lxcvt -lpng -linih -lnettle -ldw -lelf -lm -ldl
    mkdir -p "$corpus" "$work" "$findings"
    dictionary=
    [ -f "tests/fuzz/$name.dict" ] && dictionary="-dict=tests/fuzz/$name.dict"
    echo "fuzz_$name: $seconds s from $(ls "$corpus" | wc -l) kept inputs"
    if ! "$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -max_len="${FUZZ_MAX_LEN:-4096}" $dictionary -artifact_prefix="$findings/" "$work" "$corpus" \
        >"$out/$name.log" 2>&1; then
        status=1
        echo "fuzz_$name: a finding; the input is in $findings, the report ends $out/$name.log:" >&2
        tail -n 25 "$out/$name.log" >&2
        continue
    fi
    # The shortest inputs that reach edges no kept one reaches are kept from now on. How often an edge is
    # passed does not count, or thousands would be.
    "$program" -merge=1 -use_counters=0 -max_len="${FUZZ_MAX_LEN:-4096}" "$corpus" "$work" \
        >"$out/$name-merge.log" 2>&1
    "$program" -runs=0 "$corpus" >"$out/$name-cover.log" 2>&1
    edges=$(sed -n 's/.*Loaded 1 PC tables (\([0-9]*\) PCs).*/\1/p' "$out/$name-cover.log")
    covered=$(sed -n 's/.*INITED cov: \([0-9]*\).*/\1/p' "$out/$name-cover.log")
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$out/$name.log")
    echo "fuzz_$name: $runs inputs run; the kept corpus covers $covered of $edges edges linked in"
    echo "fuzz_$name: no finding; corpus $(ls "$corpus" | wc -l) inputs, $(du -sk "$corpus" | cut -f1) KiB on disk"
done
exit $status
