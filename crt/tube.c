#include "crt/tube.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/mask.h"
#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/plan.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

/* Quick terms are followed for this many time constants after a stroke: e^−18 = 2e-8. */
#define QUICK_SPAN 18.0

/* Cells may not be so large that the spot falls between them, nor so small that counting them in a
 * spot is beyond the kernels. */
static bool sane_cells(const struct crt_tube_desc *desc, struct crt_error *err)
{
    const struct crt_grid *g = &desc->grid;
    if (!(g->cell_mm > 0) || !isfinite(g->cell_mm) || !isfinite(g->left_mm) || !isfinite(g->top_mm))
        return crt_fail(err, "film cells of %g mm are impossible", g->cell_mm);
    double sigma = crt_spot_sigma0(desc->row), most = sigma / CRT_LEAST_SIGMA;
    if (!(g->cell_mm <= most * (1 + 1e-9)))
        return crt_fail(err,
                        "film cells of %g mm are too large for the spot of this tube; have at most "
                        "%g mm, with a smaller area or more cells",
                        g->cell_mm, most);
    if (g->cell_mm < sigma / CRT_MOST_SIGMA)
        return crt_fail(err, "film cells of %g mm are too small; have at least %g mm", g->cell_mm,
                        sigma / CRT_MOST_SIGMA);
    return true;
}

static bool sane_desc(const struct crt_tube_desc *desc, struct crt_error *err)
{
    const struct crt_grid *g = &desc->grid;
    if (g->cols < 8 || g->cols % 8 || g->rows < 1 || g->cols > 65536 || g->rows > 65536)
        return crt_fail(
            err, "a film grid of %d x %d cells is impossible; use 8 to 65536 columns, in eights",
            g->cols, g->rows);
    if ((int64_t)g->cols * g->rows > CRT_MAX_GRID_CELLS)
        return crt_fail(err, "a film grid of %d x %d cells is too large; choose larger cells",
                        g->cols, g->rows);
    if (desc->threads < 1 || desc->threads > 256)
        return crt_fail(err, "%d threads are impossible; use 1 to 256", desc->threads);
    return crt_tube_check_phosphor(desc->row, desc->phosphor, err) &&
           crt_penetration_fits(desc->row, desc->phosphor, err) && sane_cells(desc, err);
}

void crt_tube_note_quick(struct crt_tube *tube)
{
    const struct crt_phosphor *phosphor = tube->desc.phosphor;
    double longest = 0;
    tube->quick = 0;
    for (int k = 0; k < phosphor->terms; k++) {
        bool lasting = false;
        for (int p = 0; p < tube->planes.count; p++)
            lasting |= tube->planes.plane[p].term == k;
        if (lasting)
            continue;
        tube->quick |= UINT32_C(1) << k;
        longest = fmax(longest, phosphor->term[k].tau_s);
    }
    tube->keep = (uint64_t)(QUICK_SPAN * longest * 1e12);
}

struct crt_tube *crt_tube_create(const struct crt_tube_desc *desc, struct crt_error *err)
{
    if (!sane_desc(desc, err))
        return NULL;
    const struct crt_kernels *kernels = crt_kernels_find(desc->simd, err);
    if (!kernels)
        return NULL;
    struct crt_tube *tube = calloc(1, sizeof *tube);
    if (!tube) {
        crt_fail(err, "out of memory for a tube");
        return NULL;
    }
    tube->desc = *desc;
    for (unsigned level = 0; level < CRT_LEVELS; level++)
        tube->voltage[level] = crt_voltage_at(desc->row, desc->phosphor, (enum crt_level)level);
    tube->kernels = kernels;
    tube->end = crt_tick_time(desc->epoch, 1);
    double epoch_s = (double)desc->epoch.den / (double)desc->epoch.num;
    int cols = desc->grid.cols, rows = desc->grid.rows;
    double least = desc->row->kind == CRT_RASTER_TUBE ? CRT_PLANE_SHARE_LINES : CRT_PLANE_SHARE;
    bool ok = crt_planes_init(&tube->planes, desc->phosphor, cols, rows, epoch_s, least, kernels);
    if (ok) {
        crt_tube_note_quick(tube);
        tube->pass = crt_pass_create(cols, rows, tube->planes.count, desc->threads);
        ok = tube->pass != NULL;
    }
    if (ok && desc->row->kind == CRT_RASTER_TUBE) {
        tube->line_pass = crt_line_pass_create(desc->row, desc->phosphor, &desc->grid,
                                               desc->threads, desc->simd, !desc->no_reuse, err);
        if (!tube->line_pass) {
            crt_tube_destroy(tube);
            return NULL;
        }
    }
    if (!ok) {
        crt_fail(err, "out of memory for a tube of %d x %d cells; choose larger cells", cols, rows);
        crt_tube_destroy(tube);
        return NULL;
    }
    if (!desc->no_reuse)
        tube->reuse = crt_reuse_create(); /* without memory for it, everything is computed */
    if (desc->threads > 1) {
        tube->pool = crt_pool_create(desc->threads, err);
        if (!tube->pool) {
            crt_tube_destroy(tube);
            return NULL;
        }
    }
    return tube;
}

void crt_tube_destroy(struct crt_tube *tube)
{
    if (!tube)
        return;
    crt_pool_destroy(tube->pool);
    crt_pass_destroy(tube->pass);
    crt_planes_free(&tube->planes);
    crt_journal_free(&tube->journal);
    crt_lines_free(&tube->lines);
    crt_line_pass_destroy(tube->line_pass);
    crt_reuse_destroy(tube->reuse);
    free(tube);
}

void crt_tube_set_knobs(struct crt_tube *tube, struct crt_knobs knobs)
{
    tube->desc.knobs = knobs;
    tube->spot_valid = false;
}

struct crt_knobs crt_tube_knobs(const struct crt_tube *tube)
{
    return tube->desc.knobs;
}

static bool sane_stroke(const struct crt_stroke *s)
{
    return s->t1 > s->t0 && isfinite(s->x0) && isfinite(s->y0) && isfinite(s->x1) &&
           isfinite(s->y1);
}

/* The beam's voltage: how wide it is, where it goes, and what it lights. */
static void apply_voltage(const struct crt_voltage *voltage, double sigma_mm,
                          struct crt_entry *entry)
{
    struct crt_stroke *s = &entry->stroke;
    float *const place[4] = {&s->x0, &s->y0, &s->x1, &s->y1};
    entry->sigma_mm = sigma_mm * voltage->sigma;
    memcpy(entry->light, voltage->light, sizeof entry->light);
    for (int i = 0; voltage->place != 1 && i < 4; i++)
        *place[i] = (float)((double)*place[i] * voltage->place);
}

void crt_tube_stroke(struct crt_tube *tube, const struct crt_stroke *stroke)
{
    assert(stroke->t0 >= tube->last_start && stroke->t0 >= tube->now);
    assert(stroke->level < CRT_LEVELS);
    tube->last_start = stroke->t0;
    tube->strokes++;
    if (!sane_stroke(stroke))
        return;
    if (!tube->spot_valid || stroke->drive != tube->spot_drive) {
        tube->spot = crt_spot_at(tube->desc.row, &tube->desc.knobs, (double)stroke->drive);
        tube->spot_drive = stroke->drive;
        tube->spot_valid = true;
    }
    if (!(tube->spot.power > 0))
        return;
    struct crt_entry entry = {.stroke = *stroke, .power = tube->spot.power};
    apply_voltage(&tube->voltage[stroke->level], tube->spot.sigma_mm, &entry);
    entry.crest = crt_plan_crest(&entry);
    if (!crt_journal_push(&tube->journal, &entry))
        tube->lost++;
    crt_diodes_stroke(tube->diodes, &entry);
}

static bool sane_line(const struct crt_scan_line *line)
{
    return line->t1 > line->t0 && isfinite(line->x0) && isfinite(line->x1) && isfinite(line->y0) &&
           line->y0 == line->y1 && line->x0 < line->x1;
}

void crt_tube_scan_line(struct crt_tube *tube, const struct crt_scan_line *line)
{
    assert(tube->line_pass && line->guns == crt_tube_guns(tube->desc.row));
    assert(line->dots >= 1 && line->dots <= CRT_MAX_DOTS);
    assert(line->t0 >= tube->last_start && line->t0 >= tube->now);
    tube->last_start = line->t0;
    tube->strokes++;
    if (!sane_line(line))
        return;
    if (!crt_lines_push(&tube->lines, &tube->lines.now, tube->desc.row, &tube->desc.knobs, line))
        tube->lost++;
    crt_diodes_scan_line(tube->diodes, line, &tube->desc.knobs);
}

bool crt_tube_intact(const struct crt_tube *tube, struct crt_error *err)
{
    if (tube->lost == 0)
        return true;
    return crt_fail(err,
                    "out of memory: the light of %llu strokes or scan lines was lost; draw less in "
                    "a refresh",
                    (unsigned long long)tube->lost);
}

/* ---- time ------------------------------------------------------------------------------------ */

/* The stretch of a film that can be exposed now; false: none. */
static bool feedable(const struct crt_tube *tube, const struct crt_film *film, bool commit,
                     struct crt_feed *feed)
{
    uint64_t from = film->t0 > tube->begin ? film->t0 : tube->begin;
    uint64_t to = film->t1 < tube->end ? film->t1 : tube->end;
    if (from >= to || film->fed_to >= to || (!commit && film->t1 > tube->now))
        return false;
    *feed = (struct crt_feed){(struct crt_film *)film, from, to};
    return true;
}

static void drop_complete(struct crt_tube *tube)
{
    struct crt_film **link = &tube->films;
    while (*link) {
        struct crt_film *film = *link;
        if (film->fed_to >= film->t1) {
            crt_mask_complete(&tube->desc, film, tube->pool);
            film->complete = true;
            *link = film->next;
            film->next = NULL;
        } else {
            link = &film->next;
        }
    }
}

void crt_tube_feed(struct crt_tube *tube, bool commit, int late)
{
    struct crt_feed feeds[CRT_PASS_FILMS];
    int count = 0;
    for (struct crt_film *film = tube->films; film; film = film->next) {
        if (!feedable(tube, film, commit, &feeds[count]))
            continue;
        if (++count == CRT_PASS_FILMS) {
            crt_pass_run(tube, feeds, count, false);
            count = 0;
        }
    }
    if (commit)
        crt_pass_run_late(tube, feeds, count, late);
    else if (count > 0)
        crt_pass_run(tube, feeds, count, false);
    drop_complete(tube);
}

static void end_epoch(struct crt_tube *tube)
{
    crt_tube_feed(tube, true, tube->planes.count);
    uint64_t keep_from = tube->end > tube->keep ? tube->end - tube->keep : 0;
    keep_from = tube->keep ? keep_from : UINT64_MAX;
    if (!crt_journal_turn(&tube->journal, tube->end, keep_from))
        tube->lost++;
    if (!crt_lines_turn(&tube->lines, tube->end, keep_from))
        tube->lost++;
    tube->planes.epoch++;
    tube->begin = tube->end;
    tube->end = crt_tube_epoch_time(tube, tube->planes.epoch + 1);
}

/* Epochs in which nothing is drawn and nothing exposed only move the clock; planes age when
 * touched. */
static void skip_epochs(struct crt_tube *tube)
{
    uint64_t until = tube->now;
    if (tube->journal.now.count > 0 && tube->journal.now.at[0].stroke.t0 < until)
        until = tube->journal.now.at[0].stroke.t0;
    if (tube->lines.now.count > 0 && tube->lines.now.at[0].t0 < until)
        until = tube->lines.now.at[0].t0;
    for (const struct crt_film *film = tube->films; film; film = film->next)
        until = film->t0 < until ? film->t0 : until;
    uint64_t epoch = crt_tube_epoch_at(tube, until);
    if (epoch < tube->planes.epoch + 2)
        return;
    tube->journal.before.count = 0;
    crt_line_list_clear(&tube->lines.before);
    tube->planes.epoch = epoch;
    tube->begin = crt_tube_epoch_time(tube, epoch);
    tube->end = crt_tube_epoch_time(tube, epoch + 1);
}

void crt_tube_advance(struct crt_tube *tube, uint64_t now)
{
    assert(now >= tube->now);
    tube->now = now;
    skip_epochs(tube);
    while (tube->end <= now) {
        end_epoch(tube);
        skip_epochs(tube);
    }
    crt_tube_feed(tube, false, tube->planes.count);
    crt_diodes_advance(tube->diodes);
}
