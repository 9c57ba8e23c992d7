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
    struct vm_look look;      /* letters smaller than the style's where there are many rows */
    struct vm_type cell, row; /* of the cells and of the rows' names */
    struct vm_heading heading;
    bool turned; /* the names of columns */
    double pad, left, top, right, bottom, cell_w, cell_h;
    double note_y, label_y, bar_y; /* base lines */
};

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
        if (vm_has(heat->cells[i].text))
            width = fmax(width, vm_text_width(type, heat->cells[i].text));
    return width;
}

/* ---- colours -------------------------------------------------------------------------------------- */

/* From pale blue through yellow and red to dark red; lightness only falls, so the order survives in grey print, and
 * blue against yellow and red is told apart by most of the colour-blind. Anchors: ColorBrewer's Blues and YlOrRd
 * (C. Brewer, M. Harrower, 2003). */
static struct vm_rgb colour_of(double value)
{
    static const double anchor[6][3] = {{222, 235, 247}, {254, 217, 118}, {253, 170, 72},
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

static void rows_around(struct table *t, struct vm_size size)
{
    const struct vm_heat *h = t->heat;
    double s = t->look.type.size, whole = size.width - 2 * t->pad;
    t->heading = vm_heading_of(&t->look, h->title, whole);
    t->top = t->pad + t->heading.height;
    if (vm_has(h->low) || vm_has(h->high)) {
        t->bar_y = t->top + 0.9 * s;
        t->top += 1.6 * s;
    }
    t->bottom = size.height - t->pad;
    if (vm_has(h->note)) {
        int lines = vm_wrapped_lines(t->look.type, h->note, whole);
        t->note_y = t->bottom - 0.3 * s - (lines - 1) * VM_LINE_STEP * s;
        t->bottom = t->note_y - 1.15 * s;
    }
    if (vm_has(h->x_label)) {
        t->label_y = t->bottom - 0.3 * s;
        t->bottom = t->label_y - s;
    }
}

/* Cells, then the letters that fit into them. */
static void cells_within(struct table *t, struct vm_size size)
{
    const struct vm_heat *h = t->heat;
    double s = t->look.type.size, below = 1.5 * s,
           columns = widest(h->columns, h->column_count, t->look.type);
    for (int round = 0; round < 2; round++) {
        t->cell_h = fmax(floor((t->bottom - below - t->top) / h->row_count), 1);
        t->row = t->look.type;
        t->row.size = fmin(s, t->cell_h / ROW);
        t->left = floor(t->pad + (vm_has(h->y_label) ? 1.5 * s : 0) +
                        widest(h->rows, h->row_count, t->row) + 0.6 * s);
        t->right = size.width - t->pad;
        t->cell_w = fmax(floor((t->right - t->left) / h->column_count), 1);
        t->turned = columns > t->cell_w - 0.5 * s;
        if (!t->turned)
            break;
        below = columns + 0.9 * s;
    }
    t->top = floor(t->top);
    /* Whole pixels of cells leave a rest; it goes below. */
    t->label_y = fmin(t->label_y, t->top + h->row_count * t->cell_h + below + s);
    t->cell = t->row;
    double text = widest_cell(h, t->cell), room = fmax(t->cell_w - BESIDE * t->cell.size, 0);
    if (text > room)
        t->cell.size *= room / text;
}

/* Whether all letters are large enough to be read. */
static bool arrange(struct table *t, enum vm_plot_style style, struct vm_size size)
{
    bool texts = widest_cell(t->heat, (struct vm_type){LEGIBLE, 1}) > 0;
    t->look = vm_look_of(style, size);
    for (double share = 1; share > 0.45; share -= 0.1) {
        struct vm_look look = vm_look_of(style, size);
        look.type.size = fmax(look.type.size * share, LEGIBLE + 2);
        look.title.size = fmax(look.title.size * share, LEGIBLE + 3);
        t->look = look;
        t->pad = 0.7 * look.type.size;
        rows_around(t, size);
        cells_within(t, size);
        /* Letters around the table that dwarf those in it take its room. */
        bool balanced = t->row.size >= 0.6 * look.type.size || share < 0.6;
        if (balanced && t->row.size >= LEGIBLE && (!texts || t->cell.size >= LEGIBLE) &&
            t->cell_w >= LEGIBLE && (!t->turned || t->cell_w >= look.type.size))
            return true;
    }
    return false;
}

static bool lay_out(struct table *t, enum vm_plot_style style, struct vm_size size,
                    struct crt_error *err)
{
    struct vm_size enough = size;
    if (arrange(t, style, size))
        return true;
    for (int round = 0; round < 200 && !arrange(t, style, enough); round++) {
        bool low = t->row.size < LEGIBLE,
             narrow = t->cell.size < LEGIBLE || t->cell_w < t->look.type.size;
        enough.height += low || !narrow ? 10 + enough.height / 20 : 0;
        enough.width += narrow || !low ? 10 + enough.width / 20 : 0;
    }
    return crt_fail(err,
                    "a picture of %dx%d is too small for %d rows and %d columns that can be read; "
                    "%dx%d would do",
                    size.width, size.height, t->heat->row_count, t->heat->column_count,
                    (enough.width + 9) / 10 * 10, (enough.height + 9) / 10 * 10);
}

/* ---- drawing -------------------------------------------------------------------------------------- */

/* Light letters look bolder than dark ones; estimate, by eye. */
#define LIGHT 0.85

static void cell(struct vm_sheet *sheet, const struct table *t, int r, int c)
{
    const struct vm_heat_cell *cell = &t->heat->cells[r * t->heat->column_count + c];
    double x = t->left + c * t->cell_w, y = t->top + r * t->cell_h, gap = t->cell_h > 24 ? 1 : 0.5;
    struct vm_rgb colour = colour_of(cell->value), letters = letters_on(&sheet->ink, colour);
    struct vm_type type = t->cell;
    vm_ink_box(&sheet->ink,
               (struct vm_rect){x + gap, y + gap, x + t->cell_w - gap, y + t->cell_h - gap}, colour,
               1);
    if (!vm_has(cell->text))
        return;
    type.weight *= letters.r ? LIGHT : 1;
    vm_sheet_text(sheet, VM_WORD_CELL, type, x + t->cell_w / 2,
                  y + t->cell_h / 2 + 0.33 * type.size, VM_MIDDLE, false, cell->text, letters);
}

static void names(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    struct vm_rgb colour = t->look.text;
    double s = t->look.type.size, floor_y = t->top + h->row_count * t->cell_h;
    for (int r = 0; r < h->row_count; r++)
        if (vm_has(h->rows[r]))
            vm_sheet_text(sheet, VM_WORD_Y_TICK, t->row, t->left - 0.5 * s,
                          t->top + (r + 0.5) * t->cell_h + 0.33 * t->row.size, VM_RIGHT, false,
                          h->rows[r], colour);
    for (int c = 0; c < h->column_count; c++) {
        double x = t->left + (c + 0.5) * t->cell_w;
        if (!vm_has(h->columns[c]))
            continue;
        if (t->turned)
            vm_sheet_text(sheet, VM_WORD_X_TICK, t->look.type, x + 0.36 * s, floor_y + 0.45 * s,
                          VM_RIGHT, true, h->columns[c], colour);
        else
            vm_sheet_text(sheet, VM_WORD_X_TICK, t->look.type, x, floor_y + 1.2 * s, VM_MIDDLE,
                          false, h->columns[c], colour);
    }
}

/* "low [colours] high", above the right end of the table. */
static void bar(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    struct vm_type type = t->look.type;
    double s = type.size, end = t->left + h->column_count * t->cell_w, length = 10 * s;
    if (!vm_has(h->low) && !vm_has(h->high))
        return;
    double high = vm_has(h->high) ? vm_text_width(type, h->high) + 0.6 * s : 0,
           x1 = floor(end - high);
    double low = vm_has(h->low) ? vm_text_width(type, h->low) + 0.6 * s : 0;
    double x0 = fmax(x1 - floor(length), floor(t->pad + low));
    double top = floor(t->bar_y - 0.78 * s), bottom = floor(t->bar_y + 0.08 * s);
    if (vm_has(h->high))
        vm_sheet_text(sheet, VM_WORD_SCALE, type, end, t->bar_y, VM_RIGHT, false, h->high,
                      t->look.text);
    for (double x = x0; x < x1; x++)
        vm_ink_box(&sheet->ink, (struct vm_rect){x, top, x + 1, bottom},
                   colour_of((x - x0 + 0.5) / (x1 - x0)), 1);
    if (vm_has(h->low))
        vm_sheet_text(sheet, VM_WORD_SCALE, type, x0 - 0.6 * s, t->bar_y, VM_RIGHT, false, h->low,
                      t->look.text);
}

static void draw(struct vm_sheet *sheet, const struct table *t)
{
    const struct vm_heat *h = t->heat;
    double s = t->look.type.size, whole = sheet->image->width - 2 * t->pad;
    double width = h->column_count * t->cell_w, height = h->row_count * t->cell_h;
    char text[256];
    for (int r = 0; r < h->row_count; r++)
        for (int c = 0; c < h->column_count; c++)
            cell(sheet, t, r, c);
    names(sheet, t);
    bar(sheet, t);
    if (t->heading.lines > 0)
        vm_sheet_heading(sheet, &t->heading, t->pad, t->pad, whole, h->title);
    if (vm_has(h->note))
        vm_sheet_wrapped(sheet, VM_WORD_NOTE, t->look.type, t->pad, t->note_y, whole, h->note,
                         t->look.dim);
    if (vm_has(h->x_label)) {
        vm_text_cut(t->look.type, h->x_label, width, text, sizeof text);
        vm_sheet_text(sheet, VM_WORD_X_LABEL, t->look.type, t->left + width / 2, t->label_y,
                      VM_MIDDLE, false, text, t->look.text);
    }
    if (vm_has(h->y_label)) {
        vm_text_cut(t->look.type, h->y_label, height, text, sizeof text);
        vm_sheet_text(sheet, VM_WORD_Y_LABEL, t->look.type, t->pad + 0.8 * s, t->top + height / 2,
                      VM_MIDDLE, true, text, t->look.text);
    }
}

bool vm_heat_draw_words(const struct vm_heat *heat, struct vm_size size, enum vm_plot_style style,
                        struct crt_image *image, struct vm_words *words, struct crt_error *err)
{
    *image = (struct crt_image){0};
    if (heat->row_count < 1 || heat->column_count < 1)
        return crt_fail(err, "there is nothing to show%s%.200s: the table is empty",
                        vm_has(heat->title) ? " for " : "", vm_has(heat->title) ? heat->title : "");
    struct vm_sheet *sheet = malloc(sizeof *sheet);
    if (!sheet)
        return crt_fail(err, "not enough memory for a plot");
    struct table table = {.heat = heat};
    bool ok = vm_sheet_open(sheet, image, size, style, words, err);
    if (ok) {
        ok = lay_out(&table, style, size, err);
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
