#include "roms/scenery/eye.h"

#include <math.h>
#include <stddef.h>

#include "roms/geometry/scalar.h"

/* ---- Mach bands ------------------------------------------------------------------------------ */

void eye_profile_make(struct eye_profile *p, int facets, bool interpolated)
{
    p->facets = facets;
    p->interpolated = interpolated;
    mach_profile(facets, interpolated, p->intensity, MACH_SAMPLES);
    mach_seen(p->intensity, p->seen, MACH_SAMPLES);
    p->over = p->under = 0;
    for (int i = 0; i < MACH_SAMPLES; i++) {
        float more = p->seen[i] - p->intensity[i];
        p->over = scalar_max(p->over, more);
        p->under = scalar_max(p->under, -more);
    }
}

struct eye_facet eye_facet(const struct eye_profile *p, int facet)
{
    float width = 1 / (float)p->facets, inside = 0.001f * width;
    float left = (float)facet * width;
    struct eye_facet f = {mach_intensity(p->facets, p->interpolated, left + inside),
                          mach_intensity(p->facets, p->interpolated, left + width / 2),
                          mach_intensity(p->facets, p->interpolated, left + width - inside), 2, -2};
    int first = facet * MACH_SAMPLES / p->facets, last = (facet + 1) * MACH_SAMPLES / p->facets;
    for (int i = first; i < last; i++) {
        f.least = scalar_min(f.least, p->seen[i]);
        f.most = scalar_max(f.most, p->seen[i]);
    }
    return f;
}

enum { LEFT = 60, RIGHT = 1140, BAND_LOW = 430, BAND_HIGH = 780, LOW = 40, HIGH = 340 };

static void draw_bands(const struct stage *s, const struct eye_profile *p)
{
    int x0 = (int)stage_canvas_x(s, LEFT), x1 = (int)stage_canvas_x(s, RIGHT);
    int top = (int)stage_canvas_y(s, BAND_HIGH), bottom = (int)stage_canvas_y(s, BAND_LOW);
    for (int x = x0; x < x1; x++) {
        float place = ((float)(x - x0) + 0.5f) / (float)(x1 - x0);
        float light = mach_intensity(p->facets, p->interpolated, place);
        canvas_fill(&s->canvas, x, top, 1, bottom - top, ink_shade(RAMP_GREY, light));
    }
}

/* As few lines as show it: a line goes on as long as it keeps its first direction. */
static void draw_curve(struct stage *s, const float *value, enum ink ink)
{
    const float across = (float)(RIGHT - LEFT) / (MACH_SAMPLES - 1), up = HIGH - LOW;
    int from = 0;
    stage_ink(s, ink);
    for (int i = 1; i < MACH_SAMPLES; i++) {
        float slope = value[from + 1] - value[from];
        float ahead = value[from] + slope * (float)(i + 1 - from);
        if (i + 1 < MACH_SAMPLES && fabsf(ahead - value[i + 1]) * up < 1.2f)
            continue;
        stage_line(s, LEFT + across * (float)from, LOW + up * value[from], LEFT + across * (float)i,
                   LOW + up * value[i]);
        from = i;
    }
}

void eye_mach_draw(struct stage *s, const struct eye_profile *p)
{
    draw_bands(s, p);
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, INK_TEXT);
    stage_rectangle(s, LEFT, BAND_LOW, RIGHT - LEFT, BAND_HIGH - BAND_LOW);
    for (int i = 1; i < p->facets; i++) {
        float x = LEFT + (float)(RIGHT - LEFT) * (float)i / (float)p->facets;
        stage_line(s, x, BAND_LOW, x, BAND_HIGH);
    }
    stage_heads(s, STAGE_BOTH);
    stage_ink(s, INK_GRID);
    stage_line(s, LEFT, LOW, RIGHT, LOW);
    stage_line(s, LEFT, LOW, LEFT, HIGH + 40);
    draw_curve(s, p->seen, INK_RED);
    draw_curve(s, p->intensity, INK_YELLOW);
    stage_ink(s, INK_TEXT);
    stage_text(s, LEFT + 12, HIGH + 30, "intensity");
}

/* ---- few levels ------------------------------------------------------------------------------ */

/* A Lambertian ball of radius 1, lit from the upper left; its ground is dark. */
static float ball(float x, float y)
{
    float rr = x * x + y * y;
    if (rr >= 1)
        return 0.04f + 0.08f * (y + 1);
    float z = sqrtf(1 - rr), light = (y - x + 1.4f * z) * 0.503f;
    return 0.05f + 0.9f * scalar_max(light, 0);
}

enum { WIDEST = 2 * STAGE_WIDTH }; /* pixels, of a ball */

static void draw_ball(const struct stage *s, int left, int top, int width, int levels,
                      enum dither_method method)
{
    struct dither d;
    float error[WIDEST + 2];
    const struct canvas *c = &s->canvas;
    dither_begin(&d, method, levels, error, width);
    for (int y = 0; y < width && top + y < c->height; y++) {
        for (int x = 0; x < width; x++) {
            float per = 2 / (float)width;
            float light = ball(((float)x + 0.5f) * per - 1, 1 - ((float)y + 0.5f) * per);
            int level = dither_next(&d, x, y, light);
            canvas_dot(c, left + x, top + y,
                       ink_shade(RAMP_GREY, (float)level / (float)(levels - 1)));
        }
    }
}

/* On the vector head: a dot for a pixel, as bright as its level. */
static void dot_ball(struct stage *s, float x, float y, float radius, int levels,
                     enum dither_method method)
{
    enum { DOTS = 26 };
    static const enum ink inks[] = {INK_BLACK, INK_GRID,  INK_BROWN,
                                    INK_TEXT,  INK_GREEN, INK_BRIGHT};
    struct dither d;
    float error[DOTS + 2];
    dither_begin(&d, method, levels, error, DOTS);
    for (int row = 0; row < DOTS; row++) {
        for (int k = 0; k < DOTS; k++) {
            float u = 2 * ((float)k + 0.5f) / DOTS - 1, v = 1 - 2 * ((float)row + 0.5f) / DOTS;
            int level = dither_next(&d, k, row, ball(u, v));
            if (level == 0)
                continue;
            stage_ink(s, inks[level * 5 / (levels - 1) > 0 ? level * 5 / (levels - 1) : 1]);
            stage_dot(s, x + u * radius, y + v * radius);
        }
    }
}

void eye_halftone_draw(struct stage *s, float x, float y, float radius, int levels,
                       enum dither_method method)
{
    unsigned heads = s->heads;
    int width = (int)(2 * radius * s->dots);
    if (heads & STAGE_RASTER && width > 0 && width <= WIDEST)
        draw_ball(s, (int)stage_canvas_x(s, x - radius), (int)stage_canvas_y(s, y + radius), width,
                  levels, method);
    stage_heads(s, heads & STAGE_VECTOR);
    if (heads & STAGE_VECTOR)
        dot_ball(s, x, y, radius, levels, method);
    stage_heads(s, heads);
}

struct eye_means eye_halftone_means(int levels, enum dither_method method)
{
    struct dither d;
    float error[EYE_BALL + 2];
    struct eye_means m = {0};
    dither_begin(&d, method, levels, error, EYE_BALL);
    for (int y = 0; y < EYE_BALL; y++) {
        for (int x = 0; x < EYE_BALL; x++) {
            float per = 2.0f / EYE_BALL;
            float light = ball(((float)x + 0.5f) * per - 1, 1 - ((float)y + 0.5f) * per);
            int band = y * EYE_BANDS / EYE_BALL;
            m.wanted[band] += light;
            m.shown[band] += (float)dither_next(&d, x, y, light) / (float)(levels - 1);
        }
    }
    for (int i = 0; i < EYE_BANDS; i++) {
        m.wanted[i] /= EYE_BALL * EYE_BALL / EYE_BANDS;
        m.shown[i] /= EYE_BALL * EYE_BALL / EYE_BANDS;
        m.all_wanted += m.wanted[i] / EYE_BANDS;
        m.all_shown += m.shown[i] / EYE_BANDS;
    }
    return m;
}
