#!/bin/sh
# flicker.sh — flicker figures as the probe measures them on a display file that is run, against the closed
# forms: every phosphor at 30, 50, 60 and 75 Hz. A table; ends with the largest differences. Needs
# $KINESCOPE. P33 and P38 glow so long that the whole takes a minute or two.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$KINESCOPE" sweep --rates 30,50,60,75 --csv "$work/closed.csv"
printf '%-9s %5s   %-19s %-19s %-19s\n' '' '' 'C1' 'percent flicker' 'flicker index'
printf '%-9s %5s   %9s %9s %9s %9s %9s %9s\n' phosphor Hz measured closed measured closed measured closed
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    { row = $column["phosphor"] " " $column["refresh_hz"]
      if (!(row in seen)) print row, $column["c1"], $column["percent_flicker"], $column["flicker_index"]
      seen[row] = 1 }' "$work/closed.csv" |
    while read -r phosphor hz c1 percent index_; do
        "$KINESCOPE" probe roms/laboratory/flash.df --at 512,512 --phosphor "$phosphor" --refresh "$hz" \
            </dev/null >"$work/probe.json"
        sed -n 's/^ "\(c1\|percent_flicker\|flicker_index\)": \([^,]*\),*$/\2/p' "$work/probe.json" | tr '\n' ' ' |
            awk -v p="$phosphor" -v hz="$hz" -v c1="$c1" -v percent="$percent" -v fi="$index_" \
                '{ print p, hz, $1, c1, $2, percent, $3, fi }'
    done |
    awk '
        function off(i) { return $i == $(i + 1) ? 0 : ($i > $(i + 1) ? $i - $(i + 1) : $(i + 1) - $i) / $(i + 1) }
        {
            printf "%-9s %5s   %9.5f %9.5f %9.4f %9.4f %9.5f %9.5f\n", $1, $2, $3, $4, $5, $6, $7, $8
            for (k = 0; k < 3; k++)
                if (off(3 + 2 * k) > worst[k]) { worst[k] = off(3 + 2 * k); at[k] = $1 " at " $2 " Hz" }
        }
        END {
            printf "\nlargest difference: C1 %.2g %% (%s), percent flicker %.2g %% (%s), flicker index %.2g %% (%s)\n",
                100 * worst[0], at[0], 100 * worst[1], at[1], 100 * worst[2], at[2]
        }'
