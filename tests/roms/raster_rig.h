/* raster_rig.h — for host tests of drawing into pixels: one canvas of any format, and numbers from a seed.
 *
 * Included after the sources under test; canvas_of clears the canvas that was there.
 */
#ifndef TESTS_ROMS_RASTER_RIG_H
#define TESTS_ROMS_RASTER_RIG_H

#include <stdint.h>
#include <string.h>

#include "roms/raster/canvas.h"

enum { WIDTH = 128, HEIGHT = 96 };

static struct {
    uint32_t words[WIDTH * HEIGHT];
    uint32_t state;
} rig;

static uint32_t random_below(uint32_t limit)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) % limit;
}

static float random_within(float low, float high)
{
    return low + (high - low) * (float)random_below(65536) / 65536;
}

static struct canvas canvas_of(unsigned bits)
{
    memset(rig.words, 0, sizeof rig.words);
    struct canvas c = {.width = WIDTH, .height = HEIGHT, .bits = bits, .dots_a_row = 1};
    c.pitch = canvas_pitch(WIDTH, bits);
    c.pixels = (uint8_t *)rig.words;
    return c;
}

#endif
