#include "crt/pass.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/plan.h"
#include "crt/tube_parts.h"

/* Pieces planned before the bands are worked on. */
#define BATCH 2048

/* What a band's planes and films may take of the second-level cache, bytes. */
#define BAND_BYTES (384 * 1024)

/* A piece of footprint with its weights, ready for the bands. */
struct piece {
    struct crt_shape shape;
    float *kept; /* its footprint in the reuse memory, or NULL */
    bool store;  /* … to be computed first */
    bool moment; /* some weight has a slope */
};

struct feed {
    struct crt_feed open;
    bool blank;
    float share[CRT_MAX_TERMS]; /* of each plane's energy that the film gets */
};

struct crt_pass {
    int cols, rows;
    int band_rows, bands;
    int workers;
    size_t scratch_chunks; /* per worker, for F0 and again for F1 */
    float *scratch;
    struct piece *pieces;
    struct crt_weight *weights; /* [piece][receiver] */
    uint16_t *band_items;       /* [band][…] pieces of each band in order */
    int *band_counts;
    /* the running pass */
    struct crt_tube *tube;
    struct feed feed[CRT_PASS_FILMS];
    int feeds;
    bool commit, tiles_done;
    struct crt_receiver receiver[CRT_MAX_TARGETS];
    int receivers, planes; /* planes come first */
    int count;             /* pieces in the batch */
};

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
    pass->pieces = malloc(BATCH * sizeof pass->pieces[0]);
    pass->weights = malloc(BATCH * CRT_MAX_TARGETS * sizeof pass->weights[0]);
    pass->band_items = malloc((size_t)pass->bands * BATCH * sizeof pass->band_items[0]);
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

/* ---- bands: planes to films
 * ------------------------------------------------------------------------ */

/* One tile of one film colour: the planes of that colour, or darkness. */
static bool expose_tile(struct crt_pass *pass, const struct feed *feed, int colour, int tile,
                        float *const cells[])
{
    struct crt_tube *tube = pass->tube;
    struct crt_tile place = crt_planes_place(&tube->planes, tile);
    float *light =
        feed->open.film->light[colour] + (size_t)place.row * (size_t)pass->cols + (size_t)place.col;
    bool add = !feed->blank;
    for (int k = 0; k < tube->planes.count; k++) {
        int term = tube->planes.plane[k].term;
        if (!cells[k] || tube->desc.phosphor->term[term].colour != colour)
            continue;
        tube->kernels->expose(cells[k], light, pass->cols, place.rows, place.cols, feed->share[k],
                              add);
        add = true;
    }
    return add;
}

static void clear_tile(struct crt_pass *pass, float *light, int tile)
{
    struct crt_tile place = crt_planes_place(&pass->tube->planes, tile);
    light += (size_t)place.row * (size_t)pass->cols + (size_t)place.col;
    for (int r = 0; r < place.rows; r++, light += pass->cols)
        memset(light, 0, (size_t)place.cols * sizeof light[0]);
}

static void work_tile(struct crt_pass *pass, int tile)
{
    struct crt_tube *tube = pass->tube;
    float *cells[CRT_MAX_TERMS];
    for (int k = 0; k < tube->planes.count; k++)
        cells[k] = crt_planes_tile(&tube->planes, k, tile, tube->planes.epoch);
    for (int i = 0; i < pass->feeds; i++)
        for (int c = 0; c < tube->desc.phosphor->colours; c++)
            if (!expose_tile(pass, &pass->feed[i], c, tile, cells))
                clear_tile(pass, pass->feed[i].open.film->light[c], tile);
}

/* Lit tiles side by side from `tile` on, before `end`, brought up to date. */
static int lit_run(struct crt_pass *pass, int tile, int end)
{
    struct crt_planes *planes = &pass->tube->planes;
    int run = 0;
    while (tile + run < end && run < CRT_RUN_TILES &&
           crt_planes_tile(planes, 0, tile + run, planes->epoch))
        run++;
    return run;
}

/* The usual case, one plane, one film, and the epoch ends: tiles [tile, end) of one row of tiles
 * exposed and aged in one sweep, along whole rows of cells where they are lit. */
static void sweep_tiles(struct crt_pass *pass, int tile, int end)
{
    struct crt_tube *tube = pass->tube;
    struct crt_plane *plane = &tube->planes.plane[0];
    const struct feed *feed = &pass->feed[0];
    while (tile < end) {
        int run = lit_run(pass, tile, end);
        if (run == 0) {
            work_tile(pass, tile++);
            continue;
        }
        struct crt_tile first = crt_planes_place(&tube->planes, tile);
        struct crt_tile last = crt_planes_place(&tube->planes, tile + run - 1);
        size_t at = (size_t)first.row * (size_t)pass->cols + (size_t)first.col;
        tube->kernels->expose_age(plane->cells + at, feed->open.film->light[0] + at, pass->cols,
                                  first.rows, last.col + last.cols - first.col, feed->share[0],
                                  !feed->blank, plane->factor, CRT_STORED_FLOOR, plane->lit + tile);
        for (int i = 0; i < run; i++)
            plane->age[tile + i] = tube->planes.epoch + 1;
        tile += run;
    }
}

static void work_tiles(struct crt_pass *pass, int tile, int end)
{
    const struct crt_tube *tube = pass->tube;
    if (pass->commit && tube->planes.count == 1 && pass->feeds == 1 &&
        tube->desc.phosphor->colours == 1)
        sweep_tiles(pass, tile, end);
    else
        for (; tile < end; tile++)
            work_tile(pass, tile);
}

/* ---- bands: pieces
 * ----------------------------------------------------------------------------------- */

static int lesser(int a, int b)
{
    return a < b ? a : b;
}

static int greater(int a, int b)
{
    return a > b ? a : b;
}

/* Tells the planes which tiles rows [lo, hi) of a row walk reach, a row of tiles at a time. */
static void touch_rows(struct crt_tube *tube, const struct crt_shape *shape, int lo, int hi,
                       uint64_t epoch)
{
    for (int row = lo; row < hi;) {
        int next = lesser(hi, (row / CRT_TILE_ROWS + 1) * CRT_TILE_ROWS);
        int a = crt_shape_start(shape, row), b = crt_shape_start(shape, next - 1);
        int left = greater(0, lesser(lesser(a, b), shape->last));
        int right = greater(0, lesser(greater(a, b), shape->last)) + 8 * shape->count - 1;
        crt_planes_touch(&tube->planes, row, next, left, right, epoch);
        row = next;
    }
}

static void touch_columns(struct crt_tube *tube, const struct crt_shape *shape, int lo, int hi,
                          uint64_t epoch)
{
    enum { GROUPS = CRT_TILE_COLS / 8 };
    for (int at = shape->a0; at < shape->a1;) {
        int next = lesser(shape->a1, (at / GROUPS + 1) * GROUPS);
        int a = crt_shape_start(shape, at), b = crt_shape_start(shape, next - 1);
        int top = greater(lo, lesser(a, b)), bottom = lesser(hi, greater(a, b) + shape->count);
        if (top < bottom)
            crt_planes_touch(&tube->planes, top, bottom, 8 * at, 8 * next - 1, epoch);
        at = next;
    }
}

/* Adds a footprint, or a part of it, to all its receivers. */
static void deposit(const struct crt_pass *pass, const struct piece *piece,
                    const struct crt_weight *weights, struct crt_part part, const float *f0,
                    const float *f1)
{
    const struct crt_kernels *kernels = pass->tube->kernels;
    struct crt_target waiting = {0};
    for (int i = 0; i < pass->receivers; i++) {
        struct crt_target target = {pass->receiver[i].cells, weights[i].w0, weights[i].w1};
        if (target.w0 == 0)
            continue;
        if (target.w1 != 0) {
            kernels->deposit(&piece->shape, part, f0, f1, target, pass->cols);
        } else if (waiting.cells) {
            kernels->deposit_pair(&piece->shape, part, f0, waiting, target, pass->cols);
            waiting.cells = NULL;
        } else {
            waiting = target;
        }
    }
    if (waiting.cells)
        kernels->deposit(&piece->shape, part, f0, f0, waiting, pass->cols);
}

static void work_kept(const struct crt_pass *pass, const struct piece *piece,
                      const struct crt_weight *weights, int lo, int hi)
{
    struct crt_part whole = {piece->shape.r0, piece->shape.r1, true}, part = {lo, hi, true};
    float *f1 = piece->moment ? piece->kept + 8 * crt_part_chunks(&piece->shape, whole) : NULL;
    if (piece->store)
        pass->tube->kernels->evaluate(&piece->shape, part, piece->kept, f1);
    deposit(pass, piece, weights, part, piece->kept, f1);
}

/* Straight to one or two receivers; false when there are others. */
static bool work_drawn(const struct crt_pass *pass, const struct piece *piece,
                       const struct crt_weight *weights, int lo, int hi)
{
    const struct crt_kernels *kernels = pass->tube->kernels;
    struct crt_part part = {lo, hi, false};
    struct crt_target target[2];
    int count = 0;
    for (int i = 0; i < pass->receivers; i++) {
        if (weights[i].w0 == 0)
            continue;
        if (count == 2)
            return false;
        target[count++] =
            (struct crt_target){pass->receiver[i].cells, weights[i].w0, weights[i].w1};
    }
    if (count == 2)
        (piece->moment ? kernels->draw_ramp_pair
                       : kernels->draw_pair)(&piece->shape, part, target[0], target[1], pass->cols);
    else if (count == 1)
        (piece->moment ? kernels->draw_ramp : kernels->draw)(&piece->shape, part, target[0],
                                                             pass->cols);
    return true;
}

static void work_computed(const struct crt_pass *pass, const struct piece *piece,
                          const struct crt_weight *weights, int lo, int hi, int worker)
{
    const struct crt_shape *shape = &piece->shape;
    float *f0 = pass->scratch + (size_t)worker * pass->scratch_chunks * 16;
    float *f1 = piece->moment ? f0 + pass->scratch_chunks * 8 : NULL;
    int across = shape->walk == CRT_WALK_COLUMNS ? shape->a1 - shape->a0 : shape->count;
    int step = greater(1, (int)(pass->scratch_chunks / (size_t)across));
    struct crt_part all = {lo, hi, false};
    if (crt_part_chunks(shape, all) <= pass->scratch_chunks)
        step = hi - lo;
    for (int row = lo; row < hi; row += step) {
        struct crt_part part = {row, lesser(row + step, hi), false};
        pass->tube->kernels->evaluate(shape, part, f0, f1);
        deposit(pass, piece, weights, part, f0, f1);
    }
}

static void work_piece(const struct crt_pass *pass, int index, int lo, int hi, int worker)
{
    const struct piece *piece = &pass->pieces[index];
    const struct crt_weight *weights = &pass->weights[index * pass->receivers];
    const struct crt_shape *shape = &piece->shape;
    lo = greater(lo, shape->r0);
    hi = lesser(hi, shape->r1);
    bool to_planes = false;
    for (int k = 0; k < pass->planes; k++)
        to_planes |= weights[k].w0 != 0;
    if (to_planes && shape->walk == CRT_WALK_COLUMNS)
        touch_columns(pass->tube, shape, lo, hi, pass->tube->planes.epoch + 1);
    else if (to_planes)
        touch_rows(pass->tube, shape, lo, hi, pass->tube->planes.epoch + 1);
    if (piece->kept)
        work_kept(pass, piece, weights, lo, hi);
    else if (!work_drawn(pass, piece, weights, lo, hi))
        work_computed(pass, piece, weights, lo, hi, worker);
}

/* Asks for the start of a kept footprint's part in this band while the piece before is worked on.
 */
static void fetch_ahead(const struct piece *piece, int lo)
{
    const struct crt_shape *shape = &piece->shape;
    if (!piece->kept || piece->store)
        return;
    int skipped = shape->walk == CRT_WALK_COLUMNS ? 0 : greater(0, lo - shape->r0) * shape->count;
    const char *at = (const char *)(piece->kept + 8 * (size_t)skipped);
    for (int i = 0; i < 16; i++)
        __builtin_prefetch(at + 64 * i);
}

static void work_band(void *context, int band, int worker)
{
    struct crt_pass *pass = context;
    int lo = band * pass->band_rows, hi = lesser(lo + pass->band_rows, pass->rows);
    const struct crt_planes *planes = &pass->tube->planes;
    if (!pass->tiles_done && pass->feeds > 0) {
        int first = lo / CRT_TILE_ROWS, last = (hi + CRT_TILE_ROWS - 1) / CRT_TILE_ROWS;
        for (int row = first; row < last; row++)
            work_tiles(pass, row * planes->tile_cols, (row + 1) * planes->tile_cols);
    }
    const uint16_t *items = pass->band_items + (size_t)band * BATCH;
    for (int i = 0; i < pass->band_counts[band]; i++) {
        if (i + 1 < pass->band_counts[band])
            fetch_ahead(&pass->pieces[items[i + 1]], lo);
        work_piece(pass, items[i], lo, hi, worker);
    }
}

/* ---- planning
 * ------------------------------------------------------------------------------------------ */

static void flush(struct crt_pass *pass)
{
    for (int i = 0; i < pass->count; i++) {
        const struct crt_shape *shape = &pass->pieces[i].shape;
        int last = (shape->r1 - 1) / pass->band_rows;
        for (int band = shape->r0 / pass->band_rows; band <= last; band++)
            pass->band_items[(size_t)band * BATCH + (size_t)pass->band_counts[band]++] =
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

static void look_up(struct crt_pass *pass, struct piece *piece, const struct crt_entry *entry,
                    const struct crt_stretch *stretch)
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
    struct piece *piece = &pass->pieces[pass->count];
    *piece = (struct piece){0};
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
    if (++pass->count == BATCH)
        flush(pass);
}

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
        *receiver = (struct crt_receiver){.cells = plane->cells, .shares = 1};
        receiver->share[0] = (struct crt_share){.ref = tube->end, .to = tube->end};
        crt_share_add(&receiver->share[0], term->w, term->tau_s);
    }
    pass->planes = pass->receivers;
}

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

static void begin_pass(struct crt_pass *pass, struct crt_tube *tube, const struct crt_feed *feeds,
                       int count, bool commit)
{
    pass->tube = tube;
    pass->feeds = count;
    pass->commit = commit;
    pass->tiles_done = false;
    pass->count = 0;
    for (int i = 0; i < count; i++) {
        struct feed *feed = &pass->feed[i];
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

void crt_pass_run(struct crt_tube *tube, const struct crt_feed *feeds, int count, bool commit)
{
    struct crt_pass *pass = tube->pass;
    assert(count <= CRT_PASS_FILMS);
    begin_pass(pass, tube, feeds, count, commit);
    uint64_t end = commit ? tube->end : tube->begin;
    for (int i = 0; i < count; i++)
        end = feeds[i].to > end ? feeds[i].to : end;
    if (count > 0 && tube->journal.before.count > 0) {
        pass->receivers = pass->planes = 0;
        add_films(pass, tube->quick);
        plan_entries(pass, &tube->journal.before, 0, tube->begin);
        flush(pass);
    }
    pass->receivers = pass->planes = 0;
    if (commit)
        add_planes(pass);
    add_films(pass, UINT32_MAX);
    plan_entries(pass, &tube->journal.now, tube->begin, end);
    flush(pass);
    for (int i = 0; i < count; i++) {
        feeds[i].film->blank = false;
        feeds[i].film->fed_to = feeds[i].to;
    }
}
