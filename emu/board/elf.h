/* elf.h — an executable file for the processor: what to load where, where to begin, and names.
 *
 *      bytes of the file ─▶ header ─▶ segments ─▶ checks ─▶ board (emu/board/board.h)
 *                               └───▶ symbols, sorted ─▶ "main+0x1c" in reports
 *
 * Models:     ELF32, little-endian, RISC-V, statically linked. A segment is loaded at its physical
 *             address, as QEMU and gdb do it (a start-up routine may copy initialised data from there
 *             to where they belong); segments that are not writable are ROM.
 * Units:      byte addresses of the processor.
 * Ownership:  vm_elf_parse allocates the table of symbols, vm_elf_free frees it. Segments and names
 *             point into the caller's bytes, which must outlive the struct.
 * Errors:     bytes are hostile. What cannot run is refused with one sentence that names the file and
 *             the reason. Symbols are a courtesy: bad ones, or a bad table, are left out silently.
 * Source:     System V ABI, chapters 4 and 5 (2013 draft); RISC-V ELF psABI 1.0, chapter 8.
 * Not modelled: dynamic linking, relocation, compressed code, embedded (RVE) and double-float ABIs.
 */
#ifndef EMU_BOARD_ELF_H
#define EMU_BOARD_ELF_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"

#define VM_ELF_MAX_SEGMENTS 16

struct vm_elf_segment {
    uint32_t address;     /* within program memory */
    const uint8_t *bytes; /* file_size of them; 0 follows up to memory_size */
    uint32_t file_size, memory_size;
    bool writable, executable;
};

struct vm_elf_symbol {
    uint32_t address;
    uint32_t end;     /* the first address that is no longer its own */
    const char *name; /* not empty */
};

struct vm_elf {
    struct vm_elf_segment segment[VM_ELF_MAX_SEGMENTS]; /* in order of address; none is empty */
    int segments;
    uint32_t entry;
    struct vm_elf_symbol *symbol; /* in order of address, one an address */
    size_t symbols;
};

/* Whether the bytes begin as an ELF file does. */
bool vm_elf_is(const uint8_t *bytes, size_t size);

/* `name` is for the sentence. On failure nothing needs to be freed. */
bool vm_elf_parse(struct vm_elf *elf, const char *name, const uint8_t *bytes, size_t size,
                  struct crt_error *err);
void vm_elf_free(struct vm_elf *elf);

/* The name of what is at an address, and how far into it; NULL when nothing named is there. */
const char *vm_elf_symbol(const struct vm_elf *elf, uint32_t address, uint32_t *offset);
/* The address of a name; false when there is none of it. */
bool vm_elf_find(const struct vm_elf *elf, const char *name, uint32_t *address);

#endif
