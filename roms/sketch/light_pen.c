#include "roms/sketch/light_pen.h"

#include "roms/bsp/timer.h"

enum { PATIENCE = 3 * TIMER_HZ };

void light_pen_begin(struct light_pen *pen, uint32_t next)
{
    tracking_begin(&pen->tracking, LIGHT_PEN_LOW, next);
    pen->used = false;
}

static void tell(struct pointer *pointer, const struct tracking_sample *sample)
{
    const struct stage *s = pointer->stage;
    struct point2 at = {sample->at.x / s->units, (sample->at.y - stage_head_y(s, 0)) / s->units};
    bool near = sample->state == TRACKING_FOLLOWING;
    pointer_pen_place(pointer, at, near, near && sample->pressed);
}

bool light_pen_poll(struct light_pen *pen, struct pointer *pointer)
{
    struct tracking_sample sample;
    bool used = pen->used, tip = pen_tip(INPUT_VECTOR);
    uint32_t now = (uint32_t)timer_now();
    while (used && tracking_take(&pen->tracking, &sample))
        tell(pointer, &sample);
    bool lost = tracking_state(&pen->tracking) == TRACKING_LOST;
    if (tip && lost)
        tracking_scan(&pen->tracking);
    if (tip || (used && !lost))
        pen->seen = now;
    pen->used = tip || (used && now - pen->seen < PATIENCE);
    return pen->used != used;
}
