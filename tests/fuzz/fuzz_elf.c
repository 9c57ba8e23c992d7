/* Any bytes as an executable: a sentence, or segments that can be copied into program memory, an
 * entry that can be fetched, and names that can be printed. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/board/elf.h"
#include "emu/memmap.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(bool holds)
{
    if (!holds) {
        abort();
    }
}

/* Copies them as the board does: a sanitizer sees reads and writes outside. */
static void check_segments(const struct vm_elf *elf)
{
    static uint8_t memory[MAP_PROGRAM_SIZE];
    uint64_t end = MAP_PROGRAM;
    bool runs = false;

    check(elf->segments > 0 && elf->segments <= VM_ELF_MAX_SEGMENTS);
    for (int i = 0; i < elf->segments; i++) {
        const struct vm_elf_segment *s = &elf->segment[i];
        check(s->address >= end && s->memory_size > 0 && s->file_size <= s->memory_size);
        memcpy(memory + (s->address - MAP_PROGRAM), s->bytes, s->file_size);
        end = (uint64_t)s->address + s->memory_size;
        check(end <= (uint64_t)MAP_PROGRAM + MAP_PROGRAM_SIZE);
        runs = runs || (s->executable && elf->entry >= s->address && elf->entry < end);
    }
    check(runs && elf->entry % 4 == 0);
}

static void check_symbols(const struct vm_elf *elf)
{
    for (size_t i = 0; i < elf->symbols; i++) {
        const struct vm_elf_symbol *s = &elf->symbol[i];
        uint32_t offset = 1;
        check(s->address < s->end && s->name[0] != 0);
        check(i == 0 || elf->symbol[i - 1].address < s->address);
        for (const char *c = s->name; *c; c++) {
            check((unsigned char)*c >= ' ' && *c != 0x7F);
        }
        check(vm_elf_symbol(elf, s->address, &offset) == s->name && offset == 0);
        vm_elf_symbol(elf, s->end, &offset);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct vm_elf elf;
    struct crt_error err = {""};

    if (!vm_elf_parse(&elf, "fuzz", data, size, &err)) {
        check(err.text[0] != 0 && elf.symbol == NULL);
        return 0;
    }
    check_segments(&elf);
    check_symbols(&elf);
    vm_elf_free(&elf);
    return 0;
}
