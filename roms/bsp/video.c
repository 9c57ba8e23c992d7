#include "roms/bsp/video.h"

#include <assert.h>
#include <stddef.h>

#include "emu/memmap.h"
#include "roms/bsp/board.h"

static volatile uint32_t *reg(uint32_t offset)
{
    return (volatile uint32_t *)(MAP_VIDEO + offset);
}

static uint32_t read(uint32_t offset)
{
    return video_present() ? *reg(offset) : 0;
}

static void write(uint32_t offset, uint32_t value)
{
    if (video_present())
        *reg(offset) = value;
}

bool video_present(void)
{
    return board_has_raster_head();
}

/* ---- timing ----------------------------------------------------------------------------------- */

struct video_timing video_timing(void)
{
    return (struct video_timing){
        .clock_hz = read(VIDEO_CLOCK),
        .h_visible = read(VIDEO_H_VISIBLE),
        .h_sync_start = read(VIDEO_H_SYNC_START),
        .h_sync_end = read(VIDEO_H_SYNC_END),
        .h_total = read(VIDEO_H_TOTAL),
        .v_visible = read(VIDEO_V_VISIBLE),
        .v_sync_start = read(VIDEO_V_SYNC_START),
        .v_sync_end = read(VIDEO_V_SYNC_END),
        .v_total = read(VIDEO_V_TOTAL),
        .sync = read(VIDEO_SYNC),
    };
}

static void write_timing(const struct video_timing *t)
{
    write(VIDEO_CLOCK, t->clock_hz);
    write(VIDEO_H_VISIBLE, t->h_visible);
    write(VIDEO_H_SYNC_START, t->h_sync_start);
    write(VIDEO_H_SYNC_END, t->h_sync_end);
    write(VIDEO_H_TOTAL, t->h_total);
    write(VIDEO_V_VISIBLE, t->v_visible);
    write(VIDEO_V_SYNC_START, t->v_sync_start);
    write(VIDEO_V_SYNC_END, t->v_sync_end);
    write(VIDEO_V_TOTAL, t->v_total);
    write(VIDEO_SYNC, t->sync);
}

bool video_set_timing(const struct video_timing *timing)
{
    const uint32_t refused = VIDEO_STATUS_BAD_MODE | VIDEO_STATUS_OUT_RANGE;
    struct video_timing before = video_timing();
    write(VIDEO_STATUS, refused);
    write_timing(timing);
    write(VIDEO_LOAD, 1);
    if (video_present() && (read(VIDEO_STATUS) & refused) == 0)
        return true;
    write(VIDEO_STATUS, refused);
    write_timing(&before); /* the registers tell of what runs again */
    return false;
}

uint32_t video_line_millihertz(const struct video_timing *timing)
{
    if (timing->h_total == 0)
        return 0;
    return (uint32_t)(((uint64_t)timing->clock_hz * 1000 + timing->h_total / 2) / timing->h_total);
}

uint32_t video_field_millihertz(const struct video_timing *timing)
{
    uint64_t dots = (uint64_t)timing->h_total * timing->v_total;
    if (dots == 0)
        return 0;
    unsigned fields = timing->sync & VIDEO_SYNC_INTERLACED ? 2 : 1;
    return (uint32_t)(((uint64_t)timing->clock_hz * 1000 * fields + dots / 2) / dots);
}

/* ---- pictures ---------------------------------------------------------------------------------- */

struct canvas video_open(unsigned bits)
{
    assert(bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16 || bits == 32);
    struct video_timing t = video_timing();
    struct canvas c = {.width = (int)t.h_visible, .height = (int)t.v_visible, .bits = bits};
    c.pitch = canvas_pitch(c.width, bits);
    if ((uint64_t)c.pitch * t.v_visible > VIDEO_BUFFER_BYTES)
        c.width = c.height = 0;
    c.pixels = (uint8_t *)MAP_VIDEO_BUFFER;
    c.dots_a_row = 1.0f;
    if (!video_present())
        return c;
    c.dots_a_row =
        (float)video_height_um() / (float)c.height * (float)c.width / (float)video_width_um();
    write(VIDEO_FORMAT, bits);
    write(VIDEO_PITCH, c.pitch);
    video_show(&c);
    return c;
}

void video_on(void)
{
    write(VIDEO_CONTROL, VIDEO_CONTROL_ON);
}

void video_off(void)
{
    write(VIDEO_CONTROL, 0);
}

struct canvas video_page(const struct canvas *canvas, unsigned n)
{
    struct canvas page = *canvas;
    uint32_t bytes = page.pitch * (uint32_t)page.height;
    assert((n + 1) * bytes <= VIDEO_BUFFER_BYTES);
    page.pixels = (uint8_t *)MAP_VIDEO_BUFFER + n * bytes;
    return page;
}

void video_show(const struct canvas *page)
{
    write(VIDEO_BASE, (uint32_t)(uintptr_t)page->pixels - MAP_VIDEO_BUFFER);
}

void video_set_colour(unsigned index, uint32_t rgb)
{
    if (video_present() && index < VIDEO_LUT_ENTRIES)
        ((volatile uint32_t *)MAP_VIDEO_LUT)[index] = rgb;
}

void video_set_overscan(uint32_t rgb)
{
    write(VIDEO_OVERSCAN, rgb);
}

uint32_t video_width_um(void)
{
    return read(VIDEO_WIDTH_UM);
}

uint32_t video_height_um(void)
{
    return read(VIDEO_HEIGHT_UM);
}

uint32_t video_beam_row(void)
{
    return read(VIDEO_BEAM_LINE);
}

uint32_t video_beam_dot(void)
{
    return read(VIDEO_BEAM_DOT);
}
