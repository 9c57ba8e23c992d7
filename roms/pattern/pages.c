/* The patterns for one thing each. */
#include <stdio.h>

#include "roms/pattern/pattern.h"
#include "roms/raster/font.h"

/* ---- colour bars ------------------------------------------------------------------------------- */

static void bar_row(const struct pattern *p, int y0, int y1, const uint32_t *colours, int count,
                    int x0, int x1)
{
    for (int i = 0; i < count; i++) {
        int from = x0 + (x1 - x0) * i / count, to = x0 + (x1 - x0) * (i + 1) / count;
        canvas_fill(&p->canvas, from, y0, to - from, y1 - y0, colours[i]);
    }
}

/* SMPTE's: bars of 75 %; the same blue backwards; below −I, white, +Q and steps near black, which a
 * computer has above black only: 4, 8 and 12 %. */
void pattern_bars(const struct pattern *p)
{
    static const uint32_t top[] = {0xBFBFBF, 0xBFBF00, 0x00BFBF, 0x00BF00,
                                   0xBF00BF, 0xBF0000, 0x0000BF};
    static const uint32_t back[] = {0x0000BF, 0x000000, 0xBF00BF, 0x000000,
                                    0x00BFBF, 0x000000, 0xBFBFBF};
    static const uint32_t quadrature[] = {0x00214C, 0xFFFFFF, 0x32006A, 0x000000};
    static const uint32_t pluge[] = {0x0A0A0A, 0x141414, 0x1E1E1E};
    const struct canvas *c = &p->canvas;
    int w = c->width, castle = c->height * 2 / 3, low = c->height * 3 / 4;
    bar_row(p, 0, castle, top, 7, 0, w);
    bar_row(p, castle, low, back, 7, 0, w);
    bar_row(p, low, c->height, quadrature, 4, 0, w * 5 / 7);
    canvas_fill(c, w * 5 / 7, low, w, c->height - low, PATTERN_BLACK);
    bar_row(p, low, c->height, pluge, 3, w * 5 / 7, w * 6 / 7);
}

/* ---- geometry and convergence ------------------------------------------------------------------ */

static void ring(const struct pattern *p, float x, float y, float radius)
{
    int ry = (int)(radius * (float)p->cell_y + 0.5f);
    canvas_ellipse(&p->canvas, pattern_x(p, x), pattern_y(p, y), canvas_round_dots(&p->canvas, ry),
                   ry, PATTERN_WHITE);
}

void pattern_hatch(const struct pattern *p)
{
    const struct canvas *c = &p->canvas;
    canvas_clear(c, PATTERN_BLACK);
    for (int i = -PATTERN_ACROSS / 2; i <= PATTERN_ACROSS / 2; i++)
        canvas_fill(c, p->x + i * p->cell_x, 0, 1, c->height, PATTERN_WHITE);
    for (int i = -PATTERN_DOWN / 2; i <= PATTERN_DOWN / 2; i++)
        canvas_fill(c, 0, p->y + i * p->cell_y, c->width, 1, PATTERN_WHITE);
    for (int y = -PATTERN_DOWN / 2; y < PATTERN_DOWN / 2; y++) /* a dot in each cell */
        for (int x = -PATTERN_ACROSS / 2; x < PATTERN_ACROSS / 2; x++)
            canvas_fill(c, pattern_x(p, (float)x + 0.5f), pattern_y(p, (float)y + 0.5f), 2, 2,
                        PATTERN_WHITE);
    ring(p, 0, 0, 5);
    ring(p, 0, 0, 2);
    for (int i = 0; i < 4; i++)
        ring(p, i % 2 == 0 ? -6 : 6, i / 2 == 0 ? -4 : 4, 2);
    canvas_frame(c, 0, 0, c->width, c->height, 1, PATTERN_WHITE);
}

/* ---- gamma ------------------------------------------------------------------------------------- */

/* Rows black and white by turns give half of white's light; the patch within gives as much where the
 * tube's exponent is the one written below. From afar that patch cannot be seen. */
static void matched(const struct pattern *p, float x, float y, int tenths)
{
    char text[8];
    pattern_grating(p, (struct pattern_box){x - 1.6f, y - 1.2f, x + 1.6f, y + 1.2f}, 2, true);
    pattern_fill(p, (struct pattern_box){x - 0.8f, y - 0.6f, x + 0.8f, y + 0.6f},
                 pattern_light(0.5f, (float)tenths / 10.0f));
    snprintf(text, sizeof text, "%d.%d", tenths / 10, tenths % 10);
    pattern_label(p, x, y + 1.55f, 1, PATTERN_WHITE, text);
}

void pattern_gamma(const struct pattern *p)
{
    enum { STEPS = 16 };
    canvas_clear(&p->canvas, PATTERN_BLACK);
    pattern_label(p, 0, -5.5f, 1, PATTERN_WHITE,
                  "gamma: the patch that vanishes in its lines, seen from afar");
    for (int i = 0; i < 8; i++)
        matched(p, (float)(i % 4) * 4.0f - 6.0f, i < 4 ? -3.6f : -0.2f, 20 + i);
    for (int i = 0; i < STEPS; i++)
        pattern_fill(p, (struct pattern_box){(float)i - 8.0f, 2.1f, (float)i - 7.0f, 4.6f},
                     pattern_grey((unsigned)i * 255 / (STEPS - 1)));
    pattern_label(p, 0, 5.2f, 1, PATTERN_WHITE, "sixteen equal steps of the signal");
}

/* ---- resolution -------------------------------------------------------------------------------- */

static void patches(const struct pattern *p, float y, bool level)
{
    static const int pairs[] = {2, 4, 6, 8, 12};
    char text[16];
    for (int i = 0; i < 5; i++) {
        float x = (float)i * 1.2f - 2.4f;
        pattern_grating(p, (struct pattern_box){x - 0.55f, y - 0.55f, x + 0.55f, y + 0.55f},
                        pairs[i], level);
        snprintf(text, sizeof text, "%d", pairs[i] / 2);
        pattern_label(p, x, y + (level ? 0.85f : -0.85f), 1, PATTERN_WHITE, text);
    }
}

void pattern_resolution(const struct pattern *p)
{
    const struct canvas *c = &p->canvas;
    struct pattern_wedge wedge = {
        .pairs = 9, .wide = p->text > 1 ? 12 : 8, .narrow = 2, .marks = true};
    float half = 0.5f * (float)wedge.pairs * wedge.wide;
    float x = half / (float)p->cell_x + 0.05f, y = half / (float)p->cell_y + 0.05f;
    canvas_clear(c, PATTERN_BLACK);
    canvas_frame(c, 0, 0, c->width, c->height, 1, PATTERN_WHITE);
    for (int i = 0; i < 4; i++)
        pattern_star(p, i % 2 == 0 ? -5.6f : 5.6f, i / 2 == 0 ? -3.8f : 3.8f, 1.9f);
    for (int back = 0; back < 2; back++) {
        wedge.back = back != 0;
        wedge.level = false;
        float from = back ? 2.0f : -5.2f;
        pattern_wedge(p, (struct pattern_box){-x, from, x, from + 3.2f}, wedge);
        wedge.level = true;
        from = back ? 3.7f : -7.4f;
        pattern_wedge(p, (struct pattern_box){from, -y, from + 3.7f, y}, wedge);
    }
    pattern_label(p, 0, -5.55f, 1, PATTERN_WHITE, "dots or rows a line");
    patches(p, -0.8f, false);
    patches(p, 0.8f, true);
}

/* ---- focus ------------------------------------------------------------------------------------- */

void pattern_focus(const struct pattern *p)
{
    static const char words[] = "Home me He#e eHm @ ";
    const struct canvas *c = &p->canvas;
    int columns = c->width / FONT_WIDTH, rows = c->height / (FONT_HEIGHT + 2);
    int left = (c->width - columns * FONT_WIDTH) / 2,
        top = (c->height - rows * (FONT_HEIGHT + 2)) / 2;
    canvas_clear(c, PATTERN_BLACK);
    for (int row = 0; row < rows; row++) {
        char text[2] = "";
        for (int i = 0; i < columns; i++) {
            text[0] = words[(unsigned)(i + row * 7) % (sizeof words - 1)];
            canvas_text(c, left + i * FONT_WIDTH, top + row * (FONT_HEIGHT + 2), 1, 1,
                        PATTERN_WHITE, text);
        }
    }
}

void pattern_field(const struct pattern *p, uint32_t colour)
{
    canvas_clear(&p->canvas, colour);
}
