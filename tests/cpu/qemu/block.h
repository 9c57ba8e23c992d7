/* block.h — a random piece of program that shows everything it did, made from a seed.
 *
 *      code:  load all registers and fcsr ─▶ body: random instructions ─▶ store them ─▶ write(data) ─▶ next
 *      data:  registers to begin with │ registers as they ended │ scratch, for the body's loads and stores
 *
 * Models:     any instruction of insn_table.h with any operands, as long as control stays within the
 *             block, accesses are aligned and within its data, and no dynamic rounding meets a mode
 *             that does not exist. One register a block, a different one each time, holds the data's
 *             address and is only read. Bodies also have counted loops and jumps backward.
 * Units:      addresses and sizes in bytes; code in words.
 * Ownership:  the caller's struct holds everything.
 * Errors:     none.
 */
#ifndef TESTS_QEMU_BLOCK_H
#define TESTS_QEMU_BLOCK_H

#include <stdbool.h>
#include <stdint.h>

enum {
    BLOCK_CODE = 2048, /* room for a block's code and data */
    BLOCK_DATA = 2048,
    BLOCK_ITEMS = 64, /* at most, in a body */
};

/* Places within the data. */
enum {
    BLOCK_X = 0,   /* x0 … x31 to begin with; x0 is not used */
    BLOCK_F = 128, /* f0 … f31 */
    BLOCK_FCSR = 256,
    BLOCK_END_X = 272, /* as they ended */
    BLOCK_END_F = 400,
    BLOCK_END_FCSR = 528,
    BLOCK_SCRATCH = 544,
    BLOCK_BASE = 1024, /* where the register with the address points */
};

/* Linux's calls. */
enum { BLOCK_SYS_WRITE = 64, BLOCK_SYS_EXIT = 93 };

struct block_plan {
    uint32_t seed;
    unsigned items; /* of the body, at most; BLOCK_ITEMS: as many as the seed says */
    uint32_t code_address, data_address;
    bool last; /* exits instead of going on behind BLOCK_CODE */
};

struct block {
    uint32_t code[BLOCK_CODE / 4];
    unsigned words;
    unsigned body_begin, body_end; /* words */
    uint32_t data[BLOCK_DATA / 4];
};

void block_make(struct block *b, const struct block_plan *plan);

#endif
