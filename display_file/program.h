/* program.h — a display-file program: words at display-memory addresses, an entry, their source.
 *
 * Models:     what the assembler and the loaders make and the machine loads.
 * Addresses:  even byte addresses in display memory, 0 … DF_MEMORY_BYTES-2.
 * Ownership:  df_program_init allocates, df_program_free releases; plain data between.
 * Errors:     out of memory gives a sentence; an odd or too high address asserts.
 * Source:     the 64 KiB of a VT11 after DEC EK-VT11-TM-001; 256 KiB with VS60 relocation.
 * Not modelled: relocation; addresses above 64 KiB hold words that a VT11 cannot fetch.
 */
#ifndef DF_PROGRAM_H
#define DF_PROGRAM_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/error.h"

#define DF_MEMORY_BYTES  0x40000u /* 256 KiB; the VT11's 16-bit addresses reach the first 64 KiB */
#define DF_ADDRESS_SPACE 0x10000u

struct df_program {
    uint16_t *words; /* DF_MEMORY_BYTES / 2, indexed by address / 2; 0 where nothing was loaded */
    uint8_t *loaded; /* same index: 1 where the program put a word */
    uint32_t *line;  /* same index: file << 24 | line number of the source, 0 = unknown */
    char **files;    /* names for that file index */
    unsigned file_count;
    uint32_t low;      /* the first address loaded */
    uint32_t high;     /* the one after the last; low == high: empty */
    uint32_t entry;    /* where DPC starts */
    char tube[40];     /* what it was made for: TUBE or TUBE/PHOSPHOR; "": it does not say */
    char firmware[64]; /* image of the firmware it needs, without .elf; "": none */
};

bool df_program_init(struct df_program *p, struct crt_error *err);
void df_program_free(struct df_program *p);

/* Puts a word at an even address below DF_MEMORY_BYTES. */
void df_program_put(struct df_program *p, uint32_t address, uint16_t word);

/* Makes `name` the program's only file, number 0. */
bool df_program_name_file(struct df_program *p, const char *name, struct crt_error *err);

#endif
