#include <math.h>

#include "roms/clock/clock.h"

#define TURN 6.2831853f

struct xy {
    int x, y;
};

static struct xy xy_of(float turn, float along, float across)
{
    float s = sinf(turn * TURN), c = cosf(turn * TURN);
    return (struct xy){CLOCK_X + (int)lrintf(along * s + across * c),
                       CLOCK_Y + (int)lrintf(along * c - across * s)};
}

void clock_at(struct display *d, float turn, float along, float across)
{
    struct xy p = xy_of(turn, along, across);
    display_at(d, p.x, p.y);
}

void clock_line(struct display *d, float turn, float along, float across)
{
    struct xy p = xy_of(turn, along, across);
    display_line(d, p.x, p.y);
}

void clock_ring(struct display *d, struct clock_place centre, float radius, int sides)
{
    clock_at(d, centre.turn, centre.along + radius, centre.across);
    for (int i = 1; i <= sides; i++) {
        float angle = TURN * (float)i / (float)sides;
        clock_line(d, centre.turn, centre.along + radius * cosf(angle),
                   centre.across + radius * sinf(angle));
    }
}
