#!/bin/sh
# The disassembler against objdump: every instruction with many operands, and every CSR that has a name.
set -u
# shellcheck source=tests/support/tap.sh
. tests/support/tap.sh
work=$TEST_OUT/rv_disasm
mkdir -p "$work"
objdump=riscv64-unknown-elf-objdump
if ! command -v $objdump >/dev/null; then
    echo "ok 1 - every instruction as objdump writes it # SKIP $objdump is not installed"
    echo "ok 2 - every CSR as objdump writes it # SKIP $objdump is not installed"
    echo "1..2"
    exit 0
fi
${CC:-gcc} -std=c11 -I. -o "$work/words" tests/cpu/disasm_words.c emu/cpu/rv_disasm*.c \
    emu/cpu/rv_names.c >"$work/said" 2>&1 || {
    report 1 "the tool that writes words builds"
    exit 1
}

# "WORD mnemonic operands". Comments go. binutils before 2.41 leave the "i" of some mnemonics out when the
# last operand is a number, and write "zero," for the rd that nothing reads.
by_objdump() { # WORDS
    $objdump -D -b binary -m riscv:rv32 --adjust-vma=0x80000000 "$1" | sed -nE '
        s/^[0-9a-f]+:[ \t]+([0-9a-f]{8})[ \t]+/\1 /
        t instruction
        d
        :instruction
        s/[ \t]*#.*//
        s/[ \t]+$//
        s/\t/ /
        s/ \.4byte / .word /
        s/^(.{8} (add|and|or|xor|sll|srl|sra)) (.*,-?[0-9][^,]*)$/\1i \3/
        s/^(.{8} (csrr?[wsc])) (.*,[0-9]+)$/\1i \3/
        s/^(.{8} fs(rm|flags)i) zero,/\1 /
        p'
}

# A CSR without a name here belongs to a mode or extension that this processor has not; objdump may know it.
unnamed='^.{8} csr[a-z]+ (.*,)?0x'

compare() { # WORDS-FILE: leaves the differences in "said"
    "$work/words" text 0x80000000 <"$1" | grep -vE "$unnamed" >"$1.ours"
    by_objdump "$1" >"$1.all"
    cut -d' ' -f1 "$1.ours" | sort -u >"$1.named"
    # Words that occur twice are the same instruction twice, except where the address shows.
    awk 'NR == FNR { named[$1]; next } $1 in named' "$1.named" "$1.all" >"$1.theirs"
    diff "$1.ours" "$1.theirs" >"$work/diff"
    status=$?
    { wc -l "$1.ours"; head -n 40 "$work/diff"; } >"$work/said"
    [ $status -eq 0 ] && [ "$(wc -l <"$1.ours")" -ge "$2" ]
}

"$work/words" instructions 400 "${SEED:-1}" >"$work/instructions"
compare "$work/instructions" 31000
report $? "every instruction with 400 choices of operands as objdump writes it"
"$work/words" csrs >"$work/csrs"
compare "$work/csrs" 180
report $? "every CSR as objdump writes it"
echo "1..$number"
exit $failed
