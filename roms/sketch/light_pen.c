#include "roms/sketch/light_pen.h"

#include "roms/bsp/timer.h"
#include "roms/interact/pointer_tracking.h"

enum { PATIENCE = 3 * TIMER_HZ };

void light_pen_begin(struct light_pen *pen, uint32_t next)
{
    tracking_begin(&pen->tracking, LIGHT_PEN_LOW, next);
    pen->used = false;
}

bool light_pen_poll(struct light_pen *pen, struct pointer *pointer)
{
    struct tracking_sample sample;
    bool used = pen->used, tip = pen_tip(INPUT_VECTOR);
    uint32_t now = (uint32_t)timer_now();
    while (used && tracking_take(&pen->tracking, &sample))
        pointer_tracked(pointer, &sample);
    bool lost = tracking_state(&pen->tracking) == TRACKING_LOST;
    if (tip && lost)
        tracking_scan(&pen->tracking);
    if (tip || (used && !lost))
        pen->seen = now;
    pen->used = tip || (used && now - pen->seen < PATIENCE);
    return pen->used != used;
}
