#include "crt/pass.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/pass_parts.h"
#include "crt/plan.h"
#include "crt/tube_parts.h"

/* What a band's planes and films may take of the second-level cache, bytes. */
#define BAND_BYTES (384 * 1024)

static int band_rows_for(int cols, int rows, int planes, int threads)
{
    size_t row_bytes = (size_t)cols * sizeof(float) * (size_t)(planes + 1);
    int tiles = (int)(BAND_BYTES / (row_bytes * CRT_TILE_ROWS));
    int share = (rows + threads * CRT_TILE_ROWS - 1) / (threads * CRT_TILE_ROWS);
    tiles = tiles > share && threads > 1 ? share : tiles;
    return (tiles < 1 ? 1 : tiles) * CRT_TILE_ROWS;
}

struct crt_pass *crt_pass_create(int cols, int rows, int planes, int threads)
{
    struct crt_pass *pass = calloc(1, sizeof *pass);
    if (!pass)
        return NULL;
    pass->cols = cols;
    pass->rows = rows;
    pass->workers = threads;
    pass->band_rows = band_rows_for(cols, rows, planes, threads);
    pass->bands = (rows + pass->band_rows - 1) / pass->band_rows;
    pass->scratch_chunks = (size_t)(cols / 8 > 1024 ? cols / 8 : 1024);
    pass->scratch = malloc((size_t)threads * pass->scratch_chunks * 16 * sizeof(float));
    pass->pieces = malloc(CRT_PASS_BATCH * sizeof pass->pieces[0]);
    pass->weights = malloc(CRT_PASS_BATCH * CRT_MAX_TARGETS * sizeof pass->weights[0]);
    pass->band_items = malloc((size_t)pass->bands * CRT_PASS_BATCH * sizeof pass->band_items[0]);
    pass->band_counts = calloc((size_t)pass->bands, sizeof pass->band_counts[0]);
    if (pass->scratch && pass->pieces && pass->weights && pass->band_items && pass->band_counts)
        return pass;
    crt_pass_destroy(pass);
    return NULL;
}

float *crt_pass_scratch(const struct crt_pass *pass, size_t *chunks)
{
    *chunks = pass->scratch_chunks;
    return pass->scratch;
}

void crt_pass_destroy(struct crt_pass *pass)
{
    if (!pass)
        return;
    free(pass->scratch);
    free(pass->pieces);
    free(pass->weights);
    free(pass->band_items);
    free(pass->band_counts);
    free(pass);
}

/* ---- batches --------------------------------------------------------------------------------- */

/* Films get the light of what planes store. */
static void expose_band(struct crt_pass *pass, int lo, int hi)
{
    int first = lo / CRT_TILE_ROWS, last = (hi + CRT_TILE_ROWS - 1) / CRT_TILE_ROWS;
    int across = pass->tube->planes.tile_cols;
    for (int row = first; row < last; row++)
        crt_pass_tiles(pass, row * across, (row + 1) * across);
}

static void work_band(void *context, int band, int worker)
{
    struct crt_pass *pass = context;
    int lo = band * pass->band_rows, end = lo + pass->band_rows;
    int hi = end < pass->rows ? end : pass->rows;
    if (!pass->tiles_done && pass->feeds > 0)
        expose_band(pass, lo, hi);
    crt_pass_pieces(pass, band, lo, hi, worker);
}

static void flush(struct crt_pass *pass)
{
    for (int i = 0; i < pass->count; i++) {
        const struct crt_shape *shape = &pass->pieces[i].shape;
        int last = (shape->r1 - 1) / pass->band_rows;
        for (int band = shape->r0 / pass->band_rows; band <= last; band++)
            pass->band_items[(size_t)band * CRT_PASS_BATCH + (size_t)pass->band_counts[band]++] =
                (uint16_t)i;
    }
    crt_pool_run(pass->tube->pool, work_band, pass, pass->bands);
    pass->tiles_done = true;
    pass->count = 0;
    memset(pass->band_counts, 0, (size_t)pass->bands * sizeof pass->band_counts[0]);
}

struct planning {
    struct crt_pass *pass;
    const struct crt_entry *entry;
};

static void look_up(struct crt_pass *pass, struct crt_pass_piece *piece,
                    const struct crt_entry *entry, const struct crt_stretch *stretch)
{
    struct crt_tube *tube = pass->tube;
    struct crt_reuse_key key = {.moment = piece->moment};
    struct crt_part whole = {piece->shape.r0, piece->shape.r1, true};
    const float position[4] = {entry->stroke.x0, entry->stroke.y0, entry->stroke.x1,
                               entry->stroke.y1};
    const float rest[2] = {(float)stretch->rest0, (float)stretch->rest1};
    memcpy(key.position, position, sizeof position);
    memcpy(key.rest, rest, sizeof rest);
    memcpy(&key.sigma, &entry->sigma_mm, sizeof key.sigma);
    size_t floats = crt_part_chunks(&piece->shape, whole) * (piece->moment ? 16 : 8);
    piece->store = crt_reuse_find(tube->reuse, &key, floats, tube->planes.epoch, &piece->kept) ==
                   CRT_REUSE_STORE;
}

static void add_piece(void *context, const struct crt_piece_plan *plan)
{
    struct planning *planning = context;
    struct crt_pass *pass = planning->pass;
    struct crt_pass_piece *piece = &pass->pieces[pass->count];
    *piece = (struct crt_pass_piece){0};
    if (!crt_shape_init(&piece->shape, &plan->stretch, pass->cols, pass->rows))
        return;
    struct crt_weight *weights = &pass->weights[pass->count * pass->receivers];
    float scale = (float)(1 / piece->shape.area), turn = piece->shape.turned ? -scale : scale;
    for (int i = 0; i < pass->receivers; i++) {
        weights[i] = (struct crt_weight){plan->weight[i].w0 * scale, plan->weight[i].w1 * turn};
        piece->moment |= weights[i].w1 != 0;
    }
    if (plan->whole && pass->tube->reuse)
        look_up(pass, piece, planning->entry, &plan->stretch);
    if (++pass->count == CRT_PASS_BATCH)
        flush(pass);
}

/* ---- receivers ------------------------------------------------------------------------------- */

/* Light of a film over [from, to), of deposits before and within; only terms of `mask`. */
static void film_shares(struct crt_receiver *receiver, const struct crt_phosphor *phosphor,
                        int colour, uint32_t mask, uint64_t from, uint64_t to)
{
    double exposure = crt_seconds(from, to);
    struct crt_share *before = &receiver->share[0], *within = &receiver->share[1];
    *receiver = (struct crt_receiver){.shares = 2};
    *before = (struct crt_share){.ref = from, .to = from};
    *within = (struct crt_share){.within = true, .ref = to, .from = from, .to = to};
    for (int k = 0; k < phosphor->terms; k++) {
        const struct crt_phosphor_term *term = &phosphor->term[k];
        if (term->colour != colour || !(mask >> k & 1))
            continue;
        crt_share_add(before, -term->w * crt_expm1(-exposure / term->tau_s), term->tau_s);
        crt_share_add(within, term->w, term->tau_s);
    }
}

/* One receiver per film colour, after those already there. */
static void add_films(struct crt_pass *pass, uint32_t mask)
{
    const struct crt_phosphor *phosphor = pass->tube->desc.phosphor;
    for (int i = 0; i < pass->feeds; i++)
        for (int c = 0; c < phosphor->colours; c++) {
            const struct crt_feed *open = &pass->feed[i].open;
            struct crt_receiver *receiver = &pass->receiver[pass->receivers++];
            film_shares(receiver, phosphor, c, mask, open->from, open->to);
            receiver->colour = c;
            receiver->cells = open->film->light[c];
        }
}

static void add_planes(struct crt_pass *pass)
{
    const struct crt_tube *tube = pass->tube;
    for (int k = 0; k < tube->planes.count; k++) {
        const struct crt_plane *plane = &tube->planes.plane[k];
        const struct crt_phosphor_term *term = &tube->desc.phosphor->term[plane->term];
        struct crt_receiver *receiver = &pass->receiver[pass->receivers++];
        *receiver =
            (struct crt_receiver){.cells = plane->cells, .colour = term->colour, .shares = 1};
        receiver->share[0] = (struct crt_share){.ref = tube->end, .to = tube->end};
        crt_share_add(&receiver->share[0], term->w, term->tau_s);
    }
    pass->planes = pass->receivers;
}

/* ---- strokes --------------------------------------------------------------------------------- */

static bool all_done(const struct crt_pass *pass, const bool *done)
{
    for (int i = 0; i < pass->receivers; i++)
        if (!done[i])
            return false;
    return true;
}

/* Strokes between `begin` and `end` to the pass's receivers. */
static void plan_entries(struct crt_pass *pass, const struct crt_entries *entries, uint64_t begin,
                         uint64_t end)
{
    const struct crt_grid *grid = &pass->tube->desc.grid;
    struct crt_drawn drawn;
    if (pass->feeds > 0)
        crt_plan_brightest(entries, grid, begin, end, pass->receiver + pass->planes,
                           pass->receivers - pass->planes);
    for (size_t i = 0, n; i < entries->count; i += n) {
        const struct crt_entry *at = &entries->at[i];
        bool done[CRT_MAX_TARGETS] = {false};
        n = crt_plan_is_rested(at, entries->count - i, begin, end) ? 3 : 1;
        if (n == 3) {
            struct planning planning = {pass, &at[1]};
            if (!crt_drawn_init(&drawn, &at[1], grid, begin, end))
                continue;
            if (drawn.whole)
                crt_plan_rested(&drawn, at, pass->receiver, pass->receivers, done, add_piece,
                                &planning);
        }
        if (n == 3 && all_done(pass, done))
            continue;
        for (size_t k = 0; k < n; k++) {
            struct planning planning = {pass, &at[k]};
            if (crt_drawn_init(&drawn, &at[k], grid, begin, end))
                crt_plan(&drawn, pass->receiver, pass->receivers, done, add_piece, &planning);
        }
    }
}

static void run_strokes(struct crt_pass *pass, uint64_t end)
{
    struct crt_tube *tube = pass->tube;
    if (pass->feeds > 0 && tube->journal.before.count > 0) {
        pass->receivers = pass->planes = 0;
        add_films(pass, tube->quick);
        plan_entries(pass, &tube->journal.before, 0, tube->begin);
        flush(pass);
    }
    pass->receivers = pass->planes = 0;
    if (pass->commit)
        add_planes(pass);
    add_films(pass, UINT32_MAX);
    plan_entries(pass, &tube->journal.now, tube->begin, end);
    flush(pass);
}

/* ---- scan lines ------------------------------------------------------------------------------ */

/* The gun that lights a receiver: three guns have a colour each. */
static int gun_of(const struct crt_pass *pass, int receiver)
{
    const struct crt_tube *tube = pass->tube;
    const struct crt_phosphor *phosphor = tube->desc.phosphor;
    if (crt_tube_guns(tube->desc.row) == 1)
        return 0;
    if (receiver < pass->planes)
        return phosphor->term[tube->planes.plane[receiver].term].colour;
    return (receiver - pass->planes) % phosphor->colours;
}

static void work_line_band(void *context, int band, int worker)
{
    struct crt_pass *pass = context;
    struct crt_tube *tube = pass->tube;
    int lo = band * pass->band_rows, end = lo + pass->band_rows;
    int hi = end < pass->rows ? end : pass->rows;
    if (pass->feeds > 0 && tube->planes.count > 0)
        expose_band(pass, lo, hi);
    crt_line_pass_band(tube->line_pass, lo, hi, worker, &tube->planes, tube->planes.epoch + 1);
}

/* Films without planes are not cleared first: lines write all of their cells. */
static bool is_fresh(const struct crt_pass *pass, int receiver)
{
    const struct crt_tube *tube = pass->tube;
    int colours = tube->desc.phosphor->colours;
    return tube->planes.count == 0 && receiver >= pass->planes &&
           pass->feed[(receiver - pass->planes) / colours].blank;
}

/* Lines of both epochs that begin before `end`. */
static bool plan_lines(struct crt_pass *pass, uint64_t end)
{
    struct crt_tube *tube = pass->tube;
    struct crt_line_target target[CRT_MAX_TARGETS];
    pass->receivers = pass->planes = 0;
    if (pass->commit)
        add_planes(pass);
    int late = pass->late < pass->planes ? pass->late : pass->planes;
    add_films(pass, tube->quick);
    int earlier = pass->receivers - late;
    memcpy(pass->earlier, pass->receiver + late, (size_t)earlier * sizeof pass->earlier[0]);
    pass->receivers = pass->planes;
    add_films(pass, UINT32_MAX);
    for (int i = 0; i < pass->receivers; i++)
        target[i] =
            (struct crt_line_target){pass->receiver[i].cells, gun_of(pass, i), is_fresh(pass, i)};
    crt_line_pass_begin(tube->line_pass, target, pass->receivers, pass->planes);
    return crt_line_pass_add(tube->line_pass, &tube->lines.before, pass->earlier, late, earlier, 0,
                             tube->begin) &&
           crt_line_pass_add(tube->line_pass, &tube->lines.now, pass->receiver, 0, pass->receivers,
                             tube->begin, end) &&
           crt_line_pass_prepare(tube->line_pass, tube->pool);
}

static void run_lines(struct crt_pass *pass, uint64_t end)
{
    struct crt_tube *tube = pass->tube;
    if (!plan_lines(pass, end))
        tube->lost++;
    crt_pool_run(tube->pool, work_line_band, pass, pass->bands);
    crt_line_pass_end(tube->line_pass);
}

/* ---- a pass ---------------------------------------------------------------------------------- */

static void begin_pass(struct crt_pass *pass, struct crt_tube *tube, const struct crt_feed *feeds,
                       int count, bool commit, int late)
{
    pass->tube = tube;
    pass->feeds = count;
    pass->late = late;
    pass->commit = commit;
    pass->tiles_done = false;
    pass->count = 0;
    for (int i = 0; i < count; i++) {
        struct crt_pass_feed *feed = &pass->feed[i];
        feed->open = feeds[i];
        feed->blank = feeds[i].film->blank;
        double dark = crt_seconds(tube->begin, feeds[i].from);
        double exposure = crt_seconds(feeds[i].from, feeds[i].to);
        for (int k = 0; k < tube->planes.count; k++) {
            double tau = tube->desc.phosphor->term[tube->planes.plane[k].term].tau_s;
            feed->share[k] = (float)(-crt_expm1(-exposure / tau) * crt_exp(-dark / tau));
        }
    }
}

static void run(struct crt_tube *tube, const struct crt_feed *feeds, int count, bool commit,
                int late)
{
    struct crt_pass *pass = tube->pass;
    assert(count <= CRT_PASS_FILMS);
    begin_pass(pass, tube, feeds, count, commit, late);
    uint64_t end = commit ? tube->end : tube->begin;
    for (int i = 0; i < count; i++)
        end = feeds[i].to > end ? feeds[i].to : end;
    if (tube->line_pass)
        run_lines(pass, end);
    else
        run_strokes(pass, end);
    for (int i = 0; i < count; i++) {
        feeds[i].film->blank = false;
        feeds[i].film->fed_to = feeds[i].to;
    }
}

void crt_pass_run(struct crt_tube *tube, const struct crt_feed *feeds, int count, bool commit)
{
    run(tube, feeds, count, commit, CRT_MAX_TARGETS);
}

void crt_pass_run_late(struct crt_tube *tube, const struct crt_feed *feeds, int count, int late)
{
    run(tube, feeds, count, true, late);
}
