#include <stdlib.h>
#include <string.h>

#include "emu/board/elf_format.h"

/* A symbol with what decides between several of one address. */
struct candidate {
    struct vm_elf_symbol symbol;
    unsigned rank; /* the less, the better */
    uint32_t order;
};

struct tables {
    const uint8_t *bytes;
    size_t size;
    const uint8_t *section; /* headers */
    unsigned sections;
    const uint8_t *symbol;
    uint32_t symbols;
    const char *names;
    uint32_t names_size;
};

static bool bytes_of(const struct tables *t, const uint8_t *section, uint32_t *offset,
                     uint32_t *size)
{
    *offset = elf_u32(section + SH_OFFSET);
    *size = elf_u32(section + SH_SIZE);
    return elf_has(t->size, *offset, *size);
}

static bool find_sections(struct tables *t)
{
    uint32_t offset = elf_u32(t->bytes + E_SHOFF);

    t->sections = elf_u16(t->bytes + E_SHNUM);
    if (elf_u16(t->bytes + E_SHENTSIZE) != SHDR_SIZE ||
        !elf_has(t->size, offset, (uint64_t)t->sections * SHDR_SIZE))
        return false;
    t->section = t->bytes + offset;
    return true;
}

/* The first table of symbols and the names that go with it. */
static bool find_symbols(struct tables *t)
{
    const uint8_t *table = NULL, *strings;
    uint32_t offset, size;

    for (unsigned i = 0; i < t->sections && table == NULL; i++)
        if (elf_u32(t->section + i * SHDR_SIZE + SH_TYPE) == SHT_SYMTAB)
            table = t->section + i * SHDR_SIZE;
    if (table == NULL || elf_u32(table + SH_LINK) >= t->sections ||
        !bytes_of(t, table, &offset, &size))
        return false;
    t->symbol = t->bytes + offset;
    t->symbols = size / SYM_SIZE;
    strings = t->section + elf_u32(table + SH_LINK) * SHDR_SIZE;
    if (elf_u32(strings + SH_TYPE) != SHT_STRTAB || !bytes_of(t, strings, &offset, &t->names_size))
        return false;
    t->names = (const char *)t->bytes + offset;
    return true;
}

/* The compiler's own labels and the assembler's marks ($x, $d) tell a reader nothing; control
 * characters would upset a terminal. */
static bool readable(const char *name)
{
    if (name[0] == 0 || name[0] == '$' || strncmp(name, ".L", 2) == 0)
        return false;
    for (; *name; name++)
        if ((unsigned char)*name < ' ' || *name == 0x7F)
            return false;
    return true;
}

/* NULL: no readable string that ends within the table. */
static const char *name_at(const struct tables *t, uint32_t offset)
{
    if (offset >= t->names_size || !memchr(t->names + offset, 0, t->names_size - offset))
        return NULL;
    return readable(t->names + offset) ? t->names + offset : NULL;
}

/* Within its section; what has no size reaches to the end of that. */
static bool extent(const struct tables *t, const uint8_t *s, struct vm_elf_symbol *symbol)
{
    unsigned index = elf_u16(s + ST_SHNDX);
    uint32_t size = elf_u32(s + ST_SIZE), begin;
    uint64_t end;

    if (index == 0 || index >= t->sections)
        return false; /* undefined, or a number and no address */
    begin = elf_u32(t->section + index * SHDR_SIZE + SH_ADDR);
    end = (uint64_t)begin + elf_u32(t->section + index * SHDR_SIZE + SH_SIZE);
    symbol->address = elf_u32(s + ST_VALUE);
    if (symbol->address < begin || symbol->address >= end || end > UINT32_MAX)
        return false;
    if (size > 0 && size < end - symbol->address)
        end = symbol->address + size;
    symbol->end = (uint32_t)end;
    return true;
}

/* Functions before data before labels, those with a size first, then global ones. */
static unsigned rank_of(const uint8_t *s)
{
    unsigned type = s[ST_INFO] & 15, binding = s[ST_INFO] >> 4;
    unsigned kind = type == STT_FUNC ? 0 : type == STT_OBJECT ? 1 : 2;

    return kind * 4 + (elf_u32(s + ST_SIZE) ? 0 : 2) + (binding == STB_GLOBAL ? 0 : 1);
}

static bool read_symbol(const struct tables *t, uint32_t i, struct candidate *c)
{
    const uint8_t *s = t->symbol + (size_t)i * SYM_SIZE;

    if ((s[ST_INFO] & 15) > STT_FUNC || !extent(t, s, &c->symbol))
        return false;
    c->symbol.name = name_at(t, elf_u32(s + ST_NAME));
    c->rank = rank_of(s);
    c->order = i;
    return c->symbol.name != NULL;
}

static int compare(const void *x, const void *y)
{
    const struct candidate *a = x, *b = y;

    if (a->symbol.address != b->symbol.address)
        return a->symbol.address < b->symbol.address ? -1 : 1;
    if (a->rank != b->rank)
        return a->rank < b->rank ? -1 : 1;
    return a->order < b->order ? -1 : a->order > b->order;
}

/* The best of each address. */
static bool keep_best(struct vm_elf *elf, struct candidate *candidate, size_t count)
{
    size_t kept = 0;

    elf->symbol = malloc(count * sizeof *elf->symbol);
    if (elf->symbol == NULL)
        return false;
    qsort(candidate, count, sizeof *candidate, compare);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || candidate[i].symbol.address != candidate[i - 1].symbol.address)
            elf->symbol[kept++] = candidate[i].symbol;
    elf->symbols = kept;
    return true;
}

void vm_elf_read_symbols(struct vm_elf *elf, const uint8_t *bytes, size_t size)
{
    struct tables t = {.bytes = bytes, .size = size};
    struct candidate *candidate;
    size_t count = 0;

    if (!find_sections(&t) || !find_symbols(&t) || t.symbols == 0)
        return;
    candidate = malloc(t.symbols * sizeof *candidate);
    if (candidate == NULL)
        return;
    for (uint32_t i = 0; i < t.symbols; i++)
        if (read_symbol(&t, i, &candidate[count]))
            count++;
    if (count > 0)
        keep_best(elf, candidate, count);
    free(candidate);
}

const char *vm_elf_symbol(const struct vm_elf *elf, uint32_t address, uint32_t *offset)
{
    size_t low = 0, high = elf->symbols;

    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (elf->symbol[middle].address <= address)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0 || address >= elf->symbol[low - 1].end)
        return NULL;
    *offset = address - elf->symbol[low - 1].address;
    return elf->symbol[low - 1].name;
}

bool vm_elf_find(const struct vm_elf *elf, const char *name, uint32_t *address)
{
    for (size_t i = 0; i < elf->symbols; i++)
        if (strcmp(elf->symbol[i].name, name) == 0) {
            *address = elf->symbol[i].address;
            return true;
        }
    return false;
}
