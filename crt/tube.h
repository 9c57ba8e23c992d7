/* tube.h — the tube: beam pieces in, light out.
 *
 *      strokes or ──▶ journal ──┬── commit at each epoch end ──▶ phosphor planes (stored energy)
 *      scan lines               │                                     │
 *                               └───────────── expose ────────────────┴──▶ film, probe
 *
 * Models:     gun (I ∝ drive^γ), a Gaussian spot that grows with current, the line integral of a
 *             spot moving at constant speed with end-point dwell (erf caps), time-stamped deposits,
 *             decay by the phosphor's sum of exponentials; on a penetration tube colour, spot and
 *             place by the stroke's level (crt/penetration.h). Absolute: light is in cd·s/m²
 *             (fluence) or cd/m².
 *             Raster tubes: scan lines through a video amplifier, with the optics of each gun
 *             (crt/line_beam.h, crt/optics.h); lines run from left to right, others give no light.
 * Time:       picoseconds; epoch n ends at tick n+1 of desc.epoch, or as crt_tube_set_epoch says.
 * Observing:  never changes state: an exposure or a probe is a function of planes (as of the last
 *             epoch) and journal (strokes and lines since); a film's samples depend on its interval only,
 *             never on what else was observed, on the number of threads or on the instruction set.
 * Planes:     one per phosphor term that outlives an epoch (e^(−T/τ) above CRT_PLANE_SHARE, of
 *             raster tubes CRT_PLANE_SHARE_LINES);
 *             shorter terms are computed from the journal of this and the previous epoch. Planes stay
 *             when a shorter epoch is set, and join when a term outlives the new one.
 * Ageing:     n epochs are n float multiplications; values below a fixed floor become 0.
 * Accuracy:   film within 1e-3 of its peak of the exact integral; energy to 1e-5 as long as an
 *             epoch is 0.003 τ or more (a factor is a float: a rate of decay is good to
 *             3e-8·τ/T). Cells of at most 1.25 sigma of the smallest spot; larger ones are refused.
 *             Films of scan lines: light to 3e-4 (whole fields to 5e-5); 1.5e-3 of the peak where knobs clip
 *             the drive. Dim dots of a line are rounded to 3e-5 of its brightest.
 * Ownership:  crt_tube_create allocates planes and journal, crt_tube_destroy frees them. Films
 *             belong to the caller. desc is copied; row and phosphor must outlive the tube.
 * Errors:     out of memory: NULL and a sentence; for strokes crt_tube_intact() tells. Misuse (time
 *             running backwards, a film of another tube) asserts.
 * Source:     the integrals are elementary; figures come from crt/tube_table.h and crt/phosphor.h.
 * Not modelled: video amplifier and misfocus towards the corners of vector tubes, saturation.
 */
#ifndef CRT_TUBE_H
#define CRT_TUBE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/error.h"
#include "crt/geometry.h"
#include "crt/phosphor.h"
#include "crt/piece.h"
#include "crt/state.h"
#include "crt/ticks.h"
#include "crt/tube_table.h"

enum crt_simd { CRT_SIMD_AUTO, CRT_SIMD_BASELINE, CRT_SIMD_AVX2 };

/* Front-panel knobs; the neutral setting is {0, 1, 0}. */
struct crt_knobs {
    double brightness; /* −1…1, added to the drive of every piece (grid bias) */
    double contrast;   /* 0…4, multiplies the drive */
    double focus;      /* 0 = best; sigma grows by sqrt(1 + focus²) */
};

struct crt_tube_desc {
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    struct crt_grid grid;  /* crt_tube_grid(row), or a close-up */
    struct crt_rate epoch; /* the head's sync tick */
    struct crt_knobs knobs;
    int threads; /* 1… */
    enum crt_simd simd;
    bool microscope; /* a close-up of a tube with a mask: the mask is drawn on film (crt/mask.h) */
    bool no_reuse;   /* never reuse cached footprints (for benchmarks and tests) */
};

struct crt_tube;

/* Light gathered during [t0, t1) on the tube's grid, per phosphor colour (that of the tube's guns when
 * it has three), in cd·s/m² (fluence).
 * Divide by the exposure for mean cd/m². Row-major, grid.cols × grid.rows floats each. */
struct crt_film {
    struct crt_grid grid;
    int colours;
    float *light[CRT_MAX_COLOURS];
    uint64_t t0, t1;
    bool complete;
    struct crt_film *next; /* the tube's list of open films */
    uint64_t fed_to;       /* how far light has been gathered; private to the tube */
    bool blank;            /* nothing gathered yet: samples hold nothing in particular; private */
};

struct crt_tube *crt_tube_create(const struct crt_tube_desc *desc, struct crt_error *err);
void crt_tube_destroy(struct crt_tube *tube);

/* Commits one stroke to the journal. t0 must not precede that of the stroke before, nor the `now`
 * of the last crt_tube_advance: films may have been completed up to then. */
void crt_tube_stroke(struct crt_tube *tube, const struct crt_stroke *stroke);

/* The same for a scan line, on a raster tube, with as many guns as the tube has. Its dots are copied.
 * Strokes and scan lines may not be mixed on one tube. */
void crt_tube_scan_line(struct crt_tube *tube, const struct crt_scan_line *line);

/* A raster head begins a new timing: the running epoch ends at `origin`, the `now` of the last
 * advance, and from there on epoch n ends at origin + crt_tick_time(epoch, n). Open films stay
 * open. */
void crt_tube_set_epoch(struct crt_tube *tube, struct crt_rate epoch, uint64_t origin);

/* Tells the tube that every stroke starting before `now` has been delivered: ends the epochs up to
 * `now` and feeds open films; films with t1 <= now become complete and leave the list. */
void crt_tube_advance(struct crt_tube *tube, uint64_t now);

/* Knobs act on strokes delivered from now on. */
void crt_tube_set_knobs(struct crt_tube *tube, struct crt_knobs knobs);
struct crt_knobs crt_tube_knobs(const struct crt_tube *tube);

/* Film memory for this tube's grid and colours; crt_film_free releases it. */
bool crt_film_init(struct crt_film *film, const struct crt_tube *tube, struct crt_error *err);
void crt_film_free(struct crt_film *film);

/* Opens the film for [t0, t1), t0 < t1; t0 must not precede the `now` of the last advance. What it
 * held is gone; its samples mean something once it is complete. The film must stay alive until then
 * or until crt_film_cancel(). */
void crt_film_open(struct crt_tube *tube, struct crt_film *film, uint64_t t0, uint64_t t1);
void crt_film_cancel(struct crt_tube *tube, struct crt_film *film);
void crt_tube_cancel_films(struct crt_tube *tube); /* all that are open */
/* Ends an open film at the `now` of the last advance: it is complete, with that t1. False when it is
 * not open, or when that is not after t0; it is not open then, and not complete. */
bool crt_film_end(struct crt_tube *tube, struct crt_film *film);

/* Instantaneous luminance at a point of the glass, cd/m² per colour, at time t, not before the
 * running epoch began (strokes after t do not count). Light of the running epoch is exact; what
 * planes hold is interpolated between cells, to 1 % of its crest for the smallest spot. */
void crt_tube_probe(const struct crt_tube *tube, double x_mm, double y_mm, uint64_t t,
                    double cd_m2[CRT_MAX_COLOURS]);

/* False and a sentence when memory ran out and light was lost since the tube was created. */
bool crt_tube_intact(const struct crt_tube *tube, struct crt_error *err);

/* Totals for tests and traces, double precision, cd·s/m² summed over cells. */
struct crt_tube_totals {
    double stored;    /* in planes and journal at the last advance, within the grid */
    uint64_t strokes; /* delivered since creation */
};
struct crt_tube_totals crt_tube_totals(const struct crt_tube *tube);

/* All that future light depends on, as of the last advance and with the strokes delivered since:
 * a tube of the same desc (knobs, threads and kernels aside) that loads it goes on to the same
 * samples. Films are observers and no part of it; loading cancels those that are open, as time is
 * another. A tube whose loading failed is fit to be loaded again or destroyed, for nothing else. */
void crt_tube_state(struct crt_tube *tube, struct crt_state *s);

/* The `now` of the last advance, and when the last stroke began. */
struct crt_tube_times {
    uint64_t now, last_start;
};
struct crt_tube_times crt_tube_times(const struct crt_tube *tube);

#endif
