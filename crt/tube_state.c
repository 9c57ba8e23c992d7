/* A tube in a snapshot: planes, journal, time, knobs. Caches are no part of it. */
#include "crt/tube.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "crt/line_state.h"
#include "crt/photodiode_parts.h"
#include "crt/plan.h"
#include "crt/tube_parts.h"

#define VERSION 2

/* Longer strokes are none that a head could have drawn, ps (two and a half hours). */
#define LONGEST (UINT64_C(1) << 53)

/* More energy than any tube can store in a cell, cd·s/m². */
#define BRIGHTEST 1e30F

#define CHUNK 8 /* cells that are written together or not at all */

/* ---- planes ------------------------------------------------------------------------------------ */

static bool all_dark(const float *cells)
{
    static const float dark[CHUNK];
    return memcmp(cells, dark, sizeof dark) == 0;
}

static void cells_state(struct crt_state *s, float *cells)
{
    bool sane = true;
    crt_state_f32s(s, cells, CHUNK);
    for (int i = 0; i < CHUNK; i++)
        sane &= cells[i] >= -BRIGHTEST && cells[i] <= BRIGHTEST; /* not a NaN either */
    if (!crt_state_check(s, sane, "stored light"))
        memset(cells, 0, CHUNK * sizeof cells[0]);
}

/* Each row of a tile: which of its chunks hold anything, and those. */
static void tile_state(const struct crt_planes *planes, float *cells, int tile, struct crt_state *s)
{
    struct crt_tile place = crt_planes_place(planes, tile);
    int chunks = place.cols / CHUNK;
    for (int row = 0; row < place.rows; row++, cells += planes->cols) {
        uint8_t lit = 0;
        for (int i = 0; !s->loading && i < chunks; i++)
            lit = (uint8_t)(lit | !all_dark(cells + i * CHUNK) << i);
        crt_state_u8(s, &lit);
        crt_state_check(s, lit >> chunks == 0, "stored light");
        for (int i = 0; i < chunks; i++)
            if (lit >> i & 1)
                cells_state(s, cells + i * CHUNK);
    }
}

/* A tile's cells as of the running epoch; NULL when they are dark. Ageing is not seen from outside
 * (crt/planes.h), and the bytes do not depend on when it was done. */
static float *lit_tile(struct crt_planes *planes, int k, int tile)
{
    struct crt_tile place = crt_planes_place(planes, tile);
    float *cells = crt_planes_tile(planes, k, tile, planes->epoch), *row = cells;
    for (int r = 0; cells && r < place.rows; r++, row += planes->cols)
        for (int c = 0; c < place.cols; c += CHUNK)
            if (!all_dark(row + c))
                return cells;
    return NULL;
}

static void save_plane(struct crt_planes *planes, int k, uint32_t tiles, struct crt_state *s)
{
    uint32_t count = 0;
    for (uint32_t tile = 0; tile < tiles; tile++)
        count += lit_tile(planes, k, (int)tile) != NULL;
    crt_state_u32(s, &count);
    for (uint32_t tile = 0; tile < tiles; tile++) {
        float *cells = lit_tile(planes, k, (int)tile);
        if (!cells)
            continue;
        crt_state_u32(s, &tile);
        tile_state(planes, cells, (int)tile, s);
    }
}

static void load_plane(struct crt_planes *planes, int k, uint32_t tiles, struct crt_state *s)
{
    struct crt_plane *plane = &planes->plane[k];
    uint32_t count = 0, after = 0, tile = 0;
    memset(plane->cells, 0, (size_t)planes->cols * (size_t)planes->rows * sizeof plane->cells[0]);
    memset(plane->lit, 0, tiles);
    crt_state_u32(s, &count);
    for (; count > 0 && !s->failed; count--) {
        crt_state_u32(s, &tile);
        if (!crt_state_check(s, tile >= after && tile < tiles, "tile"))
            return;
        after = tile + 1;
        plane->lit[tile] = 1;
        plane->age[tile] = planes->epoch;
        tile_state(planes, crt_planes_tile(planes, k, (int)tile, planes->epoch), (int)tile, s);
    }
}

static void planes_state(struct crt_planes *planes, struct crt_state *s)
{
    uint32_t count = (uint32_t)planes->count;
    crt_state_u32(s, &count);
    if (!crt_state_check(s, count == (uint32_t)planes->count, "number of planes"))
        return;
    uint32_t tiles = (uint32_t)planes->tile_cols * (uint32_t)planes->tile_rows;
    for (int k = 0; k < planes->count; k++)
        if (s->loading)
            load_plane(planes, k, tiles, s);
        else
            save_plane(planes, k, tiles, s);
}

/* ---- journal ----------------------------------------------------------------------------------- */

/* What strokes of this tube can have. */
struct limits {
    uint64_t begin, last_start;
    double power, sigma_mm; /* the most; the least */
    const struct crt_voltage *voltage;
};

static struct limits limits_of(const struct crt_tube *tube)
{
    const struct crt_knobs neutral = {0, 1, 0};
    return (struct limits){tube->begin, tube->last_start,
                           crt_spot_at(tube->desc.row, &neutral, 1).power,
                           crt_spot_sigma0(tube->desc.row) * (1 - 1e-9), tube->voltage};
}

static bool sane_entry(const struct limits *limits, const struct crt_entry *entry)
{
    const struct crt_stroke *stroke = &entry->stroke;
    return stroke->level < CRT_LEVELS && stroke->t0 <= limits->last_start &&
           stroke->t1 > stroke->t0 && stroke->t1 - stroke->t0 <= LONGEST && isfinite(stroke->x0) &&
           isfinite(stroke->y0) && isfinite(stroke->x1) && isfinite(stroke->y1) &&
           isfinite(stroke->drive) && entry->power > 0 && entry->power <= limits->power &&
           entry->sigma_mm >= limits->sigma_mm && isfinite(entry->sigma_mm);
}

static void entry_state(struct crt_entry *entry, const struct limits *limits, struct crt_state *s)
{
    struct crt_stroke *stroke = &entry->stroke;
    crt_state_u64(s, &stroke->t0);
    crt_state_u64(s, &stroke->t1);
    crt_state_f32(s, &stroke->x0);
    crt_state_f32(s, &stroke->y0);
    crt_state_f32(s, &stroke->x1);
    crt_state_f32(s, &stroke->y1);
    crt_state_f32(s, &stroke->drive);
    crt_state_u32(s, &stroke->source);
    crt_state_u32(s, &stroke->level);
    crt_state_f64(s, &entry->power);
    crt_state_f64(s, &entry->sigma_mm);
    if (!crt_state_check(s, sane_entry(limits, entry), "stroke"))
        return;
    entry->crest = crt_plan_crest(entry);
    memcpy(entry->light, limits->voltage[stroke->level].light, sizeof entry->light);
}

/* Strokes in order of their begin. Those of the epoch before began before the running one, the
 * others end in it or later. */
static void entries_state(struct crt_entries *list, const struct limits *limits, bool before,
                          struct crt_state *s)
{
    size_t count = list->count;
    uint64_t last = 0;
    if (s->loading)
        list->count = 0;
    crt_state_size(s, &count, SIZE_MAX);
    for (size_t i = 0; i < count && !s->failed; i++) {
        struct crt_entry entry = {.power = 0};
        if (!s->loading)
            entry = list->at[i];
        entry_state(&entry, limits, s);
        bool here = before ? entry.stroke.t0 < limits->begin : entry.stroke.t1 > limits->begin;
        if (!crt_state_check(s, here && entry.stroke.t0 >= last, "order of strokes"))
            return;
        last = entry.stroke.t0;
        if (s->loading && !crt_entries_push(list, &entry))
            crt_state_fail(s, "not enough memory for the snapshot's strokes; close other programs");
    }
}

/* Cells lie where they did: in a close-up they do not. */
static void grid_state(const struct crt_grid *grid, struct crt_state *s)
{
    struct crt_grid g = *grid;
    crt_state_i32(s, &g.cols);
    crt_state_i32(s, &g.rows);
    crt_state_f64(s, &g.cell_mm);
    crt_state_f64(s, &g.left_mm);
    crt_state_f64(s, &g.top_mm);
    if (g.cols != grid->cols || g.rows != grid->rows || g.cell_mm != grid->cell_mm ||
        g.left_mm != grid->left_mm || g.top_mm != grid->top_mm)
        crt_state_fail(s, "the snapshot's light lies on other film cells than this tube's: one of "
                          "the two is a close-up, or another one");
}

/* ---- all of it --------------------------------------------------------------------------------- */

static void knobs_state(struct crt_tube *tube, struct crt_state *s)
{
    struct crt_knobs knobs = tube->desc.knobs;
    crt_state_f64(s, &knobs.brightness);
    crt_state_f64(s, &knobs.contrast);
    crt_state_f64(s, &knobs.focus);
    if (crt_state_check(s,
                        fabs(knobs.brightness) <= 1e6 && fabs(knobs.contrast) <= 1e6 &&
                            fabs(knobs.focus) <= 1e6,
                        "knob setting") &&
        s->loading)
        crt_tube_set_knobs(tube, knobs);
}

/* The running epoch follows from the time. */
static void time_state(struct crt_tube *tube, struct crt_state *s)
{
    crt_state_u64(s, &tube->now);
    crt_state_u64(s, &tube->last_start);
    crt_state_u64(s, &tube->strokes);
    crt_state_u64(s, &tube->lost);
    if (!crt_state_check(s,
                         tube->now < CRT_STATE_LATEST && tube->last_start < CRT_STATE_LATEST &&
                             tube->origin <= tube->now,
                         "time"))
        tube->now = tube->last_start = tube->origin = 0;
    uint64_t epoch = crt_tube_epoch_at(tube, tube->now);
    assert(s->loading || epoch == tube->planes.epoch);
    tube->planes.epoch = epoch;
    tube->begin = crt_tube_epoch_time(tube, epoch);
    tube->end = crt_tube_epoch_time(tube, epoch + 1);
}

void crt_tube_state(struct crt_tube *tube, struct crt_state *s)
{
    if (s->loading)
        crt_tube_cancel_films(tube);
    crt_state_begin(s, "TUBE", VERSION);
    grid_state(&tube->desc.grid, s);
    if (tube->line_pass)
        crt_line_timing_state(tube, s);
    time_state(tube, s);
    knobs_state(tube, s);
    planes_state(&tube->planes, s);
    struct limits limits = limits_of(tube);
    entries_state(&tube->journal.before, &limits, true, s);
    entries_state(&tube->journal.now, &limits, false, s);
    if (tube->line_pass)
        crt_lines_state(tube, s);
    crt_state_end(s);
    if (s->loading)
        crt_diodes_restart(tube->diodes, s->failed);
}

struct crt_tube_times crt_tube_times(const struct crt_tube *tube)
{
    return (struct crt_tube_times){tube->now, tube->last_start};
}
