/* flight_camera.h — draws things of the world through the windscreen, on both heads.
 *
 * Models:     clipping in homogeneous coordinates, then the division; areas on the raster head,
 *             lines on the heads that the stage is set to.
 * Units:      metres; stage units.
 * Ownership:  plain values; the stage must outlive the camera.
 * Errors:     none: what is out of sight is left out.
 */
#ifndef ROMS_LESSONS_FLIGHT_CAMERA_H
#define ROMS_LESSONS_FLIGHT_CAMERA_H

#include "roms/geometry/matrix4.h"
#include "roms/lessons/flight_model.h"
#include "roms/stage/stage.h"

struct flight_camera {
    struct stage *stage;
    struct vector3 eye;
    struct vector3 right, up, ahead; /* of the aircraft, in the world */
    struct matrix4 matrix;           /* world to view volume */
    float wide, high;                /* of the windscreen, at a distance of 1: half of it */
};

struct flight_camera flight_camera(struct stage *stage, const struct flight *f);
/* False: all of these lie outside of one plane of the view volume. */
bool flight_camera_sees(const struct flight_camera *c, const struct vector3 *corners, int count);
/* A convex polygon of up to 8 corners. */
void flight_camera_area(const struct flight_camera *c, const struct vector3 *corners, int count,
                        uint32_t colour);
void flight_camera_line(const struct flight_camera *c, struct vector3 a, struct vector3 b);
/* The same, of a polygon of up to 8 corners. */
void flight_camera_outline(const struct flight_camera *c, const struct vector3 *corners, int count);
/* A light: a dot, a larger one when near. */
void flight_camera_light(const struct flight_camera *c, struct vector3 at, enum ink ink);

#endif
