/* When epochs begin and end, and what a change of the head's timing does to them. */
#include <assert.h>

#include "crt/maths.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

uint64_t crt_tube_epoch_time(const struct crt_tube *tube, uint64_t n)
{
    return tube->origin + crt_tick_time(tube->desc.epoch, n - tube->first);
}

uint64_t crt_tube_epoch_at(const struct crt_tube *tube, uint64_t t)
{
    return tube->first + (t > tube->origin ? crt_tick_at(tube->desc.epoch, t - tube->origin) : 0);
}

/* All tiles of all planes as of `epoch`. */
static void age_planes(struct crt_planes *planes, uint64_t epoch)
{
    int tiles = planes->tile_cols * planes->tile_rows;
    for (int k = 0; k < planes->count; k++)
        for (int tile = 0; tile < tiles; tile++)
            crt_planes_tile(planes, k, tile, epoch);
}

static void set_factors(struct crt_tube *tube, double seconds)
{
    for (int k = 0; k < tube->planes.count; k++) {
        struct crt_plane *plane = &tube->planes.plane[k];
        plane->factor = (float)crt_exp(-seconds / tube->desc.phosphor->term[plane->term].tau_s);
    }
}

/* Planes for terms that outlive the new epoch. Those that there are stay: they hold light. */
static void add_planes(struct crt_tube *tube, double epoch_s)
{
    const struct crt_phosphor *phosphor = tube->desc.phosphor;
    for (int k = 0; k < phosphor->terms; k++) {
        bool there = !(tube->quick >> k & 1);
        if (!there && crt_exp(-epoch_s / phosphor->term[k].tau_s) > tube->planes.least &&
            !crt_planes_add(&tube->planes, k, 0))
            tube->lost++;
    }
}

void crt_tube_set_epoch(struct crt_tube *tube, struct crt_rate epoch, uint64_t origin)
{
    assert(tube->line_pass && origin == tube->now);
    double epoch_s = (double)epoch.den / (double)epoch.num;
    int late = tube->planes.count;
    age_planes(&tube->planes, tube->planes.epoch);
    add_planes(tube, epoch_s);
    set_factors(tube, crt_seconds(tube->begin, origin));
    tube->end = origin;
    crt_tube_feed(tube, true, late);
    age_planes(&tube->planes, tube->planes.epoch + 1);
    crt_tube_note_quick(tube);
    uint64_t keep_from = tube->end > tube->keep ? tube->end - tube->keep : 0;
    if (!crt_lines_turn_early(&tube->lines, tube->end, tube->keep ? keep_from : UINT64_MAX))
        tube->lost++;
    tube->planes.epoch++;
    tube->desc.epoch = epoch;
    tube->origin = tube->begin = origin;
    tube->first = tube->planes.epoch;
    tube->end = crt_tube_epoch_time(tube, tube->planes.epoch + 1);
    set_factors(tube, epoch_s);
}
