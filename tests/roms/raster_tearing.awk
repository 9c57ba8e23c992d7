# raster_tearing.awk — reads, in order of time, stores into the refresh buffer, rows of the picture and
# what is taken at retrace, and tells whether a moving picture tears.
#
#   TIME store ADDRESS      TIME row N begins      TIME retrace base=B pitch=P format=F
#
# ADDRESS and B are hexadecimal.
# A page has `size` bytes, 768 rows of 1024 unless told. A field is torn when both a row that the beam
# has passed and one that it has not reached are changed in the shown page while it is on its way.
function hex(text,    n, i) {
    for (i = 1; i <= length(text); i++)
        n = n * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
    return n
}
function ends() {
    if (behind && before)
        torn++
    behind = before = 0
}
BEGIN {
    if (!rows)
        rows = 768
    if (!size)
        size = 1024 * 768
    base = -1
    row = -1
    torn = into = stores = fields = turns = pages = 0
}
$2 == "retrace" {
    ends()
    fields++
    split($3, part, "=")
    part[2] = hex(part[2])
    if (base >= 0 && part[2] != base)
        turns++
    base = part[2]
    split($4, part, "=")
    pitch = part[2]
    if (!((base) in seen))
        pages++
    seen[base] = 1
    row = -1
}
$2 == "row" { row = $3 }
$2 == "store" {
    address = hex($3)
    stores++
    if (base < 0 || address < base || address >= base + size)
        next
    into++
    if (row < 0 || row == rows - 1)
        next
    if (int((address - base) / pitch) < row)
        behind = 1
    else if (int((address - base) / pitch) > row)
        before = 1
}
END {
    ends()
    print "fields " fields ", pages " pages ", turns " turns ", stores " stores \
        ", into the shown page " into ", torn " torn
}
