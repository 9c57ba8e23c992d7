#include <stdlib.h>
#include <string.h>

#include "crt/names.h"
#include "crt/tube_table.h"

bool crt_catalogue_init(struct crt_catalogue *c, struct crt_error *err)
{
    *c = (struct crt_catalogue){0};
    const struct crt_tube_row *tubes = crt_tube_rows(&c->tube_count);
    const struct crt_phosphor *phosphors = crt_phosphors(&c->phosphor_count);
    c->tubes = malloc(c->tube_count * sizeof *tubes);
    c->phosphors = malloc(c->phosphor_count * sizeof *phosphors);
    if (!c->tubes || !c->phosphors) {
        crt_catalogue_free(c);
        return crt_fail(err, "out of memory for the table of tubes; free some and try again");
    }
    memcpy(c->tubes, tubes, c->tube_count * sizeof *tubes);
    memcpy(c->phosphors, phosphors, c->phosphor_count * sizeof *phosphors);
    return true;
}

const struct crt_tube_row *crt_catalogue_tube(const struct crt_catalogue *c, const char *name)
{
    for (size_t i = 0; i < c->tube_count; i++)
        if (crt_same_name(c->tubes[i].name, name))
            return &c->tubes[i];
    return NULL;
}

const struct crt_phosphor *crt_catalogue_phosphor(const struct crt_catalogue *c, const char *name)
{
    for (size_t i = 0; i < c->phosphor_count; i++)
        if (crt_same_name(c->phosphors[i].name, name))
            return &c->phosphors[i];
    return NULL;
}

void crt_catalogue_free(struct crt_catalogue *c)
{
    for (size_t i = 0; i < c->string_count; i++)
        free(c->strings[i]);
    free(c->strings);
    free(c->tubes);
    free(c->phosphors);
    *c = (struct crt_catalogue){0};
}
