/* fill_run.h — the same value over a stretch of memory.
 *
 *      at ─▶ ·· ████ ████ ████ … ████ · ◀─ end      bytes up to the first whole word, words, bytes
 *
 * Models:     the inner loop of everything that fills: rectangles, polygons, depth buffers.
 * Cost:       8 words take about 12 instructions, a single word, half or byte about 4.
 * Domain:     what is larger than a byte lies where its size divides the address.
 * Units:      words of 32 bits, the value repeated in them.
 * Ownership:  nothing.
 * Errors:     none: nothing is written where the end is not above the beginning.
 * Source:     elementary.
 */
#ifndef ROMS_RASTER_FILL_RUN_H
#define ROMS_RASTER_FILL_RUN_H

#include <stdint.h>

#define FILL_RUN(name, type)                                                                       \
    static inline void name(type *at, type *end, type value)                                       \
    {                                                                                              \
        for (; end - at >= 8; at += 8) {                                                           \
            at[0] = at[1] = at[2] = at[3] = value;                                                 \
            at[4] = at[5] = at[6] = at[7] = value;                                                 \
        }                                                                                          \
        for (; at < end; at++)                                                                     \
            *at = value;                                                                           \
    }

FILL_RUN(fill_run_words, uint32_t)
FILL_RUN(fill_run_floats, float)

static inline void fill_run_halves(uint16_t *at, uint16_t *end, uint32_t word)
{
    if (at < end && ((uintptr_t)at & 2) != 0)
        *at++ = (uint16_t)word;
    uint16_t *whole = at + (end - at) / 2 * 2;
    fill_run_words((uint32_t *)(void *)at, (uint32_t *)(void *)whole, word);
    if (at < end && whole < end)
        *whole = (uint16_t)word;
}

static inline void fill_run_bytes(uint8_t *at, uint8_t *end, uint32_t word)
{
    if (end - at >= 8) {
        for (; ((uintptr_t)at & 3) != 0; at++)
            *at = (uint8_t)word;
        uint8_t *whole = at + (end - at) / 4 * 4;
        fill_run_words((uint32_t *)(void *)at, (uint32_t *)(void *)whole, word);
        at = whole;
    }
    for (; at < end; at++)
        *at = (uint8_t)word;
}

#endif
