/* text.c — text in the picture, above it and below it, on both heads. */
#include <stdio.h>
#include <string.h>

#include "roms/raster/font.h"
#include "roms/stage/device.h"

enum { LONGEST = 128, ASCENT = 14, DESCENT = 4 /* of a character, head units */ };

/* Pixels a dot of the font. */
static int font_scale(const struct stage *s)
{
    return s->page[0].height >= 900 ? 2 : 1;
}

/* ---- in the picture -------------------------------------------------------------------------- */

/* Of a line of text that begins at *x, what lies within low…high; moves *x to it. */
static void cut(const char *text, int *x, int advance, int low, int high, char part[LONGEST])
{
    int length = (int)strlen(text), first = 0;
    if (*x < low)
        first = (low - *x + advance - 1) / advance;
    first = first < length ? first : length;
    *x += first * advance;
    int room = high > *x ? (high - *x) / advance : 0;
    int count = length - first < room ? length - first : room;
    snprintf(part, LONGEST, "%.*s", count < LONGEST ? count : LONGEST - 1, text + first);
}

/* Moves a line of text into low…high unless it is outside altogether: false. */
static bool level(int *y, int height, int low, int high)
{
    if (*y < low - height || *y > high)
        return false;
    if (*y > high - height)
        *y = high - height;
    if (*y < low)
        *y = low;
    return true;
}

static void raster_text(struct stage *s, float x, float y, const char *text)
{
    char part[LONGEST];
    int scale = font_scale(s), left, top;
    struct canvas c = stage_picture(s, &left, &top);
    int at = device_dot(s, x), row = device_row(s, y) - (FONT_HEIGHT - 2) * scale;
    cut(text, &at, FONT_WIDTH * scale, left, left + c.width, part);
    if (level(&row, FONT_HEIGHT * scale, top, top + c.height))
        canvas_text(&s->canvas, at, row, scale, scale, s->ink, part);
}

static void vector_text(struct stage *s, float x, float y, const char *text)
{
    char part[LONGEST];
    int at = device_head_x(s, x), base = device_head_y(s, y);
    cut(text, &at, DEVICE_CHARACTER, 0, DEVICE_UNITS, part);
    if (level(&base, ASCENT, device_head_y(s, 0), device_head_y(s, STAGE_HEIGHT)) &&
        part[0] != '\0')
        display_text(&s->display, at, base, part);
}

void stage_text(struct stage *s, float x, float y, const char *text)
{
    if (!device_sane((struct point2){x, y}))
        return;
    if (s->heads & STAGE_RASTER)
        raster_text(s, x, y, text);
    if (s->heads & STAGE_VECTOR)
        vector_text(s, x, y, text);
}

void stage_text_middle(struct stage *s, float x, float y, const char *text)
{
    unsigned heads = s->heads;
    float characters = (float)strlen(text);
    float raster = characters * FONT_WIDTH * (float)font_scale(s) / 2 / s->dots;
    float vector = characters * DEVICE_CHARACTER / 2 / s->units;
    stage_heads(s, heads & STAGE_RASTER);
    stage_text(s, x - raster, y, text);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_text(s, x - vector, y, text);
    stage_heads(s, heads);
}

void stage_number(struct stage *s, float x, float y, float value, int decimals)
{
    char text[32];
    snprintf(text, sizeof text, "%.*f", decimals, (double)value);
    stage_text(s, x, y, text);
}

/* ---- above and below ------------------------------------------------------------------------- */

/* Around the picture: in an ink of its own, on both heads. */
static void around(struct stage *s, enum ink ink)
{
    display_intensity(&s->display, ink_intensity(ink));
    s->intensity = (int)ink_intensity(ink);
}

/* Twice as large where it has room. */
void stage_title(struct stage *s, const char *text)
{
    enum ink ink = s->ink;
    int scale = font_scale(s), length = (int)strlen(text), twice = 2 * scale;
    if (length * FONT_WIDTH * twice > s->canvas.width)
        twice = scale;
    canvas_text_middle(&s->canvas, s->canvas.width / 2, twice > scale ? 0 : 6 * scale, twice, twice,
                       INK_BRIGHT, text);
    around(s, INK_BRIGHT);
    display_text(&s->display, (DEVICE_UNITS - length * DEVICE_CHARACTER) / 2, 960, text);
    stage_ink(s, ink);
}

/* The length of the first line of a text when a line takes so many characters. */
static int line_length(const char *text, int room)
{
    int length = (int)strlen(text);
    if (length <= room)
        return length;
    for (int i = room; i > 0; i--)
        if (text[i] == ' ')
            return i;
    return room;
}

/* Calls write(…) with each line of the text. */
static void caption_lines(struct stage *s, const char *text, int room,
                          void (*write)(struct stage *s, int line, const char *text))
{
    room = room < LONGEST ? room : LONGEST - 1;
    for (int line = 0; line < STAGE_CAPTION_LINES && *text != '\0' && room > 0; line++) {
        char part[LONGEST];
        int length = line_length(text, room);
        snprintf(part, sizeof part, "%.*s", length, text);
        write(s, line, part);
        text += length;
        while (*text == ' ')
            text++;
    }
}

static void raster_caption(struct stage *s, int line, const char *text)
{
    int scale = font_scale(s),
        from_bottom = (STAGE_CAPTION_LINES - line) * (FONT_HEIGHT + 1) + FONT_HEIGHT + 4;
    canvas_text_middle(&s->canvas, s->canvas.width / 2, s->canvas.height - scale * from_bottom,
                       scale, scale, INK_TEXT, text);
}

static void vector_caption(struct stage *s, int line, const char *text)
{
    display_text(&s->display, (DEVICE_UNITS - (int)strlen(text) * DEVICE_CHARACTER) / 2,
                 90 - 40 * line, text);
}

void stage_caption(struct stage *s, const char *text)
{
    enum { MARGIN = 2 };
    enum ink ink = s->ink;
    caption_lines(s, text, s->canvas.width / (FONT_WIDTH * font_scale(s)) - MARGIN, raster_caption);
    around(s, INK_TEXT);
    caption_lines(s, text, DEVICE_UNITS / DEVICE_CHARACTER - MARGIN, vector_caption);
    stage_ink(s, ink);
}
