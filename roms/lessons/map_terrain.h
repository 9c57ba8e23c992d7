/* map_terrain.h — an island: its heights, and what a map draws of them.
 *
 *      hills ──▶ grid of heights ──▶ contour lines (coast: height 0)
 *                        └─────────▶ rivers: down the steepest way
 *
 * Models:     heights as sums of round hills and hollows with a little unrest; contour lines by
 *             marching squares, joined to polylines; a grid of light for shaded relief.
 * Units:      kilometres east and north; heights in kilometres.
 * Ownership:  plain value, about 200 KB; one for the program.
 * Errors:     none: contour points that do not fit are left out.
 * Source:     the island is invented; marching squares: W. E. Lorensen, H. E. Cline, Computer
 *             Graphics (SIGGRAPH) 21 (1987) 163, in two dimensions.
 */
#ifndef ROMS_LESSONS_MAP_TERRAIN_H
#define ROMS_LESSONS_MAP_TERRAIN_H

#include <stdint.h>

#include "roms/geometry/vector.h"

enum {
    MAP_WIDTH = 120, /* km */
    MAP_HEIGHT = 100,
    MAP_COLUMNS = 81, /* of the grid: every 1.5 km */
    MAP_ROWS = 68,
    MAP_LEVELS = 6,
    MAP_POINTS = 4096,
    MAP_LINES = 96,
    MAP_RIVERS = 6,
    MAP_RIVER_POINTS = 80,
};
#define MAP_CELL       1.5f
#define MAP_LEVEL_STEP 0.13f /* from contour to contour */

struct map_line {
    int first, count; /* of point[] */
    int level;        /* 0: the coast */
};

struct map_terrain {
    float height[MAP_ROWS][MAP_COLUMNS];
    int16_t fixed[MAP_ROWS][MAP_COLUMNS]; /* height · 4096 */
    int16_t light[MAP_ROWS][MAP_COLUMNS]; /* 0…4096: as the sun in the north-west lights it */
    struct point2 point[MAP_POINTS];
    int points;
    struct map_line line[MAP_LINES];
    int lines;
    struct point2 river[MAP_RIVERS][MAP_RIVER_POINTS];
    int river_count[MAP_RIVERS];
    /* Private: which edges of the grid the contour that is being traced joins. */
    int16_t joined[MAP_ROWS * MAP_COLUMNS * 2][2];
};

void map_terrain_make(struct map_terrain *t);

#endif
