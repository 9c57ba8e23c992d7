#include "roms/stage/ink.h"

#include <math.h>

static const struct {
    uint32_t rgb;
    unsigned intensity;
} inks[INK_COUNT] = {
    [INK_BLACK] = {0x000000, 0},  [INK_GRID] = {0x5C6874, 1},   [INK_TEXT] = {0xB8C0C4, 4},
    [INK_BRIGHT] = {0xFFFFFF, 7}, [INK_RED] = {0xFF4838, 6},    [INK_ORANGE] = {0xFF9828, 5},
    [INK_YELLOW] = {0xF8E038, 6}, [INK_GREEN] = {0x40D850, 5},  [INK_CYAN] = {0x38D0E8, 5},
    [INK_BLUE] = {0x5080FF, 4},   [INK_VIOLET] = {0xC878FF, 4}, [INK_BROWN] = {0x906040, 3},
};

/* The brightest of each ramp; linear light. */
static const float tops[INK_RAMPS][3] = {
    [RAMP_GREY] = {1, 1, 1},         [RAMP_COPPER] = {1, 0.45f, 0.2f},
    [RAMP_GREEN] = {0.3f, 1, 0.35f}, [RAMP_BLUE] = {0.25f, 0.45f, 1},
    [RAMP_GOLD] = {1, 0.75f, 0.2f},
};

static uint32_t drive(float light)
{
    return (uint32_t)(255 * powf(light, 1 / 2.4f) + 0.5f);
}

uint32_t ink_rgb(unsigned entry)
{
    if (entry < 16)
        return entry < INK_COUNT ? inks[entry].rgb : 0;
    unsigned ramp = (entry - 16) / INK_LEVELS;
    float light = (float)((entry - 16) % INK_LEVELS) / (INK_LEVELS - 1);
    uint32_t rgb = 0;
    for (int i = 0; i < 3; i++) {
        /* Colours of the upper third go toward white, as a highlight does. */
        float white = light > 0.67f ? (light - 0.67f) / 0.33f : 0;
        float part = tops[ramp][i] + (1 - tops[ramp][i]) * white * 0.8f;
        rgb = rgb << 8 | drive(light * part);
    }
    return rgb;
}

uint32_t ink_shade(enum ink_ramp ramp, float intensity)
{
    float level = intensity * (INK_LEVELS - 1) + 0.5f;
    level = level < 0 ? 0 : level > INK_LEVELS - 1 ? INK_LEVELS - 1 : level;
    return 16u + (unsigned)ramp * INK_LEVELS + (unsigned)level;
}

unsigned ink_intensity(enum ink ink)
{
    if (ink < INK_COUNT)
        return inks[ink].intensity;
    return ink < 16 ? 0 : (ink - 16u) % INK_LEVELS * 8 / INK_LEVELS; /* of a shade */
}
