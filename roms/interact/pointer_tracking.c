#include "roms/interact/pointer_tracking.h"

#include "roms/geometry/scalar.h"

void pointer_tracked(struct pointer *p, const struct tracking_sample *sample)
{
    bool follows = sample->state == TRACKING_FOLLOWING;
    if (!follows && !p->follows)
        return;
    p->follows = follows;
    struct point2 at = stage_from_head(p->stage, sample->at.x, sample->at.y);
    at.x = scalar_clamp(at.x, 0, STAGE_WIDTH);
    at.y = scalar_clamp(at.y, 0, STAGE_HEIGHT);
    pointer_pen_place(p, at, follows, follows && sample->pressed);
}

static void sampled(void *ctx, const struct tracking_sample *sample)
{
    pointer_tracked(ctx, sample);
}

void pointer_follow(struct pointer *pointer, struct tracking *tracking)
{
    tracking->place = sampled;
    tracking->place_ctx = pointer;
}
