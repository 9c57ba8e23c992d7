/* blocks.h — many blocks as one program: for QEMU in an ELF file, for our processor in its memory.
 *
 *      base: block 0 │ block 1 │ …  (BLOCK_CODE each)      base + data_offset: data 0 │ data 1 │ …
 *
 * Models:     block n has seed + n; with `steps`, all have the same seed, and block n ends its body
 *             after n + 1 items, so that the first block to differ names the item.
 * Ownership:  the image is the caller's.
 * Errors:     functions that can fail say why on stderr and return false.
 */
#ifndef TESTS_QEMU_BLOCKS_H
#define TESTS_QEMU_BLOCKS_H

#include <stddef.h>

#include "tests/cpu/qemu/block.h"

/* Addresses with the sign bit set; program memory is there in the machine, too. */
#define BLOCKS_BASE 0x80000000u

struct blocks {
    uint32_t seed;
    unsigned count;
    bool steps;
};

static inline uint32_t blocks_align(uint32_t size)
{
    return (size + 4095) & ~4095u;
}

static inline uint32_t blocks_data_offset(const struct blocks *all)
{
    return blocks_align(all->count * BLOCK_CODE);
}

static inline uint32_t blocks_size(const struct blocks *all)
{
    return blocks_data_offset(all) + blocks_align(all->count * BLOCK_DATA);
}

struct block_plan blocks_plan(const struct blocks *all, unsigned n);
/* Code and data of all, blocks_size bytes; NULL: out of memory. The caller frees it. */
uint8_t *blocks_image(const struct blocks *all);

/* blocks_elf.c */
bool blocks_write_elf(const struct blocks *all, const char *path);

/* blocks_core.c: runs them all here and compares with what QEMU wrote, BLOCK_DATA bytes a block. */
bool blocks_compare(const struct blocks *all, const char *path);

#endif
