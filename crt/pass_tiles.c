/* What a band does first: the films get the light of what the planes store, tile by tile. */
#include "crt/pass_parts.h"

#include <string.h>

#include "crt/tube_parts.h"

/* One tile of one film colour: the planes of that colour, or darkness. */
static bool expose_tile(struct crt_pass *pass, const struct crt_pass_feed *feed, int colour,
                        int tile, float *const cells[])
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
    const struct crt_pass_feed *feed = &pass->feed[0];
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

void crt_pass_tiles(struct crt_pass *pass, int tile, int end)
{
    const struct crt_tube *tube = pass->tube;
    if (pass->commit && tube->planes.count == 1 && pass->feeds == 1 &&
        tube->desc.phosphor->colours == 1)
        sweep_tiles(pass, tile, end);
    else
        for (; tile < end; tile++)
            work_tile(pass, tile);
}
