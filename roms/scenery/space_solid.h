/* space_solid.h — small solids of flat faces, drawn through any projection on both heads.
 *
 *      corners ──model──▶ world ──projection──▶ view plane ──scale, place──▶ stage
 *
 *      raster head: faces that look at the viewer, shaded, with their edges
 *      vector head: their edges; those behind are faint
 *
 * Models:     a convex body and, on one of its faces, a second one that stands on it: which of both
 *             is drawn first follows from whether that face is seen (a tree of one partition).
 *             Marks (doors, windows) belong to the face they are on. A light far away at the upper
 *             left.
 * Cost:       a matrix product a solid, 16 multiplications and 2 divisions a corner, a search for
 *             the neighbour of each edge of a face.
 * Domain:     up to SPACE_CORNERS corners and SPACE_FACES faces. A face with a corner beside or
 *             behind the eye is left out.
 * Units:      stage units; the solid's own.
 * Ownership:  plain values; solids are constants.
 * Errors:     none.
 * Source:     H. Fuchs, Z. M. Kedem, B. F. Naylor, On Visible Surface Generation by A Priori Tree
 *             Structures, Computer Graphics 14 (SIGGRAPH 1980) 124.
 */
#ifndef ROMS_SCENERY_SPACE_SOLID_H
#define ROMS_SCENERY_SPACE_SOLID_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/geometry/matrix4.h"
#include "roms/stage/stage.h"

enum { SPACE_CORNERS = 48, SPACE_FACES = 24, SPACE_FACE_CORNERS = 5 };

/* Corners anticlockwise, seen from outside. */
struct space_face {
    uint8_t corner[SPACE_FACE_CORNERS];
    uint8_t corners;
    uint8_t ramp;
    bool mark;
};

struct space_solid {
    const struct vector3 *corner;
    int corners;
    const struct space_face *face;
    int faces;
    int second; /* faces from here on are those of the second body … */
    int stands; /* … that stands on this face */
};

/* A house, 3 wide, 4 deep, on the ground around the origin, its front toward +z: gable with door
 * and window; a chimney on the roof's right side. */
extern const struct space_solid space_house;
/* The cube from (0,0,0) to (1,1,1) with an L on its front, z = 1. */
extern const struct space_solid space_cube;

struct space_view {
    struct stage *stage;
    struct matrix4 projection;
    float scale; /* stage units a unit of the view plane */
    float x, y;  /* where the view plane's origin is on the stage */
};

/* Chooses scale and place so that these places of the view plane fill a part of the stage. */
void space_fit(struct space_view *view, float left, float bottom, float width, float height,
               const struct point2 *places, int count);
/* Where a point of the world is on the stage; false: beside or behind the eye. */
bool space_place(const struct space_view *view, struct vector3 p, struct point2 *out);
void space_line(const struct space_view *view, struct vector3 a, struct vector3 b);
void space_text(const struct space_view *view, struct vector3 at, const char *text);
/* 1, 2 or 5 times a power of ten, at least so much (which is above 0). */
float space_round(float at_least);
/* Axes of this length with arrowheads, names and ticks; their negative halves, faint, if wanted. */
void space_axes(const struct space_view *view, float length, bool negative);

enum space_style { SPACE_FILLED, SPACE_WIRE };
/* Wire: all edges, in the ink of the stage. */
void space_draw(const struct space_view *view, const struct space_solid *solid,
                const struct matrix4 *model, enum space_style style);

#endif
