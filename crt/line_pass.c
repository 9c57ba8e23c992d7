#include "crt/line_pass.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/line_parts.h"

struct crt_line_pass *crt_line_pass_create(const struct crt_tube_row *row,
                                           const struct crt_phosphor *phosphor,
                                           const struct crt_grid *grid, int workers,
                                           enum crt_simd simd, bool reuse, struct crt_error *err)
{
    struct crt_line_pass *pass = calloc(1, sizeof *pass);
    if (pass)
        pass->worker = calloc((size_t)workers, sizeof pass->worker[0]);
    if (!pass || !pass->worker) {
        free(pass);
        crt_fail(err, "out of memory for scan lines");
        return NULL;
    }
    pass->workers = workers;
    pass->grid = *grid;
    pass->memory = reuse ? crt_strip_memory_create() : NULL;
    pass->kernels = &crt_line_kernels_baseline;
#if defined(__x86_64__)
    if (simd != CRT_SIMD_BASELINE && __builtin_cpu_supports("avx2"))
        pass->kernels = &crt_line_kernels_avx2;
#else
    (void)simd;
#endif
    if (crt_line_beams_init(&pass->beams, row, phosphor, grid, err)) {
        pass->even = pass->beams.optics.edge == 0 && pass->beams.optics.converge_edge == 0;
        pass->area = crt_line_area();
        return pass;
    }
    crt_line_pass_destroy(pass);
    return NULL;
}

void crt_line_pass_destroy(struct crt_line_pass *pass)
{
    if (!pass)
        return;
    for (int i = 0; i < pass->workers; i++) {
        free(pass->worker[i].scratch.stream);
        free(pass->worker[i].lines);
        free(pass->worker[i].pointers);
        free(pass->worker[i].weights);
        free(pass->worker[i].across);
        free(pass->worker[i].near);
        free(pass->worker[i].lit);
    }
    crt_line_pass_end(pass);
    crt_strip_memory_destroy(pass->memory);
    crt_line_beams_free(&pass->beams);
    free(pass->worker);
    crt_line_held_free(&pass->held);
    free(pass->key);
    free(pass->entry);
    free(pass->weight);
    free(pass->row);
    free(pass->make);
    free(pass->glow);
    free(pass);
}

/* Makes room for one more of `size` bytes. */
static bool grow(void *list, size_t *room, size_t count, size_t size)
{
    void *old, *grown;
    if (count < *room)
        return true;
    memcpy(&old, list, sizeof old);
    size_t more = *room ? *room * 2 : 256;
    if (more < count + 1)
        more = count + 1;
    grown = realloc(old, more * size);
    if (!grown)
        return false;
    memcpy(list, &grown, sizeof grown);
    *room = more;
    return true;
}

void crt_line_pass_begin(struct crt_line_pass *pass, const struct crt_line_target *targets,
                         int count, int planes)
{
    assert(count <= CRT_MAX_TARGETS);
    memcpy(pass->target, targets, (size_t)count * sizeof targets[0]);
    pass->targets = count;
    pass->planes = planes;
    pass->entries = pass->rows = pass->makes = 0;
    memset(pass->brightest, 0, sizeof pass->brightest);
}

/* ---- shares ---------------------------------------------------------------------------------- */

/* Current of a line's brightest dot, from above. */
static double peak_of(const struct crt_line_pass *pass, const struct crt_line *line, int gun)
{
    const struct crt_knobs *knobs = &line->strip->way.knobs;
    double drive = knobs->brightness +
                   fmax(0, knobs->contrast * line->strip->brightest[gun][line->lane] / 255.0);
    if (!(drive > 0) || pass->beams.power[gun] <= 0)
        return 0;
    if (pass->peak_drive[gun] != drive) {
        double current[CRT_LINE_SETS];
        crt_line_current(pass->beams.row, drive, current);
        ((struct crt_line_pass *)pass)->peak_drive[gun] = drive;
        ((struct crt_line_pass *)pass)->peak[gun] = current[0] + current[1];
    }
    return pass->peak[gun];
}

/* Whether a line lies within one share, wholly between begin and end. */
static const struct crt_share *only_share(const struct crt_receiver *receiver,
                                          const struct crt_line *line, uint64_t begin, uint64_t end)
{
    if (line->t0 < begin || line->t1 > end)
        return NULL;
    for (int k = 0; k < receiver->shares; k++)
        if (receiver->share[k].from <= line->t0 && receiver->share[k].to >= line->t1)
            return &receiver->share[k];
    return NULL;
}

/* A share's mean over the line, or, where it is cut, an estimate of it. */
static void weigh_entry(struct crt_line_pass *pass, size_t entry,
                        const struct crt_receiver *receivers, int first, int count)
{
    const struct crt_line_entry *e = &pass->entry[entry];
    for (int i = 0; i < count; i++) {
        int target = first + i;
        struct crt_line_weight *w = &pass->weight[entry * (size_t)pass->targets + (size_t)target];
        double peak = peak_of(pass, e->line, pass->target[target].gun);
        if (!(peak > 0))
            continue;
        const struct crt_share *share = only_share(&receivers[i], e->line, e->begin, e->end);
        if (share) {
            w->fit = crt_share_over(share, e->line->t0, e->line->t1);
            w->kind = CRT_LINE_WHOLE;
        } else {
            for (int k = 0; k < receivers[i].shares; k++) {
                const struct crt_share *s = &receivers[i].share[k];
                uint64_t from = e->line->t0 > e->begin ? e->line->t0 : e->begin;
                uint64_t to = e->line->t1 < e->end ? e->line->t1 : e->end;
                from = s->from > from ? s->from : from;
                to = s->to < to ? s->to : to;
                if (from >= to)
                    continue;
                w->fit.mean += crt_share_over(s, from, to).mean;
                w->kind = CRT_LINE_CUT_OFF;
            }
        }
        w->peak = peak;
        if (w->kind != CRT_LINE_NONE)
            pass->brightest[target] = fmax(pass->brightest[target], w->fit.mean * peak);
    }
}

/* Further from the grid than this, sigma of the widest spot, a line has no light there. */
static bool near_grid(const struct crt_line_pass *pass, const struct crt_line *line)
{
    const struct crt_optics *o = &pass->beams.optics;
    const struct crt_grid *g = &pass->grid;
    const struct crt_line_way *way = &line->strip->way;
    double y = (double)line->strip->y[line->lane], low = g->top_mm - g->rows * g->cell_mm;
    double x = fmax(fabs((double)way->x0), fabs((double)way->x1)),
           r2 = o->per_mm2 * (x * x + y * y);
    double blur = sqrt(1 + way->knobs.focus * way->knobs.focus);
    double sigma = pass->beams.sigma_mm[pass->beams.sets - 1] * blur * (1 + o->edge * r2);
    double reach = CRT_LINE_CUT * sigma + o->converge + o->converge_edge * r2;
    double length = (double)way->x1 - (double)way->x0;
    return sigma / g->cell_mm <= CRT_WIDEST &&
           length <= CRT_MOST_PARTS * CRT_WIDEST_DOT * pass->beams.sigma_mm[0] * blur * way->dots &&
           sigma * way->dots <= CRT_MOST_DOTS * length && y > low - reach &&
           y < g->top_mm + reach && (double)way->x1 > g->left_mm - reach &&
           (double)way->x0 < g->left_mm + g->cols * g->cell_mm + reach;
}

bool crt_line_pass_add(struct crt_line_pass *pass, const struct crt_line_list *list,
                       const struct crt_receiver *receivers, int first, int count, uint64_t begin,
                       uint64_t end)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct crt_line *line = &list->at[i];
        if (line->t0 >= end || line->t1 <= begin || !near_grid(pass, line))
            continue;
        size_t n = pass->entries, each = (size_t)pass->targets;
        if (!grow(&pass->entry, &pass->entry_room, n, sizeof pass->entry[0]))
            return false;
        for (size_t k = 0; k < each; k++) {
            if (!grow(&pass->weight, &pass->weight_room, n * each + k, sizeof pass->weight[0]))
                return false;
            pass->weight[n * each + k] = (struct crt_line_weight){.kind = CRT_LINE_NONE};
        }
        pass->entry[n] = (struct crt_line_entry){.line = line,
                                                 .y = line->strip->y[line->lane],
                                                 .order = n,
                                                 .weight = n * each,
                                                 .begin = begin,
                                                 .end = end,
                                                 .receivers = receivers,
                                                 .first = first,
                                                 .count = count};
        pass->entries++;
        weigh_entry(pass, n, receivers, first, count);
    }
    return true;
}

/* ---- preparing ------------------------------------------------------------------------------- */

/* From the top down; lines of one place in the order they came. */
static int by_place(const void *a, const void *b)
{
    const struct crt_line_entry *x = a, *y = b;
    if (x->y != y->y)
        return x->y < y->y ? 1 : -1;
    return x->order < y->order ? -1 : 1;
}

static void sort_entries(struct crt_line_pass *pass)
{
    if (pass->entries > 1)
        qsort(pass->entry, pass->entries, sizeof pass->entry[0], by_place);
}

/* Fewer stretches than this tell how a share changes along a line. */
#define MOST_STRETCHES 256

struct splitting {
    struct crt_line_stretch stretch[MOST_STRETCHES];
    int count;
    const struct crt_line *line;
    double dots, good; /* of the line, after splitting; what a straight line may miss */
};

static void split(struct splitting *s, const struct crt_share *share, uint64_t from, uint64_t to,
                  int depth)
{
    struct crt_share_fit fit = crt_share_over(share, from, to);
    if (fit.off_line > s->good && depth > 0 && to - from > 1) {
        uint64_t middle = from + (to - from) / 2;
        split(s, share, from, middle, depth - 1);
        split(s, share, middle, to, depth - 1);
        return;
    }
    double scale = s->dots / (double)(s->line->t1 - s->line->t0);
    if (s->count < MOST_STRETCHES)
        s->stretch[s->count++] =
            (struct crt_line_stretch){(double)(from - s->line->t0) * scale,
                                      (double)(to - s->line->t0) * scale, fit.mean, fit.slope};
}

/* The stretches of a line for one target, of mean 1 at most; the brightest is returned. */
static double split_line(struct splitting *s, const struct crt_line_entry *e,
                         const struct crt_receiver *receiver)
{
    double most = 0;
    s->count = 0;
    for (int k = 0; k < receiver->shares; k++) {
        const struct crt_share *share = &receiver->share[k];
        uint64_t from = e->line->t0 > e->begin ? e->line->t0 : e->begin;
        uint64_t to = e->line->t1 < e->end ? e->line->t1 : e->end;
        from = share->from > from ? share->from : from;
        to = share->to < to ? share->to : to;
        if (from < to)
            split(s, share, from, to, 6);
    }
    for (int i = 0; i < s->count; i++)
        most = fmax(most, s->stretch[i].mean + fabs(s->stretch[i].slope));
    for (int i = 0; i < s->count && most > 0; i++) {
        s->stretch[i].mean /= most;
        s->stretch[i].slope /= most;
    }
    return most;
}

static bool weigh_dots(struct crt_line_pass *pass, const struct crt_line_entry *e, int target,
                       struct crt_line_weight *w)
{
    struct splitting s = {.line = e->line,
                          .good = CRT_OFF_LINE * pass->brightest[target] / w->peak};
    s.dots = (double)e->line->strip->way.dots * e->course->parts;
    double most = split_line(&s, e, &e->receivers[target - e->first]);
    w->kind = CRT_LINE_NONE;
    if (!(most > 0))
        return true;
    if (!grow(&pass->glow, &pass->glow_room, pass->glows, sizeof pass->glow[0]))
        return false;
    struct crt_glow *glow = malloc(sizeof *glow);
    if (!glow)
        return false;
    pass->glow[pass->glows++] = glow;
    w->kind = CRT_LINE_OWN;
    w->own = glow;
    w->w0 = (float)most;
    w->w1 = 0;
    return crt_glow_weighted(glow, e->line->strip, e->line->lane, pass->target[target].gun,
                             s.stretch, s.count, &pass->beams, e->place, pass->kernels,
                             &pass->worker[0].scratch);
}

/* From shares to weights per unit of glow: constants or straight lines along the columns. */
static bool settle_entry(struct crt_line_pass *pass, struct crt_line_entry *e)
{
    const struct crt_line_way *way = &e->line->strip->way;
    double length = (double)way->x1 - (double)way->x0;
    double seconds = crt_seconds(e->line->t0, e->line->t1);
    for (int i = e->first; i < e->first + e->count; i++) {
        struct crt_line_weight *w = &pass->weight[e->weight + (size_t)i];
        double bright = pass->brightest[i];
        if (w->kind == CRT_LINE_NONE)
            continue;
        if (w->kind == CRT_LINE_WHOLE && w->fit.mean * w->peak < CRT_LINE_FAINT * bright) {
            w->kind = CRT_LINE_NONE;
            continue;
        }
        bool constant =
            w->kind == CRT_LINE_WHOLE && w->fit.off_constant * w->peak <= CRT_OFF_CONSTANT * bright;
        bool straight =
            w->kind == CRT_LINE_WHOLE && w->fit.off_line * w->peak <= CRT_OFF_LINE * bright;
        if (constant || straight) {
            double slope = constant ? 0 : w->fit.slope * 2 * pass->grid.cell_mm / length;
            double x = pass->grid.left_mm + pass->grid.cell_mm / 2 - (double)way->x0;
            double left = constant ? 0 : w->fit.slope * (2 * x / length - 1);
            w->w0 = (float)(w->fit.mean + left);
            w->w1 = (float)slope;
        } else if (!weigh_dots(pass, e, i, w)) {
            return false;
        }
        float unit = (float)(pass->beams.power[pass->target[i].gun] * seconds / length);
        w->w0 *= unit;
        w->w1 *= unit;
        e->used |= w->kind != CRT_LINE_NONE;
    }
    return true;
}

static bool repeats(const struct crt_line_entry *a, const struct crt_line_entry *b, int guns)
{
    const struct crt_strip *x = a->line->strip, *y = b->line->strip;
    size_t dots = (size_t)x->way.dots;
    if (!a->used || !crt_line_same_way(&x->way, &y->way))
        return false;
    for (int gun = 0; gun < guns; gun++)
        if (memcmp(x->drive + (size_t)(gun * CRT_STRIP_LINES + a->line->lane) * dots,
                   y->drive + (size_t)(gun * CRT_STRIP_LINES + b->line->lane) * dots, dots) != 0)
            return false;
    return true;
}

/* Lines of one place and way go to one row. */
static bool make_rows(struct crt_line_pass *pass)
{
    for (size_t i = 0; i < pass->entries; i++) {
        struct crt_line_entry *e = &pass->entry[i];
        if (!e->used)
            continue;
        struct crt_line_row *row = pass->rows ? &pass->row[pass->rows - 1] : NULL;
        if (!row || row->y != e->y || row->course != e->course) {
            if (!grow(&pass->row, &pass->row_room, pass->rows, sizeof pass->row[0]))
                return false;
            row = &pass->row[pass->rows++];
            double blur = sqrt(1 + e->course->focus * e->course->focus);
            double sigma = pass->beams.sigma_mm[pass->beams.sets - 1] * blur;
            *row = (struct crt_line_row){.y = e->y, .course = e->course, .place = e->place};
            row->first = i;
            row->reach_mm = CRT_LINE_CUT * sigma * (e->place->most_spread + 0.01) +
                            e->place->most_landing * 1.01;
            pass->reach_mm = fmax(pass->reach_mm, row->reach_mm);
        }
        e->repeats = row->end == i && row->end > row->first &&
                     repeats(&pass->entry[i - 1], e, pass->beams.guns);
        row->end = i + 1;
    }
    return true;
}

static void make_glow(void *context, int index, int worker)
{
    struct crt_line_pass *pass = context;
    struct crt_line_make *make = &pass->make[index];
    make->ok = crt_glow_make(make->strip, &pass->beams, make->place, pass->kernels,
                             &pass->worker[worker].scratch);
}

static bool find_place(struct crt_line_pass *pass, struct crt_line_entry *e)
{
    struct crt_strip *strip = e->line->strip;
    strip->beam = crt_line_beam_find(&pass->beams, &strip->way);
    if (!strip->beam)
        return false;
    e->course = strip->beam->course;
    e->place = crt_line_place_find(&pass->beams, strip->beam->course, strip->band);
    return e->place != NULL;
}

/* Strips that have no glow yet get one. */
static bool make_glows(struct crt_line_pass *pass, struct crt_pool *pool)
{
    bool ok = true;
    for (size_t i = 0; i < pass->entries; i++) {
        const struct crt_line_entry *e = &pass->entry[i];
        struct crt_strip *strip = e->line->strip;
        if (!e->used || strip->glow || strip->closed ||
            crt_strip_recall(pass->memory, strip, pass->beams.guns))
            continue;
        if (!grow(&pass->make, &pass->make_room, pass->makes, sizeof pass->make[0]))
            return false;
        strip->closed = true;
        pass->make[pass->makes++] = (struct crt_line_make){strip, e->place, false};
    }
    crt_pool_run(pool, make_glow, pass, (int)pass->makes);
    for (size_t i = 0; i < pass->makes; i++) {
        ok &= pass->make[i].ok;
        pass->make[i].strip->closed = pass->make[i].ok;
        if (pass->make[i].ok)
            crt_strip_remember(pass->memory, pass->make[i].strip);
    }
    return ok;
}

bool crt_line_pass_prepare(struct crt_line_pass *pass, struct crt_pool *pool)
{
    bool ok = true;
    pass->reach_mm = 0;
    for (size_t i = 0; i < pass->entries && ok; i++)
        ok = find_place(pass, &pass->entry[i]) && settle_entry(pass, &pass->entry[i]);
    sort_entries(pass);
    ok = ok && make_rows(pass) && make_glows(pass, pool) && crt_line_bands_prepare(pass);
    if (!ok)
        pass->rows = 0;
    return ok;
}

const struct crt_line_beams *crt_line_pass_beams(const struct crt_line_pass *pass)
{
    return &pass->beams;
}

void crt_line_pass_end(struct crt_line_pass *pass)
{
    for (size_t i = 0; i < pass->glows; i++)
        crt_glow_release(pass->glow[i]);
    pass->glows = pass->entries = pass->rows = 0;
    crt_line_beams_trim(&pass->beams);
    crt_strip_memory_turn(pass->memory);
}
