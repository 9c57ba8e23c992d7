# segments.awk — reads stores to display memory and words fetched from it, in order of time, and
# tells whether each refresh drew each segment wholly old or wholly new (roms/stage/segments.h).
#
#   TIME store ADDRESS      TIME fetch ADDRESS WORD      (octal)
#
# Segments lie from `low` on. The display processor enters one at its first word, which sets
# intensity, pen, blink and line type at once as no other word does, and leaves it by the jump that
# ends it. In the meantime none of its words may be stored, but the jump's address may.
# Prints "refreshes R, segments drawn N, stores S, torn T, entered elsewhere E".
function octal(text,    n, i) {
    for (i = 1; i <= length(text); i++)
        n = n * 8 + substr(text, i, 1)
    return n
}
function leave(    i) {
    for (i = 0; i < stored; i++)
        if (at[i] >= first && at[i] < last)
            bad = 1
    torn += bad
    stored = bad = first = 0
}
BEGIN { refreshes = drawn = stores = torn = elsewhere = stored = first = 0 }
$2 == "fetch" {
    address = octal($3)
    if (address == 0)
        refreshes++
    if (address < low)
        next
    if (!first) {
        first = address
        drawn++
        if ($4 !~ /^11[67][1357][2367][4567]$/)
            elsewhere++
    }
    last = address
    if (jumps) # this was where to
        leave()
    jumps = !jumps && $4 == "160000"
}
$2 == "store" {
    address = octal($3)
    if (address >= low)
        stores++
    if (first)
        at[stored++] = address
}
END {
    print "refreshes " refreshes ", segments drawn " drawn ", stores " stores ", torn " torn \
        ", entered elsewhere " elsewhere
}
