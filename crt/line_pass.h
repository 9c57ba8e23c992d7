/* line_pass.h — one pass over scan lines: their light to planes and films.
 *
 *      lines of both epochs ─▶ share of each receiver ─┐
 *      strips ─▶ glows (crt/line_light.h) ─────────────┴─▶ lines along the columns ─▶ rows of cells
 *
 * Models:     a line's light at a cell is its light along the columns times a Gaussian of the distance
 *             across, times the share of it that the receiver gets; a share is a constant or a
 *             straight line along the line as far as what that misses stays below CRT_OFF_CONSTANT or
 *             CRT_OFF_LINE of the brightest line's; else the dots themselves are weighed.
 * Units:      cells; light in cd·s/m².
 * Ownership:  crt_line_pass_create allocates, crt_line_pass_destroy frees; lines, glows and receivers
 *             stay their owners'.
 * Errors:     false when memory is out: light of lines is missing then.
 */
#ifndef CRT_LINE_PASS_H
#define CRT_LINE_PASS_H

#include "crt/line_light.h"
#include "crt/plan.h"
#include "crt/planes.h"
#include "crt/pool.h"

struct crt_line_pass;

struct crt_line_pass *crt_line_pass_create(const struct crt_tube_row *row,
                                           const struct crt_phosphor *phosphor,
                                           const struct crt_grid *grid, int workers,
                                           enum crt_simd simd, bool reuse, struct crt_error *err);
void crt_line_pass_destroy(struct crt_line_pass *pass);

/* A receiver's cells and the gun that lights it. */
struct crt_line_target {
    float *cells;
    int gun;
    bool fresh; /* cells hold nothing in particular */
};

void crt_line_pass_begin(struct crt_line_pass *pass, const struct crt_line_target *targets,
                         int count, int planes);
/* Lines of a list between `begin` and `end`, by receivers for targets `first` on. */
bool crt_line_pass_add(struct crt_line_pass *pass, const struct crt_line_list *list,
                       const struct crt_receiver *receivers, int first, int count, uint64_t begin,
                       uint64_t end);
/* When all are added: works out what bands need. */
bool crt_line_pass_prepare(struct crt_line_pass *pass, struct crt_pool *pool);
/* Adds the light of lines to rows [lo, hi) of the targets; the first `planes` of them are those of
 * `planes`, made ready as of `epoch`. */
void crt_line_pass_band(struct crt_line_pass *pass, int lo, int hi, int worker,
                        struct crt_planes *planes, uint64_t epoch);
/* Figures of the tube's beams. */
const struct crt_line_beams *crt_line_pass_beams(const struct crt_line_pass *pass);
void crt_line_pass_end(struct crt_line_pass *pass);

#endif
