#!/bin/sh
# Every lesson: it is left by q, takes any keys in any order, and shows after two seconds what was looked at
# and judged right: the refresh buffer's hash and the display file's, word by word, stand in
# tests/golden/lessons.txt (make golden writes it anew). Needs $KINESCOPE and $TEST_OUT; prints TAP.
# Lessons with a depth buffer also on a monitor that has more pixels than it.
# --regenerate FILE writes that file.
set -u
work=$TEST_OUT/lessons
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

printf 'lessons\n' | "$KINESCOPE" run --headless --console --for 5s 2>/dev/null | tr -d '\r' |
    sed -n 's/^  \([a-z0-9-]*\) .*/\1/p' >"$work/names"

shown() { # LESSON: its name, the buffer's hash, the words' hash
    printf '%s %s ' "$1" "$("$KINESCOPE" capture --type "lesson $1\n" --at 2s --buffer --hash 2>"$work/said")"
    "$KINESCOPE" trace roms/monitor.elf --type "lesson $1\n" --what dpu --from 2s --for 50ms 2>>"$work/said" |
        sed 's/^dpu [0-9]* //' | sha256sum | cut -c1-64
}
if [ "${1:-}" = --regenerate ]; then
    while read -r name; do shown "$name"; done <"$work/names" >"$2"
    exit 0
fi

[ "$(wc -l <"$work/names")" -ge 19 ]
report $? "the lessons are listed"
while read -r name; do
    shown "$name" >"$work/$name.shown"
    grep -qxF -f "$work/$name.shown" tests/golden/lessons.txt
    report $? "$name: it shows what was judged right"
    # Keys from a fixed seed, cursor keys among them, without those that leave.
    awk -v name="$name" 'BEGIN {
        srand(length(name)); printf "lesson %s\r", name
        for (i = 0; i < 150; i++) {
            c = int(rand() * 100) + 32
            if (c > 126) printf "\033[%c", 65 + (c - 127) % 4
            else if (c != 113) printf "%c", c
        }
        printf "qquit 9\r" }' >"$work/$name.keys"
    timeout 200 "$KINESCOPE" run --headless --console --for 200s <"$work/$name.keys" >"$work/out" 2>"$work/said"
    [ $? -eq 9 ]
    report $? "$name: any keys, then q leaves it"
done <"$work/names"
# A monitor that cannot follow the lessons' mode, and stays at one with more pixels than the depth buffer.
cat >"$work/large.ini" <<'EOF'
[tube LARGE]
like = GRILLE17
mode = 1800x1350
h_min = 60
h_max = 130
clock_max = 400
EOF
for name in solids surfaces shading visual cad; do
    printf 'lesson %s\r1234567 n n n +qquit 9\r' "$name" | timeout 200 "$KINESCOPE" run --tubes "$work/large.ini" \
        --tube LARGE --headless --console --for 100s >"$work/out" 2>"$work/said"
    [ $? -eq 9 ]
    report $? "$name: too many pixels for the depth buffer: it is left by q"
done
echo "1..$number"
exit $failed
