/* pass_parts.h — what a pass is made of; private to the files of the pass.
 *
 *      pass.c         strokes to batches of pieces, and who gets what of their light
 *      pass_tiles.c   planes to films, tile by tile, and their ageing
 *      pass_pieces.c  the batch's pieces to planes and films, band by band
 *
 * Bands:      rows of tiles that fit in the cache with their films. One thread at a time works on a
 *             band: first its tiles, in the first batch of a pass, and then its pieces in order.
 * Units:      cells; light in cd·s/m².
 * Ownership:  all parts belong to the pass; cells are the tube's planes' and the caller's films'.
 * Errors:     none.
 */
#ifndef CRT_PASS_PARTS_H
#define CRT_PASS_PARTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/footprint.h"
#include "crt/pass.h"
#include "crt/phosphor.h"
#include "crt/plan.h"

/* Pieces planned before the bands are worked on. */
#define CRT_PASS_BATCH 2048

/* A piece of footprint with its weights, ready for the bands. */
struct crt_pass_piece {
    struct crt_shape shape;
    float *kept; /* its footprint in the reuse memory, or NULL */
    bool store;  /* … to be computed first */
    bool moment; /* some weight has a slope */
};

/* A stretch of a film, and what the planes light it with. */
struct crt_pass_feed {
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
    struct crt_pass_piece *pieces;
    struct crt_weight *weights; /* [piece][receiver] */
    uint16_t *band_items;       /* [band][…] pieces of each band in order */
    int *band_counts;
    /* the running pass */
    struct crt_tube *tube;
    struct crt_pass_feed feed[CRT_PASS_FILMS];
    int feeds;
    bool commit, tiles_done;
    struct crt_receiver receiver[CRT_MAX_TARGETS];
    int receivers, planes;                        /* planes come first */
    struct crt_receiver earlier[CRT_MAX_TARGETS]; /* of lines of the epoch before */
    int late;  /* planes from this one on know nothing of those lines */
    int count; /* pieces in the batch */
};

/* Exposes the films to tiles [tile, end) of one row of tiles. When the epoch ends and one sweep can
 * do both, it also ages them; else they age when they are next needed. */
void crt_pass_tiles(struct crt_pass *pass, int tile, int end);

/* Adds the pieces of a band, whose rows are [lo, hi), to their receivers. */
void crt_pass_pieces(const struct crt_pass *pass, int band, int lo, int hi, int worker);

#endif
