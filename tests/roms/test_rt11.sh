#!/bin/sh
# Display subroutines by firmware (roms/rt11): what they draw, how deep they go, when a refresh begins,
# and what is said of a file that goes wrong. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/rt11
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh
cp roms/rt11.inc "$work/"

# A program from standard input, after what all of them begin with.
program() { # NAME
    { printf '        .include "rt11.inc"\n        .firmware "rt11"\n'; cat; } >"$work/$1.df"
}
trace() { # NAME OPTIONS...
    name=$1
    shift
    "$KINESCOPE" trace "$work/$name.df" --firmware roms/rt11.elf "$@" 2>"$work/said"
}
# Addresses fetched below the firmware's own words, in order, in one line.
path() { # NAME FOR
    trace "$1" --what dpu --for "$2" | sed -n 's/^dpu [0-9]* DPC=\([0-7]*\) .*/\1/p' |
        grep -v '^1777' | tr '\n' ' '
}
# When the words at an address are fetched, ps, one a line.
fetched() { # NAME ADDRESS FOR
    trace "$1" --what dpu --for "$3" | sed -n "s/^dpu \([0-9]*\) DPC=$2 .*/\1/p"
}

# ---- the picture of the village is that of its words without calls --------------------------------
strokes() { # FILE FOR
    "$KINESCOPE" trace "$1" --what beam --for "$2" --tube VR17 2>"$work/said" |
        sed -n 's/^s [0-9]* [0-9]* \(.*\) [0-7]*$/\1/p'
}
"$KINESCOPE" asm roms/village.df -o "$work/village.oct" 2>"$work/said"
awk -f tests/roms/flatten.awk "$work/village.oct" >"$work/flat.oct"
strokes roms/village.df 33ms >"$work/called"  # it begins at the first tick
strokes "$work/flat.oct" 16ms >"$work/flat"
[ "$(wc -l <"$work/flat")" -gt 2000 ]
report $? "the village has more than 2000 strokes"
cmp "$work/called" "$work/flat" >"$work/said" 2>&1
report $? "the village drawn by subroutines is the village without them"

# ---- where calls, names and returns lead -----------------------------------------------------------
program calls <<'END'
start:  point                   ; 000000
        djsr    inner           ; 000002: stop word; the others are read by the firmware
        nop                     ; 000010
        dname   5               ; 000012
        dstat                   ; 000016
        djsr    outer           ; 000020
        dret                    ; 000026
        .org    0o100
outer:  dstat                   ; 000100
        djsr    inner           ; 000102
        nop                     ; 000110
        dret                    ; 000112
        .org    0o200
inner:  nop                     ; 000200
        dret                    ; 000202
END
[ "$(path calls 33ms)" = "000000 000002 000200 000202 000010 000012 000016 000020 000100 000102 000200 000202 \
000110 000112 000026 " ]
report $? "calls, names and returns lead where they should"

# The status buffer, as the processor stores it: name, subroutine, DPC; X and Y are 0.
trace calls --what cpu --from 16ms --for 17ms | sed -n 's/.* sh .* \[8.*\]=\(....\)$/\1/p' | tr '\n' ' ' \
    >"$work/said"
grep -q '0005 0000 0010 .... 0000 0000 0001 ' "$work/said"
report $? "a status word tells name 5, no subroutine, DPC 20 octal"
grep -q '0005 0040 0042 .... 0000 0000 0001 ' "$work/said"
report $? "another one tells the subroutine it is in"

# ---- ten deep, and no deeper -------------------------------------------------------------------------
deep() { # NAME LEVELS
    program "$1" <<END
        djsr    1000
        dret
        .repeat $2 - 1, K
        .org    1000 + 20*K
        djsr    1000 + 20*(K + 1)
        dret
        .endr
        .org    1000 + 20*($2 - 1)
        nop
        dret
END
}
deep ten 10
trace ten --what dpu --for 60ms | grep -c 'WORD=164000' >"$work/said"
[ "$(cat "$work/said")" = 3 ]
report $? "ten levels are drawn at each tick"
deep eleven 11
"$KINESCOPE" run "$work/eleven.df" --firmware roms/rt11.elf --headless --console --for 1s \
    >"$work/said" 2>&1 </dev/null
[ $? = 1 ] && grep -q 'more than ten deep, at 002234' "$work/said"
report $? "an eleventh ends the program, with the place"

# ---- when a refresh begins ---------------------------------------------------------------------------
program plain <<'END'
        nop
        dret
END
fetched plain 000000 100ms >"$work/said"
awk 'NR > 1 && $1 - before > 16700000000 { bad = 1 } NR > 1 && $1 - before < 16600000000 { bad = 1 }
     { before = $1 } END { exit bad || NR != 5 }' "$work/said"
report $? "a refresh begins at each tick"
program waits <<'END'
        sync
        nop
        dret
END
fetched waits 000002 100ms >"$work/said" # the word after the one that waits
awk '{ tick = int(($1 + 1000) * 60 / 1e12); late = $1 - tick * 1e12 / 60; if (late > 2000000) bad = 1 }
     END { exit bad || NR != 5 }' "$work/said"
report $? "a file that waits for the tick itself does not wait twice"
# Two ticks long: it misses one, and waits for the next.
program long <<'END'
        point
        at      0, 0
        longv
        .repeat 100
        draw    1000, 0, -1000, 0
        .endr
        dret
END
fetched long 000000 200ms >"$work/said"
awk 'NR > 1 && ($1 - before < 33300000000 || $1 - before > 33400000000) { bad = 1 } { before = $1 }
     END { exit bad || NR < 4 }' "$work/said"
report $? "one that takes longer than a tick gets every second one"

# ---- what goes wrong ----------------------------------------------------------------------------------
says() { # NAME PATTERN
    "$KINESCOPE" run "$work/$1.df" --firmware roms/rt11.elf --headless --console --for 1s \
        >"$work/said" 2>&1 </dev/null
    [ $? = 1 ] && grep -q "$2" "$work/said"
    report $? "$1: $2"
}
program unknown <<'END'
        nop
        .word   0o173440
END
says unknown 'asks for nothing that is known, at 000002'
program crowded <<'END'
        .start  go
        .org    0o177770
        nop
        .org    0o1000
go:     dret
END
says crowded 'needs room for its own, at 177770'
program halts <<'END'
        point
        plot    500, 500
        dhalt
END
[ "$(path halts 200ms)" = "000000 000002 000004 000006 " ]
report $? "after a halt nothing is fetched"
"$KINESCOPE" run "$work/halts.df" --firmware roms/rt11.elf --headless --console --for 100ms \
    >"$work/said" 2>&1 </dev/null
grep -q 'has halted the display' "$work/said"
report $? "the console tells of a halt"
"$KINESCOPE" run roms/rt11.elf --headless --console --for 1s >"$work/said" 2>&1 </dev/null
[ $? = 1 ] && grep -q 'no display file to serve' "$work/said"
report $? "without a display file it says so"
echo "1..$number"
exit $failed
