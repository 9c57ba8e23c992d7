#!/bin/sh
# run.sh OBJECTS TEST-BINARY... -- SHELL-TEST... — runs every test and counts.
#
# Test binaries and shell tests print TAP ("ok 1 - name", "not ok 2 - name", "ok 3 - name # SKIP why").
# Ends with "N passed, N failed, N skipped" alone on a line; exit status 1 when anything failed.
# TEST_ONLY=pattern runs only the files whose path matches. TEST_MODE (rel, dbg, asan, tsan, cov) is told
# to the tests: what compares bytes or speeds and would take long may skip itself in a sanitizer mode.
set -u
objects=$1
shift
export TEST_MODE="${TEST_MODE:-rel}"
export KINESCOPE="$PWD/$objects/kinescope" CMOCKA_MESSAGE_OUTPUT=TAP
export TEST_OUT="$PWD/$objects/test-out"
# Memory that GL drivers keep is not ours; no lines about it, either: tests compare what is printed.
export LSAN_OPTIONS="suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
rm -rf "$TEST_OUT"
mkdir -p "$TEST_OUT"
passed=0 failed=0 skipped=0
kind=binary
for test in "$@"; do
    if [ "$test" = -- ]; then
        kind=shell
        continue
    fi
    case "$test" in *"${TEST_ONLY:-}"*) ;; *) continue ;; esac
    name=$(basename "$test" .sh)
    log="$TEST_OUT/$(basename "$test").log" # test_window.c and test_window.sh have one each
    start=$(date +%s)
    if [ $kind = shell ]; then sh "$test" >"$log" 2>&1; else "$test" >"$log" 2>&1; fi
    status=$?
    # cmocka marks what it skips "not ok N # SKIP name".
    skip=$(grep -cE '^(not )?ok .*# *SKIP' "$log")
    ok=$(grep -E '^ok ' "$log" | grep -cvE '# *SKIP')
    bad=$(grep -E '^not ok ' "$log" | grep -cvE '# *SKIP')
    # A test that died, or said nothing, is a failure of its own.
    if [ $status -ne 0 ] && [ "$bad" -eq 0 ]; then bad=1; fi
    if [ "$ok" -eq 0 ] && [ "$bad" -eq 0 ] && [ "$skip" -eq 0 ]; then bad=1; fi
    printf '%-32s %4d passed' "$name" "$ok"
    [ "$bad" -gt 0 ] && printf ', %d FAILED' "$bad"
    [ "$skip" -gt 0 ] && printf ', %d skipped' "$skip"
    printf '   (%d s)\n' $(($(date +%s) - start))
    if [ "$bad" -gt 0 ]; then
        grep -vE '^ok |^1\.\.' "$log" | head -n 40 | sed 's/^/    /'
        echo "    (exit status $status; all of it in $log)"
    fi
    grep -E '^(not )?ok .*# *SKIP' "$log" | sed -E 's/^(not )?ok [0-9]+ -? */    skipped: /'
    passed=$((passed + ok)) failed=$((failed + bad)) skipped=$((skipped + skip))
done
echo
if [ $skipped -gt 0 ]; then
    echo "$passed passed, $failed failed, $skipped skipped"
else
    echo "$passed passed, $failed failed"
fi
[ $failed -eq 0 ] && [ $passed -gt 0 ]
