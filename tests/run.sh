#!/bin/sh
# run.sh OBJECTS TEST-BINARY... -- SHELL-TEST... — runs every test and counts.
#
# Test binaries and shell tests print TAP ("ok 1 - name", "not ok 2 - name", "ok 3 - name # SKIP why").
# As many files run at a time as there are processors (TEST_JOBS=1: one after the other); those of the
# window, which press keys and wait for pictures, and of terminals run alone, after the others.
# Ends with "N passed, N failed, N skipped" alone on a line; exit status 1 when anything failed.
# TEST_ONLY=pattern runs only the files whose path matches. TEST_MODE (rel, dbg, asan, tsan, cov) is told
# to the tests: what compares bytes or speeds and would take long may skip itself in a sanitizer mode.
set -u

# ---- one test file: its log, then a line for the reader, and its counts in NAME.counts
if [ "$1" = --one ]; then
    test=$2
    name=$(basename "$test" .sh)
    log="$TEST_OUT/$(basename "$test").log" # test_window.c and test_window.sh have one each
    start=$(date +%s)
    case "$test" in *.sh) sh "$test" >"$log" 2>&1 ;; *) "$test" >"$log" 2>&1 ;; esac
    status=$?
    # cmocka marks what it skips "not ok N # SKIP name".
    skip=$(grep -cE '^(not )?ok .*# *SKIP' "$log")
    ok=$(grep -E '^ok ' "$log" | grep -cvE '# *SKIP')
    bad=$(grep -E '^not ok ' "$log" | grep -cvE '# *SKIP')
    # A test that died, or said nothing, is a failure of its own.
    if [ $status -ne 0 ] && [ "$bad" -eq 0 ]; then bad=1; fi
    if [ "$ok" -eq 0 ] && [ "$bad" -eq 0 ] && [ "$skip" -eq 0 ]; then bad=1; fi
    # In one piece, so that lines of two tests do not mix.
    text=$(
        printf '%-32s %4d passed' "$name" "$ok"
        [ "$bad" -gt 0 ] && printf ', %d FAILED' "$bad"
        [ "$skip" -gt 0 ] && printf ', %d skipped' "$skip"
        printf '   (%d s)\n' $(($(date +%s) - start))
        if [ "$bad" -gt 0 ]; then
            grep -vE '^ok |^1\.\.' "$log" | head -n 40 | sed 's/^/    /'
            echo "    (exit status $status; all of it in $log)"
        fi
        grep -E '^(not )?ok .*# *SKIP' "$log" | sed -E 's/^(not )?ok [0-9]+ -? */    skipped: /'
    )
    printf '%s\n' "$text"
    echo "$ok $bad $skip" >"$log.counts"
    exit 0
fi

# ---- all of them
objects=$1
shift
export TEST_MODE="${TEST_MODE:-rel}"
export KINESCOPE="$PWD/$objects/kinescope" CMOCKA_MESSAGE_OUTPUT=TAP
export TEST_OUT="$PWD/$objects/test-out"
# Memory that GL drivers keep is not ours; no lines about it, either: tests compare what is printed.
export LSAN_OPTIONS="suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
jobs=${TEST_JOBS:-$(nproc 2>/dev/null || echo 2)}
rm -rf "$TEST_OUT"
mkdir -p "$TEST_OUT"
for test in "$@"; do
    [ "$test" = -- ] && continue
    case "$test" in *"${TEST_ONLY:-}"*) ;; *) continue ;; esac
    case "$test" in
    *test_window* | *terminal*) echo "$test" >>"$TEST_OUT/alone" ;;
    *) echo "$test" >>"$TEST_OUT/together" ;;
    esac
done
for list in together alone; do
    [ -s "$TEST_OUT/$list" ] || continue
    [ $list = alone ] && jobs=1
    tr '\n' '\0' <"$TEST_OUT/$list" | xargs -0 -n 1 -P "$jobs" sh tests/run.sh --one
done
passed=0 failed=0 skipped=0
for test in $(cat "$TEST_OUT/together" "$TEST_OUT/alone" 2>/dev/null); do
    counts="$TEST_OUT/$(basename "$test").log.counts"
    if [ -s "$counts" ]; then
        read -r ok bad skip <"$counts"
    else # its runner was killed
        ok=0 bad=1 skip=0
    fi
    passed=$((passed + ok)) failed=$((failed + bad)) skipped=$((skipped + skip))
done
echo
if [ $skipped -gt 0 ]; then
    echo "$passed passed, $failed failed, $skipped skipped"
else
    echo "$passed passed, $failed failed"
fi
[ $failed -eq 0 ] && [ $passed -gt 0 ]
