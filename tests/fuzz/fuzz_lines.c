/* Any bytes as an executable with line tables: no lines, or names that can be printed, for the addresses they
 * are asked for. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "emu/lab/source_lines.h"
#include "emu/memmap.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(bool holds)
{
    if (!holds) {
        abort();
    }
}

/* Where linked code lies, and around the ends of program memory. */
static void ask(const struct vm_source_lines *lines, uint32_t address)
{
    int line = 0;
    const char *file = vm_source_line(lines, address, &line);
    check(!file || (address >= MAP_PROGRAM && address - MAP_PROGRAM < MAP_PROGRAM_SIZE));
    for (; file && *file; file++) {
        check((unsigned char)*file >= ' ' && *file != 0x7F);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct vm_source_lines *lines = vm_source_lines_open(data, size);
    ask(lines, 0);
    ask(lines, MAP_PROGRAM - 1);
    ask(lines, MAP_PROGRAM + MAP_PROGRAM_SIZE);
    ask(lines, UINT32_MAX);
    for (uint32_t at = 0; lines && at < 0x400; at += 2) {
        ask(lines, MAP_PROGRAM + at);
    }
    vm_source_lines_free(lines);
    return 0;
}
