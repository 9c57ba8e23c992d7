/* plan.h — from strokes to pieces of footprint with a weight for each plane and film.
 *
 * Models:     the share of a stroke's light that a target gets depends on when each point of it was
 *             drawn. Over a piece that share is a constant, or a straight line, as far as what that
 *             misses stays below CRT_OFF_CONSTANT or CRT_OFF_LINE of the light of the stroke; or of the
 *             brightest stroke of the pass, as long as the strokes of one place together miss no
 *             more than CRT_OFF_PLACE of it. Else the stroke is halved in time for that target.
 * Units:      weights in cd·s/m².
 * Ownership:  plain values; the caller's.
 * Errors:     none.
 */
#ifndef CRT_PLAN_H
#define CRT_PLAN_H

#include "crt/footprint.h"
#include "crt/journal.h"
#include "crt/share.h"

#define CRT_OFF_CONSTANT 4e-4
#define CRT_OFF_LINE     1e-4
#define CRT_OFF_PLACE    5e-4

/* Places: the grid in CRT_PLACES × CRT_PLACES parts; a stroke's is that of its middle. */
#define CRT_PLACES 16

/* Light too faint to be deposited, cd·s/m². */
#define CRT_TOO_FAINT 1e-11

#define CRT_MAX_TARGETS 48

/* Somewhere that light goes: a plane, or a film. */
struct crt_receiver {
    float *cells;
    int colour; /* of the phosphor, whose light it gets */
    int shares;
    struct crt_share share[2]; /* one after the other in time */
    double brightest;          /* crest of the brightest stroke in it, so far as known */
    float missed[CRT_PLACES * CRT_PLACES]; /* on the brightest's account, cd·s/m² */
};

struct crt_weight {
    float w0, w1;
};

struct crt_piece_plan {
    struct crt_stretch stretch;
    struct crt_weight
        weight[CRT_MAX_TARGETS]; /* per unit of F0 and F1, before dividing by the area */
    bool whole;                  /* the stroke as it was delivered */
};

/* Sigma in cells: with less, light falls between cells; more is for no use, and a stroke so wide
 * (a spot far out of focus under a strong microscope) is left out. */
#define CRT_LEAST_SIGMA 0.8
#define CRT_MOST_SIGMA  1e5
#define CRT_WIDEST      1e6

/* A stroke in cells, cut to the neighbourhood of the grid, between two moments. */
struct crt_drawn {
    double x0, y0, dx, dy; /* cells; position = x0 + dx·(t − t0)/(t1 − t0) */
    uint64_t t0, t1;       /* of the stroke */
    uint64_t from, to;     /* the part considered */
    double power;          /* per second, in cd·s/m² × cells */
    double sigma;          /* cells */
    double crest;          /* light of the brightest cell, energy share 1, cd·s/m² */
    const double *light;   /* the entry's, per colour */
    int place;
    bool moving, whole;
};

/* False when nothing of the stroke between `from` and `to` can be on the grid. */
bool crt_drawn_init(struct crt_drawn *drawn, const struct crt_entry *entry,
                    const struct crt_grid *grid, uint64_t from, uint64_t to);

/* The crest of an entry's light, from below. */
double crt_plan_crest(const struct crt_entry *entry);

/* Notes in each receiver the crest of the brightest stroke that is drawn between `from` and `to`
 * and crosses the grid with its middle. */
void crt_plan_brightest(const struct crt_entries *entries, const struct crt_grid *grid,
                        uint64_t from, uint64_t to, struct crt_receiver *receivers, int count);

/* A spot that rests, moves and rests again, delivered as three strokes: whether entries at[0…2] are that,
 * wholly between `from` and `to`. With the same power and sigma they have the same beam voltage. */
bool crt_plan_is_rested(const struct crt_entry *at, size_t left, uint64_t from, uint64_t to);

typedef void crt_plan_emit(void *context, const struct crt_piece_plan *piece);

/* Draws the three as one piece in those receivers for which that is exact enough, which are noted in
 * `done`; the others want the strokes one by one. `line` is the moving one. */
void crt_plan_rested(const struct crt_drawn *line, const struct crt_entry *at,
                     struct crt_receiver *receivers, int count, bool *done, crt_plan_emit *emit,
                     void *context);

/* Calls emit for each piece of a stroke, in an order that is each receiver's order of time, but for the
 * receivers already `done`. */
void crt_plan(const struct crt_drawn *drawn, struct crt_receiver *receivers, int count,
              const bool *done, crt_plan_emit *emit, void *context);

#endif
