/* stage_rig.h — the stage on a board of the test's own: a display processor that goes on by a few
 * words whenever its counter is read, and a raster head whose retrace may come at any moment.
 *
 * Included once; brings the sources of the stage with it.
 *
 * Models:     fetches and jumps of the display processor; what is taken at retrace.
 * Ownership:  static.
 * Errors:     none; `fetched`, if set, sees each word.
 */
#ifndef TESTS_ROMS_STAGE_RIG_H
#define TESTS_ROMS_STAGE_RIG_H

#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define within display_within /* another file has one of its own */
#include "roms/bsp/display.c"
#undef within
#include "roms/clip/liang_barsky.c"
#include "roms/geometry/matrix3.c"
#include "roms/raster/ellipse.c"
#include "roms/raster/fill.c"
#include "roms/raster/font.c"
#include "roms/raster/line.c"
#include "roms/raster/line_bresenham.c"
#include "roms/raster/polygon_fill.c"
#include "roms/raster/text.c"
#include "roms/stage/hatch.c"
#include "roms/stage/ink.c"
#include "roms/stage/primitives.c"
#include "roms/stage/prompt.c"
#include "roms/stage/stage.c"
#include "roms/stage/text.c"

enum { RIG_WIDTH = 640, RIG_HEIGHT = 480, RIG_PAGE = RIG_WIDTH * RIG_HEIGHT };

static struct {
    uint32_t seed;
    /* Display processor. */
    uint16_t memory[DPU_BYTES / 2];
    bool vector, runs, address; /* there is one; it goes on; the next word is a jump's */
    uint16_t pc;
    void (*fetched)(uint16_t at, uint16_t word);
    /* Raster head. */
    bool raster;
    uint32_t pixels[2 * RIG_PAGE / 4];
    const uint8_t *given, *shown; /* in the register; taken at retrace */
    uint32_t retraces;
} rig;

static uint32_t random_below(uint32_t limit)
{
    rig.seed = rig.seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)rig.seed * limit >> 32);
}

static float random_between(float low, float high)
{
    return low + (high - low) * (float)random_below(1u << 24) / (float)(1 << 24);
}

/* ---- display processor ----------------------------------------------------------------------- */

static void rig_step(void)
{
    uint16_t at = rig.pc, word = rig.memory[at / 2];
    rig.pc = (uint16_t)(at + 2);
    if (rig.fetched != NULL)
        rig.fetched(at, word);
    if (rig.address) {
        rig.pc = word & 0xFFFEu;
        rig.address = false;
    } else {
        rig.address = (word & 0174000) == DF_JUMP;
    }
}

static void rig_steps(uint32_t most)
{
    for (uint32_t i = rig.vector && rig.runs ? random_below(most + 1) : 0; i > 0; i--)
        rig_step();
}

volatile uint16_t *dpu_memory(void)
{
    return rig.memory;
}

uint32_t dpu_pc(void)
{
    rig_steps(30);
    return rig.vector ? rig.pc : 0;
}

void dpu_start(uint32_t address)
{
    rig.pc = (uint16_t)address;
    rig.address = false;
    rig.runs = true;
}

bool board_has_vector_head(void)
{
    return rig.vector;
}

/* ---- raster head ----------------------------------------------------------------------------- */

static void rig_retrace(void)
{
    rig.shown = rig.given;
    rig.retraces++;
}

static void rig_perhaps_retrace(void)
{
    if (rig.raster && random_below(4) == 0)
        rig_retrace();
}

bool video_set_timing(const struct video_timing *timing)
{
    (void)timing;
    return rig.raster;
}

struct canvas video_open(unsigned bits)
{
    struct canvas c = {.bits = bits, .dots_a_row = 1.0f};
    if (!rig.raster)
        return c;
    c.width = RIG_WIDTH;
    c.height = RIG_HEIGHT;
    c.pitch = canvas_pitch(c.width, bits);
    c.pixels = (uint8_t *)rig.pixels;
    rig.given = rig.shown = c.pixels;
    return c;
}

struct canvas video_page(const struct canvas *canvas, unsigned n)
{
    struct canvas page = *canvas;
    if (rig.raster)
        page.pixels += n * RIG_PAGE;
    return page;
}

void video_on(void)
{
}

void video_show(const struct canvas *page)
{
    rig_perhaps_retrace();
    rig.given = page->pixels;
    rig_perhaps_retrace();
}

void video_set_colour(unsigned index, uint32_t rgb)
{
    (void)index;
    (void)rgb;
}

uint32_t video_retraces(void)
{
    rig_perhaps_retrace();
    return rig.retraces;
}

void video_wait_retrace(void)
{
    if (rig.raster)
        rig_retrace();
}

/* ---- a stage on it --------------------------------------------------------------------------- */

static void rig_open(struct stage *stage, bool vector, bool raster)
{
    uint32_t seed = rig.seed;
    memset(&rig, 0, sizeof rig);
    rig.seed = seed != 0 ? seed : 1;
    rig.vector = vector;
    rig.raster = raster;
    stage_open(stage);
}

/* ---- words as lines -------------------------------------------------------------------------- */

struct drawn {
    int x0, y0, x1, y1; /* a dot: twice the same */
    unsigned intensity, type;
    bool blink;
};

struct drawing {
    struct drawn line[8192];
    int count, points, characters;
    uint32_t end; /* where the last jump leads to */
    unsigned intensity, type;
    bool blink;
};

static int sign_and_amount(unsigned word, unsigned sign, unsigned amount)
{
    return word & sign ? -(int)amount : (int)amount;
}

static void decode_line(struct drawing *out, int *x, int *y, unsigned first, int dx, int dy)
{
    if ((first & DF_BEAM_ON) && (dx != 0 || dy != 0)) {
        assert_true(out->count < 8192);
        out->line[out->count++] =
            (struct drawn){*x, *y, *x + dx, *y + dy, out->intensity, out->type, out->blink};
    }
    *x += dx;
    *y += dy;
    assert_in_range(*x, 0, 1023);
    assert_in_range(*y, 0, 1023);
}

static void decode_mode(struct drawing *out, unsigned word)
{
    if (word & DF_SGM_INTENSITY)
        out->intensity = word >> DF_SGM_INTENSITY_SHIFT & 7;
    if (word & DF_SGM_LINE)
        out->type = word & DF_LINE_DOTDASH;
    if (word & DF_SGM_BLINK)
        out->blink = word & DF_SGM_BLINK_ON;
}

/* From `at` to the next jump, by the definitions of df_regs.h. */
static void decode(uint32_t at, struct drawing *out)
{
    unsigned mode = DF_MODE_CHAR;
    int x = 0, y = 0;
    memset(out, 0, offsetof(struct drawing, line));
    out->count = out->points = out->characters = 0;
    out->intensity = 4;
    for (uint32_t words = 0; words < DPU_BYTES / 2; words++, at += 2) {
        unsigned word = rig.memory[at / 2];
        if ((word & 0174000) == DF_JUMP) {
            out->end = rig.memory[at / 2 + 1];
            return;
        }
        if (word & DF_CONTROL) {
            if (word < 0140000) {
                mode = word >> DF_MODE_SHIFT & 15;
                decode_mode(out, word);
            }
            continue;
        }
        if (mode == DF_MODE_CHAR) {
            out->characters += ((word & 0177) != 0) + ((word >> 8 & 0177) != 0);
        } else if (mode == DF_MODE_SHORT) {
            decode_line(out, &x, &y, word,
                        sign_and_amount(word, DF_SIGN_X, (word & DF_SHORT_DX) >> DF_SHORT_DX_SHIFT),
                        sign_and_amount(word, DF_SHORT_SIGN_Y, word & DF_SHORT_DY));
        } else if (mode == DF_MODE_LONG) {
            unsigned second = rig.memory[(at += 2) / 2];
            decode_line(out, &x, &y, word, sign_and_amount(word, DF_SIGN_X, word & DF_LONG_DELTA),
                        sign_and_amount(second, DF_SIGN_X, second & DF_LONG_DELTA));
        } else {
            assert_int_equal(mode, DF_MODE_POINT);
            x = word & 01777;
            y = rig.memory[(at += 2) / 2] & 01777;
            out->points++;
            if (word & DF_BEAM_ON) {
                assert_true(out->count < 8192);
                out->line[out->count++] =
                    (struct drawn){x, y, x, y, out->intensity, out->type, out->blink};
            }
        }
    }
    fail_msg("no jump");
}

/* What of a line is in the picture, in head units, by another method and in double precision: each
 * edge of the picture takes its part off. */
static bool visible_part(double v[4])
{
    for (int axis = 0; axis < 2; axis++)
        for (int side = 0; side < 2; side++) {
            double edge = side == 0 ? 0 : axis == 0 ? STAGE_WIDTH : STAGE_HEIGHT;
            double da = side == 0 ? v[axis] - edge : edge - v[axis];
            double db = side == 0 ? v[2 + axis] - edge : edge - v[2 + axis];
            if (da < 0 && db < 0)
                return false;
            if (da >= 0 && db >= 0)
                continue;
            double t = da / (da - db), x = v[0] + t * (v[2] - v[0]), y = v[1] + t * (v[3] - v[1]);
            int moved = da < 0 ? 0 : 2;
            v[moved] = x;
            v[moved + 1] = y;
        }
    for (int i = 0; i < 4; i++)
        v[i] = v[i] * 1024.0 / STAGE_WIDTH +
               (i % 2 == 1 ? (1024.0 - STAGE_HEIGHT * 1024.0 / STAGE_WIDTH) / 2 : 0);
    return true;
}

static bool drawn_is(const struct drawn *d, const double v[4])
{
    return fabs(d->x0 - v[0]) < 1.01 && fabs(d->y0 - v[1]) < 1.01 && fabs(d->x1 - v[2]) < 1.01 &&
           fabs(d->y1 - v[3]) < 1.01;
}

#endif
