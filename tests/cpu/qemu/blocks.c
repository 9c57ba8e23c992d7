/* blocks.c — the tool: makes a program of random blocks, and compares what QEMU made of it.
 *
 *   blocks make FILE.elf SEED COUNT      blocks compare OUTPUT SEED COUNT
 *   blocks make FILE.elf SEED            blocks compare OUTPUT SEED       (one block in steps)
 */
#include "tests/cpu/qemu/blocks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct block_plan blocks_plan(const struct blocks *all, unsigned n)
{
    struct block_plan plan = {
        .seed = all->steps ? all->seed : all->seed + n,
        .items = all->steps ? n + 1 : BLOCK_ITEMS,
        .code_address = BLOCKS_BASE + n * BLOCK_CODE,
        .data_address = BLOCKS_BASE + blocks_data_offset(all) + n * BLOCK_DATA,
        .last = n + 1 == all->count,
    };
    return plan;
}

static void put_words(uint8_t *at, const uint32_t *words, unsigned count)
{
    for (unsigned i = 0; i < 4 * count; i++)
        at[i] = (uint8_t)(words[i / 4] >> 8 * (i % 4));
}

uint8_t *blocks_image(const struct blocks *all)
{
    uint8_t *image = calloc(1, blocks_size(all));

    for (unsigned n = 0; image && n < all->count; n++) {
        struct block b;
        struct block_plan plan = blocks_plan(all, n);
        block_make(&b, &plan);
        put_words(image + (plan.code_address - BLOCKS_BASE), b.code, BLOCK_CODE / 4);
        put_words(image + (plan.data_address - BLOCKS_BASE), b.data, BLOCK_DATA / 4);
    }
    return image;
}

int main(int count, char **arguments)
{
    bool steps = count == 4;

    if (count == 4 || count == 5) {
        struct blocks all = {
            .seed = (uint32_t)strtoul(arguments[3], NULL, 10),
            .count = steps ? BLOCK_ITEMS : (unsigned)strtoul(arguments[4], NULL, 10),
            .steps = steps,
        };
        if (all.count > 0 && all.count <= 100000) {
            if (strcmp(arguments[1], "make") == 0)
                return blocks_write_elf(&all, arguments[2]) ? 0 : 1;
            if (strcmp(arguments[1], "compare") == 0)
                return blocks_compare(&all, arguments[2]) ? 0 : 1;
        }
    }
    fprintf(stderr, "usage: blocks make|compare FILE SEED [COUNT]\n");
    return 2;
}
