/* Light that the journal's strokes still hold: their footprints summed in double precision. */
#include "crt/pass.h"

#include <string.h>

#include "crt/line_look.h"
#include "crt/plan.h"
#include "crt/tube_parts.h"

struct summing {
    const struct crt_tube *tube;
    double sum;
};

static void sum_piece(void *context, const struct crt_piece_plan *plan)
{
    struct summing *summing = context;
    const struct crt_grid *grid = &summing->tube->desc.grid;
    struct crt_shape shape;
    if (!crt_shape_init(&shape, &plan->stretch, grid->cols, grid->rows))
        return;
    int across = shape.walk == CRT_WALK_COLUMNS ? shape.a1 - shape.a0 : shape.count;
    size_t room;
    float *f0 = crt_pass_scratch(summing->tube->pass, &room), *f1 = f0 + 8 * room;
    int step = (int)(room / (size_t)across);
    step = step < 1 ? 1 : step;
    double sum0 = 0, sum1 = 0;
    for (int row = shape.r0; row < shape.r1; row += step) {
        struct crt_part part = {row, row + step < shape.r1 ? row + step : shape.r1, false};
        size_t floats = 8 * crt_part_chunks(&shape, part);
        memset(f0, 0, floats * sizeof f0[0]); /* groups may leave slots unused */
        memset(f1, 0, floats * sizeof f1[0]);
        summing->tube->kernels->evaluate(&shape, part, f0, f1);
        for (size_t i = 0; i < floats; i++) {
            sum0 += (double)f0[i];
            sum1 += (double)f1[i];
        }
    }
    double w1 = shape.turned ? -(double)plan->weight[0].w1 : (double)plan->weight[0].w1;
    summing->sum += ((double)plan->weight[0].w0 * sum0 + w1 * sum1) / shape.area;
}

static void sum_entries(struct summing *summing, const struct crt_entries *entries, uint32_t mask,
                        uint64_t begin, uint64_t end)
{
    const struct crt_tube *tube = summing->tube;
    const struct crt_phosphor *phosphor = tube->desc.phosphor;
    struct crt_receiver receiver = {.shares = 1};
    receiver.share[0] = (struct crt_share){.ref = tube->now, .to = end};
    for (int k = 0; k < phosphor->terms; k++)
        if (mask >> k & 1)
            crt_share_add(&receiver.share[0], phosphor->term[k].w, phosphor->term[k].tau_s);
    struct crt_drawn drawn;
    const bool done = false;
    for (size_t i = 0; i < entries->count; i++)
        if (crt_drawn_init(&drawn, &entries->at[i], &tube->desc.grid, begin, end))
            crt_plan(&drawn, &receiver, 1, &done, sum_piece, summing);
}

double crt_pass_stored(const struct crt_tube *tube)
{
    if (tube->line_pass)
        return crt_lines_stored(tube);
    struct summing summing = {tube, 0};
    sum_entries(&summing, &tube->journal.before, tube->quick, 0, tube->begin);
    sum_entries(&summing, &tube->journal.now, UINT32_MAX, tube->begin, tube->now);
    return summing.sum;
}
