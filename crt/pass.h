/* pass.h — one pass over planes and journal: light to films, and at the end of an epoch to planes.
 *
 *      planes ──emission──▶ films ◀──shares of── strokes ──residuals──▶ planes (aged)
 *
 * Models:     a pass feeds up to CRT_PASS_FILMS films, each over its own stretch of one epoch, and,
 *             when the epoch ends, ages the planes and deposits the residuals. What each of them
 *             gets, and in which order, does not depend on the others.
 * Method:     strokes become pieces of footprint (one each, unless the share of light varies too
 *             much along a stroke); bands of rows are worked on one after the other, or by several
 *             threads, so that a band stays in the cache for all its pieces.
 * Units:      cells; light in cd·s/m².
 * Ownership:  crt_pass_create allocates, crt_pass_destroy frees.
 * Errors:     crt_pass_create: NULL when memory is out; a pass itself needs no more.
 */
#ifndef CRT_PASS_H
#define CRT_PASS_H

#include "crt/tube.h"

#define CRT_PASS_FILMS 8

/* A stretch of a film within the running epoch. */
struct crt_feed {
    struct crt_film *film;
    uint64_t from, to;
};

struct crt_pass;

struct crt_pass *crt_pass_create(int cols, int rows, int planes, int threads);
void crt_pass_destroy(struct crt_pass *pass);

/* `commit`: the running epoch ends, planes become those of its end. */
void crt_pass_run(struct crt_tube *tube, const struct crt_feed *feeds, int count, bool commit);

/* The same at the end of an epoch in which planes from `late` on were added: they get light of scan
 * lines of the epoch before, too. */
void crt_pass_run_late(struct crt_tube *tube, const struct crt_feed *feeds, int count, int late);

/* Room for the F0 and then the F1 of so many chunks; for one thread, between passes. */
float *crt_pass_scratch(const struct crt_pass *pass, size_t *chunks);

/* Sum over the cells of the grid of the light that strokes of the journal still hold at `now`,
 * in cd·s/m² (for totals; slow). */
double crt_pass_stored(const struct crt_tube *tube);

#endif
