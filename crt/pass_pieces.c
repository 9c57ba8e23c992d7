/* What a band does with the pieces of a batch: their footprints, added to planes and films. */
#include "crt/pass_parts.h"

#include "crt/tube_parts.h"

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
static void deposit(const struct crt_pass *pass, const struct crt_pass_piece *piece,
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

static void work_kept(const struct crt_pass *pass, const struct crt_pass_piece *piece,
                      const struct crt_weight *weights, int lo, int hi)
{
    struct crt_part whole = {piece->shape.r0, piece->shape.r1, true}, part = {lo, hi, true};
    float *f1 = piece->moment ? piece->kept + 8 * crt_part_chunks(&piece->shape, whole) : NULL;
    if (piece->store)
        pass->tube->kernels->evaluate(&piece->shape, part, piece->kept, f1);
    deposit(pass, piece, weights, part, piece->kept, f1);
}

/* Straight to one or two receivers; false when there are others. */
static bool work_drawn(const struct crt_pass *pass, const struct crt_pass_piece *piece,
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

static void work_computed(const struct crt_pass *pass, const struct crt_pass_piece *piece,
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
    const struct crt_pass_piece *piece = &pass->pieces[index];
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
static void fetch_ahead(const struct crt_pass_piece *piece, int lo)
{
    const struct crt_shape *shape = &piece->shape;
    if (!piece->kept || piece->store)
        return;
    int skipped = shape->walk == CRT_WALK_COLUMNS ? 0 : greater(0, lo - shape->r0) * shape->count;
    const char *at = (const char *)(piece->kept + 8 * (size_t)skipped);
    for (int i = 0; i < 16; i++)
        __builtin_prefetch(at + 64 * i);
}

void crt_pass_pieces(const struct crt_pass *pass, int band, int lo, int hi, int worker)
{
    const uint16_t *items = pass->band_items + (size_t)band * CRT_PASS_BATCH;
    for (int i = 0; i < pass->band_counts[band]; i++) {
        if (i + 1 < pass->band_counts[band])
            fetch_ahead(&pass->pieces[items[i + 1]], lo);
        work_piece(pass, items[i], lo, hi, worker);
    }
}
