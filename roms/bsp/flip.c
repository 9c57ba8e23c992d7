#include "roms/bsp/flip.h"

#include "roms/bsp/dpu.h"

static uint32_t part(const struct flip *flip, int number)
{
    return flip->low + FLIP_STILL + (uint32_t)number * FLIP_MOVING;
}

struct display flip_begin(struct flip *flip, uint32_t low)
{
    struct display still;
    *flip = (struct flip){.low = low};
    display_begin(&still, low, low + FLIP_STILL);
    display_sync(&still);
    return still;
}

void flip_start(struct flip *flip, struct display *still)
{
    struct display empty;
    display_begin(&empty, part(flip, 0), part(flip, 1));
    display_jump(&empty, flip->low);
    display_jump(still, part(flip, 0));
    flip->patch = still->at - 2;
    dpu_start(flip->low);
}

bool flip_draw(const struct flip *flip, struct display *moving)
{
    uint32_t low = part(flip, 1 - flip->shown), pc = dpu_pc();
    if (pc >= low && pc < low + FLIP_MOVING)
        return false;
    display_begin(moving, low, low + FLIP_MOVING);
    return true;
}

void flip_show(struct flip *flip, struct display *moving)
{
    display_jump(moving, flip->low);
    flip->shown = 1 - flip->shown;
    dpu_memory()[flip->patch / 2] = (uint16_t)part(flip, flip->shown);
}
