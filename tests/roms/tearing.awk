# tearing.awk — reads stores to display memory and words fetched from it, in order of time, and tells
# whether a moving picture tears: a store into the part that the display processor is going through.
#
#   store TIME ADDRESS     fetch TIME ADDRESS     (octal addresses)
#
# A picture is `still` bytes that stay, then two parts of `moving` bytes each (roms/bsp/flip.h); what is
# stored before the first fetch makes it. Prints "refreshes R, shown A B, torn T".
function octal(text,    n, i) {
    n = 0
    for (i = 1; i <= length(text); i++)
        n = n * 8 + substr(text, i, 1)
    return n
}
function part(address) {
    return address < still ? -1 : int((address - still) / moving)
}
BEGIN { still = 16384; moving = 8192; shown[0] = shown[1] = torn = refreshes = 0; in_part = -1 }
$1 == "fetch" {
    address = octal($3)
    if (address == 0)
        refreshes++
    p = part(address)
    if (p >= 0 && p != in_part) {
        shown[p]++
        if (address != still + p * moving)
            torn++ # entered elsewhere than at its beginning
    }
    in_part = p
}
$1 == "store" {
    p = part(octal($3))
    if (refreshes > 0 && p >= 0 && p == in_part)
        torn++
    # Of what stays, the jump's address may change: one word.
    if (refreshes > 0 && p < 0 && patched != "" && $3 != patched)
        torn++
    if (refreshes > 0 && p < 0)
        patched = $3
}
END { print "refreshes " refreshes ", shown " shown[0] " " shown[1] ", torn " torn }
