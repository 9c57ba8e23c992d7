#!/bin/sh
# The same film bytes of strokes and scan lines from gcc and clang, baseline and AVX2, 1, 2 and 4 threads, x86-64 and
# aarch64; and
# of firmware that rewrites its display file while it is refreshed the same trace of 1000 refreshes.
# What is not installed is skipped, visibly.
set -u
out=$TEST_OUT/same_bytes
mkdir -p "$out"
program=roms/testcard.df
at=1s at_ps=1000000000000
n=0
ok() { n=$((n + 1)); echo "ok $n - $1"; }
check() { # NAME HASH
    n=$((n + 1))
    if [ "$2" = "$want" ]; then echo "ok $n - $1"; else echo "not ok $n - $1: $2, expected $want"; fi
}
skip() { n=$((n + 1)); echo "ok $n - $1 # SKIP $2"; }
film() { # KINESCOPE OPTIONS...
    k=$1
    shift
    "$k" capture $program --tube VR17 --at $at --film --depth 16 --hash -o "$out/film.png" "$@" | cut -d' ' -f1
}
want=$(film "$KINESCOPE" --threads 1 --simd baseline)
if [ ${#want} -ne 64 ]; then
    echo "not ok 1 - no film from $KINESCOPE"
    exit 1
fi
ok "baseline, 1 thread: $want"
check "baseline, 2 threads" "$(film "$KINESCOPE" --threads 2 --simd baseline)"
check "baseline, 4 threads" "$(film "$KINESCOPE" --threads 4 --simd baseline)"
if grep -qw avx2 /proc/cpuinfo 2>/dev/null; then
    check "AVX2, 1 thread" "$(film "$KINESCOPE" --threads 1 --simd avx2)"
    check "AVX2, 4 threads" "$(film "$KINESCOPE" --threads 4 --simd avx2)"
else
    skip "AVX2" "this processor has none"
fi

case ${TEST_MODE:-rel} in
rel | dbg) ;;
*)
    # These builds have no sanitizer in them and are the same as in the ordinary run.
    skip "gcc -O2, clang and aarch64 builds" "compared in MODE=rel"
    echo "1..$n"
    exit 0
    ;;
esac

"$KINESCOPE" asm $program -o "$out/program.oct" || exit 1
# Another film, of light in two layers, for the compilers.
"$KINESCOPE" asm roms/colours.df -o "$out/colours.oct" || exit 1
coloured=$("$KINESCOPE" capture roms/colours.df --at 0.6s --film --depth 16 --hash -o "$out/film.png" | cut -d' ' -f1)
# And one of the raster head, of three guns.
raster=$("$KINESCOPE" capture roms/pattern.elf --view raster --at 0.5s --film --depth 16 --hash -o "$out/film.png" | cut -d' ' -f1)
firmware=roms/clock.elf refreshes=1000
# What a film and a trace need, without libpng, GL, inih, nettle and libxcvt; the AVX2 kernels on x86-64 only.
sources="$(ls crt/*.c display_file/*.c | grep -vE '_avx2|png|glass|gl_|ini|image_hash|catalogue|beam_read')
    $(ls raster/*.c | grep -vE 'mode_(cvt|parse)')
    $(ls input/*.c) $(ls emu/machine*.c emu/cpu/*.c emu/board/*.c) emu/operator.c emu/flow.c emu/refresh.c emu/console.c emu/trace_lines.c"
flags="-std=c11 -D_POSIX_C_SOURCE=200809L -O2 -ffp-contract=off -I. -pthread"
compile() { # COMPILER...: its objects, then the programs
    rm -rf "$out/objects"
    for source in $sources tests/support/line_model.c tests/cross/*_bytes.c; do
        mkdir -p "$out/objects/$(dirname "$source")"
        # shellcheck disable=SC2086
        "$@" $flags -c -o "$out/objects/${source%.c}.o" "$source" || return 1
    done
    # shellcheck disable=SC2086
    case $("$@" -dumpmachine) in
    x86_64*)
        for kernels in footprint line; do
            "$@" $flags -mavx2 -c -o "$out/objects/${kernels}_avx2.o" crt/${kernels}_avx2.c || return 1
        done
        ;;
    esac
    objects=$(find "$out/objects" -name '*.o' ! -path '*/cross/*' | sort)
    for main in film_bytes lines_bytes raster_bytes trace_bytes; do
        # shellcheck disable=SC2086
        "$@" $flags -o "$out/$main" "$out/objects/tests/cross/$main.o" $objects -lm || return 1
    done
}
sum() { sha256sum | cut -d' ' -f1; }
cross() { # NAME RUNNER COMPILER...
    name=$1 runner=$2
    shift 2
    if compile "$@"; then
        check "$name: film" "$($runner "$out/film_bytes" "$out/program.oct" VR17 $at_ps 2 | sum)"
        film=$want want=$coloured
        check "$name: film in colours" "$($runner "$out/film_bytes" "$out/colours.oct" PENET17 600000000000 2 | sum)"
        want=$raster
        check "$name: film of the raster head" "$($runner "$out/raster_bytes" roms/pattern.elf COLOR17 500000000000 2 | sum)"
        want=$film
        lines=$($runner "$out/lines_bytes" | sum)
        if [ -n "$first" ]; then
            film=$want want=$first_lines
            check "$name: scan lines as from $first_name" "$lines"
            want=$film
        else
            first_lines=$lines
        fi
        trace=$($runner "$out/trace_bytes" $firmware $refreshes | sum)
        if [ -n "$first" ]; then
            film=$want want=$first
            check "$name: trace of $refreshes refreshes of $firmware as from $first_name" "$trace"
            want=$film
        else
            first=$trace first_name=$name
        fi
    else
        n=$((n + 1))
        echo "not ok $n - $name: does not compile"
    fi
}
first= # trace
cross "gcc -O2, on its own" "" gcc
if command -v clang >/dev/null 2>&1; then
    cross "clang" "" clang
else
    skip "clang" "not installed"
fi
if command -v aarch64-linux-gnu-gcc >/dev/null 2>&1 && command -v qemu-aarch64 >/dev/null 2>&1; then
    cross "aarch64" qemu-aarch64 aarch64-linux-gnu-gcc -static
else
    skip "aarch64" "needs gcc-aarch64-linux-gnu and qemu-user"
fi
echo "1..$n"
