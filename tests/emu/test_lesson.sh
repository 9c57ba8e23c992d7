#!/bin/sh
# kinescope lesson: a small lesson of the test's own is run; its page needs nothing but itself; what does not hold or
# fails is told; same bytes twice. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. "$(dirname "$0")/../support/tap.sh"
work=$TEST_OUT/lesson
rm -rf "$work"
mkdir -p "$work/mine"
kinescope=$KINESCOPE

says() { # NAME PATTERN
    grep -q -e "$2" "$work/said"
    report $? "$1"
}

# ends NAME STATUS ARGUMENTS...: lesson ends with that; what it said is in said.
ends() {
    name=$1 status=$2
    shift 2
    "$kinescope" lesson "$@" >"$work/said" 2>&1 </dev/null
    [ $? -eq "$status" ]
    report $? "$name"
}

cat >"$work/mine/line.df" <<'END'
        .tube   "VR17/P31"
        .start  line
line:   point   i=7 pen=off blink=off line=solid
        at      480, 512
        longv
        draw    64, 0
        sync    stop
END
cat >"$work/mine/small.lesson" <<'END'
title A <small> lesson
summary Of a line & a table
order 1
text The line rate is {rate.refresh_hz:.2} Hz and `a < b`.
item one
item two
step shown A line
picture capture line.df --film --allow-dark
caption A "line"
picture capture line.df --closeup 512,512,9 --size 64x48 -o near.png
live run line.df
flashes never, in truth
step rate A calculation
table calc refresh --line-rate 31.5kHz --lines 480
says refresh
figures calc refresh --line-rate 31.5kHz --lines 480 --json
expect refresh_hz 62..63 by hand: 31500/480*0.95
notes it is {refresh_hz:3}
table measure resolution --tube VR17 --csv
END
lesson=$work/mine/small.lesson

ends "the list" 0
says "has the lessons that come along" '^  persistence '
ends "a lesson as text" 0 persistence
says "with the commands to type" '^    kinescope probe .* -o p31.png$'
says "with the warning" 'Photosensitivity warning'
ends "a lesson that is not there" 2 persistance
says "a suggestion" 'did you mean persistence?'
ends "no folder for the list" 2 list -o "$work/x"
ends "a file that is not there" 1 ./none.lesson
printf 'title T\ntitel U\n' >"$work/bad.lesson"
ends "a mistake" 1 "$work/bad.lesson"
says "has file and line" 'bad.lesson:2: .*did you mean title?'

ends "a lesson of one's own runs" 0 "$lesson" -o "$work/a"
says "what holds is counted" 'small.html: 1 lesson, 2 expectations hold'
(cd "$work/mine" && "$kinescope" lesson small.lesson -o ../b) >"$work/said" 2>&1
report $? "also from where it lies"
diff -r "$work/a" "$work/b" >"$work/said" 2>&1
report $? "the same bytes, wherever"

page=$work/a/small.html
ls "$work/a/small" >"$work/said"
[ "$(tr '\n' ' ' <"$work/said")" = "near.png rate.csv rate.txt shown.png small.txt " ]
report $? "files are named after steps, or as the command says"
sed 's/base64,[^"]*/base64,/' "$page" >"$work/said"
[ "$(grep -c '<img ' "$work/said")" -eq 2 ] &&
    ! grep -q -e 'https\?:' -e 'src="[^d]' -e 'url(' -e '@import' -e '<link' "$work/said" &&
    ! grep -q "$work" "$work/said"
report $? "the page needs nothing but itself"
says "pictures have their caption for those who cannot see" 'width="64" height="48" alt="A line"'
says "a quotation mark in it is escaped" 'alt="A &quot;line&quot;"'
says "as is the title" '<h1>A &lt;small&gt; lesson</h1>'
says "figures are filled in" 'The line rate is 62.34 Hz and <code>a &lt; b</code>'
says "what was measured is told" 'measured 62.34</td><td>expected 62 to 63</td><td class="good">✓ holds'
says "CSV becomes a table" '<th scope="col">lp_per_mm</th>'
sed 's/<[^>]*>//g' "$page" | grep -q '^kinescope capture line.df --film --allow-dark -o shown.png$'
report $? "the command can be copied"
for i in 1 2; do
    grep -o 'base64,[^"]*' "$page" | sed -n "${i}s/base64,//p" | base64 -d >"$work/$i.png"
done
cmp "$work/1.png" "$work/a/small/shown.png" >"$work/said" 2>&1 &&
    cmp "$work/2.png" "$work/a/small/near.png" >>"$work/said" 2>&1
report $? "the pictures in it are those in the folder"
grep -q 'holds$' "$work/a/small/small.txt" && grep -q 'makes small/near.png' "$work/a/small/small.txt"
report $? "the text has it, too"

ends "without flashes, for a projector" 0 "$lesson" -o "$work/calm" --no-flash --projector
grep -q 'Not shown live' "$work/calm/small.html" && ! grep -q 'kinescope run' "$work/calm/small.html" &&
    ! grep -q 'warning' "$work/calm/small.html" && grep -q 'font:30px' "$work/calm/small.html"
report $? "nothing live that flashes, large type"

sed 's/62\.\.63/63..64/' "$lesson" >"$work/mine/false.lesson"
ends "what does not hold fails" 1 "$work/mine/false.lesson" -o "$work/c"
says "it names line, step and figures" 'false.lesson:[0-9]*: step rate: refresh_hz is 62.34375, expected 63 to 64$'
grep -q '✗ does not hold' "$work/c/false.html"
report $? "the page shows it"
sed 's/says refresh/says nonsense/' "$lesson" >"$work/mine/mute.lesson"
ends "what is not said fails" 1 "$work/mine/mute.lesson" -o "$work/d"
grep -q 'it does not say so</td><td>expected the words nonsense</td><td class="bad">✗' "$work/d/mute.html"
report $? "the page shows that, too"
says "it names the words" "step rate: its command does not say 'nonsense'"
sed 's/capture line.df --film/capture missing.df --film/; s/--lines 480$/--lines -1/' "$lesson" >"$work/mine/trouble.lesson"
ends "a command that fails" 1 "$work/mine/trouble.lesson" -o "$work/e"
says "is told with its line and sentence" 'trouble.lesson:8: capture: .*missing.df'
says "and the next one, too" 'trouble.lesson:14: calc: '
[ ! -e "$work/e/trouble.html" ]
report $? "there is no page then"
says "and that there is no page" 'e/trouble.html is not written because of that$'
sed 's/--lines 480 --json/--lines 480/; s/^notes.*/notes {nothing}/' "$lesson" >"$work/mine/small2.lesson"
ends "figures that are not there" 1 "$work/mine/small2.lesson" -o "$work/f"
says "a command without figures is told, with its place once" '^kinescope lesson: [^:]*small2.lesson:16: the command prints no JSON'
sed 's/^notes.*/notes {nothing} {none}/; s/^expect.*/expect lost 1..2/' "$lesson" >"$work/mine/small3.lesson"
mkdir "$work/g"
echo old >"$work/g/small3.html"
ends "quoted or expected" 1 "$work/mine/small3.lesson" -o "$work/g"
[ "$(grep -c "no figure 'lost'" "$work/said")" -eq 1 ] && [ "$(grep -c "no figure 'nothing'" "$work/said")" -eq 1 ]
report $? "are told once, all of them"
says "the page of before is called old" 'is not written because of that; the one that is there is of an earlier run'
[ "$(cat "$work/g/small3.html")" = old ]
report $? "and stays"

cat >"$work/mine/My_Long.lesson" <<'END'
title T
summary S
order 1
step a A
picture capture line.df --at 3600s --size 4000x4000 --threads 1
END
ends "a command that takes too long" 1 "$work/mine/My_Long.lesson" -o "$work/h" --limit 1
says "is ended" 'My_Long.lesson:5: the command was ended, as it took longer than 1 s'
"$kinescope" lesson "$work/mine/My_Long.lesson" -o "$work/h" >"$work/said" 2>&1 </dev/null &
lesson_pid=$!
sleep 0.3
children=$(cat "/proc/$lesson_pid/task/$lesson_pid/children" 2>/dev/null)
kill -TERM $lesson_pid
wait $lesson_pid 2>/dev/null
sleep 0.2
left=0
for child in $children; do
    grep -q '^State:.*[ZX]' "/proc/$child/status" 2>/dev/null || [ ! -e "/proc/$child" ] || left=1
done
[ -n "$children" ] && [ $left -eq 0 ] && [ -z "$(ls "$work/h/my-long")" ]
report $? "ended from outside, it leaves no command and no file behind"
(trap '' CHLD && "$kinescope" lesson "$lesson" -o "$work/i") >"$work/said" 2>&1 </dev/null
report $? "a caller that ignores its children does no harm"
echo text >"$work/file"
ends "a file in place of the folder" 1 "$lesson" -o "$work/file"
says "is no folder" 'file is no folder'
mkdir -p "$work/j/small.html"
ends "a page that cannot be written" 1 "$lesson" -o "$work/j"
[ ! -e "$work/j/small/shown.png" ]
report $? "is told before anything is run"
ends "a folder that cannot be made" 1 "$lesson" -o "$work/none/none"

guide=$(dirname "$0")/../../roms/laboratory/LESSONS.md
sed -n '/^    # growing/,/^## /{/^## /d;s/^    //;p;}' "$guide" >"$work/growing.lesson"
ends "the example of the guide holds" 0 "$work/growing.lesson" -o "$work/guide"
says "what it expects" '1 lesson, 2 expectations hold'

mkdir -p "$work/roms/laboratory"
for n in 1 2; do
    sed "s/^order.*/order $((9 - n))/; s/^title.*/title Number $n/" "$lesson" >"$work/roms/laboratory/n$n.lesson"
done
cp "$work/mine/line.df" "$work/roms/laboratory"
ends "all lessons of a folder" 0 all -o "$work/all" --roms "$work/roms"
says "on one page" 'all/index.html: 2 lessons, 4 expectations hold'
grep -n '<h2>Number' "$work/all/index.html" | head -n 1 >"$work/said"
says "in their order" 'Number 2'

echo "1..$number"
exit $failed
