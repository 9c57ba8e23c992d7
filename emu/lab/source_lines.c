#include "emu/lab/source_lines.h"

#include <elfutils/libdw.h>
#include <stdlib.h>
#include <string.h>

#include "emu/memmap.h"

/* Up to `end` the code is of this line. Rows do not overlap. */
struct row {
    uint32_t address, end;
    int line;
    const char *file;
    uint32_t order; /* among rows of one address: the last of them counts */
};

struct vm_source_lines {
    char *image; /* a copy: libelf wants to write to it */
    Elf *elf;
    Dwarf *dwarf;
    struct row *row;
    size_t count, room;
};

/* ---- reading --------------------------------------------------------------------------------- */

static bool push(struct vm_source_lines *l, const struct row *row)
{
    if (l->count == l->room) {
        size_t room = l->room ? 2 * l->room : 4096;
        struct row *larger = realloc(l->row, room * sizeof *larger);
        if (!larger)
            return false;
        l->row = larger;
        l->room = room;
    }
    l->row[l->count] = *row;
    l->row[l->count].order = (uint32_t)l->count;
    l->count++;
    return true;
}

static bool is_printable(const char *text)
{
    while ((unsigned char)*text >= ' ' && *text != 0x7F)
        text++;
    return *text == '\0';
}

/* "./roms/hello.c" is "roms/hello.c"; libraries were built in folders that are no longer there. */
static const char *file_of(Dwarf_Line *line)
{
    const char *file = dwarf_linesrc(line, NULL, NULL);
    while (file && (strncmp(file, "./", 2) == 0 || strncmp(file, "../", 3) == 0))
        file += file[1] == '/' ? 2 : 3;
    return file && is_printable(file) ? file : "?";
}

/* The rows of one table, in order of address, each up to the next. Code that the linker has thrown away
 * is said to be at 0, where no program is. */
static bool take_table(struct vm_source_lines *l, Dwarf_Lines *lines, size_t count)
{
    for (size_t i = 0; i + 1 < count; i++) {
        Dwarf_Line *line = dwarf_onesrcline(lines, i);
        Dwarf_Addr address = 0, next = 0;
        bool ends = true;
        int number = 0;
        dwarf_lineendsequence(line, &ends);
        if (ends || dwarf_lineaddr(line, &address) != 0 || dwarf_lineno(line, &number) != 0 ||
            dwarf_lineaddr(dwarf_onesrcline(lines, i + 1), &next) != 0 || next <= address ||
            address < MAP_PROGRAM || next > MAP_PROGRAM + (Dwarf_Addr)MAP_PROGRAM_SIZE)
            continue;
        const struct row row = {(uint32_t)address, (uint32_t)next, number, file_of(line), 0};
        if (!push(l, &row))
            return false;
    }
    return true;
}

static bool take_tables(struct vm_source_lines *l)
{
    Dwarf_Off at = 0, next = 0;
    Dwarf_CU *unit = NULL;
    Dwarf_Lines *lines = NULL;
    size_t count = 0;
    int more;
    while ((more = dwarf_next_lines(l->dwarf, at, &next, &unit, NULL, NULL, &lines, &count)) == 0) {
        if (!take_table(l, lines, count))
            return false;
        if (next <= at)
            break;
        at = next;
    }
    return true; /* what was before a bad table is good */
}

static int compare(const void *x, const void *y)
{
    const struct row *a = x, *b = y;
    if (a->address != b->address)
        return a->address < b->address ? -1 : 1;
    return a->order < b->order ? -1 : a->order > b->order;
}

static bool open_dwarf(struct vm_source_lines *l, const uint8_t *bytes, size_t size)
{
    l->image = malloc(size ? size : 1);
    if (!l->image || elf_version(EV_CURRENT) == EV_NONE)
        return false;
    memcpy(l->image, bytes, size);
    l->elf = elf_memory(l->image, size);
    l->dwarf = l->elf ? dwarf_begin_elf(l->elf, DWARF_C_READ, NULL) : NULL;
    return l->dwarf != NULL;
}

struct vm_source_lines *vm_source_lines_open(const uint8_t *bytes, size_t size)
{
    struct vm_source_lines *l = calloc(1, sizeof *l);
    if (l && open_dwarf(l, bytes, size) && take_tables(l) && l->count > 0) {
        qsort(l->row, l->count, sizeof *l->row, compare);
        return l;
    }
    vm_source_lines_free(l);
    return NULL;
}

void vm_source_lines_free(struct vm_source_lines *l)
{
    if (!l)
        return;
    if (l->dwarf)
        dwarf_end(l->dwarf);
    if (l->elf)
        elf_end(l->elf);
    free(l->image);
    free(l->row);
    free(l);
}

/* ---- looking up ------------------------------------------------------------------------------ */

const char *vm_source_line(const struct vm_source_lines *l, uint32_t address, int *line)
{
    size_t low = 0, high = l ? l->count : 0;
    while (low < high) { /* the first row behind the address */
        size_t middle = low + (high - low) / 2;
        if (l->row[middle].address <= address)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0 || address >= l->row[low - 1].end)
        return NULL;
    *line = l->row[low - 1].line;
    return l->row[low - 1].file;
}
