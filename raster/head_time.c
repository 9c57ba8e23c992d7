/* Dots and time: where the beam is, and what comes next. A row r of field f begins f·V_TOTAL + r
 * units after the origin; a unit is a line, or half of one when interlaced. */
#include "raster/head_parts.h"

/* Dots or rows of the tube's border, at most `most`. */
static int64_t border(double border_mm, double pitch_mm, int64_t most)
{
    int64_t half = (CRT_MAX_DOTS - RAS_MAX_DOTS) / 2;
    most = most < half ? most : half;
    double n = border_mm / pitch_mm;
    return n < (double)most ? (int64_t)n : most;
}

void ras_sweep_of(struct ras_sweep *w, const struct ras_timing *t, const struct ras_head_desc *desc)
{
    int64_t lace = t->interlaced ? 1 : 0, rows = t->v.visible;
    double x_mm = desc->width_mm / t->h.visible, y_mm = desc->height_mm / t->v.visible;
    *w = (struct ras_sweep){.line = t->h.total, .step = 1 + lace};
    w->unit = w->line / w->step;
    w->field = w->unit * t->v.total;
    w->sync_begin = w->unit * (t->v.sync_start + lace);
    w->sync_end = w->unit * (t->v.sync_end + lace);
    w->left = border(desc->border_mm, x_mm, t->h.total - t->h.sync_end);
    w->right = border(desc->border_mm, x_mm, t->h.sync_start - t->h.visible);
    w->top = -border(desc->border_mm, y_mm, t->v.total - t->v.sync_end - lace);
    w->bottom = rows - 1 + border(desc->border_mm, y_mm, t->v.sync_start - rows);
}

uint64_t ras_dot_time(const struct ras_head *head, uint64_t dot)
{
    return head->origin + crt_tick_time(head->timing.clock, dot);
}

uint64_t ras_dot_at(const struct ras_head *head, uint64_t t)
{
    return t > head->origin ? crt_tick_at(head->timing.clock, t - head->origin) : 0;
}

/* ---- rows ------------------------------------------------------------------------------------- */

int64_t ras_row_at(const struct ras_head *head, uint64_t begin)
{
    int64_t total = head->timing.v.total;
    int64_t row = (int64_t)begin / head->sweep.unit % total;
    return row > head->sweep.bottom && row - total >= head->sweep.top ? row - total : row;
}

uint64_t ras_line_after(const struct ras_head *head, int64_t after, int64_t first, int64_t last)
{
    const struct ras_sweep *w = &head->sweep;
    int64_t total = head->timing.v.total;
    int64_t from = after < 0 ? 0 : after / w->unit + 1; /* units since the origin */
    int64_t field = from > last ? (from - last + total - 1) / total : 0;
    /* Of one row, interlaced, every other field has none. */
    for (int64_t end = field + 2; field <= end; field++) {
        int64_t begin = field * total;
        int64_t row = first > from - begin ? first : from - begin;
        if (w->step == 2 && (uint64_t)(row + begin) % 2)
            row++;
        if (row <= last)
            return (uint64_t)((begin + row) * w->unit);
    }
    return RAS_NEVER;
}

uint64_t ras_periodic_after(int64_t after, int64_t offset, int64_t period)
{
    int64_t n = after < offset ? 0 : (after - offset) / period + 1;
    return (uint64_t)(offset + n * period);
}

/* ---- the next event --------------------------------------------------------------------------- */

/* The first line of the timing has no overscan on its left: it would have begun before. */
static uint64_t next_pixels(const struct ras_head *head, int64_t after)
{
    const struct ras_sweep *w = &head->sweep;
    uint64_t begin = ras_line_after(head, after < 0 ? -1 : after + w->left, w->top, w->bottom);
    return begin == 0 || begin == RAS_NEVER ? begin : begin - (uint64_t)w->left;
}

static uint64_t next_of(const struct ras_head *head, unsigned kind, int64_t after)
{
    if (kind == RAS_EVENT_RETRACE)
        return ras_periodic_after(after, head->sweep.sync_begin, head->sweep.field);
    if (kind == RAS_EVENT_LINE)
        return next_pixels(head, after);
    return head->compare < head->timing.v.visible
               ? ras_line_after(head, after, head->compare, head->compare)
               : RAS_NEVER;
}

void ras_schedule(struct ras_head *head, uint64_t dot, unsigned kind)
{
    head->next_dot = RAS_NEVER;
    for (unsigned k = 0; k < RAS_EVENTS; k++) {
        uint64_t at = next_of(head, k, (int64_t)dot - (k >= kind));
        if (at < head->next_dot) {
            head->next_dot = at;
            head->next_kind = k;
        }
    }
    head->next_time = ras_dot_time(head, head->next_dot);
}

/* ---- the beam --------------------------------------------------------------------------------- */

bool ras_head_beam(const struct ras_head *head, uint64_t t, uint32_t *line, uint32_t *dot)
{
    *line = *dot = 0;
    if (!head->on)
        return false;
    uint64_t n = ras_dot_at(head, t), length = (uint64_t)head->sweep.line;
    *line = (uint32_t)(n / length * (uint64_t)head->sweep.step % head->timing.v.total);
    *dot = (uint32_t)(n % length);
    return true;
}

uint64_t ras_head_fields(const struct ras_head *head, uint64_t t)
{
    return head->on ? ras_dot_at(head, t) / (uint64_t)head->sweep.field + 1 : 0;
}
