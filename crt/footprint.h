/* footprint.h — where on the grid the light of a moving spot falls.
 *
 *        start cap      interior       end cap
 *       ╭─────────┬────────────────┬─────────╮     F0 = cross(d) · [step(s) − step(s − L)]
 *       │    ●━━━━┿━━━━━━━━━━━━━━━━┿━━━●     │     F1 = the same, light weighted by −1…1 along the
 *       ╰─────────┴────────────────┴─────────╯          stroke
 *
 * Models:     a round Gaussian spot of width sigma moving at constant speed, or standing still; or
 *             resting at one end, moving, and resting at the other, as vectors are drawn.
 *             The spot is cut off at CRT_CUT sigma, lowered by its edge value so that it ends at
 *             exactly 0, and scaled back to unit energy.
 * Units:      cells; the footprint has no unit and is multiplied by a weight in cd·s/m².
 * Method:     each cell's value follows from the stroke and the cell alone, not from where a loop
 *             began, so any part of a footprint can be computed alone. Steep strokes are walked by
 *             rows, shallow ones by groups of 8 columns; only the caps need the step.
 * Accuracy:   5e-6 of the crest.
 * Ownership:  plain values; buffers are the caller's.
 * Errors:     a stroke that lights no cell has no shape; kernels the processor lacks: a sentence.
 * Not modelled: spots much smaller than a cell (sigma below 0.8 cells loses energy to sampling).
 */
#ifndef CRT_FOOTPRINT_H
#define CRT_FOOTPRINT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/tube.h"

#define CRT_CUT 4.8 /* sigma */

/* A stretch of stroke in continuous cell coordinates (crt/geometry.h). */
struct crt_stretch {
    double x0, y0, x1, y1; /* cells */
    double sigma;          /* cells */
    double rest0, rest1; /* light of the spot at rest at each end, in parts of the moving spot's */
};

enum crt_walk { CRT_WALK_DOT, CRT_WALK_ROWS, CRT_WALK_COLUMNS };

/* A footprint prepared for the kernels. Lines are walked along their longer axis; `at` is the
 * walk's index: a row, or a group of 8 columns. Coordinates across the walk are in 2^-32 cells, so
 * that steps are exact. */
struct crt_shape {
    enum crt_walk walk;
    bool whole;     /* the caps overlap: every cell needs both steps */
    bool narrow;    /* rows: the upper half of the last chunk is not needed */
    bool rested;    /* rest_start or rest_end is not 0 */
    bool turned;    /* walked from the end to the start: the first moment changes sign */
    int r0, r1;     /* rows it may light, clipped to the grid */
    int a0, a1;     /* rows or groups walked */
    int mid0, mid1; /* of those, the ones with nothing but the cross profile */
    int count;      /* chunks a row, or rows a group */
    int last;       /* rows: the last column a row's chunks may start at */
    int64_t edge;   /* lower edge of the band at a0 */
    int64_t step;   /* … and its change per row or group */
    float half;     /* of the band's width at its walk index, cells */
    float cross;    /* cross profile: change of its argument per cell across the walk */
    float slant;    /* columns: change of that argument per column */
    double along_0, along_col, along_row; /* s [sigma] = along_0 + col·along_col + row·along_row */
    double side_0, side_col, side_row;    /* dots: the same across */
    float along_step;                     /* along_col */
    float length;                         /* [sigma] */
    float rest_start, rest_end; /* light at rest at the ends: times the bell of unit area */
    float ramp_scale, ramp_0;   /* position −1…1 along the stroke = ramp_0 + s·ramp_scale */
    double area; /* Σ F0 over all cells in units of sigma² (dots) or sigma·length (lines): 1/area
                    normalises */
};

/* Prepares the shape; false when no cell of the grid is lit. */
bool crt_shape_init(struct crt_shape *shape, const struct crt_stretch *stretch, int cols, int rows);

/* First row of group `at`, or first column of row `at`, before clipping to the grid. */
int crt_shape_start(const struct crt_shape *shape, int at);

/* A part of a footprint in a buffer: rows [lo, hi), laid out for all its rows or for these alone.
 */
struct crt_part {
    int lo, hi;
    bool laid_out_whole;
};

/* Chunks of 8 floats that the part's buffer holds. */
size_t crt_part_chunks(const struct crt_shape *shape, struct crt_part part);

/* Planes are kept in tiles (crt/planes.h). */
#define CRT_TILE_COLS 64
#define CRT_TILE_ROWS 16
#define CRT_RUN_TILES 32

struct crt_target {
    float *cells;
    float w0, w1; /* cells += w0·F0 + w1·F1 */
};

/* What differs between instruction sets. */
struct crt_kernels {
    const char *name;
    /* Computes F0, and F1 unless it is NULL. */
    void (*evaluate)(const struct crt_shape *shape, struct crt_part part, float *f0, float *f1);
    /* Adds F0 at once to cells whose rows are `stride` apart: one target of constant weight, or
     * two. */
    void (*draw)(const struct crt_shape *shape, struct crt_part part, struct crt_target target,
                 int stride);
    void (*draw_pair)(const struct crt_shape *shape, struct crt_part part, struct crt_target one,
                      struct crt_target two, int stride);
    /* The same by ramps: F0 and F1. */
    void (*draw_ramp)(const struct crt_shape *shape, struct crt_part part, struct crt_target target,
                      int stride);
    void (*draw_ramp_pair)(const struct crt_shape *shape, struct crt_part part,
                           struct crt_target one, struct crt_target two, int stride);
    /* Adds what was computed before to cells whose rows are `stride` apart. f1 is used where w1 is
     * not 0. */
    void (*deposit)(const struct crt_shape *shape, struct crt_part part, const float *f0,
                    const float *f1, struct crt_target target, int stride);
    /* The same for two targets of constant weight at once. */
    void (*deposit_pair)(const struct crt_shape *shape, struct crt_part part, const float *f0,
                         struct crt_target one, struct crt_target two, int stride);
    /* n multiplications by `factor`, values below `floor` becoming 0; whether anything is left. */
    bool (*age)(float *cells, int stride, int rows, int cols, float factor, float floor,
                unsigned n);
    /* light = or += share·cells. */
    void (*expose)(const float *cells, float *light, int stride, int rows, int cols, float share,
                   bool add);
    /* Both in one go, one multiplication, for at most CRT_RUN_TILES tiles side by side; lit says
     * which of them have anything left. */
    void (*expose_age)(float *cells, float *light, int stride, int rows, int cols, float share,
                       bool add, float factor, float floor, uint8_t *lit);
};

extern const struct crt_kernels crt_kernels_baseline;
#if defined(__x86_64__)
extern const struct crt_kernels crt_kernels_avx2;
#endif

/* The kernels for this processor, or those asked for; NULL and a sentence when it lacks them. */
const struct crt_kernels *crt_kernels_find(enum crt_simd simd, struct crt_error *err);

#endif
