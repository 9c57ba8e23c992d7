/* primitives.c — lines, areas, markers and text by the drivers of both heads. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/clip/liang_barsky.h"
#include "roms/raster/font.h"
#include "roms/raster/polygon_fill.h"
#include "roms/stage/stage.h"

enum {
    MARKER = 7,        /* half of a marker's arm, stage units */
    CHARACTER = 14,    /* advance of a character on the vector head, head units */
    AREA_CORNERS = 64, /* at most */
};

static int nearest(float v)
{
    return (int)floorf(v + 0.5f);
}

static int dot_of(const struct stage *s, float x)
{
    return nearest(stage_canvas_x(s, x));
}

static int row_of(const struct stage *s, float y)
{
    return nearest(stage_canvas_y(s, y));
}

static int head_x(const struct stage *s, float x)
{
    return nearest(stage_head_x(s, x));
}

static int head_y(const struct stage *s, float y)
{
    return nearest(stage_head_y(s, y));
}

static void vector_line(struct stage *s, float x0, float y0, float x1, float y1)
{
    struct display *d = &s->display;
    int ax = head_x(s, x0), ay = head_y(s, y0);
    if (d->x != ax || d->y != ay || d->mode < 0)
        display_at(d, ax, ay);
    display_line(d, head_x(s, x1), head_y(s, y1));
}

void stage_line(struct stage *s, float x0, float y0, float x1, float y1)
{
    static const struct clip_window picture = {0, 0, STAGE_WIDTH, STAGE_HEIGHT};
    struct point2 a = {x0, y0}, b = {x1, y1};
    if (!clip_liang_barsky(&picture, &a, &b))
        return;
    if (s->heads & STAGE_RASTER)
        canvas_line(&s->canvas, dot_of(s, a.x), row_of(s, a.y), dot_of(s, b.x), row_of(s, b.y),
                    s->ink);
    if (s->heads & STAGE_VECTOR)
        vector_line(s, a.x, a.y, b.x, b.y);
}

void stage_polyline(struct stage *s, const struct point2 *p, int count)
{
    for (int i = 1; i < count; i++)
        stage_line(s, p[i - 1].x, p[i - 1].y, p[i].x, p[i].y);
}

void stage_polygon(struct stage *s, const struct point2 *p, int count)
{
    stage_polyline(s, p, count);
    if (count > 2)
        stage_line(s, p[count - 1].x, p[count - 1].y, p[0].x, p[0].y);
}

void stage_area(struct stage *s, const struct point2 *p, int count)
{
    unsigned heads = s->heads;
    if (heads & STAGE_RASTER) {
        struct point2 q[AREA_CORNERS];
        count = count < AREA_CORNERS ? count : AREA_CORNERS;
        for (int i = 0; i < count; i++)
            q[i] = (struct point2){stage_canvas_x(s, p[i].x), stage_canvas_y(s, p[i].y)};
        canvas_polygon(&s->canvas, q, count, POLYGON_EVEN_ODD, s->ink);
    }
    stage_heads(s, heads & STAGE_VECTOR);
    stage_polygon(s, p, count);
    stage_heads(s, heads);
}

void stage_rectangle(struct stage *s, float x, float y, float width, float height)
{
    struct point2 corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    stage_polygon(s, corners, 4);
}

void stage_marker(struct stage *s, float x, float y)
{
    stage_line(s, x - MARKER, y, x + MARKER, y);
    stage_line(s, x, y - MARKER, x, y + MARKER);
}

void stage_dot(struct stage *s, float x, float y)
{
    if (x < 0 || y < 0 || x > STAGE_WIDTH || y > STAGE_HEIGHT)
        return;
    if (s->heads & STAGE_RASTER)
        canvas_dot(&s->canvas, dot_of(s, x), row_of(s, y), s->ink);
    if (s->heads & STAGE_VECTOR)
        display_dot(&s->display, head_x(s, x), head_y(s, y));
}

/* ---- text -------------------------------------------------------------------------------------- */

/* Pixels a dot of the font. */
static int font_scale(const struct stage *s)
{
    return s->canvas.height >= 900 ? 2 : 1;
}

void stage_text(struct stage *s, float x, float y, const char *text)
{
    int scale = font_scale(s);
    if (s->heads & STAGE_RASTER)
        canvas_text(&s->canvas, dot_of(s, x), row_of(s, y) - (FONT_HEIGHT - 2) * scale, scale,
                    scale, s->ink, text);
    if (s->heads & STAGE_VECTOR)
        display_text(&s->display, head_x(s, x), head_y(s, y), text);
}

void stage_text_middle(struct stage *s, float x, float y, const char *text)
{
    unsigned heads = s->heads;
    float characters = (float)strlen(text);
    float raster = characters * FONT_WIDTH * (float)font_scale(s) / 2 / s->dots;
    float vector = characters * CHARACTER / 2 / s->units;
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

void stage_title(struct stage *s, const char *text)
{
    int scale = font_scale(s);
    canvas_text_middle(&s->canvas, s->canvas.width / 2, 6 * scale, scale, scale, INK_BRIGHT, text);
    display_intensity(&s->display, ink_intensity(INK_BRIGHT));
    display_text(&s->display, (1024 - (int)strlen(text) * CHARACTER) / 2, 960, text);
    stage_ink(s, s->ink);
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
    for (int line = 0; line < STAGE_CAPTION_LINES && *text != '\0'; line++) {
        char part[128];
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
    display_text(&s->display, (1024 - (int)strlen(text) * CHARACTER) / 2, 90 - 40 * line, text);
}

void stage_caption(struct stage *s, const char *text)
{
    enum { MARGIN = 2 };
    caption_lines(s, text, s->canvas.width / (FONT_WIDTH * font_scale(s)) - MARGIN, raster_caption);
    display_intensity(&s->display, ink_intensity(INK_TEXT));
    caption_lines(s, text, 1024 / CHARACTER - MARGIN, vector_caption);
    stage_ink(s, s->ink);
}
