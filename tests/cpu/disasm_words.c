/* disasm_words.c — words for test_rv_disasm.sh, and what rv_disasm makes of them.
 *
 *   disasm_words instructions COUNT SEED   every instruction COUNT times, other fields at random
 *   disasm_words csrs                      a csrrs of every CSR that has a name
 *   disasm_words random COUNT SEED         any words
 *   disasm_words text PC < WORDS           a line of text each
 *
 * Words are little-endian on standard output or input.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/cpu/rv_disasm.h"
#include "tests/cpu/rv_encodings.h"

/* Registers and immediates that have names of their own come often: 0, 1 and all ones. */
static uint32_t random_fields(uint64_t *state)
{
    uint32_t word = 0;
    for (int half = 0; half < 2; half++) {
        *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        word = word << 16 | (uint32_t)(*state >> 48);
    }
    static const uint32_t special[][2] = {
        {0xfffff07f, 0},          {0xfffff07f, 0x00000080}, {0xfff07fff, 0},
        {0xfff07fff, 0x8000},     {0xfe0fffff, 0},          {0x000fffff, 0},
        {0xfff0707f, 0},          {0x000fffff, 0xfff00000}, {0x000fffff, 0x00100000},
        {0x000fffff, 0x0ff00000}, {0x0000007f, 0},
    };
    unsigned pick = (unsigned)(*state >> 40) % 22;
    if (pick < sizeof special / sizeof *special) {
        word = (word & special[pick][0]) | special[pick][1];
    } else if (pick == 11) { /* rs1 and rs2 alike */
        word = (word & 0xfe0fffff) | (word >> 15 & 31) << 20;
    }
    return word;
}

static void put(uint32_t word)
{
    for (int i = 0; i < 4; i++) {
        putchar((int)(word >> 8 * i & 255));
    }
}

static int text(uint32_t pc)
{
    unsigned char bytes[4];
    while (fread(bytes, 1, 4, stdin) == 4) {
        uint32_t word = (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
                        (uint32_t)bytes[3] << 24;
        char line[RV_DISASM_MAX];
        rv_disasm(pc, word, line, sizeof line);
        printf("%08" PRIx32 " %s\n", word, line);
        pc += 4;
    }
    return 0;
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    unsigned long first = argc > 2 ? strtoul(argv[2], NULL, 0) : 0;
    uint64_t state = argc > 3 ? strtoul(argv[3], NULL, 0) : 1;
    if (strcmp(what, "text") == 0) {
        return text((uint32_t)first);
    }
    if (strcmp(what, "instructions") == 0) {
        for (int i = 0; i < RV_ENCODINGS; i++) {
            for (unsigned long n = 0; n < first; n++) {
                put(rv_encode(i, random_fields(&state)));
            }
        }
    } else if (strcmp(what, "csrs") == 0) {
        for (uint32_t csr = 0; csr < 4096; csr++) {
            if (rv_csr_name(csr) != NULL) {
                put(csr << 20 | 0x0005a573); /* csrrs a0,CSR,a1 */
            }
        }
    } else if (strcmp(what, "random") == 0) {
        for (unsigned long n = 0; n < first; n++) {
            put(random_fields(&state));
        }
    } else {
        fputs("disasm_words instructions COUNT SEED | csrs | random COUNT SEED | text PC\n",
              stderr);
        return 2;
    }
    return 0;
}
