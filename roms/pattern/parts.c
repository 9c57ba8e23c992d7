/* Places, colours, text. */
#include <math.h>
#include <stdio.h>

#include "roms/pattern/pattern.h"
#include "roms/raster/font.h"

/* Of the monitors this is for; partly covered pixels give the light of their share by it. */
#define GAMMA 2.4f

uint32_t pattern_grey(unsigned level)
{
    return level * 0x010101u;
}

static unsigned level_of(float share, float gamma)
{
    return (unsigned)(255.0f * powf(share, 1.0f / gamma) + 0.5f);
}

uint32_t pattern_light(float share, float gamma)
{
    return pattern_grey(level_of(share, gamma));
}

void pattern_begin(struct pattern *p)
{
    *p = (struct pattern){.canvas = video_open(32), .timing = video_timing()};
    const struct canvas *c = &p->canvas;
    p->x = c->width / 2;
    p->y = c->height / 2;
    /* The border takes at least 6 % of each side; cells are as large as both sides allow. */
    float high = (float)c->height * 0.94f / PATTERN_DOWN;
    float wide = (float)c->width * 0.94f / PATTERN_ACROSS / c->dots_a_row;
    p->cell_y = (int)(high < wide ? high : wide);
    p->cell_x = canvas_round_dots(c, p->cell_y);
    p->text = p->cell_y >= 52 ? 2 : 1;
    for (int i = 0; i < PATTERN_LEVELS; i++)
        p->level[i] = (uint8_t)level_of((float)i / (PATTERN_LEVELS - 1), GAMMA);
}

int pattern_x(const struct pattern *p, float cells)
{
    return p->x + (int)lrintf(cells * (float)p->cell_x);
}

int pattern_y(const struct pattern *p, float cells)
{
    return p->y + (int)lrintf(cells * (float)p->cell_y);
}

void pattern_fill(const struct pattern *p, struct pattern_box box, uint32_t colour)
{
    int x = pattern_x(p, box.x0), y = pattern_y(p, box.y0);
    canvas_fill(&p->canvas, x, y, pattern_x(p, box.x1) - x, pattern_y(p, box.y1) - y, colour);
}

void pattern_label(const struct pattern *p, float x, float y, int enlarge, uint32_t colour,
                   const char *text)
{
    int scale = p->text * enlarge;
    canvas_text_middle(&p->canvas, pattern_x(p, x), pattern_y(p, y) - FONT_HEIGHT * scale / 2,
                       scale, scale, colour, text);
}

void pattern_mode_name(const struct pattern *p, char *text)
{
    const struct video_timing *t = &p->timing;
    snprintf(text, PATTERN_NAME, "%lux%lu@%lu%s", (unsigned long)t->h_visible,
             (unsigned long)t->v_visible, (unsigned long)(video_field_millihertz(t) + 500) / 1000,
             t->sync & VIDEO_SYNC_INTERLACED ? "i" : "");
}

void pattern_line_rate(const struct pattern *p, char *text)
{
    uint32_t hz = (video_line_millihertz(&p->timing) + 500) / 1000;
    snprintf(text, PATTERN_NAME, "%lu.%03lu kHz", (unsigned long)hz / 1000,
             (unsigned long)hz % 1000);
}

void pattern_field_rate(const struct pattern *p, char *text)
{
    uint32_t hundredths = (video_field_millihertz(&p->timing) + 5) / 10;
    snprintf(text, PATTERN_NAME, "%lu.%02lu Hz", (unsigned long)hundredths / 100,
             (unsigned long)hundredths % 100);
}

void pattern_screen_size(char *text)
{
    snprintf(text, PATTERN_NAME, "%lu x %lu mm", (unsigned long)(video_width_um() + 500) / 1000,
             (unsigned long)(video_height_um() + 500) / 1000);
}
