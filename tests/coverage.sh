#!/bin/sh
# coverage.sh OBJECTS REPLAY... -- TEST... — lines run, in per cent of those that hold code, for all of
# display_file/ and the readers elsewhere: first by the fuzzers' kept inputs alone, then by those and the
# C tests together. OBJECTS was built with MODE=cov; its counts are started afresh. gcc only (gcov).
set -eu
objects=$1
shift
command -v gcov >/dev/null || {
    echo "coverage: gcov is not installed; it comes with the package gcc" >&2
    exit 1
}
files="$(ls display_file/*.c) crt/beam_read.c crt/ini_value.c crt/number_text.c crt/phosphor_ini.c
       crt/png_read.c crt/tube_ini.c emu/input_file.c emu/machine.c emu/options.c emu/quantity.c
       emu/settings.c"
logs=$objects/coverage
mkdir -p "$logs"
find "$objects" -name "*.gcda" -exec rm -f {} +
export CMOCKA_MESSAGE_OUTPUT=TAP LSAN_OPTIONS=detect_leaks=0

# "FILE LINES-RUN LINES" for each file.
count() {
    for file in $files; do
        gcov -n "$objects/${file%.c}.gcno" 2>/dev/null | awk -v file="$file" '
            /^File / { mine = $0 == "File \x27" file "\x27" }
            mine && /^Lines executed:/ { split($2, p, /[:%]/); n = $4; run = p[2] * n / 100; mine = 0 }
            END { printf "%s %d %d\n", file, run + 0.5, n }'
    done
}

failed=0
stage=inputs
for program in "$@"; do
    if [ "$program" = -- ]; then
        count >"$logs/inputs"
        stage=tests
        continue
    fi
    "$program" >"$logs/$(basename "$program").log" 2>&1 || {
        echo "coverage: $program fails; see $logs/$(basename "$program").log" >&2
        failed=1
    }
done
count >"$logs/$stage"
awk 'function row(name, a, b, n) { printf "%-32s %6d %9.1f %9.1f\n", name, n, 100 * a / n, 100 * b / n }
     NR == FNR { inputs[$1] = $2; next }
     FNR == 1 { printf "%-32s %6s %9s %9s\n", "file", "lines", "corpora %", "+ tests %" }
     $3 > 0 { row($1, inputs[$1], $2, $3)
         folder = $1; sub(/\/.*/, "/", folder)
         a[folder] += inputs[$1]; b[folder] += $2; n[folder] += $3 }
     END { print ""; for (f in n) row(f, a[f], b[f], n[f]) }' "$logs/inputs" "$logs/tests"
exit $failed
