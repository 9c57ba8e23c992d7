#include "emu/plot/plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/plot/curve.h"
#include "emu/plot/layout.h"

const struct vm_size vm_plot_size = {1280, 720};

/* ---- panels --------------------------------------------------------------------------------------- */

/* A line of a grid covers whole pixels, so that all are equally sharp. */
static void grid_line(struct vm_sheet *sheet, struct vm_rect box, bool vertical, double at,
                      double width, struct vm_rgb colour)
{
    double whole = fmax(1, floor(width + 0.5)), from = floor(at - whole / 2 + 0.5);
    if (vertical) {
        box.x0 = from;
        box.x1 = from + whole;
    } else {
        box.y0 = from;
        box.y1 = from + whole;
    }
    vm_ink_box(&sheet->ink, box, colour, 1);
}

/* The marked place that is nearest to the middle. */
static double middle(const struct vm_ticks *ticks, const struct vm_scale *scale)
{
    double centre = (scale->from + scale->to) / 2, best = -1e9;
    for (int i = 0; i < ticks->count; i++) {
        double at = vm_scale_place(scale, ticks->major[i].at);
        best = fabs(at - centre) < fabs(best - centre) ? at : best;
    }
    return best;
}

/* The fine divisions of an oscilloscope's graticule: short strokes across its middle lines. */
static void graticule(struct vm_sheet *sheet, const struct vm_place *p,
                      const struct vm_ticks *along)
{
    const struct vm_look *look = &sheet->look;
    double half = 0.22 * look->type.size, x = middle(along, &p->x), y = middle(&p->ticks, &p->y);
    for (int i = 0; i < along->minor_count; i++)
        grid_line(sheet, (struct vm_rect){0, y - half, 0, y + half}, true,
                  vm_scale_place(&p->x, along->minor[i]), look->fine, look->grid);
    for (int i = 0; i < p->ticks.minor_count; i++)
        grid_line(sheet, (struct vm_rect){x - half, 0, x + half, 0}, false,
                  vm_scale_place(&p->y, p->ticks.minor[i]), look->fine, look->grid);
}

static void fine_grid(struct vm_sheet *sheet, const struct vm_place *p,
                      const struct vm_ticks *along)
{
    const struct vm_look *look = &sheet->look;
    if (p->x.log)
        for (int i = 0; i < along->minor_count; i++)
            grid_line(sheet, p->box, true, vm_scale_place(&p->x, along->minor[i]), look->fine,
                      look->minor);
    if (p->y.log && p->ticks.minor_count < 60)
        for (int i = 0; i < p->ticks.minor_count; i++)
            grid_line(sheet, p->box, false, vm_scale_place(&p->y, p->ticks.minor[i]), look->fine,
                      look->minor);
}

static void grid(struct vm_sheet *sheet, const struct vm_place *p, const struct vm_ticks *along)
{
    const struct vm_look *look = &sheet->look;
    vm_ink_box(&sheet->ink, p->box, look->panel, 1);
    vm_ink_clip(&sheet->ink, p->box);
    if (look->scope)
        graticule(sheet, p, along);
    else
        fine_grid(sheet, p, along);
    for (int i = 0; i < along->count; i++)
        grid_line(sheet, p->box, true, vm_scale_place(&p->x, along->major[i].at), look->fine,
                  look->grid);
    for (int i = 0; i < p->ticks.count; i++)
        grid_line(sheet, p->box, false, vm_scale_place(&p->y, p->ticks.major[i].at), look->fine,
                  look->grid);
    double zero = p->y.log ? -1 : vm_scale_place(&p->y, 0);
    if (zero > p->box.y0 && zero < p->box.y1)
        grid_line(sheet, p->box, false, zero, look->line, look->frame);
    vm_ink_unclip(&sheet->ink);
}

static void frame(struct vm_sheet *sheet, const struct vm_place *p)
{
    double w = fmax(1, floor(sheet->look.line + 0.5));
    struct vm_rect b = p->box;
    const struct vm_rect side[4] = {{b.x0 - w, b.y0 - w, b.x1 + w, b.y0},
                                    {b.x0 - w, b.y1, b.x1 + w, b.y1 + w},
                                    {b.x0 - w, b.y0, b.x0, b.y1},
                                    {b.x1, b.y0, b.x1 + w, b.y1}};
    for (int i = 0; i < 4; i++)
        vm_ink_box(&sheet->ink, side[i], sheet->look.frame, 1);
}

static void curves(struct vm_sheet *sheet, const struct vm_place *p)
{
    const struct vm_plot_panel *panel = p->panel;
    const struct vm_look *look = &sheet->look;
    double half = look->curve / 2;
    vm_ink_clip(&sheet->ink, p->box);
    for (int i = 0; i < panel->series_count; i++)
        if (panel->series[i].kind == VM_PLOT_AREA) {
            vm_curve_cover_area(&sheet->ink, &panel->series[i], &p->x, &p->y);
            vm_ink_spread(&sheet->ink, look->series[vm_look_colour(&panel->series[i], i)],
                          look->area);
        }
    vm_marks_draw(sheet, p);
    /* A curve along an edge of the panel keeps its width. */
    vm_ink_clip(&sheet->ink, (struct vm_rect){p->box.x0 - half, p->box.y0 - half, p->box.x1 + half,
                                              p->box.y1 + half});
    for (int i = 0; i < panel->series_count; i++) {
        const struct vm_plot_series *s = &panel->series[i];
        vm_curve_cover(&sheet->ink, s, &p->x, &p->y, look->curve, vm_dash_of(s, i));
        vm_ink_spread(&sheet->ink, look->series[vm_look_colour(s, i)], 1);
    }
    vm_ink_unclip(&sheet->ink);
}

/* ---- words around them ---------------------------------------------------------------------------- */

/* The lines of a label turned beside its panel, the last one nearest to the numbers. */
static void y_label(struct vm_sheet *sheet, const struct vm_layout *l, int i)
{
    const char *text = l->plot->panel[i].y.label;
    const struct vm_place *p = &l->place[i];
    struct vm_type type = l->y_label[i];
    double t = sheet->look.type.size, room = p->box.y1 - p->box.y0 + 0.7 * t;
    char line[256];
    if (!vm_has(text))
        return;
    int lines = vm_wrapped_lines(type, text, room) > 1 ? 2 : 1;
    double x = l->pad + 0.85 * t + 1.25 * t * (l->y_lines - lines);
    for (int k = 0; k < lines; k++) {
        size_t n = k + 1 < lines ? vm_text_fits(type, text, room) : strlen(text);
        char part[256];
        snprintf(part, sizeof part, "%.*s", n < sizeof part ? (int)n : (int)sizeof part - 1, text);
        vm_text_cut(type, part, room, line, sizeof line);
        vm_sheet_text(sheet, VM_WORD_Y_LABEL, type, x, (p->box.y0 + p->box.y1) / 2, VM_MIDDLE, true,
                      line, sheet->look.text);
        text += n;
        text += strspn(text, " ");
        x += 1.25 * t;
    }
}

static void y_numbers(struct vm_sheet *sheet, const struct vm_place *p)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size, x = p->box.x0 - 0.45 * t;
    char text[40];
    for (int i = 0; i < p->ticks.count; i++)
        vm_sheet_text(sheet, VM_WORD_Y_TICK, look->type, x,
                      vm_scale_place(&p->y, p->ticks.major[i].at) + 0.36 * t, VM_RIGHT, false,
                      p->ticks.major[i].label, look->text);
    if (p->ticks.exponent != 0) {
        vm_exponent_text(p->ticks.exponent, text);
        vm_sheet_text(sheet, VM_WORD_EXPONENT, look->type, x, p->box.y0 - 0.7 * t, VM_RIGHT, false,
                      text, look->text);
    }
}

/* The label in the middle, the exponent at the right end. */
static void below(struct vm_sheet *sheet, const struct vm_layout *l)
{
    const struct vm_look *look = &sheet->look;
    struct vm_type type = look->type;
    double t = type.size, numbers_y = l->place[l->plot->panel_count - 1].box.y1 + 1.2 * t,
           exponent = 0;
    char text[256];
    for (int i = 0; i < l->ticks.count; i++)
        vm_sheet_text(sheet, VM_WORD_X_TICK, type, vm_scale_place(&l->x, l->ticks.major[i].at),
                      numbers_y, VM_MIDDLE, false, l->ticks.major[i].label, look->text);
    if (l->ticks.exponent != 0) {
        char power[40];
        vm_exponent_text(l->ticks.exponent, power);
        exponent = vm_text_width(type, power) + t;
        vm_sheet_text(sheet, VM_WORD_EXPONENT, type, l->right, l->label_y, VM_RIGHT, false, power,
                      look->text);
    }
    if (!vm_has(l->plot->x.label))
        return;
    double room = l->right - exponent - l->pad, width = vm_text_width(type, l->plot->x.label);
    vm_text_cut(type, l->plot->x.label, room, text, sizeof text);
    width = fmin(width, room);
    double middle = fmin((l->left + l->right) / 2, l->right - exponent - width / 2);
    vm_sheet_text(sheet, VM_WORD_X_LABEL, type, fmax(middle, l->pad + width / 2), l->label_y,
                  VM_MIDDLE, false, text, look->text);
}

static void draw(struct vm_sheet *sheet, const struct vm_layout *l)
{
    double whole = sheet->image->width - 2 * l->pad;
    for (int i = 0; i < l->plot->panel_count; i++) {
        const struct vm_place *p = &l->place[i];
        grid(sheet, p, &l->ticks);
        frame(sheet, p);
        curves(sheet, p);
        vm_legend_draw(sheet, p);
        vm_mark_words_draw(sheet, p);
        y_label(sheet, l, i);
        y_numbers(sheet, p);
        if (sheet->words)
            sheet->words->panel[i] = p->box;
    }
    below(sheet, l);
    if (vm_has(l->plot->note))
        vm_sheet_wrapped(sheet, VM_WORD_NOTE, sheet->look.type, l->pad, l->note_y, whole,
                         l->plot->note, sheet->look.dim);
    if (l->heading.lines > 0) {
        bool beside =
            l->heading.lines == 1 && l->left + vm_text_width(l->heading.type, l->plot->title) <=
                                         sheet->image->width - l->pad;
        vm_sheet_heading(sheet, &l->heading, beside ? l->left : l->pad, l->pad, whole,
                         l->plot->title);
    }
}

bool vm_plot_draw_words(const struct vm_plot *plot, struct vm_size size, enum vm_plot_style style,
                        struct crt_image *image, struct vm_words *words, struct crt_error *err)
{
    *image = (struct crt_image){0};
    struct vm_layout *layout = calloc(1, sizeof *layout);
    struct vm_sheet *sheet = malloc(sizeof *sheet);
    bool ok = (layout && sheet) || crt_fail(err, "not enough memory for a plot");
    ok = ok && vm_layout_begin(layout, plot, err);
    if (ok) {
        ok = vm_sheet_open(sheet, image, size, style, words, err);
        if (ok) {
            ok = vm_layout_find(layout, sheet, err);
            if (ok)
                draw(sheet, layout);
            vm_sheet_close(sheet, ok);
        }
    }
    free(layout);
    free(sheet);
    return ok;
}

bool vm_plot_draw(const struct vm_plot *plot, struct vm_size size, enum vm_plot_style style,
                  struct crt_image *image, struct crt_error *err)
{
    return vm_plot_draw_words(plot, size, style, image, NULL, err);
}
