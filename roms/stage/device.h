/* device.h — from stage units to the whole numbers of each head; for the stage's own files.
 *
 * Models:     the nearest dot, row and head unit.
 * Units:      stage units in; dots, rows from the top, head units out.
 * Ownership:  plain values.
 * Errors:     none, for places that device_sane takes.
 * Source:     elementary.
 */
#ifndef ROMS_STAGE_DEVICE_H
#define ROMS_STAGE_DEVICE_H

#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/stage/stage.h"

enum {
    DEVICE_FARTHEST = 1000000,
    DEVICE_UNITS = 1024,   /* of the vector head, either way */
    DEVICE_CHARACTER = 14, /* advance of a character, head units */
};

/* Finite, and not so far that whole numbers overflow. */
static inline bool device_sane(struct point2 p)
{
    return fabsf(p.x) <= DEVICE_FARTHEST && fabsf(p.y) <= DEVICE_FARTHEST;
}

/* In the picture, whatever rounding did. */
static inline struct point2 device_inside(struct point2 p)
{
    return (struct point2){scalar_clamp(p.x, 0, STAGE_WIDTH), scalar_clamp(p.y, 0, STAGE_HEIGHT)};
}

static inline int device_dot(const struct stage *s, float x)
{
    return scalar_nearest(stage_canvas_x(s, x));
}

static inline int device_row(const struct stage *s, float y)
{
    return scalar_nearest(stage_canvas_y(s, y));
}

/* 1200 units across are 1024: the last one is 1023. */
static inline int device_head_x(const struct stage *s, float x)
{
    int at = scalar_nearest(stage_head_x(s, x));
    return at > 1023 ? 1023 : at;
}

static inline int device_head_y(const struct stage *s, float y)
{
    return scalar_nearest(stage_head_y(s, y));
}

#endif
