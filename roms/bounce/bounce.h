/* bounce.h — a solid that flies about in a room.
 *
 *      floor y = -1, ceiling y = 1, walls x = ±1, panes z = ±1; the viewer looks along z, near is -1
 *
 * Models:     a ball under gravity with an icosahedron drawn in it; walls give back all of its speed,
 *             the floor makes up for what was lost, so it goes on for ever; it turns, about another
 *             axis after each bounce.
 * Position:   half rooms. Velocity: half rooms a second. Time: seconds.
 * Ownership:  plain values.
 * Errors:     none.
 * Source:     mechanics; the room and its gravity are invented.
 * Not modelled: friction, air.
 */
#ifndef ROMS_BOUNCE_BOUNCE_H
#define ROMS_BOUNCE_BOUNCE_H

#include "roms/bsp/display.h"

#define BODY_RADIUS   0.34f
#define BODY_VERTICES 12

struct vector {
    float x, y, z;
};

struct body {
    struct vector place, velocity;
    struct vector axis;   /* of its turning, length 1 */
    float turn_rate;      /* radians a second */
    struct vector row[3]; /* how it stands: a rotation's rows */
    unsigned bounces;
};

void body_init(struct body *body);
/* `dt` seconds later. True when it has bounced. */
bool body_move(struct body *body, float dt);
/* Where its corners are in the room. */
void body_corners(const struct body *body, struct vector corners[BODY_VERTICES]);

/* The room, which stays; the body and its shadow. */
void draw_room(struct display *d);
void draw_body(struct display *d, const struct body *body);

#endif
