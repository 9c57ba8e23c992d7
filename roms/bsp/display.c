#include "roms/bsp/display.h"

#include <stdlib.h>

#include "roms/bsp/dpu.h"

enum { HIGHEST = 1023, LONGEST_SHORT = 63, MODE_UNKNOWN = -1 };

void display_begin(struct display *d, uint32_t low, uint32_t high)
{
    *d = (struct display){.at = low, .end = high, .mode = MODE_UNKNOWN};
}

/* A jump's two words always find room. */
static bool has_room(struct display *d, uint32_t words, uint32_t kept)
{
    if (d->at + 2 * (words + kept) > d->end)
        d->full = true;
    return !d->full;
}

static void put(struct display *d, uint16_t word)
{
    dpu_memory()[d->at / 2] = word;
    d->at += 2;
}

void display_word(struct display *d, uint16_t word)
{
    if (has_room(d, 1, 2))
        put(d, word);
}

/* The mode word, unless the words before were of the same mode and nothing is to change. */
static void mode(struct display *d, int number)
{
    if (d->mode == number && d->setting == 0)
        return;
    put(d, (uint16_t)(DF_SET_MODE | (unsigned)number << DF_MODE_SHIFT | d->setting));
    d->mode = number;
    d->setting = 0;
}

void display_intensity(struct display *d, unsigned level)
{
    d->setting &= (uint16_t) ~(DF_SGM_INTENSITY | 7u << DF_SGM_INTENSITY_SHIFT);
    d->setting |= (uint16_t)(DF_SGM_INTENSITY | (level & 7) << DF_SGM_INTENSITY_SHIFT);
}

void display_line_type(struct display *d, unsigned type)
{
    d->setting &= (uint16_t) ~(DF_SGM_LINE | DF_LINE_DOTDASH);
    d->setting |= (uint16_t)(DF_SGM_LINE | (type & DF_LINE_DOTDASH));
}

static int within(int v)
{
    return v < 0 ? 0 : v > HIGHEST ? HIGHEST : v;
}

static void point(struct display *d, int x, int y, uint16_t lit)
{
    if (!has_room(d, 3, 2))
        return;
    mode(d, DF_MODE_POINT);
    d->x = within(x);
    d->y = within(y);
    put(d, (uint16_t)(lit | (unsigned)d->x));
    put(d, (uint16_t)d->y);
}

void display_at(struct display *d, int x, int y)
{
    point(d, x, y, 0);
}

void display_dot(struct display *d, int x, int y)
{
    point(d, x, y, DF_BEAM_ON);
}

/* Sign and magnitude: `sign` where v is negative, the amount from bit `shift` on. */
static uint16_t signed_bits(int v, unsigned sign, unsigned shift)
{
    return (uint16_t)((v < 0 ? sign : 0) | (unsigned)abs(v) << shift);
}

void display_line(struct display *d, int x, int y)
{
    if (!has_room(d, 3, 2))
        return;
    int dx = within(x) - d->x, dy = within(y) - d->y;
    if (abs(dx) <= LONGEST_SHORT && abs(dy) <= LONGEST_SHORT) {
        mode(d, DF_MODE_SHORT);
        put(d, (uint16_t)(DF_BEAM_ON | signed_bits(dx, DF_SIGN_X, DF_SHORT_DX_SHIFT) |
                          signed_bits(dy, DF_SHORT_SIGN_Y, 0)));
    } else {
        mode(d, DF_MODE_LONG);
        put(d, (uint16_t)(DF_BEAM_ON | signed_bits(dx, DF_SIGN_X, 0)));
        put(d, signed_bits(dy, DF_SIGN_X, 0)); /* the same bit in the second word */
    }
    d->x += dx;
    d->y += dy;
}

void display_text(struct display *d, int x, int y, const char *text)
{
    display_at(d, x, y);
    if (!has_room(d, 1, 2))
        return;
    mode(d, DF_MODE_CHAR);
    while (*text != '\0' && has_room(d, 1, 2)) {
        unsigned low = (unsigned char)*text++ & 0x7F;
        unsigned high = *text != '\0' ? (unsigned char)*text++ & 0x7F : 0;
        put(d, (uint16_t)(high << 8 | low));
    }
}

void display_sync(struct display *d)
{
    display_word(d, DF_STATUS_A | DF_LSA_SYNC);
}

void display_stop(struct display *d)
{
    display_word(d, DF_STOP | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON);
}

void display_jump(struct display *d, uint32_t address)
{
    if (d->at + 4 > d->end)
        return;
    put(d, DF_JUMP);
    put(d, (uint16_t)address);
}
