/* optics.h — electron optics of a raster tube: where each beam lands and how wide it is, over the
 * screen.
 *
 *      delta: red, green, blue guns at     in line, grille:         spread
 *      210°, 330°, 90° about the axis      red ◀─ green ─▶ blue     1 ─────╮
 *             B                            miss along x only                ╰─▶ spot_edge in the corner
 *           R   G
 *
 * Models:     r = distance from the centre, in half diagonals of the addressable area.
 *             - Deflection defocus: sigma grows by the factor 1 + (spot_edge − 1)·r².
 *             - Convergence: each beam but the middle one of an in-line gun misses its place by
 *               converge + converge_edge·r², in the direction in which its gun lies off the axis.
 *             - Landing (purity): each beam misses its phosphor by landing + landing_edge·r²,
 *               radially outwards (crt/mask.h makes colours of it).
 * Units:      mm.
 * Sources:    form: third-order deflection theory has errors that grow with the square of the
 *             deflection; figures: the tube row. Directions of the guns: convention.
 * Ownership:  plain values.
 * Errors:     none.
 * Not modelled: astigmatism (the spot stays round), dynamic focus, pincushion; defocus of strokes on
 *             vector tubes.
 */
#ifndef CRT_OPTICS_H
#define CRT_OPTICS_H

#include "crt/piece.h"
#include "crt/tube_table.h"

struct crt_optics {
    double per_mm2;                                  /* r² = per_mm2·(x² + y²) */
    double edge;                                     /* spot_edge − 1 */
    double way_x[CRT_MAX_GUNS], way_y[CRT_MAX_GUNS]; /* unit vectors, or 0 */
    double converge, converge_edge;                  /* mm */
    double landing, landing_edge;                    /* mm */
};

void crt_optics_init(struct crt_optics *optics, const struct crt_tube_row *row);

/* Of a beam deflected to (x, y): how far from there it lands, and its sigma in parts of the
 * centre's. */
struct crt_beam_place {
    double dx, dy; /* mm */
    double spread; /* >= 1 */
};
struct crt_beam_place crt_optics_at(const struct crt_optics *optics, int gun, double x_mm,
                                    double y_mm);

/* How far a beam lands from the phosphor it is meant for, mm outwards from the centre. */
double crt_optics_landing(const struct crt_optics *optics, double x_mm, double y_mm);

#endif
