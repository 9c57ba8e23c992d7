/* gallery_plotting_surface.c — a function of two variables as a surface: shaded pixels from back to
 * front on the raster head, lines with a floating horizon on the vector head.
 *
 * Source: T. J. Wright, A Two-Space Solution to the Hidden Line Problem for Plotting Functions of
 *         Two Variables, IEEE Transactions on Computers C-22 (1973) 28, for the horizon. */
#include <math.h>

#include "roms/lessons/gallery_plotting.h"
#include "roms/raster/polygon_fill.h"

enum { ROWS = 28, COLUMNS = 38, HORIZON = STAGE_WIDTH / 2 + 1 };

struct surface {
    struct point2 at[ROWS][COLUMNS]; /* stage units; row 0 is in front */
    float height[ROWS][COLUMNS];
};

/* Waves from two places, moving. */
static float height(float x, float z, float t)
{
    float a = sqrtf((x - 2.6f) * (x - 2.6f) + z * z), b = sqrtf((x + 2.6f) * (x + 2.6f) + z * z);
    return cosf(2.2f * a - 2 * t) / (1 + 0.5f * a) + cosf(2.2f * b - 2 * t) / (1 + 0.5f * b);
}

/* The square turned, looked at from in front and above; lines of the grid lie across the view. */
static void compute(struct surface *s, float t)
{
    float c = cosf(t * 0.3f), sine = sinf(t * 0.3f);
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++) {
            float x = 6.0f * (2 * (float)i / (COLUMNS - 1) - 1);
            float z = 6.0f * (2 * (float)j / (ROWS - 1) - 1);
            float h = height(x * c - z * sine, x * sine + z * c, t);
            float near = 1 / (1 + 0.035f * (z + 6));
            s->height[j][i] = h;
            s->at[j][i] =
                (struct point2){600 + 96 * x * near, 130 + (z + 6) * 60 * near + 150 * h * near};
        }
}

/* ---- raster ---------------------------------------------------------------------------------- */

/* By how steep it rises to the left and toward the back. */
static uint32_t shade(const struct surface *s, int j, int i)
{
    float across = s->height[j][i + 1] - s->height[j][i];
    float back = s->height[j + 1][i] - s->height[j][i];
    const float dx = 12.0f / (COLUMNS - 1), dz = 12.0f / (ROWS - 1);
    float nx = -across / dx, nz = -back / dz, length = sqrtf(nx * nx + nz * nz + 1);
    float light = (-0.75f * nx + 0.5f - 0.4f * nz) / length;
    light = 0.04f + 0.8f * (light > 0 ? light : 0);
    return ink_shade(RAMP_COPPER, light);
}

static void draw_raster(struct stage *stage, const struct surface *s)
{
    static struct point2 q[ROWS][COLUMNS];
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++)
            q[j][i] = plot_canvas(stage, s->at[j][i]);
    for (int j = ROWS - 2; j >= 0; j--)
        for (int i = 0; i + 1 < COLUMNS; i++) {
            const struct point2 p[4] = {q[j][i], q[j][i + 1], q[j + 1][i + 1], q[j + 1][i]};
            canvas_polygon(&stage->canvas, p, 4, POLYGON_NON_ZERO, shade(s, j, i));
        }
}

/* ---- vector ---------------------------------------------------------------------------------- */

/* What lines in front hide: between low and high, by columns two units wide. */
struct horizon {
    float low[HORIZON], high[HORIZON];
};

static bool hidden(const struct horizon *h, int column, float y)
{
    return y >= h->low[column] && y <= h->high[column];
}

/* The parts of a line that the horizon does not hide. */
static void draw_visible(struct stage *stage, const struct horizon *h, struct point2 a,
                         struct point2 b)
{
    int first = (int)(a.x / 2), last = (int)(b.x / 2);
    float slope = (b.y - a.y) / (b.x - a.x);
    int begun = -1;
    for (int column = first; column <= last; column++) {
        float y = a.y + slope * ((float)column * 2 - a.x);
        bool seen = !hidden(h, column, y);
        if (seen && begun < 0)
            begun = column;
        if (begun >= 0 && (!seen || column == last)) {
            float x0 = begun == first ? a.x : (float)begun * 2;
            float x1 = column == last ? b.x : (float)column * 2;
            stage_line(stage, x0, a.y + slope * (x0 - a.x), x1, a.y + slope * (x1 - a.x));
            begun = -1;
        }
    }
}

static void raise_horizon(struct horizon *h, struct point2 a, struct point2 b)
{
    float slope = (b.y - a.y) / (b.x - a.x);
    for (int column = (int)(a.x / 2); column <= (int)(b.x / 2); column++) {
        float y = a.y + slope * ((float)column * 2 - a.x);
        h->low[column] = fminf(h->low[column], y);
        h->high[column] = fmaxf(h->high[column], y);
    }
}

static void draw_vector(struct stage *stage, const struct surface *s)
{
    static struct horizon h;
    for (int i = 0; i < HORIZON; i++) {
        h.low[i] = STAGE_HEIGHT;
        h.high[i] = 0;
    }
    stage_heads(stage, STAGE_VECTOR);
    stage_ink(stage, INK_CYAN);
    for (int j = 0; j < ROWS; j++) {
        for (int i = 0; i + 1 < COLUMNS; i++)
            draw_visible(stage, &h, s->at[j][i], s->at[j][i + 1]);
        for (int i = 0; i + 1 < COLUMNS; i++)
            raise_horizon(&h, s->at[j][i], s->at[j][i + 1]);
    }
    stage_heads(stage, STAGE_BOTH);
}

void plot_surface(struct stage *stage, float seconds)
{
    static struct surface s;
    compute(&s, seconds);
    draw_raster(stage, &s);
    draw_vector(stage, &s);
}
