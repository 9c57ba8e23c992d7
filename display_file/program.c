#include "display_file/program.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#define WORDS (DF_MEMORY_BYTES / 2)

bool df_program_init(struct df_program *p, struct crt_error *err)
{
    *p = (struct df_program){0};
    p->words = calloc(WORDS, sizeof *p->words);
    p->loaded = calloc(WORDS, sizeof *p->loaded);
    p->line = calloc(WORDS, sizeof *p->line);
    if (p->words == NULL || p->loaded == NULL || p->line == NULL) {
        df_program_free(p);
        return crt_fail(err, "Out of memory for a display-file program; close other programs.");
    }
    return true;
}

void df_program_free(struct df_program *p)
{
    for (unsigned i = 0; i < p->file_count; i++) {
        free(p->files[i]);
    }
    free(p->files);
    free(p->words);
    free(p->loaded);
    free(p->line);
    *p = (struct df_program){0};
}

void df_program_put(struct df_program *p, uint32_t address, uint16_t word)
{
    assert(address % 2 == 0 && address < DF_MEMORY_BYTES);
    p->words[address / 2] = word;
    p->loaded[address / 2] = 1;
    if (p->low == p->high) {
        p->low = address;
        p->high = address + 2;
    } else if (address < p->low) {
        p->low = address;
    } else if (address >= p->high) {
        p->high = address + 2;
    }
}

bool df_program_name_file(struct df_program *p, const char *name, struct crt_error *err)
{
    assert(p->files == NULL);
    p->files = calloc(1, sizeof *p->files);
    char *copy = malloc(strlen(name) + 1);
    if (p->files == NULL || copy == NULL) {
        free(copy);
        return crt_fail(err, "Out of memory for a display-file program; close other programs.");
    }
    p->files[0] = strcpy(copy, name);
    p->file_count = 1;
    return true;
}
