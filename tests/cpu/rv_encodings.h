/* rv_encodings.h — what the words of RV32IMF, Zicsr, Zifencei and machine mode look like.
 *
 * Models:     bit 31 first: "0" and "1" must be so, "x" is any, "r" a rounding mode (0 to 4 or 7),
 *             "z" is to be 0 but not looked at by a processor.
 * Ownership:  constant.
 * Source:     typed from the tables of The RISC-V Instruction Set Manual I, chapter 24: a second
 *             opinion, nothing here comes from the decoder or the disassembler.
 */
#ifndef TESTS_RV_ENCODINGS_H
#define TESTS_RV_ENCODINGS_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static const char *const rv_encodings[] = {
    /* RV32I */
    "xxxxxxxxxxxxxxxxxxxxxxxxx0110111",
    "xxxxxxxxxxxxxxxxxxxxxxxxx0010111",
    "xxxxxxxxxxxxxxxxxxxxxxxxx1101111",
    "xxxxxxxxxxxxxxxxx000xxxxx1100111",
    "xxxxxxxxxxxxxxxxx000xxxxx1100011",
    "xxxxxxxxxxxxxxxxx001xxxxx1100011",
    "xxxxxxxxxxxxxxxxx100xxxxx1100011",
    "xxxxxxxxxxxxxxxxx101xxxxx1100011",
    "xxxxxxxxxxxxxxxxx110xxxxx1100011",
    "xxxxxxxxxxxxxxxxx111xxxxx1100011",
    "xxxxxxxxxxxxxxxxx000xxxxx0000011",
    "xxxxxxxxxxxxxxxxx001xxxxx0000011",
    "xxxxxxxxxxxxxxxxx010xxxxx0000011",
    "xxxxxxxxxxxxxxxxx100xxxxx0000011",
    "xxxxxxxxxxxxxxxxx101xxxxx0000011",
    "xxxxxxxxxxxxxxxxx000xxxxx0100011",
    "xxxxxxxxxxxxxxxxx001xxxxx0100011",
    "xxxxxxxxxxxxxxxxx010xxxxx0100011",
    "xxxxxxxxxxxxxxxxx000xxxxx0010011",
    "xxxxxxxxxxxxxxxxx010xxxxx0010011",
    "xxxxxxxxxxxxxxxxx011xxxxx0010011",
    "xxxxxxxxxxxxxxxxx100xxxxx0010011",
    "xxxxxxxxxxxxxxxxx110xxxxx0010011",
    "xxxxxxxxxxxxxxxxx111xxxxx0010011",
    "0000000xxxxxxxxxx001xxxxx0010011",
    "0000000xxxxxxxxxx101xxxxx0010011",
    "0100000xxxxxxxxxx101xxxxx0010011",
    "0000000xxxxxxxxxx000xxxxx0110011",
    "0100000xxxxxxxxxx000xxxxx0110011",
    "0000000xxxxxxxxxx001xxxxx0110011",
    "0000000xxxxxxxxxx010xxxxx0110011",
    "0000000xxxxxxxxxx011xxxxx0110011",
    "0000000xxxxxxxxxx100xxxxx0110011",
    "0000000xxxxxxxxxx101xxxxx0110011",
    "0100000xxxxxxxxxx101xxxxx0110011",
    "0000000xxxxxxxxxx110xxxxx0110011",
    "0000000xxxxxxxxxx111xxxxx0110011",
    "zzzzxxxxxxxxzzzzz000zzzzz0001111",
    "100000110011zzzzz000zzzzz0001111",
    "00000000000000000000000001110011",
    "00000000000100000000000001110011",
    /* Zifencei, Zicsr, machine mode */
    "zzzzzzzzzzzzzzzzz001zzzzz0001111",
    "xxxxxxxxxxxxxxxxx001xxxxx1110011",
    "xxxxxxxxxxxxxxxxx010xxxxx1110011",
    "xxxxxxxxxxxxxxxxx011xxxxx1110011",
    "xxxxxxxxxxxxxxxxx101xxxxx1110011",
    "xxxxxxxxxxxxxxxxx110xxxxx1110011",
    "xxxxxxxxxxxxxxxxx111xxxxx1110011",
    "00110000001000000000000001110011",
    "00010000010100000000000001110011",
    /* RV32M */
    "0000001xxxxxxxxxx000xxxxx0110011",
    "0000001xxxxxxxxxx001xxxxx0110011",
    "0000001xxxxxxxxxx010xxxxx0110011",
    "0000001xxxxxxxxxx011xxxxx0110011",
    "0000001xxxxxxxxxx100xxxxx0110011",
    "0000001xxxxxxxxxx101xxxxx0110011",
    "0000001xxxxxxxxxx110xxxxx0110011",
    "0000001xxxxxxxxxx111xxxxx0110011",
    /* RV32F */
    "xxxxxxxxxxxxxxxxx010xxxxx0000111",
    "xxxxxxxxxxxxxxxxx010xxxxx0100111",
    "xxxxx00xxxxxxxxxxrrrxxxxx1000011",
    "xxxxx00xxxxxxxxxxrrrxxxxx1000111",
    "xxxxx00xxxxxxxxxxrrrxxxxx1001011",
    "xxxxx00xxxxxxxxxxrrrxxxxx1001111",
    "0000000xxxxxxxxxxrrrxxxxx1010011",
    "0000100xxxxxxxxxxrrrxxxxx1010011",
    "0001000xxxxxxxxxxrrrxxxxx1010011",
    "0001100xxxxxxxxxxrrrxxxxx1010011",
    "010110000000xxxxxrrrxxxxx1010011",
    "0010000xxxxxxxxxx000xxxxx1010011",
    "0010000xxxxxxxxxx001xxxxx1010011",
    "0010000xxxxxxxxxx010xxxxx1010011",
    "0010100xxxxxxxxxx000xxxxx1010011",
    "0010100xxxxxxxxxx001xxxxx1010011",
    "110000000000xxxxxrrrxxxxx1010011",
    "110000000001xxxxxrrrxxxxx1010011",
    "111000000000xxxxx000xxxxx1010011",
    "1010000xxxxxxxxxx010xxxxx1010011",
    "1010000xxxxxxxxxx001xxxxx1010011",
    "1010000xxxxxxxxxx000xxxxx1010011",
    "111000000000xxxxx001xxxxx1010011",
    "110100000000xxxxxrrrxxxxx1010011",
    "110100000001xxxxxrrrxxxxx1010011",
    "111100000000xxxxx000xxxxx1010011",
};

#define RV_ENCODINGS ((int)(sizeof rv_encodings / sizeof *rv_encodings))

static inline bool rv_mode_valid(uint32_t word)
{
    uint32_t mode = word >> 12 & 7;
    return mode != 5 && mode != 6;
}

/* Puts an encoding's fixed bits into a word of any bits. */
static inline uint32_t rv_encode(int number, uint32_t word)
{
    const char *encoding = rv_encodings[number];
    for (int bit = 0; bit < 32; bit++) {
        uint32_t mask = UINT32_C(0x80000000) >> bit;
        if (encoding[bit] == '0' || encoding[bit] == 'z')
            word &= ~mask;
        else if (encoding[bit] == '1')
            word |= mask;
    }
    return strchr(encoding, 'r') && !rv_mode_valid(word) ? word | 0x7000 : word;
}

static inline bool rv_encoding_matches(int number, uint32_t word)
{
    const char *encoding = rv_encodings[number];
    for (int bit = 0; bit < 32; bit++)
        if ((encoding[bit] == '0' || encoding[bit] == '1') &&
            (word >> (31 - bit) & 1) != (uint32_t)(encoding[bit] - '0'))
            return false;
    return !strchr(encoding, 'r') || rv_mode_valid(word);
}

#endif
