#!/bin/sh
# Time as textbooks count it and as the VR17's row has it, through the command.
set -u
work=$TEST_OUT/course_notes
mkdir -p "$work"
n=0
check() { # NAME COMMAND...
    name=$1
    shift
    n=$((n + 1))
    if "$@"; then echo "ok $n - $name"; else echo "not ok $n - $name"; fi
}
# The time, in ps, at which the words at an address are fetched, one a line.
fetches() { # TRACE ADDRESS
    sed -n "s/^dpu \([0-9]*\) DPC=$2 .*/\1/p" "$1"
}

# ---- 1000 instructions of 33.33 us each: how often is the picture refreshed? ---------------------
# 2 modes, 1 point, 996 vectors of two words each, 1 jump: 1000 instructions, 1998 words. It does not
# wait for a tick, so one refresh follows the other.
cat >"$work/thousand.df" <<'END'
        .start  again
again:  point   i=4
        at      24, 24
        longv
        .repeat 498
        draw    900, 900, -900, -900
        .endr
        jump    again
END
average=dpu.average=33.33us
"$KINESCOPE" trace "$work/thousand.df" --set $average --summary >"$work/summary"
check "1000 instructions a refresh" grep -qE '^ *instructions +1000 a refresh$' "$work/summary"
check "in 1998 words" grep -qE '^ *words +1998 a refresh$' "$work/summary"
check "take 33.33 ms" grep -qE '^ *refresh time +33\.33 ms' "$work/summary"
check "which is 30 refreshes a second" grep -qE '^ *refresh rate +30 Hz' "$work/summary"
# The same from the events: the entry is fetched at 0 and then every 33.33 ms, 30 times within a second.
"$KINESCOPE" trace "$work/thousand.df" --set $average --for 1s >"$work/trace"
fetches "$work/trace" 000000 >"$work/refreshes"
i=0
while [ $i -le 30 ]; do echo $((i * 33330000000)) && i=$((i + 1)); done >"$work/expected"
check "a refresh begins every 33.33 ms, 30 are complete in a second" cmp -s "$work/refreshes" "$work/expected"
# Without it the same file takes what its vectors take: a long one is slower than a short one.
"$KINESCOPE" trace "$work/thousand.df" --tube VR17 --summary >"$work/summary"
# 1998 fetches of 1.5, 24 units to settle in 1.432, 996 vectors of 2 + 900 * 0.1 us: 94.63 ms.
check "by the tube's times they take 94.63 ms" grep -qE '^ *refresh time +94\.63 ms' "$work/summary"

# ---- a mixed file, each time worked out by hand from the VR17's row -------------------------------
cat >"$work/mixed.df" <<'END'
        .start  go
go:     point   i=4                 ; 000000
        plot    100, 50             ; 000002
        longv                       ; 000006
        draw    300, 200            ; 000010
        move    -100, -200          ; 000014
        shortv                      ; 000020
        draw    10, -20             ; 000022
        char                        ; 000024
        text    "AB"                ; 000026
        text    "\r\n"              ; 000030
        text    " ", 0              ; 000032
        step    5                   ; 000034
        graphy                      ; 000036
        value   6                   ; 000040
        relpoint                    ; 000042
        draw    3, 4                ; 000044
        move    -8, -10             ; 000046
        nop                         ; 000050
        jump    last                ; 000052
        .org    0o100
last:   status  italics=off         ; 000100
        stop                        ; 000102
END
cat >"$work/hand" <<'END'
000000 0 set mode: fetch 1.5
000002 1500000 first word: fetch 1.5
000004 3000000 fetch 1.5, 100 units to settle 1 + 1.8, lit 1
000006 8300000
000010 9800000
000012 11300000 fetch 1.5, set-up 2, 300 units at 0.1
000014 44800000
000016 46300000 fetch 1.5, beam off over 200 units: 1 + 3.6
000020 52400000
000022 53900000 fetch 1.5, set-up 2, 20 units at 0.1
000024 59400000
000026 60900000 fetch 1.5, two characters of 15
000030 92400000 fetch 1.5, CR from x = 338 (310 + 28): 1 + 6.084; LF over 24 units: 1 + 0.432
000032 102416000 fetch 1.5, a space of 15; NUL nothing
000034 118916000
000036 120416000
000040 121916000 fetch 1.5, from (14, 6) to (19, 6), 5 units: 1 + 0.09; lit 1
000042 125506000
000044 127006000 fetch 1.5, 4 units: 1 + 0.072; lit 1
000046 130578000 fetch 1.5, 10 units: 1 + 0.18
000050 133258000
000052 134758000
000054 136258000
000100 137758000
000102 139258000 and the stop word's fetch: 140.758 us in all
END
"$KINESCOPE" trace "$work/mixed.df" --tube VR17 --what dpu --on-stop halt >"$work/mixed.trace"
sed 's/^dpu \([0-9]*\) DPC=\([0-7]*\) .*/\2 \1/' "$work/mixed.trace" >"$work/got"
cut -d' ' -f1,2 "$work/hand" >"$work/times"
check "every word of a mixed file is fetched when the hand says" diff "$work/times" "$work/got"
"$KINESCOPE" trace "$work/mixed.df" --tube VR17 --summary >"$work/summary"
check "the refresh takes 140.8 us" grep -qE '^ *refresh time +140\.8 us' "$work/summary"
# Its uncertainty: all figures at the low ends of their ranges, and all at the high ends.
#   25 words, 2 vectors of 320 units together, 7 moves over 681 units, 3 points, 3 character cells:
#   25 * 1 + 2 * 0.5 + 320 * 0.05 + 7 * 0.5 + 681 * 0.016 + 3 * 0.5 + 3 * 10 = 87.896
#   25 * 3 + 2 * 5   + 320 * 0.2  + 7 * 2   + 681 * 0.02  + 3 * 2   + 3 * 25 = 257.62
check "uncertain from 87.90 us to 257.6 us" grep -q 'uncertain: 87\.90 us to 257\.6 us' "$work/summary"
echo "1..$n"
