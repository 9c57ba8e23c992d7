#!/bin/sh
# The lessons of the flicker laboratory (roms/laboratory/): every one runs, what it expects of its figures holds, and
# the page of all of them needs nothing but itself. Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. tests/support/tap.sh
work=$TEST_OUT/laboratory
rm -rf "$work"
mkdir -p "$work"

"$KINESCOPE" lesson >"$work/list" 2>"$work/said" </dev/null
report $? "lesson lists the lessons"
ls roms/laboratory/*.lesson >"$work/files"
[ "$(grep -c '^  [a-z0-9-]* ' "$work/list")" -eq "$(wc -l <"$work/files")" ] && [ "$(wc -l <"$work/files")" -ge 13 ]
report $? "every file is a lesson of the list"

"$KINESCOPE" lesson all -o "$work/all" >"$work/said" 2>&1 </dev/null
report $? "all lessons run, and all that they expect holds"
page=$work/all/index.html
grep -o '13 lessons\|[0-9]* expectations hold' "$work/said" >"$work/counts"
grep -q 'expectations hold' "$work/counts"
report $? "expectations were checked"
[ "$(grep -o 'src="[^"]*"' "$page" | grep -vc '^src="data:image/png;base64,')" -eq 0 ] &&
    ! grep -q 'href="[^#"]' "$page"
report $? "the page holds all its pictures and leads nowhere else"
[ "$(grep -o '<img ' "$page" | wc -l)" -gt 60 ] && [ "$(grep -o '<img [^>]*alt="[^"]\{5,\}' "$page" | wc -l)" -eq "$(grep -o '<img ' "$page" | wc -l)" ]
report $? "every picture has words for those who cannot see it"
[ "$(wc -c <"$page")" -lt 15000000 ]
report $? "the page is below 15 MB"
echo "1..$number"
exit $failed
