# flatten.awk — an .oct list of words with RT-11's display subroutines, as one without: the words in the
# order in which they are drawn, to the outermost return. Knows nothing of the firmware that does it.
function octal(text,    n, i) {
    n = 0
    for (i = 1; i <= length(text); i++)
        n = n * 8 + substr(text, i, 1)
    return n
}
{ sub(/;.*/, ""); gsub(/[ \t]/, "") }
/^@/ { at = octal(substr($0, 2)); next }
/^=/ { pc = octal(substr($0, 2)); given = 1; next }
/^[0-7]/ {
    if (lowest == "")
        lowest = at
    word[at] = $0
    at += 2
}
END {
    call = "173400"; status = "173420"; name = "173520"; jump = "160000"
    if (!given)
        pc = lowest
    depth = 0
    for (count = 0; count < 30000; count++) {
        w = word[pc]
        if (w == call && octal(word[pc + 2]) != 0) {
            back[depth++] = octal(word[pc + 2])
            pc = octal(word[pc + 4])
        } else if (w == call) {
            if (depth == 0)
                break
            pc = back[--depth]
        } else if (w == name) {
            pc += 4
        } else if (w == status) {
            pc += 2
        } else if (w == jump) {
            pc = octal(word[pc + 2])
        } else {
            print w
            pc += 2
        }
    }
    print "172000" # and stop
}
