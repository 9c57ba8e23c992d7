/* hatch.h — areas on a head that cannot fill: parallel lines within a polygon.
 *
 *      ╱╲      the polygon is turned so that the lines lie level; each line's crossings with the
 *     ╱//╲     edges are sorted, and every other stretch between them is drawn
 *    ╱////╲
 *
 * Models:     hatching by the even-odd rule. Lines of all areas lie on one grid: areas that touch
 *             are hatched alike.
 * Cost:       lines · edges crossings.
 * Domain:     at most STAGE_AREA_CORNERS corners; lines less than 3 units apart are drawn 3 apart.
 * Units:      stage units, degrees.
 * Ownership:  plain values; draws with the stage's ink on the heads that are chosen.
 * Errors:     none.
 * Source:     J. D. Foley et al., Computer Graphics (1990), section 3.9 (the scan-line method,
 *             turned).
 */
#ifndef ROMS_STAGE_HATCH_H
#define ROMS_STAGE_HATCH_H

#include "roms/stage/stage.h"

/* As stage_hatch has set it. */
void hatch_area(struct stage *stage, const struct point2 *corners, int count);

#endif
