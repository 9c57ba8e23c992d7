/* Rows of lines to rows of cells, band by band. */
#include "crt/line_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double row_mm(const struct crt_grid *grid, int row)
{
    return grid->top_mm - (row + 0.5) * grid->cell_mm;
}

/* Rows of lines that may reach cells' rows [lo, hi). */
static void lines_near(const struct crt_line_pass *pass, int lo, int hi, size_t *first, size_t *end)
{
    double top = row_mm(&pass->grid, lo) + pass->reach_mm;
    double bottom = row_mm(&pass->grid, hi - 1) - pass->reach_mm;
    size_t a = 0, b = pass->rows;
    while (a < b) {
        size_t middle = a + (b - a) / 2;
        if ((double)pass->row[middle].y > top)
            a = middle + 1;
        else
            b = middle;
    }
    *first = a;
    while (a < pass->rows && (double)pass->row[a].y >= bottom)
        a++;
    *end = a;
}

static bool grow_to(void *list, size_t *room, size_t count, size_t size)
{
    void *old, *made;
    if (*room >= count)
        return true;
    memcpy(&old, list, sizeof old);
    free(old);
    made = malloc(count * size);
    memcpy(list, &made, sizeof made);
    *room = made ? count : 0;
    return made != NULL;
}

/* Tiles that columns of cells are worked on in. */
static size_t tiles_across(const struct crt_line_pass *pass)
{
    return ((size_t)pass->grid.cols + CRT_LINE_TILE - 1) / CRT_LINE_TILE;
}

static bool begin_held(struct crt_line_pass *pass, size_t sets)
{
    if (!pass->memory) /* nothing is to be reused */
        return true;
    if (!grow_to(&pass->key, &pass->key_room, pass->rows, sizeof pass->key[0]))
        return false;
    for (size_t i = 0; i < pass->rows; i++) {
        const struct crt_line_course *c = pass->row[i].course;
        pass->key[i] = (struct crt_line_key){
            c->focus, pass->row[i].place->y_mm, pass->row[i].y, c->x0, c->x1, c->dots};
    }
    crt_line_held_begin(&pass->held, pass->key, pass->rows,
                        (size_t)pass->beams.guns * tiles_across(pass) * (size_t)pass->grid.rows,
                        sets, CRT_LINE_ANCHORS);
    return true;
}

/* The most lines that rows of cells worked on together can see; bands begin at any row of tiles. */
bool crt_line_bands_prepare(struct crt_line_pass *pass)
{
    const int step = CRT_LINE_STEP;
    size_t most = 0;
    for (int row = 0; row < pass->grid.rows; row += CRT_TILE_ROWS) {
        size_t first, end;
        lines_near(pass, row, row + step < pass->grid.rows ? row + step : pass->grid.rows, &first,
                   &end);
        most = end - first > most ? end - first : most;
    }
    size_t sets = (size_t)pass->beams.sets;
    if (!begin_held(pass, sets))
        return false;
    for (int i = 0; i < pass->workers; i++) {
        struct crt_line_worker *w = &pass->worker[i];
        if (!grow_to(&w->lines, &w->lines_room, CRT_LINE_TOGETHER * most * sets * CRT_LINE_TILE,
                     sizeof(float)) ||
            !grow_to(&w->across, &w->across_room, most * sets, sizeof w->across[0]) ||
            !grow_to(&w->weights, &w->weights_room, most * sets * CRT_LINE_ANCHORS,
                     sizeof(float)) ||
            !grow_to(&w->lit, &w->lit_room, CRT_LINE_TOGETHER * most * sets, sizeof(bool)) ||
            !grow_to(&w->near, &w->near_room, (most + CRT_HELD_LINES) * sets, sizeof w->near[0]) ||
            !grow_to(&w->pointers, &w->pointers_room, 2 * most * sets, sizeof(float *)))
            return false;
    }
    return true;
}

/* What a band's work on a tile of columns is about. */
struct working {
    const struct crt_line_pass *pass;
    struct crt_line_held *held;
    struct crt_line_worker *worker;
    int lo, hi, col, cols; /* rows and columns of cells */
    size_t first, end;     /* rows of lines */
    int gun;
    int target[CRT_LINE_TOGETHER], targets;
};

static float *line_at(const struct working *w, int target, size_t row, int set)
{
    size_t rows = w->end - w->first, sets = (size_t)w->pass->beams.sets;
    return w->worker->lines +
           (((size_t)target * rows + (row - w->first)) * sets + (size_t)set) * CRT_LINE_TILE;
}

/* Adds one entry's light to a line of the tile; false: it has none there. */
static bool combine_entry(const struct working *w, const struct crt_line_entry *e,
                          const struct crt_line_weight *weight, int set, float *to, bool add)
{
    const struct crt_glow *glow = weight->kind == CRT_LINE_OWN ? weight->own : e->line->strip->glow;
    int lane = weight->kind == CRT_LINE_OWN ? 0 : e->line->lane;
    if (!glow || !glow->cells[w->gun][set] || glow->scale[w->gun][set][lane] == 0)
        return false;
    int from = glow->col0[w->gun] > w->col ? glow->col0[w->gun] : w->col;
    int end = w->col + w->cols < glow->col1[w->gun] ? w->col + w->cols : glow->col1[w->gun];
    if (from >= end)
        return false;
    if (!add) {
        memset(to, 0, (size_t)(from - w->col) * sizeof to[0]);
        memset(to + (end - w->col), 0, (size_t)(w->col + w->cols - end) * sizeof to[0]);
    }
    float scale = glow->scale[w->gun][set][lane];
    size_t columns = (size_t)(glow->col1[w->gun] - glow->col0[w->gun]);
    const int16_t *cells =
        glow->cells[w->gun][set] + (size_t)lane * columns + (from - glow->col0[w->gun]);
    w->pass->kernels->combine(cells, end - from, scale * (weight->w0 + weight->w1 * (float)from),
                              scale * weight->w1, to + (from - w->col), add);
    return true;
}

static const struct crt_line_weight *weight_of(const struct working *w, int index,
                                               const struct crt_line_entry *e)
{
    return &w->pass->weight[e->weight + (size_t)w->target[index]];
}

/* The light of a row of lines in one target along the tile; false: none. */
static bool combine_row(const struct working *w, int index, size_t row, int set)
{
    const struct crt_line_pass *pass = w->pass;
    float *to = line_at(w, index, row, set);
    bool lit = false;
    for (size_t i = pass->row[row].first; i < pass->row[row].end; i++) {
        const struct crt_line_entry *e = &pass->entry[i];
        struct crt_line_weight weight = *weight_of(w, index, e);
        if (!e->used || weight.kind == CRT_LINE_NONE)
            continue;
        while (weight.kind == CRT_LINE_WHOLE && i + 1 < pass->row[row].end &&
               pass->entry[i + 1].repeats &&
               weight_of(w, index, &pass->entry[i + 1])->kind == CRT_LINE_WHOLE) {
            i++;
            weight.w0 += weight_of(w, index, &pass->entry[i])->w0;
            weight.w1 += weight_of(w, index, &pass->entry[i])->w1;
        }
        lit |= combine_entry(w, e, &weight, set, to, lit);
    }
    return lit;
}

/* Where a row of lines lands at the tile's anchors: all but what weigh_rows adds. */
static void place_across(const struct working *w, const struct crt_line_row *row, int set,
                         struct crt_line_across *across)
{
    const struct crt_line_place *place = row->place;
    const struct crt_optics *o = &w->pass->beams.optics;
    double own = (double)row->y, more = o->per_mm2 * (own * own - place->y_mm * place->y_mm);
    double spread = o->edge * more;
    double sigma = row->course->spot[set]->sigma_mm, area = w->pass->area;
    int anchor = w->col / CRT_LINE_ANCHOR, last = w->pass->grid.cols / CRT_LINE_ANCHOR + 1;
    struct crt_line_across band;
    for (int i = 0; i < CRT_LINE_ANCHORS; i++) {
        int at = anchor + i < last ? anchor + i : last;
        band.at[i] = place->landing[w->gun][at];
        band.narrow[i] = place->spread[w->gun][at];
        band.amount[i] = place->amount[w->gun][at];
    }
    w->pass->kernels->place(across, &band, (float)sigma, (float)spread, (float)(1 / area));
}

/* Of a row of lines, but for what varies along it. */
static double lands_at(const struct working *w, const struct crt_line_row *row)
{
    const struct crt_optics *o = &w->pass->beams.optics;
    double own = (double)row->y, middle = row->place->y_mm;
    return own + o->way_y[w->gun] * o->converge_edge * o->per_mm2 * (own * own - middle * middle);
}

/* Rows of lines and sets that reach a row of cells, and their weights there; none before row of lines
 * *first does. */
static int weigh_rows(const struct working *w, int r, size_t *first)
{
    const struct crt_line_pass *pass = w->pass;
    const int sets = pass->beams.sets;
    double y = row_mm(&pass->grid, r);
    int count = 0;
    while (*first < w->end && (double)pass->row[*first].y > y + pass->reach_mm)
        ++*first;
    for (size_t k = *first; k < w->end && (double)pass->row[k].y >= y - pass->reach_mm; k++) {
        float above = (float)(y - lands_at(w, &pass->row[k]));
        for (int set = 0; set < sets; set++) {
            size_t slot = (k - w->first) * (size_t)sets + (size_t)set;
            const struct crt_line_across *across = &w->worker->across[slot];
            float *weights = w->worker->weights + slot * CRT_LINE_ANCHORS;
            if (above > across->low && above < across->high &&
                pass->kernels->weigh(across, above, weights))
                w->worker->near[count++] =
                    (struct crt_line_near){k * (size_t)sets + (size_t)set, weights};
        }
    }
    return count;
}

/* One row of cells of one target. */
static void spread_row(const struct working *w, int r, int t, int near)
{
    const struct crt_line_pass *pass = w->pass;
    const int sets = pass->beams.sets;
    size_t all = (w->end - w->first) * (size_t)sets;
    const float **weights = w->worker->pointers, **lines = weights + all;
    const struct crt_line_target *target = &pass->target[w->target[t]];
    float *cells = target->cells + (size_t)r * (size_t)pass->grid.cols + (size_t)w->col;
    int count = 0;
    for (int i = 0; i < near; i++) {
        size_t slot = w->worker->near[i].slot - w->first * (size_t)sets;
        if (!w->worker->lit[(size_t)t * all + slot])
            continue;
        weights[count] = w->worker->near[i].weights;
        lines[count++] = line_at(w, t, w->first + slot / (size_t)sets, (int)(slot % (size_t)sets));
    }
    if (count > 0)
        pass->kernels->spread(lines, weights, count, w->cols, pass->even, target->fresh, cells);
    else if (target->fresh)
        memset(cells, 0, (size_t)w->cols * sizeof cells[0]);
}

/* Where what is known of a row of cells is kept. */
static size_t held_place(const struct working *w, int r)
{
    size_t tile = (size_t)w->gun * tiles_across(w->pass) + (size_t)w->col / CRT_LINE_TILE;
    return tile * (size_t)w->pass->grid.rows + (size_t)r;
}

static void work_targets(const struct working *w)
{
    const size_t rows = w->end - w->first, sets = (size_t)w->pass->beams.sets;
    size_t first = w->first;
    bool *lit = w->worker->lit;
    for (int t = 0; t < w->targets; t++)
        for (size_t k = w->first; k < w->end; k++)
            for (size_t set = 0; set < sets; set++)
                *lit++ = combine_row(w, t, k, (int)set);
    bool placed = false;
    for (int r = w->lo; r < w->hi; r++) {
        size_t place = held_place(w, r);
        int near;
        if (!crt_line_held_find(w->held, place, w->worker->near, &near)) {
            for (size_t k = 0; k < rows * sets && !placed; k++)
                place_across(w, &w->pass->row[w->first + k / sets], (int)(k % sets),
                             &w->worker->across[k]);
            placed = true;
            near = weigh_rows(w, r, &first);
            crt_line_held_store(w->held, place, w->worker->near, near);
        }
        for (int t = 0; t < w->targets; t++)
            spread_row(w, r, t, near);
    }
}

static void work_tile(struct working *w)
{
    const struct crt_line_pass *pass = w->pass;
    for (w->gun = 0; w->gun < pass->beams.guns; w->gun++) {
        w->targets = 0;
        for (int i = 0; i < pass->targets; i++) {
            if (pass->target[i].gun != w->gun)
                continue;
            w->target[w->targets++] = i;
            if (w->targets == CRT_LINE_TOGETHER) {
                work_targets(w);
                w->targets = 0;
            }
        }
        if (w->targets > 0)
            work_targets(w);
    }
}

/* Makes planes ready for the light of the lines. */
static void touch_planes(const struct working *w, struct crt_planes *planes, uint64_t epoch)
{
    const struct crt_line_pass *pass = w->pass;
    int left = pass->grid.cols, right = 0;
    for (size_t k = w->first; k < w->end; k++)
        for (int gun = 0; gun < pass->beams.guns; gun++) {
            const struct crt_line_place *place = pass->row[k].place;
            left = place->col0[gun] < left ? place->col0[gun] : left;
            right = place->col1[gun] > right ? place->col1[gun] : right;
        }
    if (left < right)
        crt_planes_touch(planes, w->lo, w->hi, left, right - 1, epoch);
}

/* No lines are near. */
static void clear_fresh(const struct working *w)
{
    const struct crt_line_pass *pass = w->pass;
    size_t cols = (size_t)pass->grid.cols;
    for (int i = 0; i < pass->targets; i++)
        if (pass->target[i].fresh)
            memset(pass->target[i].cells + (size_t)w->lo * cols, 0,
                   (size_t)(w->hi - w->lo) * cols * sizeof(float));
}

void crt_line_pass_band(struct crt_line_pass *pass, int lo, int hi, int worker,
                        struct crt_planes *planes, uint64_t epoch)
{
    for (int row = lo; row < hi; row += CRT_LINE_STEP) {
        struct working w = {
            .pass = pass, .held = &pass->held, .worker = &pass->worker[worker], .lo = row};
        w.hi = row + CRT_LINE_STEP < hi ? row + CRT_LINE_STEP : hi;
        lines_near(pass, w.lo, w.hi, &w.first, &w.end);
        if (w.first == w.end) {
            clear_fresh(&w);
            continue;
        }
        if (pass->planes > 0)
            touch_planes(&w, planes, epoch);
        for (w.col = 0; w.col < pass->grid.cols; w.col += CRT_LINE_TILE) {
            int left = pass->grid.cols - w.col;
            w.cols = left < CRT_LINE_TILE ? left : CRT_LINE_TILE;
            work_tile(&w);
        }
    }
}
