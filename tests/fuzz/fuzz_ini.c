/* fuzz_ini.c — any bytes as an INI file of tubes and phosphors.
 *
 * Checks:     a refused file leaves the catalogue as it was and is told "fuzz.ini…"; the rows of an
 *             accepted one pass crt_tube_check, have a phosphor and a grid, and can be printed; the
 *             shares of a phosphor's terms add up to 1.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/catalogue_text.h"
#include "crt/tube_table.h"

static void require(int holds)
{
    if (!holds)
        abort();
}

static void check_tube(const struct crt_catalogue *c, const struct crt_tube_row *row)
{
    struct crt_error err;
    require(crt_tube_check(row, &err));
    require(crt_catalogue_phosphor(c, row->phosphor) != NULL);
    require(crt_catalogue_tube(c, row->name) == row);
    require(memchr(row->name, 0, sizeof row->name) && row->name[0]);
    struct crt_grid grid = crt_tube_grid(row);
    require(grid.cols > 0 && grid.cols % 8 == 0 && grid.rows > 0);
#define X(field, unit, meaning)                                                                    \
    require(!crt_tube_has_figure(row, #field) || (row->field.source && row->field.source[0]));
    CRT_TUBE_FIGURES(X)
#undef X
}

static void check_phosphor(const struct crt_catalogue *c, const struct crt_phosphor *p)
{
    double sum = 0;
    require(crt_catalogue_phosphor(c, p->name) == p);
    require(p->terms >= 1 && p->terms <= CRT_MAX_TERMS);
    require(p->colours >= 1 && p->colours <= CRT_MAX_COLOURS);
    for (int k = 0; k < p->terms; k++) {
        sum += p->term[k].w;
        require(p->term[k].w > 0 && p->term[k].tau_s > 0 && isfinite(p->term[k].tau_s));
        require(p->term[k].colour >= 0 && p->term[k].colour < p->colours);
    }
    require(fabs(sum - 1) < 1e-9);
    for (int i = 0; i < p->colours; i++)
        require(p->colour[i].y > 0 && p->colour[i].x + p->colour[i].y <= 1);
    require(p->source && p->note && p->tektronix.source && p->jedec.source);
    require(crt_phosphor_decay_time(p, 0.1) > 0);
}

static void print_new(const struct crt_catalogue *c, size_t tubes, size_t phosphors)
{
    char *text;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    require(out != NULL);
    for (size_t i = tubes; i < c->tube_count; i++)
        crt_explain_tube(out, &c->tubes[i]);
    for (size_t i = phosphors; i < c->phosphor_count; i++)
        crt_explain_phosphor(out, &c->phosphors[i]);
    fclose(out);
    require(length > 0);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct crt_catalogue c;
    struct crt_error err;
    require(crt_catalogue_init(&c, &err));
    const struct crt_catalogue before = c;
    if (crt_catalogue_load_text(&c, "fuzz.ini", (const char *)data, size, &err)) {
        require(c.tube_count + c.phosphor_count > before.tube_count + before.phosphor_count);
        for (size_t i = before.tube_count; i < c.tube_count; i++)
            check_tube(&c, &c.tubes[i]);
        for (size_t i = before.phosphor_count; i < c.phosphor_count; i++)
            check_phosphor(&c, &c.phosphors[i]);
        print_new(&c, before.tube_count, before.phosphor_count);
    } else {
        require(strncmp(err.text, "fuzz.ini:", 9) == 0);
        require(memcmp(&c, &before, sizeof c) == 0);
    }
    crt_catalogue_free(&c);
    return 0;
}
