#include "roms/interact/pointer_tracking.h"

#include "roms/geometry/scalar.h"

/* One a refresh. A pen that is lost is told of once. */
static void sampled(void *ctx, const struct tracking_sample *sample)
{
    struct pointer *p = ctx;
    const struct stage *s = p->stage;
    bool follows = sample->state == TRACKING_FOLLOWING;
    if (!follows && !p->follows)
        return;
    p->follows = follows;
    struct point2 at = {sample->at.x / s->units, (sample->at.y - stage_head_y(s, 0)) / s->units};
    at.x = scalar_clamp(at.x, 0, STAGE_WIDTH);
    at.y = scalar_clamp(at.y, 0, STAGE_HEIGHT);
    pointer_pen_place(p, at, follows, follows && sample->pressed);
}

void pointer_follow(struct pointer *pointer, struct tracking *tracking)
{
    tracking->place = sampled;
    tracking->place_ctx = pointer;
}
