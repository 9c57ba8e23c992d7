#include "emu/plot/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "emu/plot/curve.h"
#include "emu/plot/legend.h"

const struct vm_size vm_plot_size = {1280, 720};

/* Everything that is decided before anything is drawn. */
struct layout {
    const struct vm_plot *plot;
    struct vm_place place[VM_PLOT_PANELS];
    struct vm_scale x;
    struct vm_ticks ticks;
    double left, right, top, bottom; /* of all panels together */
    double note_y, label_y;          /* base lines */
};

static bool has(const char *text)
{
    return text && text[0];
}

static bool anything(struct layout *l, struct crt_error *err)
{
    const struct vm_plot *plot = l->plot;
    if (plot->panel_count < 1 || plot->panel_count > VM_PLOT_PANELS)
        return crt_fail(err, "a plot has 1 to %d panels, not %d", VM_PLOT_PANELS,
                        plot->panel_count);
    bool any = vm_scale_x(&l->x, plot);
    bool any_y = false;
    for (int i = 0; i < plot->panel_count; i++) {
        l->place[i].panel = &plot->panel[i];
        any_y = vm_scale_y(&l->place[i].y, &plot->panel[i]) || any_y;
    }
    if (!any || !any_y)
        return crt_fail(err, "there is nothing to plot%s%.200s: no sample is a finite number",
                        has(plot->title) ? " for " : "", has(plot->title) ? plot->title : "");
    return true;
}

/* ---- layout --------------------------------------------------------------------------------------- */

static void rows_of_the_sheet(struct layout *l, const struct vm_sheet *sheet, struct vm_size size)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size, pad = look->scope ? 0.35 * t : 0.7 * t;
    l->top = pad + (has(l->plot->title) ? look->title.size * (look->scope ? 1.15 : 1.45) : 0.3 * t);
    l->bottom = size.height - pad;
    if (has(l->plot->note)) {
        int lines = vm_wrapped_lines(look->type, l->plot->note, size.width - 2 * pad);
        l->note_y = l->bottom - 0.3 * t - (lines - 1) * VM_LINE_STEP * t;
        l->bottom = l->note_y - 1.15 * t;
    }
    if (has(l->plot->x.label)) {
        l->label_y = l->bottom - 0.3 * t;
        l->bottom = l->label_y - 1.0 * t;
    }
    l->bottom -= 1.45 * t; /* the numbers */
}

static int labels_up(double height, double t)
{
    int most = (int)(height / (2.2 * t));
    return most < 2 ? 2 : most > 10 ? 10 : most;
}

/* Heights and the numbers beside the panels. */
static void panels_down(struct layout *l, const struct vm_sheet *sheet)
{
    double t = sheet->look.type.size, gap = 0.8 * t, above[VM_PLOT_PANELS], sum = 0;
    int n = l->plot->panel_count;
    for (int i = 0; i < n; i++) {
        struct vm_place *p = &l->place[i];
        above[i] = p->strip > 0             ? p->strip * 1.3 * t + 0.4 * t
                   : p->ticks.exponent != 0 ? 1.25 * t
                                            : 0.0;
        if (i > 0)
            above[i] += gap;
        sum += above[i];
    }
    double height = (l->bottom - l->top - sum) / n, y = l->top;
    for (int i = 0; i < n; i++) {
        struct vm_place *p = &l->place[i];
        y += above[i];
        p->box.y0 = floor(y);
        p->box.y1 = floor(y + height);
        y += height;
        p->y.from = p->box.y1;
        p->y.to = p->box.y0;
        vm_ticks_find(&p->ticks, p->y.log, p->y.low, p->y.high, labels_up(height, t));
    }
}

static double widest(const struct vm_ticks *ticks, struct vm_type type)
{
    double width = 0;
    for (int i = 0; i < ticks->count; i++)
        width = fmax(width, vm_text_width(type, ticks->major[i].label));
    return width;
}

/* Fewer numbers until none touches its neighbour. */
static void numbers_along(struct layout *l, const struct vm_sheet *sheet)
{
    double t = sheet->look.type.size;
    for (int most = 10; most >= 2; most--) {
        bool fits = true;
        double end = -1e30;
        vm_ticks_find(&l->ticks, l->x.log, l->x.low, l->x.high, most);
        for (int i = 0; i < l->ticks.count; i++) {
            double at = vm_scale_place(&l->x, l->ticks.major[i].at);
            double half = vm_text_width(sheet->look.type, l->ticks.major[i].label) / 2;
            fits = fits && at - half >= end + 0.9 * t;
            end = at + half;
        }
        if (fits)
            return;
    }
    l->ticks.count = l->ticks.count > 1 ? 1 : l->ticks.count;
}

static void panels_across(struct layout *l, const struct vm_sheet *sheet, struct vm_size size)
{
    double t = sheet->look.type.size, pad = sheet->look.scope ? 0.35 * t : 0.7 * t, numbers = 0;
    bool label = false;
    for (int i = 0; i < l->plot->panel_count; i++) {
        numbers = fmax(numbers, widest(&l->place[i].ticks, sheet->look.type));
        label = label || has(l->plot->panel[i].y.label);
    }
    l->left = ceil(pad + (label ? 1.45 * t : 0) + numbers + 0.5 * t);
    l->right = size.width - pad;
    for (int round = 0; round < 3; round++) {
        l->x.from = l->left;
        l->x.to = l->right;
        numbers_along(l, sheet);
        double out = 0;
        if (l->ticks.count > 0) {
            const struct vm_tick *last = &l->ticks.major[l->ticks.count - 1];
            out = vm_scale_place(&l->x, last->at) +
                  vm_text_width(sheet->look.type, last->label) / 2 - (size.width - 0.3 * t);
        }
        if (!(out > 0))
            break;
        l->right -= ceil(out);
    }
    l->x.to = l->right = floor(l->right);
    for (int i = 0; i < l->plot->panel_count; i++) {
        l->place[i].box.x0 = l->left;
        l->place[i].box.x1 = l->right;
        l->place[i].x = l->x;
    }
}

static bool large_enough(const struct layout *l, const struct vm_sheet *sheet, struct vm_size size,
                         struct crt_error *err)
{
    double t = sheet->look.type.size, width = 8 * t, height = 2.6 * t;
    double has_w = l->right - l->left, has_h = l->place[0].box.y1 - l->place[0].box.y0;
    if (has_w >= width && has_h >= height)
        return true;
    double more_w = fmax(0, width - has_w), more_h = fmax(0, height - has_h) * l->plot->panel_count;
    return crt_fail(err,
                    "a picture of %dx%d is too small for this plot with letters that can be read; "
                    "%dx%d would do",
                    size.width, size.height, (int)ceil((size.width + more_w * 1.3) / 10) * 10,
                    (int)ceil((size.height + more_h * 1.3) / 10) * 10);
}

static bool lay_out(struct layout *l, struct vm_sheet *sheet, struct vm_size size,
                    struct crt_error *err)
{
    rows_of_the_sheet(l, sheet, size);
    for (int round = 0; round < 2; round++) {
        panels_down(l, sheet);
        panels_down(l, sheet); /* again: exponents need room, which is known only now */
        panels_across(l, sheet, size);
        if (!large_enough(l, sheet, size, err))
            return false;
        bool placed = true;
        for (int i = 0; i < l->plot->panel_count; i++)
            if (!vm_legend_place(sheet, &l->place[i])) {
                l->place[i].strip =
                    vm_legend_strip(&sheet->look, &l->plot->panel[i], l->right - l->left);
                placed = false;
            }
        if (placed)
            break;
    }
    return true;
}

/* ---- drawing -------------------------------------------------------------------------------------- */

/* Lines of a grid fall on whole pixels, so that all are equally sharp. */
static double sharp(double at, double width)
{
    double whole = fmax(1, floor(width + 0.5));
    return floor(at - whole / 2 + 0.5) + whole / 2;
}

static void grid_line(struct vm_sheet *sheet, const struct vm_place *p, bool vertical, double at,
                      double width, struct vm_rgb colour)
{
    double whole = fmax(1, floor(width + 0.5)), middle = sharp(at, width);
    struct vm_rect box =
        vertical ? (struct vm_rect){middle - whole / 2, p->box.y0, middle + whole / 2, p->box.y1}
                 : (struct vm_rect){p->box.x0, middle - whole / 2, p->box.x1, middle + whole / 2};
    vm_ink_box(&sheet->ink, box, colour, 1);
}

static void grid(struct vm_sheet *sheet, const struct vm_place *p, const struct vm_ticks *along)
{
    const struct vm_look *look = &sheet->look;
    vm_ink_box(&sheet->ink, p->box, look->panel, 1);
    vm_ink_clip(&sheet->ink, p->box);
    if (p->x.log || look->scope)
        for (int i = 0; i < along->minor_count; i++)
            grid_line(sheet, p, true, vm_scale_place(&p->x, along->minor[i]), look->fine,
                      look->minor);
    if (p->y.log && p->ticks.minor_count < 60)
        for (int i = 0; i < p->ticks.minor_count; i++)
            grid_line(sheet, p, false, vm_scale_place(&p->y, p->ticks.minor[i]), look->fine,
                      look->minor);
    for (int i = 0; i < along->count; i++)
        grid_line(sheet, p, true, vm_scale_place(&p->x, along->major[i].at), look->fine,
                  look->grid);
    for (int i = 0; i < p->ticks.count; i++)
        grid_line(sheet, p, false, vm_scale_place(&p->y, p->ticks.major[i].at), look->fine,
                  look->grid);
    double zero = p->y.log ? -1 : vm_scale_place(&p->y, 0);
    if (zero > p->box.y0 && zero < p->box.y1)
        grid_line(sheet, p, false, zero, look->line, look->frame);
    vm_ink_unclip(&sheet->ink);
}

static void frame(struct vm_sheet *sheet, const struct vm_place *p)
{
    double w = fmax(1, floor(sheet->look.line + 0.5));
    struct vm_rect b = p->box;
    struct vm_rgb colour = sheet->look.frame;
    vm_ink_box(&sheet->ink, (struct vm_rect){b.x0 - w, b.y0 - w, b.x1 + w, b.y0}, colour, 1);
    vm_ink_box(&sheet->ink, (struct vm_rect){b.x0 - w, b.y1, b.x1 + w, b.y1 + w}, colour, 1);
    vm_ink_box(&sheet->ink, (struct vm_rect){b.x0 - w, b.y0, b.x0, b.y1}, colour, 1);
    vm_ink_box(&sheet->ink, (struct vm_rect){b.x1, b.y0, b.x1 + w, b.y1}, colour, 1);
}

static void curves(struct vm_sheet *sheet, const struct vm_place *p)
{
    const struct vm_plot_panel *panel = p->panel;
    vm_ink_clip(&sheet->ink, p->box);
    for (int i = 0; i < panel->series_count; i++)
        if (panel->series[i].kind == VM_PLOT_AREA) {
            vm_curve_cover_area(&sheet->ink, &panel->series[i], &p->x, &p->y);
            vm_ink_spread(&sheet->ink, sheet->look.series[vm_look_colour(&panel->series[i], i)],
                          0.3);
        }
    vm_marks_draw(sheet, p);
    for (int i = 0; i < panel->series_count; i++) {
        const struct vm_plot_series *s = &panel->series[i];
        vm_curve_cover(&sheet->ink, s, &p->x, &p->y, sheet->look.curve, vm_dash_of(s, i));
        vm_ink_spread(&sheet->ink, sheet->look.series[vm_look_colour(s, i)], 1);
    }
    vm_ink_unclip(&sheet->ink);
}

/* The label turned beside the panel: on two lines or smaller if it is longer than the panel is high. */
static void y_label(struct vm_sheet *sheet, const struct layout *l, const struct vm_place *p)
{
    const struct vm_look *look = &sheet->look;
    const char *text = p->panel->y.label;
    struct vm_type type = look->type;
    double room = p->box.y1 - p->box.y0 + 0.6 * type.size,
           pad = look->scope ? 0.35 * type.size : 0.7 * type.size;
    (void)l;
    if (!has(text))
        return;
    double width = vm_text_width(type, text);
    if (width > room)
        type.size = fmax(type.size * room / width, 9);
    vm_sheet_text(sheet, VM_WORD_Y_LABEL, type, pad + 0.8 * look->type.size,
                  (p->box.y0 + p->box.y1) / 2, VM_MIDDLE, true, text, look->text);
}

static void numbers(struct vm_sheet *sheet, const struct layout *l, const struct vm_place *p)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size;
    char text[40];
    for (int i = 0; i < p->ticks.count; i++)
        vm_sheet_text(sheet, VM_WORD_Y_TICK, look->type, p->box.x0 - 0.45 * t,
                      vm_scale_place(&p->y, p->ticks.major[i].at) + 0.36 * t, VM_RIGHT, false,
                      p->ticks.major[i].label, look->text);
    if (p->ticks.exponent != 0) {
        double up = p->strip > 0 ? p->strip * 1.3 * t + 0.4 * t : 0;
        vm_exponent_text(p->ticks.exponent, text);
        vm_sheet_text(sheet, VM_WORD_EXPONENT, look->type, l->left - 0.45 * t,
                      p->box.y0 - 0.5 * t - up * 0, VM_RIGHT, false, text, look->text);
    }
}

static void words_around(struct vm_sheet *sheet, const struct layout *l)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size, pad = look->scope ? 0.35 * t : 0.7 * t;
    double floor_y = l->place[l->plot->panel_count - 1].box.y1;
    char text[40];
    if (has(l->plot->title))
        vm_sheet_text(sheet, VM_WORD_TITLE, look->title, l->left, pad + 0.85 * look->title.size,
                      VM_LEFT, false, l->plot->title, look->text);
    if (has(l->plot->note))
        vm_sheet_wrapped(sheet, VM_WORD_NOTE, look->type, pad, l->note_y,
                         sheet->image->width - 2 * pad, l->plot->note, look->dim);
    for (int i = 0; i < l->ticks.count; i++)
        vm_sheet_text(sheet, VM_WORD_X_TICK, look->type,
                      vm_scale_place(&l->x, l->ticks.major[i].at), floor_y + 1.2 * t, VM_MIDDLE,
                      false, l->ticks.major[i].label, look->text);
    if (has(l->plot->x.label))
        vm_sheet_text(sheet, VM_WORD_X_LABEL, look->type, (l->left + l->right) / 2, l->label_y,
                      VM_MIDDLE, false, l->plot->x.label, look->text);
    if (l->ticks.exponent != 0) {
        vm_exponent_text(l->ticks.exponent, text);
        vm_sheet_text(sheet, VM_WORD_EXPONENT, look->type, l->right, floor_y + 2.5 * t, VM_RIGHT,
                      false, text, look->text);
    }
}

static void draw(struct vm_sheet *sheet, const struct layout *l)
{
    for (int i = 0; i < l->plot->panel_count; i++) {
        const struct vm_place *p = &l->place[i];
        grid(sheet, p, &l->ticks);
        curves(sheet, p);
        frame(sheet, p);
        vm_legend_draw(sheet, p);
        vm_mark_words_draw(sheet, p);
        y_label(sheet, l, p);
        numbers(sheet, l, p);
        if (sheet->words)
            sheet->words->panel[i] = p->box;
    }
    words_around(sheet, l);
}

bool vm_plot_draw_words(const struct vm_plot *plot, struct vm_size size, enum vm_plot_style style,
                        struct crt_image *image, struct vm_words *words, struct crt_error *err)
{
    *image = (struct crt_image){0};
    struct layout *l = calloc(1, sizeof *l);
    struct vm_sheet *sheet = malloc(sizeof *sheet);
    bool ok = (l && sheet) || crt_fail(err, "not enough memory for a plot");
    if (ok) {
        l->plot = plot;
        ok = anything(l, err) && vm_sheet_open(sheet, image, size, style, words, err);
        if (ok) {
            ok = lay_out(l, sheet, size, err);
            if (ok)
                draw(sheet, l);
            vm_sheet_close(sheet, ok);
        }
    }
    free(l);
    free(sheet);
    return ok;
}

bool vm_plot_draw(const struct vm_plot *plot, struct vm_size size, enum vm_plot_style style,
                  struct crt_image *image, struct crt_error *err)
{
    return vm_plot_draw_words(plot, size, style, image, NULL, err);
}
