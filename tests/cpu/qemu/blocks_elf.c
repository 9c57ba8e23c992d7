/* blocks_elf.c — the least ELF file that Linux runs: a header and one segment. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/cpu/qemu/blocks.h"

enum { PAGE = 4096, HEADER = 52, SEGMENT = 32 };

static void put(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

/* System V ABI, chapter 4 and 5; the machine's number and flags from the RISC-V ELF specification. */
static void put_headers(uint8_t *page, uint32_t size)
{
    static const uint8_t ident[] = {0x7f, 'E', 'L', 'F', 1 /* 32 bits */, 1 /* little-endian */, 1};
    uint8_t *segment = page + HEADER;

    memcpy(page, ident, sizeof ident);
    put(page + 16, 2, 2);           /* executable */
    put(page + 18, 243, 2);         /* RISC-V */
    put(page + 20, 1, 4);           /* version */
    put(page + 24, BLOCKS_BASE, 4); /* entry: the first block */
    put(page + 28, HEADER, 4);      /* where the segments are listed */
    put(page + 36, 2, 4);           /* floats of single precision in float registers */
    put(page + 40, HEADER, 2);
    put(page + 42, SEGMENT, 2);
    put(page + 44, 1, 2); /* one segment */

    put(segment + 0, 1, 4);           /* to be loaded */
    put(segment + 4, PAGE, 4);        /* place in the file */
    put(segment + 8, BLOCKS_BASE, 4); /* address */
    put(segment + 12, BLOCKS_BASE, 4);
    put(segment + 16, size, 4); /* bytes in the file and in memory */
    put(segment + 20, size, 4);
    put(segment + 24, 7, 4); /* read, write, execute */
    put(segment + 28, PAGE, 4);
}

bool blocks_write_elf(const struct blocks *all, const char *path)
{
    uint8_t page[PAGE] = {0};
    uint32_t size = blocks_size(all);
    uint8_t *image = blocks_image(all);
    FILE *f = fopen(path, "wb");
    bool ok = image && f;

    put_headers(page, size);
    ok = ok && fwrite(page, 1, PAGE, f) == PAGE && fwrite(image, 1, size, f) == size;
    if (f && fclose(f) != 0)
        ok = false;
    free(image);
    if (!ok)
        fprintf(stderr, "%s cannot be written\n", path);
    return ok;
}
