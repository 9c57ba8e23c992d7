#include "roms/raster/polygon_fill.h"

#include "roms/geometry/scalar.h"
#include "roms/raster/fill_run.h"

_Static_assert(POLYGON_PARTS == 64, "shifts by 6");

/* In 1/64 pixel. */
static int32_t rounded(float v)
{
    const float reach = POLYGON_REACH;
    return scalar_nearest(scalar_clamp(v, -reach, reach) * POLYGON_PARTS);
}

/* The first row at or below. */
static int row_from(int32_t y)
{
    return (y + POLYGON_PARTS - 1) >> 6;
}

int polygon_first(float v)
{
    return row_from(rounded(v));
}

/* x and `over` after so many 1/64 pixel from the upper end: x₀ + dx·down/height, rounded up. */
static void cross(struct polygon_edge *e, int32_t x0, int32_t dx, int32_t down)
{
    int64_t product = (int64_t)dx * down, whole;
    if (product >= INT32_MIN && product <= INT32_MAX)
        whole = (int32_t)product / e->height; /* one instruction instead of a function */
    else
        whole = product / e->height;
    int32_t rest = (int32_t)(product - whole * e->height);
    if (rest > 0) {
        whole++;
        rest -= e->height;
    }
    e->x = x0 + (int32_t)whole;
    e->over = -rest;
}

static void add_edge(struct polygon_fill *f, struct point2 from, struct point2 to)
{
    int32_t x0 = rounded(from.x), y0 = rounded(from.y), x1 = rounded(to.x), y1 = rounded(to.y);
    int winding = 1;
    if (y0 > y1) {
        int32_t x = x0, y = y0;
        x0 = x1, y0 = y1;
        x1 = x, y1 = y;
        winding = -1;
    }
    int first = row_from(y0), last = row_from(y1) - 1;
    first = first > f->top ? first : f->top;
    last = last < f->bottom ? last : f->bottom;
    if (first > last)
        return;
    struct polygon_edge *e = &f->edge[f->count++];
    *e = (struct polygon_edge){
        .first = first, .last = last, .height = y1 - y0, .winding = winding, .a = from, .b = to};
    cross(e, 0, x1 - x0, POLYGON_PARTS);
    e->step_x = e->x;
    e->step_over = e->over;
    cross(e, x0, x1 - x0, first * POLYGON_PARTS - y0);
}

void polygon_fill_begin(struct polygon_fill *f, enum polygon_rule rule, int top, int bottom)
{
    f->rule = rule;
    f->top = top;
    f->bottom = bottom;
    f->count = f->waiting = f->active_count = f->next = f->inside = 0;
    f->y = top - 1;
    f->sorted = false;
}

bool polygon_fill_contour(struct polygon_fill *f, const struct point2 *p, int count)
{
    if (count < 3 || f->count + count > POLYGON_CORNERS)
        return false;
    for (int i = 0; i < count; i++)
        add_edge(f, p[i], p[i + 1 < count ? i + 1 : 0]);
    return true;
}

/* By first row. */
static void sort_edges(struct polygon_fill *f)
{
    for (int i = 1; i < f->count; i++) {
        struct polygon_edge e = f->edge[i];
        int k = i;
        for (; k > 0 && f->edge[k - 1].first > e.first; k--)
            f->edge[k] = f->edge[k - 1];
        f->edge[k] = e;
    }
    f->sorted = true;
}

/* To where it crosses the next row. */
static inline void move_edge(struct polygon_edge *e)
{
    e->x += e->step_x;
    e->over += e->step_over;
    if (e->over >= e->height) {
        e->over -= e->height;
        e->x--;
    }
}

/* Removes edges that end above the row, moves the others to where they cross it. */
static void advance(struct polygon_fill *f)
{
    int kept = 0;
    for (int i = 0; i < f->active_count; i++) {
        struct polygon_edge *e = &f->edge[f->active[i]];
        if (e->last < f->y)
            continue;
        move_edge(e);
        f->active[kept++] = f->active[i];
    }
    f->active_count = kept;
}

/* By x; they are nearly so from the row before. */
static void sort_active(struct polygon_fill *f)
{
    for (int i = 1; i < f->active_count; i++) {
        uint8_t which = f->active[i];
        int32_t x = f->edge[which].x;
        int k = i;
        for (; k > 0 && f->edge[f->active[k - 1]].x > x; k--)
            f->active[k] = f->active[k - 1];
        f->active[k] = which;
    }
}

bool polygon_fill_row(struct polygon_fill *f)
{
    if (!f->sorted)
        sort_edges(f);
    f->y++;
    advance(f);
    if (f->active_count == 0) {
        if (f->waiting == f->count)
            return false;
        f->y = f->edge[f->waiting].first;
    }
    while (f->waiting < f->count && f->edge[f->waiting].first == f->y)
        f->active[f->active_count++] = (uint8_t)f->waiting++;
    sort_active(f);
    f->next = f->inside = 0;
    return true;
}

/* Where runs go: the commonest formats without what canvas_fill has to ask for each. */
struct filler {
    const struct canvas *c;
    uint32_t colour, word; /* the word: of bytes */
};

static inline void run_of(const struct filler *k, int x0, int x1, int y)
{
    const struct canvas *c = k->c;
    uint8_t *row = c->pixels + (uint32_t)y * c->pitch;
    x0 = x0 > 0 ? x0 : 0;
    x1 = x1 < c->width ? x1 : c->width;
    if (x0 >= x1)
        return;
    if (c->bits == 8)
        fill_run_bytes(row + x0, row + x1, k->word);
    else if (c->bits == 32)
        fill_run_words((uint32_t *)(void *)row + x0, (uint32_t *)(void *)row + x1, k->colour);
    else
        canvas_fill(c, x0, y, x1 - x0, 1, k->colour);
}

/* Rows that the same two edges cross, from the present one on: by either rule what lies between. */
static void run_pair(const struct filler *k, struct polygon_fill *f)
{
    struct polygon_edge *left = &f->edge[f->active[0]], *right = &f->edge[f->active[1]];
    struct polygon_edge a = *left, b = *right;
    int last = a.last < b.last ? a.last : b.last, y = f->y;
    if (f->waiting < f->count && f->edge[f->waiting].first <= last)
        last = f->edge[f->waiting].first - 1;
    for (;; y++) {
        int x0 = polygon_pixel(a.x), x1 = polygon_pixel(b.x);
        run_of(k, x0 < x1 ? x0 : x1, x0 < x1 ? x1 : x0, y);
        if (y == last)
            break;
        move_edge(&a);
        move_edge(&b);
    }
    f->y = y;
    left->x = a.x, left->over = a.over;
    right->x = b.x, right->over = b.over;
}

static void fill_runs(const struct canvas *c, struct polygon_fill *f, uint32_t colour)
{
    const struct filler k = {c, colour, (colour & 0xFF) * 0x01010101};
    struct polygon_run run;
    while (polygon_fill_row(f)) {
        if (f->active_count == 2)
            run_pair(&k, f);
        else
            while (polygon_fill_run(f, &run))
                run_of(&k, run.x0, run.x1, f->y);
    }
}

void canvas_polygons(const struct canvas *c, const struct point2 *p, const int *counts,
                     int contours, enum polygon_rule rule, uint32_t colour)
{
    struct polygon_fill f;
    polygon_fill_begin(&f, rule, 0, c->height - 1);
    for (int i = 0; i < contours; i++) {
        if (!polygon_fill_contour(&f, p, counts[i]))
            return;
        p += counts[i];
    }
    fill_runs(c, &f, colour);
}

void canvas_polygon(const struct canvas *c, const struct point2 *p, int count,
                    enum polygon_rule rule, uint32_t colour)
{
    canvas_polygons(c, p, &count, 1, rule, colour);
}
