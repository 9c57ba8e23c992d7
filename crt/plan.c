#include "crt/plan.h"

#include <math.h>
#include <string.h>

#include "crt/footprint_profile.h"

/* Coordinates beyond this are cut to the grid's neighbourhood first, cells. */
#define FAR 1e5

/* Keeps fractions [*u0, *u1] of x + dx·u between low and high; false when none is left. */
static bool cut(double x, double dx, double low, double high, double *u0, double *u1)
{
    if (dx == 0)
        return x >= low && x <= high;
    double a = (low - x) / dx, b = (high - x) / dx;
    *u0 = fmax(*u0, fmin(a, b));
    *u1 = fmin(*u1, fmax(a, b));
    return *u0 < *u1;
}

static double span(uint64_t a, uint64_t b)
{
    return (double)(b - a);
}

static uint64_t later(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

static uint64_t earlier(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

/* The brightest cell of energy spread over a line: erf(L/2√2) is at least 0.68 from 2 sigma on, and
 * falls more slowly than L below. */
double crt_plan_crest(const struct crt_entry *entry)
{
    const struct crt_stroke *s = &entry->stroke;
    double dx = (double)s->x1 - (double)s->x0, dy = (double)s->y1 - (double)s->y0;
    double length = sqrt(dx * dx + dy * dy), sigma = entry->sigma_mm;
    double full = entry->power * crt_seconds(s->t0, s->t1) / (CRT_LINE_AREA * sigma);
    if (length >= 6 * sigma)
        return full / length;
    return 0.68 * full / fmax(length, 2 * sigma);
}

static bool cut_to_grid(struct crt_drawn *d, const struct crt_grid *grid)
{
    double margin = 16 * d->sigma + 64, u0 = 0, u1 = 1;
    if (!cut(d->x0, d->dx, -margin, grid->cols + margin, &u0, &u1) ||
        !cut(d->y0, d->dy, -margin, grid->rows + margin, &u0, &u1))
        return false;
    double whole = span(d->t0, d->t1);
    d->from = later(d->from, d->t0 + (uint64_t)(u0 * whole));
    d->to = earlier(d->to, d->t0 + (uint64_t)ceil(u1 * whole));
    return d->from < d->to;
}

/* Of CRT_PLACES along one side. */
static int place_along(double middle, int cells)
{
    double place = middle / cells * CRT_PLACES;
    return place > 0 ? (int)fmin(place, CRT_PLACES - 1) : 0;
}

bool crt_drawn_init(struct crt_drawn *d, const struct crt_entry *entry, const struct crt_grid *grid,
                    uint64_t from, uint64_t to)
{
    const struct crt_stroke *s = &entry->stroke;
    double x1, y1;
    crt_mm_to_cell(grid, s->x0, s->y0, &d->x0, &d->y0);
    crt_mm_to_cell(grid, s->x1, s->y1, &x1, &y1);
    d->dx = x1 - d->x0;
    d->dy = y1 - d->y0;
    d->t0 = s->t0;
    d->t1 = s->t1;
    d->from = later(s->t0, from);
    d->to = earlier(s->t1, to);
    d->sigma = entry->sigma_mm / grid->cell_mm;
    d->power = entry->power / (grid->cell_mm * grid->cell_mm);
    d->light = entry->light;
    d->moving = d->dx != 0 || d->dy != 0;
    if (d->from >= d->to || !(d->sigma <= CRT_WIDEST))
        return false;
    double reach = 1.5 * CRT_CUT * d->sigma;
    if (fmax(d->x0, x1) < -reach || fmin(d->x0, x1) > grid->cols + reach ||
        fmax(d->y0, y1) < -reach || fmin(d->y0, y1) > grid->rows + reach)
        return false;
    d->crest = entry->crest;
    d->place = place_along(d->y0 + d->dy / 2, grid->rows) * CRT_PLACES +
               place_along(d->x0 + d->dx / 2, grid->cols);
    if (fmax(fabs(d->x0), fabs(x1)) > FAR || fmax(fabs(d->y0), fabs(y1)) > FAR)
        if (!cut_to_grid(d, grid))
            return false;
    d->whole = d->from == d->t0 && d->to == d->t1;
    return true;
}

/* Which part of the stroke a share applies to; false: none. */
static bool overlap(const struct crt_drawn *d, const struct crt_share *share, uint64_t *from,
                    uint64_t *to)
{
    *from = later(d->from, share->from);
    *to = earlier(d->to, share->to);
    return *from < *to;
}

static bool middle_on_grid(const struct crt_stroke *s, const struct crt_grid *grid)
{
    double col, row;
    crt_mm_to_cell(grid, ((double)s->x0 + (double)s->x1) / 2, ((double)s->y0 + (double)s->y1) / 2,
                   &col, &row);
    return col >= 0 && row >= 0 && col <= grid->cols - 1 && row <= grid->rows - 1;
}

void crt_plan_brightest(const struct crt_entries *entries, const struct crt_grid *grid,
                        uint64_t from, uint64_t to, struct crt_receiver *receivers, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < receivers[i].shares; k++) {
            const struct crt_share *share = &receivers[i].share[k];
            uint64_t begin = later(from, share->from), end = earlier(to, share->to);
            double most = crt_share_total(share);
            for (size_t n = 0; n < entries->count; n++) {
                const struct crt_entry *entry = &entries->at[n];
                const struct crt_stroke *s = &entry->stroke;
                double crest = entry->crest * entry->light[receivers[i].colour];
                if (crest * most <= receivers[i].brightest || s->t0 < begin || s->t1 > end ||
                    !middle_on_grid(s, grid))
                    continue;
                double mean = crt_share_over(share, s->t0, s->t1).mean;
                receivers[i].brightest = fmax(receivers[i].brightest, crest * mean);
                /* Within an exposure shares only fall: later strokes get no more. */
                if (share->within)
                    most = fmin(most, mean * (1 + 1e-9));
            }
        }
}

/* Whether `missed` light is less than `part` of a light `own`; or of the brightest's, as long as
 * nothing adds up at this place. */
static bool may_miss(const struct crt_drawn *d, struct crt_receiver *receiver, double missed,
                     double own, double part)
{
    if (missed <= fmax(part * own, CRT_TOO_FAINT))
        return true;
    float *account = &receiver->missed[d->place];
    if (missed > part * receiver->brightest ||
        (double)*account + missed > CRT_OFF_PLACE * receiver->brightest)
        return false;
    *account += (float)missed;
    return true;
}

/* The fit as a weight, or false when neither a constant nor a straight line is good enough. `crest`
 * and `energy` are those of all the light of all colours alike, `part` the part of the time during
 * which the spot moves. */
static bool weigh_fit(const struct crt_drawn *d, struct crt_receiver *receiver,
                      const struct crt_share_fit *fit, double crest, double energy, double part,
                      bool instant, struct crt_weight *weight)
{
    double light = d->light[receiver->colour];
    crest *= light;
    energy *= light;
    double own = crest * fit->mean;
    bool constant =
        !d->moving || may_miss(d, receiver, crest * fit->off_constant, own, CRT_OFF_CONSTANT);
    if (!constant && !instant && !may_miss(d, receiver, crest * fit->off_line, own, CRT_OFF_LINE))
        return false;
    *weight = (struct crt_weight){0};
    if (own < CRT_TOO_FAINT)
        return true;
    weight->w0 = (float)(energy * fit->mean);
    weight->w1 = constant ? 0 : (float)(energy * fit->slope * part);
    return true;
}

/* The share over [from, to) of one stroke. */
static bool weigh(const struct crt_drawn *d, struct crt_receiver *receiver,
                  const struct crt_share *share, uint64_t from, uint64_t to,
                  struct crt_weight *weight)
{
    struct crt_share_fit fit = crt_share_over(share, from, to);
    double energy = d->power * crt_seconds(from, to);
    return weigh_fit(d, receiver, &fit, d->crest, energy, 1, to - from < 2, weight);
}

static void locate(const struct crt_drawn *d, uint64_t from, uint64_t to,
                   struct crt_piece_plan *piece)
{
    piece->whole = from == d->t0 && to == d->t1;
    double u0 = span(d->t0, from) / span(d->t0, d->t1), u1 = span(d->t0, to) / span(d->t0, d->t1);
    piece->stretch = (struct crt_stretch){d->x0 + d->dx * u0,
                                          d->y0 + d->dy * u0,
                                          d->x0 + d->dx * u1,
                                          d->y0 + d->dy * u1,
                                          d->sigma,
                                          0,
                                          0};
}

struct halving {
    const struct crt_drawn *drawn;
    struct crt_receiver *receiver;
    int index;
    crt_plan_emit *emit;
    void *context;
    struct crt_piece_plan *piece;
};

/* Pieces for one receiver alone, halved until each will do. */
static void halve(const struct halving *h, const struct crt_share *share, uint64_t from,
                  uint64_t to)
{
    struct crt_weight *weight = &h->piece->weight[h->index];
    if (!weigh(h->drawn, h->receiver, share, from, to, weight)) {
        uint64_t middle = from + (to - from) / 2;
        halve(h, share, from, middle);
        halve(h, share, middle, to);
    } else if (weight->w0 != 0) {
        locate(h->drawn, from, to, h->piece);
        h->emit(h->context, h->piece);
    }
    *weight = (struct crt_weight){0};
}

/* ---- vectors: rest, move, rest --------------------------------------------------------------- */

static bool at_rest(const struct crt_stroke *s, float x, float y)
{
    return s->x0 == x && s->y0 == y && s->x1 == x && s->y1 == y;
}

bool crt_plan_is_rested(const struct crt_entry *at, size_t left, uint64_t from, uint64_t to)
{
    if (left < 3)
        return false;
    const struct crt_stroke *a = &at[0].stroke, *b = &at[1].stroke, *c = &at[2].stroke;
    double dx = (double)b->x1 - (double)b->x0, dy = (double)b->y1 - (double)b->y0;
    return a->t0 >= from && c->t1 <= to && a->t1 == b->t0 && b->t1 == c->t0 &&
           at_rest(a, b->x0, b->y0) && at_rest(c, b->x1, b->y1) &&
           at[0].sigma_mm == at[1].sigma_mm && at[2].sigma_mm == at[1].sigma_mm &&
           at[0].power == at[1].power && at[2].power == at[1].power &&
           dx * dx + dy * dy > at[1].sigma_mm * at[1].sigma_mm;
}

/* The share of the three strokes' light, as a weight for the moving one. While the spot rests a straight line
 * is off by what it changes meanwhile. */
static bool weigh_rested(const struct crt_drawn *d, const struct crt_entry *at,
                         struct crt_receiver *receiver, const struct crt_share *share,
                         struct crt_weight *weight)
{
    uint64_t t0 = at[0].stroke.t0, t1 = at[2].stroke.t1;
    double moving = crt_seconds(d->t0, d->t1), part = moving / crt_seconds(t0, t1);
    double crest = at[0].crest + at[1].crest + at[2].crest;
    struct crt_share_fit fit = crt_share_over(share, t0, t1);
    fit.off_line += fabs(fit.slope) * (1 - part);
    return weigh_fit(d, receiver, &fit, crest, d->power * moving, part, false, weight);
}

void crt_plan_rested(const struct crt_drawn *line, const struct crt_entry *at,
                     struct crt_receiver *receivers, int count, bool *done, crt_plan_emit *emit,
                     void *context)
{
    const struct crt_stroke *a = &at[0].stroke, *c = &at[2].stroke;
    double moving = crt_seconds(line->t0, line->t1);
    struct crt_piece_plan piece;
    bool any = false;
    memset(piece.weight, 0, (size_t)count * sizeof piece.weight[0]);
    for (int i = 0; i < count; i++) {
        done[i] = false;
        for (int k = 0; k < receivers[i].shares && !done[i]; k++) {
            const struct crt_share *share = &receivers[i].share[k];
            done[i] = share->from <= a->t0 && share->to >= c->t1 &&
                      weigh_rested(line, at, &receivers[i], share, &piece.weight[i]);
        }
        any |= piece.weight[i].w0 != 0;
    }
    if (!any)
        return;
    locate(line, line->t0, line->t1, &piece);
    piece.stretch.rest0 = crt_seconds(a->t0, a->t1) / moving;
    piece.stretch.rest1 = crt_seconds(c->t0, c->t1) / moving;
    emit(context, &piece);
}

/* ---- single strokes -------------------------------------------------------------------------- */

void crt_plan(const struct crt_drawn *d, struct crt_receiver *receivers, int count,
              const bool *done, crt_plan_emit *emit, void *context)
{
    struct crt_piece_plan piece;
    bool joined[CRT_MAX_TARGETS], any = false;
    memset(piece.weight, 0, (size_t)count * sizeof piece.weight[0]);
    /* First what takes the stroke in one piece, all together. */
    for (int i = 0; i < count; i++) {
        joined[i] = done[i];
        for (int k = 0; k < receivers[i].shares && !joined[i]; k++) {
            const struct crt_share *share = &receivers[i].share[k];
            joined[i] = share->from <= d->from && share->to >= d->to &&
                        weigh(d, &receivers[i], share, d->from, d->to, &piece.weight[i]);
        }
        any |= piece.weight[i].w0 != 0;
    }
    if (any) {
        locate(d, d->from, d->to, &piece);
        emit(context, &piece);
    }
    memset(piece.weight, 0, (size_t)count * sizeof piece.weight[0]);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < receivers[i].shares && !joined[i]; k++) {
            struct halving h = {d, &receivers[i], i, emit, context, &piece};
            uint64_t from, to;
            if (overlap(d, &receivers[i].share[k], &from, &to))
                halve(&h, &receivers[i].share[k], from, to);
        }
}
