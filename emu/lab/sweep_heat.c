/* The sweep as a heat map: rates across, phosphors (and luminances) down. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lab/sweep.h"

#define NAME 40
#define TEXT 24

/* A margin of so many Hz or more has the colour of the end. Between steady and flickering colours jump, so that
 * nobody need read the cells to tell them apart. */
#define FAR_HZ   20.0
#define STEADY   0.3  /* value at a margin of 0, coming from below */
#define FLICKERS 0.55 /* from above */

struct map {
    struct vm_heat_cell *cell;
    char (*text)[TEXT];
    char (*row)[NAME];
    const char **rows;
    char column[VM_SWEEP_MAX][NAME];
    const char *columns[VM_SWEEP_MAX];
};

static bool map_alloc(struct map *m, size_t rows, size_t cells)
{
    m->cell = calloc(cells, sizeof *m->cell);
    m->text = calloc(cells, sizeof *m->text);
    m->row = calloc(rows, sizeof *m->row);
    m->rows = calloc(rows, sizeof *m->rows);
    return m->cell && m->text && m->row && m->rows;
}

static void map_free(struct map *m)
{
    free(m->cell);
    free(m->text);
    free(m->row);
    free(m->rows);
}

static double colour_of(double margin_hz)
{
    double far = fmin(fabs(margin_hz) / FAR_HZ, 1);
    return margin_hz > 0 ? FLICKERS + (1 - FLICKERS) * far : STEADY * (1 - far);
}

/* Of one field its margin; of several those who see flicker, and the mean of their colours. */
static void fill_cell(const struct vm_sweep *s, struct vm_sweep_at at, struct vm_heat_cell *cell,
                      char *text)
{
    double sum = 0;
    bool any = false;
    for (at.field = 0; at.field < s->fields; at.field++) {
        struct vm_sweep_cell c = vm_sweep_cell(s, &at);
        size_t n = strlen(text);
        sum += colour_of(c.margin_hz);
        any |= c.flickers;
        if (s->fields == 1)
            snprintf(text, TEXT, "%s%.*f", c.margin_hz < 0 ? "−" : "+",
                     fabs(c.margin_hz) < 9.95 ? 1 : 0, fabs(c.margin_hz));
        else if (c.flickers)
            snprintf(text + n, TEXT - n, "%s%.0f°", n ? " " : "",
                     crt_fields_deg[s->field[at.field]]);
    }
    if (s->fields > 1 && !any)
        snprintf(text, TEXT, "steady");
    cell->value = sum / s->fields;
    cell->text = text;
}

static void fill(const struct vm_sweep *s, struct map *m)
{
    for (int i = 0; i < s->rates; i++) {
        snprintf(m->column[i], NAME, "%.5g", s->rate_hz[i]);
        m->columns[i] = m->column[i];
    }
    for (int p = 0, r = 0; p < s->phosphors; p++)
        for (int i = 0; i < s->luminances; i++, r++) {
            snprintf(m->row[r], NAME, "%s", s->phosphor[p]->name);
            if (s->luminances > 1)
                snprintf(m->row[r], NAME, "%s, %g cd/m²", s->phosphor[p]->name, s->cd_m2[i]);
            m->rows[r] = m->row[r];
            for (int k = 0; k < s->rates; k++) {
                int n = r * s->rates + k;
                fill_cell(s, (struct vm_sweep_at){p, i, k, 0}, &m->cell[n], m->text[n]);
            }
        }
}

static void name_it(const struct vm_sweep *s, char *title, char *note, size_t size)
{
    char at[64] = "";
    if (s->luminances == 1)
        snprintf(at, sizeof at, ", %g cd/m²", s->cd_m2[0]);
    if (s->fields == 1)
        snprintf(title, size, "Does it flicker? A field of %.0f°%s, pupil %g mm",
                 crt_fields_deg[s->field[0]], at, s->pupil_mm);
    else
        snprintf(title, size, "Who sees it flicker%s, pupil %g mm", at, s->pupil_mm);
    snprintf(note, size,
             "In the cells: %s Model: Farrell, Benson and Haynie 1987, 95 %% of viewers looking "
             "straight at an evenly lit field; thin lines on a dark screen flicker less.",
             s->fields == 1
                 ? "Hz by which the critical fusion frequency exceeds the refresh rate; above 0 "
                   "it flickers."
                 : "how many degrees across the lit field is for those who see flicker.");
}

struct vm_size vm_sweep_size(const struct vm_sweep *s, bool projector)
{
    int rows = s->phosphors * s->luminances, row = projector ? 48 : 30;
    struct vm_size size = vm_plot_size;
    while (size.height < 240 + rows * row && size.height < 4000)
        size.height += 120;
    return size;
}

bool vm_sweep_draw(const struct vm_sweep *s, struct vm_size size, enum vm_plot_style style,
                   struct crt_image *image, struct crt_error *err)
{
    struct map m = {0};
    int rows = s->phosphors * s->luminances;
    char title[512], note[512];
    bool ok = map_alloc(&m, (size_t)rows, (size_t)(rows * s->rates)) ||
              crt_fail(err, "not enough memory for the picture; close other programs");
    if (ok) {
        fill(s, &m);
        name_it(s, title, note, sizeof title);
        struct vm_heat heat = {.title = title,
                               .note = note,
                               .x_label = "refresh rate, Hz",
                               .y_label = "phosphor",
                               .columns = m.columns,
                               .rows = m.rows,
                               .column_count = s->rates,
                               .row_count = rows,
                               .cells = m.cell,
                               .low = "steady by 20 Hz or more",
                               .high = "flickers by 20 Hz or more"};
        ok = vm_heat_draw(&heat, size, style, image, err);
    }
    map_free(&m);
    return ok;
}
