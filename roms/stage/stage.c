/* stage.c — where the picture is on each head, and pictures that are shown whole. */
#include "roms/stage/stage.h"

#include <math.h>

#include "roms/bsp/board.h"
#include "roms/bsp/dpu.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"
#include "roms/stage/device.h"
#include "roms/stage/prompt.h"

/* VESA DMT 04h: pixels that a class can see. */
static const struct video_timing vga = {25175000, 640, 656, 752, 800, 480, 490, 492, 525, 0};

enum {
    PATIENCE = 4000000,                 /* looks at the display processor: half a second */
    MESSAGE_BYTES = 64,                 /* kept in a part for saying that it is full */
    TITLE_ROWS = 2 * FONT_HEIGHT,       /* above the picture, of a screen of 480 rows */
    CAPTION_ROWS = 4 * FONT_HEIGHT + 4, /* below, with the prompt */
};

static uint32_t part(int number)
{
    return STAGE_PART_LOW + (uint32_t)number * STAGE_PART_BYTES;
}

static void place_picture(struct stage *stage)
{
    const struct canvas *c = &stage->page[0];
    int scale = c->height >= 900 ? 2 : 1;
    float rows = (float)(c->height - scale * (TITLE_ROWS + CAPTION_ROWS));
    stage->dots = rows > 8 ? rows / STAGE_HEIGHT : 8.0f / STAGE_HEIGHT;
    if (stage->dots * STAGE_WIDTH > (float)c->width && c->width > 0)
        stage->dots = (float)c->width / STAGE_WIDTH;
    /* A multiple of 4, as canvases begin: stage_picture. */
    stage->left = 4 * floorf(((float)c->width - stage->dots * STAGE_WIDTH) / 8);
    stage->bottom = floorf((float)(scale * TITLE_ROWS) + (rows + stage->dots * STAGE_HEIGHT) / 2);
    stage->units = (float)DEVICE_UNITS / STAGE_WIDTH;
}

static void open_raster(struct stage *stage)
{
    video_set_timing(&vga); /* a monitor that cannot follow goes on in the mode it has */
    stage->page[0] = stage->page[1] = video_open(8);
    if (2 * stage->page[0].pitch * (uint32_t)stage->page[0].height <= VIDEO_BUFFER_BYTES)
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
    display_begin(&d, 0, STAGE_PART_LOW);
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
    display_begin(&stage->display, part(1), part(1)); /* takes nothing before stage_begin */
}

/* ---- pictures -------------------------------------------------------------------------------- */

/* The page that was given is on the screen: the other one may be written. */
static void wait_for_page(const struct stage *stage)
{
    if (video_retraces() == stage->flipped)
        video_wait_retrace(); /* at once without a head, or while it is off */
}

static bool is_in_part(int number)
{
    return dpu_pc() - part(number) < STAGE_PART_BYTES;
}

/* The display processor has left the part, which nothing leads to any more: a refresh at most; for
 * ever if somebody has stopped it there: then it is written all the same. */
static void wait_for_part(int number)
{
    for (int i = 0; i < PATIENCE && board_has_vector_head() && is_in_part(number); i++)
        ;
}

void stage_begin(struct stage *stage)
{
    int next = 1 - stage->part_shown;
    wait_for_page(stage);
    wait_for_part(next);
    stage->canvas = stage->page[1 - stage->page_shown];
    canvas_clear(&stage->canvas, INK_BLACK);
    display_begin(&stage->display, part(next), part(next) + STAGE_PART_BYTES - MESSAGE_BYTES);
    stage->intensity = stage->type = -1;
    stage->chain = 0;
    stage->full = false;
    stage->heads = STAGE_BOTH;
    stage_line_type(stage, STAGE_SOLID);
    stage_hatch(stage, 0, 0);
    stage_ink(stage, INK_TEXT);
}

/* In both pictures. */
static void say_full(struct stage *stage)
{
    static const char *const text = "Display memory is full";
    int left, top;
    stage->full = true;
    stage->display.full = false;
    stage->display.end += MESSAGE_BYTES;
    display_intensity(&stage->display, ink_intensity(INK_RED));
    display_text(&stage->display, 8, DEVICE_UNITS / 8, text);
    stage_picture(stage, &left, &top);
    canvas_fill(&stage->canvas, left, top, FONT_WIDTH * 22, FONT_HEIGHT, INK_BLACK);
    canvas_text(&stage->canvas, left, top, 1, 1, INK_RED, text);
}

/* The count after the store: a retrace between the two is one too many, and only waited for
 * again. */
static void show_page(struct stage *stage)
{
    stage->page_shown = 1 - stage->page_shown;
    stage_prompt_draw(stage, &stage->page[stage->page_shown]);
    video_show(&stage->page[stage->page_shown]);
    stage->flipped = video_retraces();
    stage->pictures++;
}

static void show_part(struct stage *stage)
{
    stage->part_shown = 1 - stage->part_shown;
    dpu_memory()[stage->patch / 2] = (uint16_t)part(stage->part_shown);
}

void stage_end(struct stage *stage)
{
    if (stage->display.full)
        say_full(stage);
    display_jump(&stage->display, stage->chain);
    show_part(stage);
    show_page(stage);
}

void stage_flip(struct stage *stage)
{
    wait_for_page(stage);
    show_part(stage);
    show_page(stage);
}

void stage_chain(struct stage *stage, uint32_t address)
{
    stage->chain = address;
}

void stage_page_begin(struct stage *stage)
{
    wait_for_page(stage);
    stage->canvas = stage->page[1 - stage->page_shown];
}

void stage_page_end(struct stage *stage)
{
    show_page(stage);
}

/* ---- what primitives are drawn with ---------------------------------------------------------- */

void stage_heads(struct stage *stage, unsigned heads)
{
    stage->heads = heads;
}

void stage_ink(struct stage *stage, enum ink ink)
{
    int intensity = (int)ink_intensity(ink);
    stage->ink = ink;
    if (stage->intensity != intensity)
        display_intensity(&stage->display, (unsigned)intensity);
    stage->intensity = intensity;
}

void stage_line_type(struct stage *stage, enum stage_line_type type)
{
    stage->line_type = type;
    stage->dash_end = (struct point2){-1, -1};
}

void stage_hatch(struct stage *stage, float degrees, float apart)
{
    stage->hatch_degrees = degrees;
    stage->hatch_apart = apart;
}

/* ---- where places are ------------------------------------------------------------------------ */

struct canvas stage_picture(const struct stage *stage, int *left, int *top)
{
    struct canvas c = stage->canvas;
    int low = (int)stage->bottom - 1, high = (int)ceilf(stage_canvas_y(stage, STAGE_HEIGHT));
    int right = (int)(stage->left + STAGE_WIDTH * stage->dots);
    *left = stage->left > 0 ? (int)stage->left : 0;
    *top = high > 0 ? high : 0;
    low = low < c.height ? low : c.height - 1;
    right = right < c.width ? right : c.width - 1;
    c.width = right >= *left ? right - *left + 1 : 0;
    c.height = low >= *top ? low - *top + 1 : 0;
    if (c.width > 0 && c.height > 0)
        c.pixels += (uint32_t)*top * c.pitch + (uint32_t)*left * c.bits / 8;
    return c;
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
    return (DEVICE_UNITS - STAGE_HEIGHT * stage->units) / 2 + y * stage->units;
}

struct point2 stage_from_canvas(const struct stage *stage, float x, float y)
{
    return (struct point2){(x - stage->left) / stage->dots, (stage->bottom - 1 - y) / stage->dots};
}

struct point2 stage_from_head(const struct stage *stage, float x, float y)
{
    return (struct point2){x / stage->units, (y - stage_head_y(stage, 0)) / stage->units};
}
