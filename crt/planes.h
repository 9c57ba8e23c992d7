/* planes.h — the energy stored in the phosphor, one plane of cells per lasting term.
 *
 * Models:     S_k per cell in cd·s/m². Ageing by n epochs is n float multiplications, each followed
 *             by the floor: what falls below it is 0. It is done when a tile is next needed.
 * Tiles:      64 × 16 cells, each with a flag per plane that says whether anything is in it; dark
 *             tiles are never read.
 * Ownership:  crt_planes_init allocates, crt_planes_free releases.
 * Threads:    rows of tiles may be worked on at the same time.
 * Errors:     crt_planes_init: false when memory is out; nothing is left allocated then.
 */
#ifndef CRT_PLANES_H
#define CRT_PLANES_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/footprint.h"
#include "crt/phosphor.h"

/* Stored energy too faint ever to be seen, cd·s/m². */
#define CRT_STORED_FLOOR 1e-9F

/* A term gets a plane when more than this share of it outlives an epoch. Scan lines light every cell in
 * every epoch, where each plane is a burden; they lose at most that share of a term's light. */
#define CRT_PLANE_SHARE       1e-6
#define CRT_PLANE_SHARE_LINES 1e-4

struct crt_plane {
    int term;     /* of the phosphor */
    float factor; /* e^(−epoch/τ) */
    float *cells;
    float *memory; /* that cells lie in */
    uint8_t *lit;  /* per tile */
    uint64_t *age; /* per tile: epoch its cells are as of */
};

struct crt_planes {
    const struct crt_kernels *kernels;
    int cols, rows, tile_cols, tile_rows;
    double least; /* CRT_PLANE_SHARE, or that of lines */
    int count;
    struct crt_plane plane[CRT_MAX_TERMS];
    uint64_t epoch; /* the epoch that has begun: planes are as of its start */
};

#define CRT_LINE_BYTES  64   /* of the processor's cache */
#define CRT_PAGE_FLOATS 1024 /* of its memory */

/* Cells, all 0, at the start of a cache line; NULL when memory is out; free() releases. */
float *crt_cells_alloc(size_t cells);

bool crt_planes_init(struct crt_planes *planes, const struct crt_phosphor *phosphor, int cols,
                     int rows, double epoch_s, double least, const struct crt_kernels *kernels);
/* One more plane, dark; false when memory is out. */
bool crt_planes_add(struct crt_planes *planes, int term, float factor);
/* No planes any more. */
void crt_planes_clear(struct crt_planes *planes);
void crt_planes_free(struct crt_planes *planes);

/* A tile's cells, brought to `epoch`; NULL when they are all 0. */
float *crt_planes_tile(struct crt_planes *planes, int plane, int tile, uint64_t epoch);

/* Makes all tiles under rows [lo, hi) × columns [left, right] ready to receive light as of
 * `epoch`. */
void crt_planes_touch(struct crt_planes *planes, int lo, int hi, int left, int right,
                      uint64_t epoch);

/* Where a tile lies. */
struct crt_tile {
    int row, col, rows, cols;
};
struct crt_tile crt_planes_place(const struct crt_planes *planes, int tile);

#endif
