/* stage.c — where the picture is on each head, and pictures that are shown whole. */
#include "roms/stage/stage.h"

#include "roms/bsp/board.h"
#include "roms/bsp/dpu.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"
#include "roms/stage/prompt.h"

/* VESA DMT 04h: pixels that a class can see. */
static const struct video_timing vga = {25175000, 640, 656, 752, 800, 480, 490, 492, 525, 0};

enum {
    HEAD_UNITS = 1024,
    PART_LOW = 0x0100, /* before it: wait for the tick, prompt, jump to the part that is shown */
    PART_BYTES = (DPU_BYTES - PART_LOW) / 2 & ~1u,
    TITLE_ROWS = 2 * FONT_HEIGHT,       /* above the picture, of a screen of 480 rows */
    CAPTION_ROWS = 4 * FONT_HEIGHT + 4, /* below, with the prompt */
};

static uint32_t part(int number)
{
    return PART_LOW + (uint32_t)number * PART_BYTES;
}

static void place_picture(struct stage *stage)
{
    const struct canvas *c = &stage->page[0];
    int scale = c->height >= 900 ? 2 : 1;
    float rows = (float)(c->height - scale * (TITLE_ROWS + CAPTION_ROWS));
    stage->dots = rows / STAGE_HEIGHT;
    if (stage->dots * STAGE_WIDTH > (float)c->width)
        stage->dots = (float)c->width / STAGE_WIDTH;
    stage->left = ((float)c->width - stage->dots * STAGE_WIDTH) / 2;
    stage->bottom = (float)(scale * TITLE_ROWS) + (rows + stage->dots * STAGE_HEIGHT) / 2;
    stage->units = (float)HEAD_UNITS / STAGE_WIDTH;
}

static void open_raster(struct stage *stage)
{
    video_set_timing(&vga);
    stage->page[0] = video_open(8);
    stage->page[1] = video_page(&stage->page[0], 1);
    for (unsigned i = 0; i < INK_ENTRIES; i++)
        video_set_colour(i, ink_rgb(i));
    canvas_clear(&stage->page[0], INK_BLACK);
    canvas_clear(&stage->page[1], INK_BLACK);
    video_on();
}

static void open_vector(struct stage *stage)
{
    struct display d;
    display_begin(&d, 0, PART_LOW);
    display_sync(&d);
    stage->prompt = stage_prompt_begin(&d);
    display_jump(&d, part(0));
    stage->patch = d.at - 2;
    display_begin(&d, part(0), part(1));
    display_jump(&d, 0);
    dpu_start(0);
}

void stage_open(struct stage *stage)
{
    *stage = (struct stage){.heads = STAGE_BOTH, .ink = INK_TEXT};
    open_raster(stage);
    open_vector(stage);
    place_picture(stage);
    stage->canvas = stage->page[1];
}

/* What was given is on the screen, and what was shown before may be written. */
static void wait_until_shown(const struct stage *stage)
{
    while (stage->flipped == video_retraces() && video_present())
        video_wait_retrace();
    for (;;) {
        uint32_t low = part(1 - stage->shown), pc = dpu_pc();
        if (!board_has_vector_head() || pc < low || pc >= low + PART_BYTES)
            return;
    }
}

void stage_begin(struct stage *stage)
{
    int next = 1 - stage->shown;
    wait_until_shown(stage);
    stage->canvas = stage->page[next];
    canvas_clear(&stage->canvas, INK_BLACK);
    display_begin(&stage->display, part(next), part(next) + PART_BYTES);
    display_line_type(&stage->display, DF_LINE_SOLID);
    stage->heads = STAGE_BOTH;
    stage_ink(stage, INK_TEXT);
}

static void show_next(struct stage *stage)
{
    stage->shown = 1 - stage->shown;
    dpu_memory()[stage->patch / 2] = (uint16_t)part(stage->shown);
    stage->flipped = video_retraces();
    video_show(&stage->page[stage->shown]);
}

void stage_end(struct stage *stage)
{
    display_jump(&stage->display, 0);
    stage_prompt_draw(stage, &stage->canvas);
    show_next(stage);
    stage->pictures++;
}

void stage_flip(struct stage *stage)
{
    wait_until_shown(stage);
    stage_prompt_draw(stage, &stage->page[1 - stage->shown]);
    show_next(stage);
}

void stage_heads(struct stage *stage, unsigned heads)
{
    stage->heads = heads;
}

void stage_ink(struct stage *stage, enum ink ink)
{
    stage->ink = ink;
    display_intensity(&stage->display, ink_intensity(ink));
}

float stage_canvas_x(const struct stage *stage, float x)
{
    return stage->left + x * stage->dots;
}

float stage_canvas_y(const struct stage *stage, float y)
{
    return stage->bottom - 1 - y * stage->dots;
}

float stage_head_x(const struct stage *stage, float x)
{
    return x * stage->units;
}

float stage_head_y(const struct stage *stage, float y)
{
    return (HEAD_UNITS - STAGE_HEIGHT * stage->units) / 2 + y * stage->units;
}
