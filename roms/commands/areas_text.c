/* areas_text.c — `text` and `dither`. */
#include <stdio.h>
#include <string.h>

#include "roms/commands/areas.h"
#include "roms/monitor/stepper.h"
#include "roms/raster/dither.h"
#include "roms/raster/font.h"
#include "roms/raster/pixel.h"
#include "roms/raster/text_turned.h"

/* ---- text ------------------------------------------------------------------------------------ */

enum { LONGEST = 90 /* pixels, of the text */, MOST_HIGH = 48 };

struct writing {
    uint32_t pixels[(LONGEST + 3) / 4 * LONGEST];
    struct canvas canvas;
    int y; /* the row that comes next, of the canvas */
};

static bool next_row(void *state, struct step *s)
{
    struct writing *t = (struct writing *)state;
    const struct canvas *c = &t->canvas;
    if (t->y == c->height)
        return false;
    for (int x = 0; x < c->width; x++) {
        bool lit = canvas_pixel(c, x, t->y) != 0;
        s->row[x] = lit ? '#' : '.';
        if (!lit)
            continue;
        int y = c->height - 1 - t->y;
        bool on = s->lit_count > 0 && s->lit[s->lit_count - 1].x1 == x - 1;
        if (on)
            s->lit[s->lit_count - 1].x1 = x;
        else if (s->lit_count < STEP_RUNS)
            s->lit[s->lit_count++] = (struct step_run){y, x, x, INK_CYAN};
    }
    snprintf(s->decision, sizeof s->decision, "Row %d", c->height - 1 - t->y);
    t->y++;
    return true;
}

bool areas_text(struct monitor *m, struct words *w)
{
    static const char *const directions[] = {"right", "up", "left", "down", NULL};
    struct writing t = {.y = 0};
    struct text_cell cell;
    char text[LONGEST];
    int direction;
    if (!words_whole(w, FONT_WIDTH / 2, MOST_HIGH, &cell.width) ||
        !words_whole(w, FONT_HEIGHT / 2, MOST_HIGH, &cell.height) ||
        !words_choice(w, directions, &direction) || !words_rest(w, text, sizeof text))
        return false;
    int length = (int)strlen(text) * cell.width, high = cell.height;
    if (length > LONGEST)
        return words_refuse(w, "the words take %d pixels; there is room for %d", length, LONGEST);
    cell.direction = (enum text_direction)direction;
    bool upright = cell.direction == TEXT_RIGHT || cell.direction == TEXT_LEFT;
    t.canvas = (struct canvas){.pixels = (uint8_t *)t.pixels,
                               .width = upright ? length : high,
                               .height = upright ? high : length,
                               .bits = 8,
                               .dots_a_row = 1};
    t.canvas.pitch = canvas_pitch(t.canvas.width, 8);
    int x = cell.direction == TEXT_LEFT || cell.direction == TEXT_DOWN ? t.canvas.width : 0;
    int y = cell.direction == TEXT_LEFT || cell.direction == TEXT_UP ? t.canvas.height : 0;
    canvas_text_turned(&t.canvas, x, y, &cell, 1, text);
    const struct stepper stepper = {.title = "Text, a dot of the font at a time",
                                    .header = text,
                                    .x1 = t.canvas.width - 1,
                                    .y1 = t.canvas.height - 1,
                                    .next = next_row,
                                    .state = &t};
    scan_run(m, &stepper);
    printf("%d by %d pixels\n", t.canvas.width, t.canvas.height);
    return true;
}

/* ---- dither ---------------------------------------------------------------------------------- */

enum { PATCH = 64, TENTHS = 11 };

/* The mean of a patch of one intensity. */
static float mean(enum dither_method method, int levels, float v)
{
    float error[PATCH + 2];
    struct dither d;
    int sum = 0;
    dither_begin(&d, method, levels, error, PATCH);
    for (int y = 0; y < PATCH; y++)
        for (int x = 0; x < PATCH; x++)
            sum += dither_next(&d, x, y, v);
    return (float)sum / (PATCH * PATCH) / (float)(levels - 1);
}

static void print_means(int levels)
{
    printf("intensity");
    for (int k = 0; k < DITHER_METHODS; k++)
        printf(" %9s", dither_names[k]);
    printf("\n");
    for (int i = 0; i < TENTHS; i++) {
        float v = (float)i / (TENTHS - 1);
        printf("%9.4f", (double)v);
        for (int k = 0; k < DITHER_METHODS; k++)
            printf(" %9.4f", (double)mean((enum dither_method)k, levels, v));
        printf("\n");
    }
}

/* A ramp on the raster head, pixel by pixel, below this place of the picture. */
static void raster_ramp(struct stage *s, enum dither_method method, int levels, float top,
                        float high)
{
    enum { WIDEST = 1280 };
    float error[WIDEST + 2];
    struct dither d;
    int left = (int)stage_canvas_x(s, 0), width = (int)stage_canvas_x(s, STAGE_WIDTH) - left;
    int y0 = (int)stage_canvas_y(s, top), y1 = (int)stage_canvas_y(s, top - high);
    if (width < 2 || width > WIDEST || s->canvas.width == 0)
        return;
    dither_begin(&d, method, levels, error, width);
    for (int y = y0; y < y1; y++)
        for (int x = 0; x < width; x++) {
            int level = dither_next(&d, x, y - y0, (float)x / (float)(width - 1));
            canvas_dot(&s->canvas, left + x, y,
                       ink_shade(RAMP_GREY, (float)level / (float)(levels - 1)));
        }
}

/* The same in dots, which the vector head can make bright or not. */
static void vector_ramp(struct stage *s, enum dither_method method, int levels, float top,
                        float high)
{
    enum { ACROSS = 56, UP = 6 };
    float error[ACROSS + 2];
    struct dither d;
    dither_begin(&d, method, levels, error, ACROSS);
    stage_heads(s, STAGE_VECTOR);
    for (int y = 0; y < UP; y++)
        for (int x = 0; x < ACROSS; x++) {
            int level = dither_next(&d, x, y, (float)x / (ACROSS - 1));
            if (level == 0)
                continue;
            stage_ink(s, (enum ink)ink_shade(RAMP_GREY, (float)level / (float)(levels - 1)));
            stage_dot(s, ((float)x + 0.5f) * STAGE_WIDTH / ACROSS,
                      top - ((float)y + 0.5f) * high / UP);
        }
    stage_heads(s, STAGE_BOTH);
}

bool areas_dither(struct monitor *m, struct words *w)
{
    enum { HIGH = 130, APART = 200, TOP = 730 };
    struct stage *s = &m->stage;
    char title[48];
    int levels;
    if (!words_whole(w, 2, INK_LEVELS, &levels) || !words_end(w))
        return false;
    snprintf(title, sizeof title, "Dithering: a ramp from %d levels", levels);
    stage_begin(s);
    for (int k = 0; k < DITHER_METHODS; k++) {
        float top = TOP - (float)k * APART;
        stage_ink(s, INK_TEXT);
        stage_text(s, 0, top + 14, dither_names[k]);
        raster_ramp(s, (enum dither_method)k, levels, top, HIGH);
        vector_ramp(s, (enum dither_method)k, levels, top, HIGH);
    }
    stage_title(s, title);
    stage_caption(s,
                  "From black to white with few levels: nothing, Bayer's matrices, and the error "
                  "given on to the pixels that come next.");
    stage_end(s);
    print_means(levels);
    return true;
}
