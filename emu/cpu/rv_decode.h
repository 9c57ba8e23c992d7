/* rv_decode.h — instruction words as entries that the loops run through.
 *
 *      memory   w0 w1 … w15 w16 …          a word each four bytes
 *      entries  e0 e1 … e15  C  e16 …      an entry a word, and a checkpoint after every 16
 *
 * Models:     the cache of decoded words. An entry says which handler of rv_ops.inc does the work
 *             and holds what the handler needs: registers, constants already relative to where they
 *             are used, jumps as distances between entries. Entries start as zeroes, which is
 *             RV_DO_DECODE: the handler that decodes.
 *             A checkpoint belongs to no instruction. It bounds how far a loop can go without
 *             looking at the clock.
 * Ownership:  the cache belongs to the processor.
 * Errors:     what is no instruction, or needs more than an entry can say, becomes RV_DO_SLOW: rv_slow
 *             looks at the word itself.
 * Not modelled: nothing of the machine lives here.
 */
#ifndef EMU_CPU_RV_DECODE_H
#define EMU_CPU_RV_DECODE_H

#include "emu/cpu/rv.h"
#include "emu/cpu/rv_op_list.h"

/* Instructions between checkpoints. With few, slices of some ten clocks, as a running display processor
 * leaves them, can use the fast loop to near their end; many cost less otherwise. Measured with 16
 * against 64: slices of 75 clocks 17 % faster, endless ones 2 % slower. */
#define RV_RUN 16

enum rv_op {
    RV_DO_DECODE = 0,
    RV_DO_CHECKPOINT,
    RV_DO_END, /* behind the last word of memory */
    RV_DO_SLOW,
#define NAME(name)          RV_DO_##name,
#define PAIR(first, second) RV_DO_##first##_##second,
    RV_ALL_OPS(NAME) RV_ALL_PAIRS(PAIR)
#undef NAME
#undef PAIR
        RV_DO_COUNT
};

struct rv_entry {
    uint8_t op, rd, rs1, rs2;
    int32_t imm;
};

static inline uint32_t rv_index_of_word(uint32_t word)
{
    return word + word / RV_RUN;
}

/* A checkpoint counts as the word behind it. */
static inline uint32_t rv_word_of_index(uint32_t index)
{
    return index - index / (RV_RUN + 1);
}

/* The entry of an address within program memory. */
static inline struct rv_entry *rv_entry_of(const struct rv_cpu *cpu, uint32_t pc)
{
    return cpu->entries + rv_index_of_word((pc - cpu->desc.memory_base) / 4);
}

static inline uint32_t rv_pc_of(const struct rv_cpu *cpu, const struct rv_entry *entry)
{
    return cpu->desc.memory_base + 4 * rv_word_of_index((uint32_t)(entry - cpu->entries));
}

/* Fills the entry from memory, and those behind it up to the next checkpoint. */
void rv_decode(struct rv_cpu *cpu, struct rv_entry *entry);
/* An entry that does the work of the next one as well does its own alone from now on. */
void rv_part(struct rv_entry *entry);

#endif
