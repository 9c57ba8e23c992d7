#include <math.h>
#include <stdlib.h>

#include "emu/plot/sheet.h"

/* The least height of letters, pixels, and what a row and a column need beyond their letters, of that height;
 * estimates, by eye. */
#define LEGIBLE 11
#define ROW     1.28
#define BESIDE  0.7

struct table {
    const struct vm_heat *heat;
    struct vm_type type;  /* of the cells */
    struct vm_type names; /* of rows */
    bool turned;          /* the names of columns */
    double left, top, right, bottom, cell_w, cell_h;
    double note_y, label_y, bar_y; /* base lines */
};

static bool has(const char *text)
{
    return text && text[0];
}

static double widest(const char *const *names, int count, struct vm_type type)
{
    double width = 0;
    for (int i = 0; i < count; i++)
        width = fmax(width, names[i] ? vm_text_width(type, names[i]) : 0);
    return width;
}

static double widest_cell(const struct vm_heat *heat, struct vm_type type)
{
    double width = 0;
    for (int i = 0; i < heat->row_count * heat->column_count; i++)
        if (has(heat->cells[i].text))
            width = fmax(width, vm_text_width(type, heat->cells[i].text));
    return width;
}

/* ---- colours -------------------------------------------------------------------------------------- */

/* From pale blue through yellow and red to dark red; lightness only falls, so the order survives in grey print, and
 * blue against yellow and red is told apart by most of the colour-blind. Anchors: ColorBrewer's Blues and YlOrRd
 * (C. Brewer, M. Harrower, 2003). */
static struct vm_rgb colour_of(double value)
{
    static const double anchor[6][3] = {{222, 235, 247}, {255, 237, 160}, {254, 190, 90},
                                        {252, 120, 50},  {214, 24, 32},   {110, 0, 38}};
    if (isnan(value))
        return (struct vm_rgb){190, 190, 190};
    double at = fmin(fmax(value, 0), 1) * 5;
    int i = at >= 5 ? 4 : (int)at;
    uint8_t c[3];
    for (int k = 0; k < 3; k++)
        c[k] = (uint8_t)floor(anchor[i][k] + (anchor[i + 1][k] - anchor[i][k]) * (at - i) + 0.5);
    return (struct vm_rgb){c[0], c[1], c[2]};
}

/* Black or white, whichever stands out: their contrasts are equal at a luminance of 0.179 (WCAG 2.1, relative
 * luminance and contrast ratio). */
static struct vm_rgb letters_on(const struct vm_ink *ink, struct vm_rgb c)
{
    double rgb[3] = {ink->linear[c.r], ink->linear[c.g], ink->linear[c.b]};
    return crt_srgb_luminance(rgb) > 0.179 ? (struct vm_rgb){0, 0, 0}
                                           : (struct vm_rgb){255, 255, 255};
}

/* ---- layout --------------------------------------------------------------------------------------- */

static bool too_small(const struct table *t, struct vm_size size, struct crt_error *err)
{
    struct vm_type least = {LEGIBLE, t->type.weight};
    const struct vm_heat *h = t->heat;
    double w = widest_cell(h, least) + BESIDE * LEGIBLE, row = ROW * LEGIBLE;
    double more_w = fmax(0, w - t->cell_w) * h->column_count,
           more_h = fmax(0, row - t->cell_h) * h->row_count;
    return crt_fail(err,
                    "a picture of %dx%d is too small for %d rows and %d columns that can be read; "
                    "%dx%d would do",
                    size.width, size.height, h->row_count, h->column_count,
                    (int)ceil((size.width + more_w * 1.15) / 10) * 10,
                    (int)ceil((size.height + more_h * 1.15) / 10) * 10);
}

static bool lay_out(struct table *t, const struct vm_look *look, struct vm_size size,
                    struct crt_error *err)
{
    const struct vm_heat *h = t->heat;
    double s = look->type.size, pad = 0.7 * s;
    t->top = pad + (has(h->title) ? look->title.size * 1.4 : 0);
    t->bar_y = t->top + 0.9 * s;
    t->top += has(h->low) || has(h->high) ? 1.7 * s : 0;
    t->bottom = size.height - pad;
    if (has(h->note)) {
        int lines = vm_wrapped_lines(look->type, h->note, size.width - 2 * pad);
        t->note_y = t->bottom - 0.3 * s - (lines - 1) * VM_LINE_STEP * s;
        t->bottom = t->note_y - 1.15 * s;
    }
    if (has(h->x_label)) {
        t->label_y = t->bottom - 0.3 * s;
        t->bottom = t->label_y - s;
    }
    t->right = size.width - pad;
    double below = 1.4 * s, columns = widest(h->columns, h->column_count, look->type);
    for (int round = 0; round < 2; round++) {
        t->cell_h = floor((t->bottom - below - t->top) / h->row_count);
        t->names = look->type;
        t->names.size = fmin(s, t->cell_h / ROW);
        t->left = pad + (has(h->y_label) ? 1.5 * s : 0) + widest(h->rows, h->row_count, t->names) +
                  0.6 * s;
        t->cell_w = floor((t->right - t->left) / h->column_count);
        t->turned = columns > t->cell_w - 0.5 * s;
        if (!t->turned)
            break;
        below = columns + 0.8 * s;
    }
    t->left = floor(t->left);
    t->top = floor(t->top);
    t->type = t->names;
    double widest_text = widest_cell(h, t->type), room = t->cell_w - BESIDE * t->type.size;
    if (widest_text > room)
        t->type.size *= fmax(room, 0) / widest_text;
    if (!(t->cell_w >= 3) || t->names.size < LEGIBLE ||
        (widest_text > 0 && t->type.size < LEGIBLE) || (t->turned && t->cell_w < s))
        return too_small(t, size, err);
    return true;
}

/* ---- drawing -------------------------------------------------------------------------------------- */

static void cells(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    double gap = t->cell_h > 24 ? 1 : 0.5;
    for (int r = 0; r < h->row_count; r++)
        for (int c = 0; c < h->column_count; c++) {
            const struct vm_heat_cell *cell = &h->cells[r * h->column_count + c];
            double x = t->left + c * t->cell_w, y = t->top + r * t->cell_h;
            struct vm_rgb colour = colour_of(cell->value);
            vm_ink_box(&sheet->ink,
                       (struct vm_rect){x + gap, y + gap, x + t->cell_w - gap, y + t->cell_h - gap},
                       colour, 1);
            if (has(cell->text))
                vm_sheet_text(sheet, VM_WORD_CELL, t->type, x + t->cell_w / 2,
                              y + t->cell_h / 2 + 0.36 * t->type.size, VM_MIDDLE, false, cell->text,
                              letters_on(&sheet->ink, colour));
        }
}

static void names(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    const struct vm_look *look = &sheet->look;
    double s = look->type.size, floor_y = t->top + h->row_count * t->cell_h;
    for (int r = 0; r < h->row_count; r++)
        if (has(h->rows[r]))
            vm_sheet_text(sheet, VM_WORD_Y_TICK, t->names, t->left - 0.5 * s,
                          t->top + (r + 0.5) * t->cell_h + 0.36 * t->names.size, VM_RIGHT, false,
                          h->rows[r], look->text);
    for (int c = 0; c < h->column_count; c++) {
        double x = t->left + (c + 0.5) * t->cell_w;
        if (!has(h->columns[c]))
            continue;
        if (t->turned)
            vm_sheet_text(sheet, VM_WORD_X_TICK, look->type, x + 0.36 * s, floor_y + 0.4 * s,
                          VM_RIGHT, true, h->columns[c], look->text);
        else
            vm_sheet_text(sheet, VM_WORD_X_TICK, look->type, x, floor_y + 1.15 * s, VM_MIDDLE,
                          false, h->columns[c], look->text);
    }
}

/* "low [colours] high", above the right end of the table. */
static void bar(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    const struct vm_look *look = &sheet->look;
    double s = look->type.size, end = t->left + h->column_count * t->cell_w, length = 9 * s;
    if (!has(h->low) && !has(h->high))
        return;
    double high = has(h->high) ? vm_text_width(look->type, h->high) : 0,
           x1 = floor(end - high - 0.6 * s);
    double x0 = x1 - floor(length);
    if (has(h->high))
        vm_sheet_text(sheet, VM_WORD_SCALE, look->type, end, t->bar_y, VM_RIGHT, false, h->high,
                      look->text);
    for (double x = x0; x < x1; x++)
        vm_ink_box(
            &sheet->ink,
            (struct vm_rect){x, floor(t->bar_y - 0.75 * s), x + 1, floor(t->bar_y + 0.05 * s)},
            colour_of((x - x0) / (x1 - 1 - x0)), 1);
    if (has(h->low))
        vm_sheet_text(sheet, VM_WORD_SCALE, look->type, x0 - 0.6 * s, t->bar_y, VM_RIGHT, false,
                      h->low, look->text);
}

static void draw(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    const struct vm_look *look = &sheet->look;
    double s = look->type.size, pad = 0.7 * s, width = h->column_count * t->cell_w,
           height = h->row_count * t->cell_h;
    cells(sheet, t);
    names(sheet, t);
    bar(sheet, t);
    if (has(h->title))
        vm_sheet_text(sheet, VM_WORD_TITLE, look->title, pad, pad + 0.85 * look->title.size,
                      VM_LEFT, false, h->title, look->text);
    if (has(h->note))
        vm_sheet_wrapped(sheet, VM_WORD_NOTE, look->type, pad, t->note_y,
                         sheet->image->width - 2 * pad, h->note, look->dim);
    if (has(h->x_label))
        vm_sheet_text(sheet, VM_WORD_X_LABEL, look->type, t->left + width / 2, t->label_y,
                      VM_MIDDLE, false, h->x_label, look->text);
    if (has(h->y_label))
        vm_sheet_text(sheet, VM_WORD_Y_LABEL, look->type, pad + 0.8 * s, t->top + height / 2,
                      VM_MIDDLE, true, h->y_label, look->text);
}

bool vm_heat_draw_words(const struct vm_heat *heat, struct vm_size size, enum vm_plot_style style,
                        struct crt_image *image, struct vm_words *words, struct crt_error *err)
{
    *image = (struct crt_image){0};
    if (heat->row_count < 1 || heat->column_count < 1)
        return crt_fail(err, "there is nothing to show%s%.200s: the table is empty",
                        has(heat->title) ? " for " : "", has(heat->title) ? heat->title : "");
    struct vm_sheet *sheet = malloc(sizeof *sheet);
    if (!sheet)
        return crt_fail(err, "not enough memory for a plot");
    struct table table = {.heat = heat};
    bool ok = vm_sheet_open(sheet, image, size, style, words, err);
    if (ok) {
        ok = lay_out(&table, &sheet->look, size, err);
        if (ok)
            draw(sheet, &table);
        vm_sheet_close(sheet, ok);
    }
    free(sheet);
    return ok;
}

bool vm_heat_draw(const struct vm_heat *heat, struct vm_size size, enum vm_plot_style style,
                  struct crt_image *image, struct crt_error *err)
{
    return vm_heat_draw_words(heat, size, style, image, NULL, err);
}
