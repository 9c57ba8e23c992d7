#include "emu/plot/legend.h"

#include <math.h>

#include "emu/plot/curve.h"

/* Of the size of letters. */
#define SAMPLE 2.4 /* length of a legend's piece of curve */
#define GAP    0.5
#define STEP   1.3 /* from line to line */

int vm_dash_of(const struct vm_plot_series *series, int order)
{
    bool again = series->colour < 0 && order >= VM_COLOURS;
    return series->dashed || again ? 1 + order % 4 : 0;
}

/* A label that is longer than `room` is cut. */
static double entry_width(const struct vm_look *look, const struct vm_plot_series *s, double room)
{
    double before = (SAMPLE + GAP) * look->type.size;
    return before + fmin(vm_text_width(look->type, s->label), fmax(room - before, 0));
}

static bool listed(const struct vm_plot_series *s)
{
    return s->label && s->label[0];
}

/* ---- places --------------------------------------------------------------------------------------- */

static struct vm_rect legend_size(const struct vm_look *look, const struct vm_plot_panel *panel)
{
    double t = look->type.size, width = 0;
    int lines = 0;
    for (int i = 0; i < panel->series_count; i++)
        if (listed(&panel->series[i])) {
            width = fmax(width, entry_width(look, &panel->series[i], 1e9));
            lines++;
        }
    if (lines == 0)
        return (struct vm_rect){0, 0, 0, 0};
    return (struct vm_rect){0, 0, width + 1.2 * t, lines * STEP * t + 0.5 * t};
}

static struct vm_rect moved(struct vm_rect r, double x, double y)
{
    return (struct vm_rect){r.x0 + x, r.y0 + y, r.x1 + x, r.y1 + y};
}

static bool inside(struct vm_rect a, struct vm_rect b)
{
    return a.x0 >= b.x0 && a.y0 >= b.y0 && a.x1 <= b.x1 && a.y1 <= b.y1;
}

/* The legend's box at column i and row j of a raster of places. */
#define COLUMNS 5
#define ROWS    4
static bool legend_within(struct vm_sheet *sheet, struct vm_place *place)
{
    /* Corners before edges before the middle: right to left, top to bottom. */
    static const int column[COLUMNS] = {4, 0, 3, 1, 2}, row[ROWS] = {0, 3, 1, 2};
    struct vm_rect size = legend_size(&sheet->look, place->panel), in = place->box;
    double gap = 0.4 * sheet->look.type.size;
    double free_x = in.x1 - in.x0 - 2 * gap - size.x1, free_y = in.y1 - in.y0 - 2 * gap - size.y1;
    place->legend = size;
    if (size.x1 == 0)
        return true;
    if (free_x < 0 || free_y < 0 || size.y1 > 0.6 * (in.y1 - in.y0))
        return false;
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++) {
            place->legend = moved(size, in.x0 + gap + free_x * column[i] / (COLUMNS - 1),
                                  in.y0 + gap + free_y * row[j] / (ROWS - 1));
            if (!(vm_ink_covered(&sheet->ink, place->legend, 1e-6) > 0))
                return true;
        }
    return false;
}

/* Place k of a mark's word; false when there are no more. Beside a vertical line: level in the upper third, turned along
 * the line, level further down. */
#define UPPER  8
#define TURNED 24
static bool candidate(const struct vm_look *look, const struct vm_place *place,
                      const struct vm_plot_mark *mark, int k, struct vm_rect *box, bool *turned)
{
    double t = look->type.size, gap = 0.4 * t,
           at = vm_scale_place(mark->vertical ? &place->x : &place->y, mark->at);
    double width = vm_text_width(look->type, mark->label) + 0.4 * t, height = 1.2 * t;
    struct vm_rect in = place->box;
    *turned = mark->vertical && k >= UPPER && k < TURNED;
    if (!mark->vertical) {
        double x = in.x1 - gap - width - (k / 2) * 0.5 * t,
               y = k % 2 ? at + 0.15 * t : at - 0.15 * t - height;
        *box = (struct vm_rect){x, y, x + width, y + height};
        return x >= in.x0;
    }
    int row = (k < UPPER ? k : *turned ? k - UPPER : k - TURNED + UPPER) / 2;
    double y = in.y0 + gap + row * (*turned ? 1.0 : 0.5) * height,
           across = *turned ? height : width;
    double down = *turned ? width : height, x = k % 2 ? at - gap - across : at + gap;
    *box = (struct vm_rect){x, y, x + across, y + down};
    return k < TURNED || y + down <= in.y1;
}

static bool taken(const struct vm_place *place, int marks, struct vm_rect box)
{
    if (place->legend.x1 > place->legend.x0 && place->strip == 0 &&
        vm_rects_meet(box, place->legend))
        return true;
    for (int i = 0; i < marks; i++)
        if (place->word[i].x1 > place->word[i].x0 && vm_rects_meet(box, place->word[i]))
            return true;
    return false;
}

static void place_word(struct vm_sheet *sheet, struct vm_place *place, int i)
{
    const struct vm_plot_mark *mark = &place->panel->mark[i];
    struct vm_rect box;
    place->word[i] = (struct vm_rect){0, 0, 0, 0};
    if (!mark->label || !mark->label[0])
        return;
    double at = vm_scale_place(mark->vertical ? &place->x : &place->y, mark->at);
    double low = mark->vertical ? place->box.x0 : place->box.y0,
           high = mark->vertical ? place->box.x1 : place->box.y1;
    if (!(at >= low - 1 && at <= high + 1))
        return;
    double least = 1e30;
    bool turned;
    for (int k = 0; least > 0 && candidate(&sheet->look, place, mark, k, &box, &turned); k++) {
        if (!inside(box, place->box) || taken(place, i, box))
            continue;
        double hidden = vm_ink_covered(&sheet->ink, box, least);
        if (hidden < least) {
            least = hidden;
            place->word[i] = box;
            place->turned[i] = turned;
        }
    }
}

static void cover_mark(struct vm_sheet *sheet, const struct vm_place *place,
                       const struct vm_plot_mark *mark, bool dashed)
{
    struct vm_ink_pen pen = vm_curve_pen(sheet->look.line * 1.4, dashed);
    double at = vm_scale_place(mark->vertical ? &place->x : &place->y, mark->at);
    struct vm_rect in = place->box;
    vm_ink_to(&sheet->ink, &pen, mark->vertical ? at : in.x0, mark->vertical ? in.y0 : at);
    vm_ink_to(&sheet->ink, &pen, mark->vertical ? at : in.x1, mark->vertical ? in.y1 : at);
}

bool vm_legend_place(struct vm_sheet *sheet, struct vm_place *place)
{
    const struct vm_plot_panel *panel = place->panel;
    vm_ink_clip(&sheet->ink, place->box);
    for (int i = 0; i < panel->series_count; i++) {
        vm_curve_cover(&sheet->ink, &panel->series[i], &place->x, &place->y, sheet->look.curve * 2,
                       0);
        if (panel->series[i].kind == VM_PLOT_AREA)
            vm_curve_cover_area(&sheet->ink, &panel->series[i], &place->x, &place->y);
    }
    for (int i = 0; i < panel->mark_count; i++)
        cover_mark(sheet, place, &panel->mark[i], false);
    bool ok = place->strip > 0 || legend_within(sheet, place);
    for (int i = 0; i < panel->mark_count; i++)
        place_word(sheet, place, i);
    vm_ink_unclip(&sheet->ink);
    vm_ink_forget(&sheet->ink);
    return ok;
}

int vm_legend_strip(const struct vm_look *look, const struct vm_plot_panel *panel, double width)
{
    double x = 0;
    int lines = 0;
    for (int i = 0; i < panel->series_count; i++) {
        if (!listed(&panel->series[i]))
            continue;
        double w = entry_width(look, &panel->series[i], width);
        if (lines == 0 || x + w > width) {
            lines++;
            x = 0;
        }
        x += w + 1.5 * look->type.size;
    }
    return lines;
}

/* ---- drawing -------------------------------------------------------------------------------------- */

/* A piece of the curve and its label; x is the left end, y the base line. */
static void entry(struct vm_sheet *sheet, const struct vm_plot_series *s, int order, double x,
                  double y, double room)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size, middle = y - 0.3 * t;
    struct vm_rgb colour = look->series[vm_look_colour(s, order)];
    struct vm_ink_pen pen = vm_curve_pen(look->curve, vm_dash_of(s, order));
    if (s->kind == VM_PLOT_AREA)
        vm_ink_box(&sheet->ink, (struct vm_rect){x, middle, x + SAMPLE * t, middle + 0.35 * t},
                   colour, 0.3);
    if (s->kind == VM_PLOT_DOTS) {
        for (int i = 0; i < 3; i++) {
            double at = x + (0.3 + 0.9 * i) * t;
            vm_ink_segment(&sheet->ink, at, middle, at, middle, look->curve * 2.6);
        }
    } else {
        vm_ink_to(&sheet->ink, &pen, x + pen.width / 2, middle);
        vm_ink_to(&sheet->ink, &pen, x + SAMPLE * t - pen.width / 2, middle);
    }
    vm_ink_spread(&sheet->ink, colour, 1);
    char label[256];
    double start = x + (SAMPLE + GAP) * t;
    vm_text_cut(look->type, s->label, room - (SAMPLE + GAP) * t, label, sizeof label);
    vm_text_draw(&sheet->ink, look->type, start, y, false, label, look->text);
    struct vm_rect box = vm_text_box(look->type, start, y, VM_LEFT, false, label);
    vm_sheet_note(sheet, VM_WORD_LEGEND, (struct vm_rect){x, box.y0, box.x1, box.y1});
}

static void strip(struct vm_sheet *sheet, const struct vm_place *place)
{
    double t = sheet->look.type.size, x = place->box.x0;
    double y = place->box.y0 - 0.55 * t - (place->strip - 1) * STEP * t;
    for (int i = 0; i < place->panel->series_count; i++) {
        const struct vm_plot_series *s = &place->panel->series[i];
        if (!listed(s))
            continue;
        double w = entry_width(&sheet->look, s, place->box.x1 - place->box.x0);
        if (x > place->box.x0 && x + w > place->box.x1) {
            x = place->box.x0;
            y += STEP * t;
        }
        entry(sheet, s, i, x, y, place->box.x1 - place->box.x0);
        x += w + 1.5 * t;
    }
}

static void legend_frame(struct vm_sheet *sheet, struct vm_rect r)
{
    double w = fmax(1, floor(sheet->look.fine + 0.5));
    struct vm_rect outer = {floor(r.x0), floor(r.y0), floor(r.x1), floor(r.y1)};
    vm_ink_box(&sheet->ink, outer, sheet->look.grid, 1);
    vm_ink_box(&sheet->ink,
               (struct vm_rect){outer.x0 + w, outer.y0 + w, outer.x1 - w, outer.y1 - w},
               sheet->look.panel, 1);
}

void vm_legend_draw(struct vm_sheet *sheet, const struct vm_place *place)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size;
    if (place->strip > 0) {
        strip(sheet, place);
        return;
    }
    if (!(place->legend.x1 > place->legend.x0))
        return;
    legend_frame(sheet, place->legend);
    double y = place->legend.y0 + 0.25 * t + 0.95 * t;
    for (int i = 0; i < place->panel->series_count; i++)
        if (listed(&place->panel->series[i])) {
            entry(sheet, &place->panel->series[i], i, place->legend.x0 + 0.6 * t, y, 1e9);
            y += STEP * t;
        }
}

void vm_marks_draw(struct vm_sheet *sheet, const struct vm_place *place)
{
    for (int i = 0; i < place->panel->mark_count; i++) {
        cover_mark(sheet, place, &place->panel->mark[i], true);
        vm_ink_spread(&sheet->ink, sheet->look.text, 1);
    }
}

void vm_mark_words_draw(struct vm_sheet *sheet, const struct vm_place *place)
{
    const struct vm_look *look = &sheet->look;
    double t = look->type.size;
    for (int i = 0; i < place->panel->mark_count; i++) {
        struct vm_rect box = place->word[i];
        if (!(box.x1 > box.x0))
            continue;
        vm_sheet_note(sheet, VM_WORD_MARK, box);
        bool turned = place->turned[i];
        double x = turned ? floor(box.x0 + 0.88 * t) + 0.5 : box.x0 + 0.2 * t;
        double y = turned ? box.y1 - 0.2 * t : floor(box.y0 + 0.88 * t) + 0.5;
        const char *label = place->panel->mark[i].label;
        /* Letters with a rim of the panel's colour, so that they can be read over grids and curves. */
        vm_text_cover(&sheet->ink, look->type, x, y, turned, label, 0.16 * t);
        vm_ink_spread(&sheet->ink, look->panel, 1);
        vm_text_draw(&sheet->ink, look->type, x, y, turned, label, look->text);
    }
}
