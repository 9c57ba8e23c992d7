/* surface_scan.h — the pixels of a convex surface, row by row.
 *
 *      edges by their first row ──▶ two active ones ──▶ row y: pixels x0 … x1 − 1
 *
 * Models:     scan conversion of one convex polygon by two active edges (scan_edge.h).
 * Cost:       about 80 instructions an edge and 40 a row.
 * Domain:     a surface of a scene; rows and pixels within width and height.
 * Units:      pixels, y downwards.
 * Ownership:  the state is the caller's; scene and surface are looked at in surface_scan_begin
 *             only.
 * Errors:     none; an edge-on surface has no rows.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 3.6.
 */
#ifndef ROMS_VISIBLE_SURFACE_SCAN_H
#define ROMS_VISIBLE_SURFACE_SCAN_H

#include "roms/visible/scan_edge.h"
#include "roms/visible/scene.h"

struct surface_scan {
    int y, x0, x1; /* the row and its pixels; may be empty */
    /* Private. */
    int width, last, next, count;
    struct scan_edge a, b, edge[SURFACE_CORNERS]; /* by their first rows */
};

void surface_scan_begin(struct surface_scan *scan, const struct scene *scene,
                        const struct surface *surface, int width, int height);
/* The next row; false: there is none left. */
bool surface_scan_next(struct surface_scan *scan);

#endif
