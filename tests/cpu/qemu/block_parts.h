/* block_parts.h — a block being made, for block.c and block_body.c. */
#ifndef TESTS_QEMU_BLOCK_PARTS_H
#define TESTS_QEMU_BLOCK_PARTS_H

#include "tests/cpu/float_operands.h"
#include "tests/cpu/qemu/block.h"
#include "tests/cpu/qemu/insn_table.h"

enum { MOST_JUMPS = 8 };

/* A jump forward whose target is not reached yet. */
struct jump {
    unsigned word, from; /* its place; what its offset counts from */
    int items;           /* still to go */
    enum insn_kind kind;
};

struct maker {
    struct block *b;
    uint64_t random;
    unsigned base;    /* the register that is only read */
    unsigned counter; /* a loop's; 0: not in a loop */
    bool calm;        /* rounds to nearest most of the time, as ordinary programs do */
    bool mild;        /* and has ordinary numbers */
    bool frm_valid;   /* whatever way led here */
    struct jump jumps[MOST_JUMPS];
    unsigned jump_count;
};

static inline uint32_t maker_random(struct maker *m)
{
    return operand_random(&m->random);
}

/* 0 … below − 1. */
static inline unsigned maker_pick(struct maker *m, unsigned below)
{
    return (unsigned)((uint64_t)maker_random(m) * below >> 32);
}

static inline void maker_emit(struct maker *m, uint32_t word)
{
    m->b->code[m->b->words++] = word;
}

/* A float, as bits: of middle size, or one of a few that meet their like, or anything. */
static inline uint32_t maker_float(struct maker *m)
{
    static const uint32_t few[] = {0,          0x80000000, 0x3f800000, 0xbf800000, 0x7f800000,
                                   0xff800000, 0x00800000, 0x80800000, 0x00000001, 0x7fc00000};

    if (m->mild && maker_pick(m, 16) != 0)
        return operand_number(&m->random, operand_within(&m->random, 110, 144));
    if (maker_pick(m, 4) == 0)
        return few[maker_pick(m, sizeof few / sizeof few[0])];
    return operands_next(&m->random).a;
}

void block_body(struct maker *m, unsigned most);

#endif
