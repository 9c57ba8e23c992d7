#include "emu/plot/layout.h"

#include <math.h>

/* All of the size of letters; estimates, by eye. */
#define LEAST_WIDTH  8.0  /* of a panel */
#define LEAST_HEIGHT 2.4  /* of a panel */
#define APART        1.1  /* panel from panel */
#define STRIP        1.3  /* a line of a legend above a panel */
#define EXPONENT     1.55 /* an exponent above a panel */
#define SMALLEST     0.6  /* letters of crowded plots, of the style's */
#define LABEL_LEAST  0.7  /* how small the label of a low panel may become */

bool vm_layout_begin(struct vm_layout *l, const struct vm_plot *plot, struct crt_error *err)
{
    l->plot = plot;
    if (plot->panel_count < 1 || plot->panel_count > VM_PLOT_PANELS)
        return crt_fail(err, "a plot has 1 to %d panels, not %d", VM_PLOT_PANELS,
                        plot->panel_count);
    bool any_x = vm_scale_x(&l->x, plot), any_y = false;
    for (int i = 0; i < plot->panel_count; i++) {
        l->place[i].panel = &plot->panel[i];
        any_y = vm_scale_y(&l->place[i].y, &plot->panel[i]) || any_y;
    }
    if (!any_x || !any_y)
        return crt_fail(err, "there is nothing to plot%s%.200s: no sample is a finite number",
                        vm_has(plot->title) ? " for " : "", vm_has(plot->title) ? plot->title : "");
    return true;
}

static void rows(struct vm_layout *l, const struct vm_look *look, struct vm_size size)
{
    double t = look->type.size;
    l->pad = look->scope ? 0.35 * t : 0.7 * t;
    l->heading = vm_heading_of(look, l->plot->title, size.width - 2 * l->pad);
    l->top = l->pad + (l->heading.lines ? l->heading.height : 0.3 * t);
    l->bottom = size.height - l->pad;
    if (vm_has(l->plot->note)) {
        int lines = vm_wrapped_lines(look->type, l->plot->note, size.width - 2 * l->pad);
        l->note_y = l->bottom - 0.3 * t - (lines - 1) * VM_LINE_STEP * t;
        l->bottom = l->note_y - 1.15 * t;
    }
    /* The exponent of x stands on the line of the label. */
    if (vm_has(l->plot->x.label) || l->ticks.exponent != 0) {
        l->label_y = l->bottom - 0.3 * t;
        l->bottom = l->label_y - 1.0 * t;
    }
    l->bottom -= 1.5 * t; /* the numbers */
}

/* The least distance of two neighbouring numbers up an axis. */
static double nearest(const struct vm_ticks *ticks, const struct vm_scale *scale)
{
    double least = 1e30;
    for (int i = 1; i < ticks->count; i++)
        least = fmin(least, fabs(vm_scale_place(scale, ticks->major[i].at) -
                                 vm_scale_place(scale, ticks->major[i - 1].at)));
    return least;
}

/* As many numbers as stand at ease; if that is less than three, as many as do not touch. */
static void numbers_up(struct vm_ticks *ticks, const struct vm_scale *scale, double t)
{
    for (int most = 10; most >= 2; most--) {
        vm_ticks_find(ticks, scale->log, scale->low, scale->high, most);
        if (ticks->count >= 3 && nearest(ticks, scale) >= 2.0 * t)
            return;
    }
    for (int most = 10; most >= 2; most--) {
        vm_ticks_find(ticks, scale->log, scale->low, scale->high, most);
        if (nearest(ticks, scale) >= 1.15 * t)
            return;
    }
    ticks->count = ticks->count > 1 ? 1 : ticks->count;
}

static double above(const struct vm_place *p, double t)
{
    return p->strip > 0             ? (p->strip * STRIP + 0.4) * t
           : p->ticks.exponent != 0 ? EXPONENT * t
                                    : 0.0;
}

static void panels_down(struct vm_layout *l, const struct vm_look *look)
{
    double t = look->type.size, sum = 0, y = l->top;
    int n = l->plot->panel_count;
    for (int i = 0; i < n; i++)
        sum += above(&l->place[i], t) + (i > 0 ? APART * t : 0);
    double height = fmax((l->bottom - l->top - sum) / n, 1);
    for (int i = 0; i < n; i++) {
        struct vm_place *p = &l->place[i];
        y += above(p, t) + (i > 0 ? APART * t : 0);
        p->box.y0 = floor(y);
        p->box.y1 = floor(y + height);
        y += height;
        p->y.from = p->box.y1;
        p->y.to = p->box.y0;
    }
    for (int i = 0; i < n; i++)
        numbers_up(&l->place[i].ticks, &l->place[i].y, t);
}

/* Labels beside panels: on two lines where one is too long, then smaller. */
static void labels_beside(struct vm_layout *l, const struct vm_look *look)
{
    l->y_lines = 0;
    for (int i = 0; i < l->plot->panel_count; i++) {
        const char *text = l->plot->panel[i].y.label;
        struct vm_type *type = &l->y_label[i];
        double room = l->place[i].box.y1 - l->place[i].box.y0 + 0.7 * look->type.size;
        *type = look->type;
        if (!vm_has(text))
            continue;
        int lines = vm_wrapped_lines(*type, text, room);
        while (lines > 2 && type->size > LABEL_LEAST * look->type.size) {
            type->size *= 0.95;
            lines = vm_wrapped_lines(*type, text, room);
        }
        lines = lines > 2 ? 2 : lines;
        l->y_lines = lines > l->y_lines ? lines : l->y_lines;
    }
}

static double widest(const struct vm_ticks *ticks, struct vm_type type)
{
    double width = 0;
    char text[40];
    for (int i = 0; i < ticks->count; i++)
        width = fmax(width, vm_text_width(type, ticks->major[i].label));
    if (ticks->exponent != 0) {
        vm_exponent_text(ticks->exponent, text);
        width = fmax(width, vm_text_width(type, text));
    }
    return width;
}

static bool numbers_fit(const struct vm_layout *l, struct vm_type type, double gap)
{
    double end = -1e30;
    for (int i = 0; i < l->ticks.count; i++) {
        double at = vm_scale_place(&l->x, l->ticks.major[i].at);
        double half = vm_text_width(type, l->ticks.major[i].label) / 2;
        if (at - half < end + gap)
            return false;
        end = at + half;
    }
    return true;
}

static void numbers_along(struct vm_layout *l, struct vm_type type)
{
    for (int most = 10; most >= 2; most--) {
        vm_ticks_find(&l->ticks, l->x.log, l->x.low, l->x.high, most);
        if (l->ticks.count >= 3 && numbers_fit(l, type, 0.9 * type.size))
            return;
    }
    for (int most = 10; most >= 2; most--) {
        vm_ticks_find(&l->ticks, l->x.log, l->x.low, l->x.high, most);
        if (numbers_fit(l, type, 0.5 * type.size))
            return;
    }
    l->ticks.count = l->ticks.count > 1 ? 1 : l->ticks.count;
}

/* How far the last number would stand out of the picture. */
static double stands_out(const struct vm_layout *l, struct vm_type type, double width)
{
    if (l->ticks.count == 0)
        return 0;
    const struct vm_tick *last = &l->ticks.major[l->ticks.count - 1];
    return vm_scale_place(&l->x, last->at) + vm_text_width(type, last->label) / 2 -
           (width - 0.3 * type.size);
}

static void panels_across(struct vm_layout *l, const struct vm_look *look, struct vm_size size)
{
    double t = look->type.size, numbers = 0;
    for (int i = 0; i < l->plot->panel_count; i++)
        numbers = fmax(numbers, widest(&l->place[i].ticks, look->type));
    double labels = l->y_lines == 0 ? 0 : (0.2 + 1.25 * l->y_lines) * t;
    l->left = ceil(l->pad + labels + numbers + 0.5 * t);
    l->right = floor(size.width - l->pad);
    for (int round = 0; round < 4; round++) {
        l->x.from = l->left;
        l->x.to = l->right;
        numbers_along(l, look->type);
        double out = stands_out(l, look->type, size.width);
        if (!(out > 0) || l->right - out <= l->left)
            break;
        l->right -= ceil(out);
    }
    l->x.to = l->right;
    for (int i = 0; i < l->plot->panel_count; i++) {
        l->place[i].box.x0 = l->left;
        l->place[i].box.x1 = l->right;
        l->place[i].x = l->x;
    }
}

/* What is wanting of the least size of panels. */
static struct vm_size arrange(struct vm_layout *l, const struct vm_look *look, struct vm_size size)
{
    double t = look->type.size;
    /* Exponents need room, and whether there are any is known only when there are panels. */
    for (int round = 0; round < 3; round++) {
        rows(l, look, size);
        panels_down(l, look);
        labels_beside(l, look);
        panels_across(l, look, size);
    }
    double more_w = LEAST_WIDTH * t - (l->right - l->left);
    double more_h = LEAST_HEIGHT * t - (l->place[0].box.y1 - l->place[0].box.y0);
    return (struct vm_size){(int)ceil(fmax(more_w, 0)),
                            (int)ceil(fmax(more_h, 0)) * l->plot->panel_count};
}

static void strips(struct vm_layout *l, const struct vm_look *look)
{
    for (int i = 0; i < l->plot->panel_count; i++)
        l->place[i].strip = vm_legend_strip(
            look, &l->plot->panel[i], fmax(l->right - l->left, LEAST_WIDTH * look->type.size));
}

/* What is wanting when every panel has its legend above it, with the smallest letters. */
static struct vm_size wanting(struct vm_layout *l, enum vm_plot_style style, struct vm_size size)
{
    struct vm_look look = vm_look_of(style, size);
    vm_look_shrink(&look, SMALLEST);
    for (int round = 0; round < 2; round++) {
        arrange(l, &look, size); /* the lines of a legend follow from the width of the panels */
        strips(l, &look);
    }
    return arrange(l, &look, size);
}

static bool too_small(struct vm_layout *l, enum vm_plot_style style, struct vm_size size,
                      struct crt_error *err)
{
    struct vm_size enough = size, more = wanting(l, style, enough);
    while ((more.width > 0 || more.height > 0) && enough.width < CRT_IMAGE_MAX_SIDE &&
           enough.height < CRT_IMAGE_MAX_SIDE) {
        /* Letters grow with the height, so lines of words become fewer only with the width. */
        enough.width += 10 + enough.width / 10;
        enough.height += more.height > 0 ? 10 + enough.height / 10 : 0;
        more = wanting(l, style, enough);
    }
    if (more.width > 0 || more.height > 0)
        return crt_fail(err, "this plot has too many panels and labels for a picture; take fewer");
    return crt_fail(err,
                    "a picture of %dx%d is too small for this plot with letters that can be read; "
                    "%dx%d would do",
                    size.width, size.height, (enough.width + 9) / 10 * 10,
                    (enough.height + 9) / 10 * 10);
}

/* With the sheet's letters; false when there is too little room for them. */
static bool find(struct vm_layout *l, struct vm_sheet *sheet, struct vm_size size)
{
    for (int i = 0; i < l->plot->panel_count; i++)
        l->place[i].strip = 0;
    /* A strip above one panel moves the others, whose legends may then need one too. */
    for (int round = 0; round <= l->plot->panel_count; round++) {
        struct vm_size more = arrange(l, &sheet->look, size);
        if (more.width > 0 || more.height > 0)
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

bool vm_layout_find(struct vm_layout *l, struct vm_sheet *sheet, struct crt_error *err)
{
    struct vm_size size = {sheet->image->width, sheet->image->height};
    const struct vm_look wished = sheet->look;
    for (double share = 1; share > SMALLEST - 0.05; share -= 0.1) {
        sheet->look = wished;
        vm_look_shrink(&sheet->look, share);
        if (find(l, sheet, size))
            return true;
    }
    return too_small(l, wished.style, size, err);
}
