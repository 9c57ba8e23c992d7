/* source_lines.h — from an address in a program to the line of its source.
 *
 *      bytes of an ELF file ─▶ .debug_line ─▶ rows in order of address ─▶ "roms/hello.c", 17
 *
 * Models:     line tables as compilers write them (DWARF 2 to 5), by elfutils' libdw. A row holds up to
 *             the next one.
 * Units:      byte addresses of the processor, as linked.
 * Ownership:  vm_source_lines_open allocates, vm_source_lines_free releases; file names live as long.
 * Errors:     bytes are hostile. A file without line tables, or with bad ones, has no lines: that is
 *             no error. Out of memory: the same.
 */
#ifndef EMU_LAB_SOURCE_LINES_H
#define EMU_LAB_SOURCE_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct vm_source_lines;

/* NULL: there are none. */
struct vm_source_lines *vm_source_lines_open(const uint8_t *bytes, size_t size);
void vm_source_lines_free(struct vm_source_lines *lines);

/* The file as the compiler was told it, and the line; NULL when the address is in no row. */
const char *vm_source_line(const struct vm_source_lines *lines, uint32_t address, int *line);

#endif
