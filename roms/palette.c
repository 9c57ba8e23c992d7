/* palette — everything moves, and no pixel is written twice: only the look-up table changes.
 *
 *      kinescope run roms/palette.elf [--console]
 *
 * Above: a surface of waves, drawn once with 240 indices. At each retrace the colours move on by
 * one entry. Below: a band of one single index. While the beam goes through it, each row interrupts
 * (line compare) and sets that index's colour for the row after it: more colours at once than the
 * table has entries.
 *
 * Keys: space stops and starts the colours; q ends the program.
 * Marks: 1 when the picture is complete; from then on the pixels stay as they are.
 */
#include <math.h>
#include <stdbool.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

#define TAU 6.2831853f

enum { CYCLE = 240, BAND = 250, BLACK = 251, WHITE = 252, WAVES = 1024 };
enum { BARS = 5 };

struct palette {
    struct canvas canvas;
    uint32_t colours[2 * CYCLE]; /* twice: a turned table is a stretch of it */
    uint32_t *rows;              /* the band's colours, one a row */
    int band_top, band_rows;
    int row;        /* of the band: that the next interrupt sets */
    int step;       /* rows from line to line: interlaced, a field has every second one */
    unsigned phase; /* of the colours */
    bool still;
};

static uint32_t rows[4096];

/* ---- the surface ------------------------------------------------------------------------------- */

static int16_t wave[WAVES]; /* a turn of a sine, of 1/16 indices */

static void waves(void)
{
    for (int i = 0; i < WAVES; i++)
        wave[i] = (int16_t)lrintf(16.0f * 40.0f * sinf(TAU * (float)i / WAVES));
}

/* How far from the place at 3/8 of the width and half the height, in units of the waves. */
static unsigned distance(const struct palette *p, int x, int y)
{
    float dx = (float)x - 0.375f * (float)p->canvas.width;
    float dy = ((float)y - 0.45f * (float)p->band_top) * p->canvas.dots_a_row;
    return (unsigned)(sqrtf(dx * dx + dy * dy) * 2560.0f / (float)p->canvas.width);
}

static void surface(const struct palette *p)
{
    const struct canvas *c = &p->canvas;
    for (int y = 0; y < p->band_top; y++) {
        uint8_t *row = c->pixels + (uint32_t)y * c->pitch;
        unsigned v = (unsigned)(y * 2000 / p->band_top);
        for (int x = 0; x < c->width; x++) {
            unsigned u = (unsigned)(x * 2400 / c->width);
            int sum = wave[(u + 300) % WAVES] + wave[v % WAVES] + wave[(u + v) / 2 % WAVES] +
                      wave[distance(p, x, y) % WAVES];
            row[x] = (uint8_t)(((unsigned)(sum / 16) + 16 * CYCLE) % CYCLE);
        }
    }
}

/* ---- colours ----------------------------------------------------------------------------------- */

static uint32_t channel(float turn)
{
    return (uint32_t)(127.5f + 127.5f * cosf(TAU * turn));
}

/* Round the circle of hues, with a dark valley each third. */
static void hues(struct palette *p)
{
    for (int i = 0; i < 2 * CYCLE; i++) {
        float turn = (float)i / CYCLE, light = 0.62f - 0.38f * cosf(TAU * turn * 3.0f);
        uint32_t red = (uint32_t)((float)channel(turn) * light),
                 green = (uint32_t)((float)channel(turn - 0.36f) * light * 0.9f),
                 blue = (uint32_t)((float)channel(turn - 0.64f) * light);
        p->colours[i] = red << 16 | green << 8 | blue;
    }
}

/* A bar as a rod of metal: bright in its middle. */
static void rod(struct palette *p, int middle, int half, uint32_t colour)
{
    for (int i = -half; i <= half; i++) {
        if (middle + i < 0 || middle + i >= p->band_rows)
            continue;
        uint32_t level = (uint32_t)(255 - i * i * 235 / (half * half));
        uint32_t red = (colour >> 16) * level / 255, green = (colour >> 8 & 255) * level / 255,
                 blue = (colour & 255) * level / 255;
        p->rows[middle + i] = red << 16 | green << 8 | blue;
    }
}

static void band(struct palette *p)
{
    static const uint32_t metals[BARS] = {0xFF4040, 0xFFC020, 0x50E050, 0x40A0FF, 0xD060FF};
    int half = p->band_rows / 14;
    for (int i = 0; i < p->band_rows; i++)
        p->rows[i] = (uint32_t)(i * 40 / p->band_rows); /* dark blue, lighter below */
    for (int i = 0; i < BARS; i++) {
        float turn = (float)p->phase / 150.0f + (float)i * 0.11f;
        rod(p, p->band_rows / 2 + (int)(sinf(TAU * turn) * (float)(p->band_rows / 2 - half)), half,
            metals[i]);
    }
}

/* ---- in time with the beam --------------------------------------------------------------------- */

/* The line before the band's `row` has begun: its colour is next. */
static void at_row(void *ctx)
{
    struct palette *p = ctx;
    video_set_colour(BAND, p->rows[p->row]);
    p->row += p->step;
    if (p->row >= p->band_rows) /* the other field has the others */
        p->row = p->step == 2 ? 1 - p->row % 2 : 0;
    video_compare((uint32_t)(p->band_top + p->row - p->step));
}

static void at_retrace(void *ctx)
{
    struct palette *p = ctx;
    if (p->still)
        return;
    p->phase++;
    const uint32_t *colours = p->colours + p->phase % CYCLE;
    for (unsigned i = 0; i < CYCLE; i++)
        video_set_colour(i, colours[i]);
}

/* ---- the whole --------------------------------------------------------------------------------- */

/* Of writing. */
static int scale_of(const struct palette *p)
{
    return p->canvas.width >= 1000 ? 2 : 1;
}

static void label(const struct palette *p, int y, int scale, const char *text)
{
    const struct canvas *c = &p->canvas;
    for (int dy = -1; dy <= 1; dy++) /* a black edge keeps it readable on every ground */
        for (int dx = -1; dx <= 1; dx++)
            canvas_text_middle(c, c->width / 2 + dx * scale, y + dy * scale, scale, scale, BLACK,
                               text);
    canvas_text_middle(c, c->width / 2, y, scale, scale, WHITE, text);
}

static void draw(struct palette *p)
{
    const struct canvas *c = &p->canvas;
    int scale = scale_of(p);
    surface(p);
    canvas_fill(c, 0, p->band_top, c->width, p->band_rows, BAND);
    canvas_fill(c, 0, p->band_top - 2, c->width, 2, BLACK);
    label(p, p->band_top - 24 * scale, scale, "240 indices, written once; colours turn at retrace");
    int below = p->band_top + p->band_rows;
    canvas_fill(c, 0, below, c->width, c->height - below, BLACK);
    label(p, below + 4 * scale, scale, "one index; line compare sets its colour row by row");
}

int main(void)
{
    static struct palette p = {.rows = rows};
    if (!video_present()) {
        console_write("palette: this board has no raster head.\n");
        return 1;
    }
    p.canvas = video_open(8);
    p.step = video_timing().sync & VIDEO_SYNC_INTERLACED ? 2 : 1;
    p.band_top = p.canvas.height * 7 / 10;
    p.band_rows = p.canvas.height - p.band_top - (FONT_HEIGHT + 8) * scale_of(&p);
    waves();
    hues(&p);
    at_retrace(&p);
    band(&p);
    video_set_colour(BLACK, 0x000000);
    video_set_colour(WHITE, 0xFFFFFF);
    draw(&p);
    video_on_retrace(at_retrace, &p);
    video_on_row(at_row, &p);
    video_compare((uint32_t)(p.band_top - p.step));
    video_on();
    board_mark(1);
    for (;;) {
        video_wait_retrace();
        band(&p); /* for the field that begins: the band is far below */
        int c = console_poll();
        if (c == ' ')
            p.still = !p.still;
        if (c == 'q')
            return 0;
    }
}
