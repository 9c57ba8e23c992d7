/* elf_format.h — where things are in an ELF32 file, and how its reader gets at them.
 *
 * Models:     offsets and values that elf.c and elf_symbols.c need, and little-endian loads.
 * Source:     System V ABI, chapters 4 and 5 (2013 draft); RISC-V ELF psABI 1.0, chapter 8.
 * Not modelled: everything else.
 */
#ifndef EMU_BOARD_ELF_FORMAT_H
#define EMU_BOARD_ELF_FORMAT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "emu/board/elf.h"

/* Header. */
enum {
    EI_CLASS = 4,
    EI_DATA = 5,
    EI_VERSION = 6,
    E_TYPE = 16,
    E_MACHINE = 18,
    E_ENTRY = 24,
    E_PHOFF = 28,
    E_SHOFF = 32,
    E_FLAGS = 36,
    E_PHENTSIZE = 42,
    E_PHNUM = 44,
    E_SHENTSIZE = 46,
    E_SHNUM = 48,
    EHDR_SIZE = 52,
};
enum { ELFCLASS32 = 1, ELFCLASS64 = 2, ELFDATA2LSB = 1, ELFDATA2MSB = 2, EV_CURRENT = 1 };
enum { ET_REL = 1, ET_EXEC = 2, ET_DYN = 3, EM_RISCV = 243 };
enum { EF_RVC = 1, EF_FLOAT_ABI = 6, EF_FLOAT_DOUBLE = 4, EF_RVE = 8 };

/* Program header. */
enum {
    P_TYPE = 0,
    P_OFFSET = 4,
    P_VADDR = 8,
    P_PADDR = 12,
    P_FILESZ = 16,
    P_MEMSZ = 20,
    P_FLAGS = 24,
    PHDR_SIZE = 32,
};
enum { PT_LOAD = 1, PT_DYNAMIC = 2, PT_INTERP = 3, PF_X = 1, PF_W = 2 };

/* Section header. */
enum {
    SH_TYPE = 4,
    SH_ADDR = 12,
    SH_OFFSET = 16,
    SH_SIZE = 20,
    SH_LINK = 24,
    SHDR_SIZE = 40,
};
enum { SHT_SYMTAB = 2, SHT_STRTAB = 3 };

/* Symbol. */
enum { ST_NAME = 0, ST_VALUE = 4, ST_SIZE = 8, ST_INFO = 12, ST_SHNDX = 14, SYM_SIZE = 16 };
enum { STT_OBJECT = 1, STT_FUNC = 2, STB_GLOBAL = 1 };

static inline uint16_t elf_u16(const uint8_t *p)
{
    return (uint16_t)(p[0] | p[1] << 8);
}

static inline uint32_t elf_u32(const uint8_t *p)
{
    return elf_u16(p) | (uint32_t)elf_u16(p + 2) << 16;
}

/* Whether a file of `size` bytes has `length` bytes at `offset`. */
static inline bool elf_has(size_t size, uint64_t offset, uint64_t length)
{
    return offset <= size && length <= size - offset;
}

/* elf_symbols.c. Fills in symbol and symbols; the header has been checked, nothing else. */
void vm_elf_read_symbols(struct vm_elf *elf, const uint8_t *bytes, size_t size);

#endif
