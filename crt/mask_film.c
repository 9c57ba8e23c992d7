/* The mask on film: light of guns becomes light of phosphor colours. */
#include <assert.h>
#include <math.h>

#include "crt/mask.h"

#define BAND_ROWS 16 /* rows a thread takes at a time */
#define NODE      32 /* cells between the places where means are worked out */

struct job {
    const struct crt_mask *mask;
    struct crt_film *film;
    double per_gun[3][3]; /* [gun][colour]: light for the same current, over transmission */
    bool pure;            /* nowhere do beams reach another colour */
};

/* The farthest that any beam misses on the grid is at its corner farthest out. */
static bool is_pure(const struct crt_mask *mask, const struct crt_grid *g)
{
    double x = fmax(fabs(g->left_mm), fabs(g->left_mm + g->cols * g->cell_mm));
    double y = fmax(fabs(g->top_mm), fabs(g->top_mm - g->rows * g->cell_mm));
    return crt_optics_landing(&mask->optics, x, y) <= crt_mask_guard(mask);
}

static void note_shares(struct job *job, const struct crt_phosphor *phosphor)
{
    double share[3] = {0, 0, 0};
    for (int k = 0; k < phosphor->terms; k++)
        share[phosphor->term[k].colour] += phosphor->term[k].w;
    for (int gun = 0; gun < 3; gun++)
        for (int c = 0; c < 3; c++)
            job->per_gun[gun][c] = (gun == c ? 1 : share[c] / share[gun]) / job->mask->transmission;
}

/* ---- under the microscope -------------------------------------------------------------------- */

static void draw_cell(const struct job *job, size_t at, double x, double y)
{
    struct crt_film *film = job->film;
    double light[3] = {0, 0, 0};
    for (int gun = 0; gun < 3; gun++) {
        double own = (double)film->light[gun][at];
        if (!(own > 0))
            continue;
        for (int c = 0; c < 3; c++)
            if (c == gun || !job->pure)
                light[c] += own * job->per_gun[gun][c] *
                            crt_mask_cover(job->mask, gun, c, x, y, film->grid.cell_mm);
    }
    for (int c = 0; c < 3; c++)
        film->light[c][at] = (float)light[c];
}

static void draw_band(void *context, int index, int worker)
{
    const struct job *job = context;
    const struct crt_grid *g = &job->film->grid;
    int end = (index + 1) * BAND_ROWS < g->rows ? (index + 1) * BAND_ROWS : g->rows;
    (void)worker;
    for (int row = index * BAND_ROWS; row < end; row++)
        for (int col = 0; col < g->cols; col++) {
            double x, y;
            crt_cell_to_mm(g, col, row, &x, &y);
            draw_cell(job, (size_t)row * (size_t)g->cols + (size_t)col, x, y);
        }
}

/* ---- from afar ------------------------------------------------------------------------------- */

struct blend {
    double share[3][3]; /* [gun][colour] */
};

static void blend_at(const struct job *job, double col, double row, struct blend *b)
{
    double x, y;
    crt_cell_to_mm(&job->film->grid, col, row, &x, &y);
    for (int gun = 0; gun < 3; gun++)
        for (int c = 0; c < 3; c++)
            b->share[gun][c] = job->per_gun[gun][c] * crt_mask_mean(job->mask, gun, c, x, y);
}

static void blend_between(const struct blend *a, const struct blend *b, double part,
                          struct blend *to)
{
    for (int gun = 0; gun < 3; gun++)
        for (int c = 0; c < 3; c++)
            to->share[gun][c] = a->share[gun][c] + part * (b->share[gun][c] - a->share[gun][c]);
}

static void mix_cell(float *const light[3], size_t at, const struct blend *b)
{
    double gun[3];
    for (int i = 0; i < 3; i++)
        gun[i] = (double)light[i][at];
    for (int c = 0; c < 3; c++)
        light[c][at] =
            (float)(gun[0] * b->share[0][c] + gun[1] * b->share[1][c] + gun[2] * b->share[2][c]);
}

/* NODE rows; means at the four corners of each square, bilinear between. */
static void mix_band(void *context, int index, int worker)
{
    const struct job *job = context;
    struct crt_film *film = job->film;
    const struct crt_grid *g = &film->grid;
    int top = index * NODE, end = top + NODE < g->rows ? top + NODE : g->rows;
    (void)worker;
    struct blend left[2], right[2];
    blend_at(job, 0, top, &left[0]);
    blend_at(job, 0, top + NODE, &left[1]);
    for (int from = 0; from < g->cols; from += NODE) {
        int to = from + NODE < g->cols ? from + NODE : g->cols;
        blend_at(job, from + NODE, top, &right[0]);
        blend_at(job, from + NODE, top + NODE, &right[1]);
        for (int row = top; row < end; row++) {
            struct blend l, r, here;
            blend_between(&left[0], &left[1], (double)(row - top) / NODE, &l);
            blend_between(&right[0], &right[1], (double)(row - top) / NODE, &r);
            for (int col = from; col < to; col++) {
                blend_between(&l, &r, (double)(col - from) / NODE, &here);
                mix_cell(film->light, (size_t)row * (size_t)g->cols + (size_t)col, &here);
            }
        }
        left[0] = right[0];
        left[1] = right[1];
    }
}

void crt_mask_film(const struct crt_mask *mask, const struct crt_phosphor *phosphor,
                   struct crt_film *film, bool microscope, struct crt_pool *pool)
{
    assert(film->colours == 3 && phosphor->colours == 3);
    struct job job = {.mask = mask, .film = film, .pure = is_pure(mask, &film->grid)};
    note_shares(&job, phosphor);
    if (microscope)
        crt_pool_run(pool, draw_band, &job, (film->grid.rows + BAND_ROWS - 1) / BAND_ROWS);
    else if (!job.pure)
        crt_pool_run(pool, mix_band, &job, (film->grid.rows + NODE - 1) / NODE);
}

void crt_mask_complete(const struct crt_tube_desc *desc, struct crt_film *film,
                       struct crt_pool *pool)
{
    if (desc->row->mask == CRT_MASK_NONE)
        return;
    struct crt_mask mask;
    crt_mask_init(&mask, desc->row);
    crt_mask_film(&mask, desc->phosphor, film, desc->microscope, pool);
}
