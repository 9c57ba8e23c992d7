/* gallery_art_areas.c — whirls: triangles in triangles, each turned a little; a kaleidoscope:
 * shards between two mirrors, seen twelve times. */
#include <math.h>
#include <stdbool.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/gallery_art.h"

static const struct point2 middle = {STAGE_WIDTH / 2, STAGE_HEIGHT / 2};

static struct point2 polar(float r, float angle)
{
    return (struct point2){middle.x + r * cosf(angle), middle.y + r * sinf(angle)};
}

static struct point2 between(struct point2 a, struct point2 b, float t)
{
    return (struct point2){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/* ---- whirls ---------------------------------------------------------------------------------- */

/* Triangles whose corners go along the edges of the one before. */
static void whirl(struct stage *s, const struct point2 *corners, float step, bool left,
                  enum ink_ramp ramp)
{
    enum { TRIANGLES = 22 };
    struct point2 p[3] = {corners[0], corners[1], corners[2]};
    for (int k = 0; k < TRIANGLES; k++) {
        float light = (k % 2 ? 0.06f : 0.7f) + 0.2f * (float)k / TRIANGLES;
        art_area(s, p, 3, ink_shade(ramp, light), k % 3 == 0 ? INK_BRIGHT : INK_TEXT);
        float t = left ? step : 1 - step;
        struct point2 q[3] = {between(p[0], p[1], t), between(p[1], p[2], t),
                              between(p[2], p[0], t)};
        p[0] = q[0], p[1] = q[1], p[2] = q[2];
    }
}

void art_whirls(struct stage *s, float seconds)
{
    enum { SIDES = 6, RADIUS = 375 };
    static const enum ink_ramp ramps[] = {RAMP_COPPER, RAMP_BLUE, RAMP_GOLD};
    float turn = seconds * 0.07f, step = 0.11f + 0.07f * sinf(seconds * 0.4f);
    for (int i = 0; i < SIDES; i++) {
        struct point2 p[3] = {middle, polar(RADIUS, turn + PI / 3 * (float)i),
                              polar(RADIUS, turn + PI / 3 * (float)(i + 1))};
        whirl(s, p, step, i % 2 == 0, ramps[i % 3]);
    }
}

/* ---- kaleidoscope ---------------------------------------------------------------------------- */

enum { SHARDS = 10, CORNERS = 4, CUT = CORNERS + 2, MIRRORS = 6 };

/* Cuts off what is to the right of the ray at this angle (or to the left); how many corners
 * remain. */
static int cut(const struct point2 *p, int count, float angle, bool right, struct point2 *out)
{
    int kept = 0;
    float c = cosf(angle), sine = sinf(angle);
    for (int i = 0; i < count; i++) {
        struct point2 a = p[i], b = p[(i + 1) % count];
        float da = a.y * c - a.x * sine, db = b.y * c - b.x * sine; /* > 0: to the left */
        if (!right)
            da = -da, db = -db;
        if (da >= 0)
            out[kept++] = a;
        if ((da > 0 && db < 0) || (da < 0 && db > 0))
            out[kept++] = between(a, b, da / (da - db));
    }
    return kept;
}

/* A shard as it drifts through the wedge between the mirrors; about the middle. */
static void shard(int which, float t, struct point2 *p)
{
    float n = (float)which, r = 20 + 33 * n + 30 * sinf(0.31f * t + 2.1f * n);
    float angle = PI / 12 + 0.45f * sinf(0.23f * t + 1.7f * n), size = 42 + 2 * n;
    for (int i = 0; i < CORNERS; i++) {
        float turn =
            0.4f * t * (which % 2 ? 1.0f : -1.0f) + PI / 2 * (float)i + 0.5f * sinf(n + (float)i);
        p[i] = (struct point2){r * cosf(angle) + size * cosf(turn),
                               r * sinf(angle) + size * sinf(turn)};
    }
}

/* All the images of a point of the wedge: turned, and mirrored. */
static struct point2 image(struct point2 p, int turn, bool mirrored)
{
    float angle = PI / 3 * (float)turn, c = cosf(angle), s = sinf(angle);
    if (mirrored)
        p.y = -p.y;
    return (struct point2){middle.x + p.x * c - p.y * s, middle.y + p.x * s + p.y * c};
}

static bool on_a_mirror(struct point2 p)
{
    return fabsf(p.y) < 0.5f || fabsf(p.y * cosf(PI / 6) - p.x * sinf(PI / 6)) < 0.5f;
}

/* All images of what a shard shows; on the vector head without the edges that the mirrors make. */
static void images(struct stage *s, const struct point2 *p, int count, uint32_t colour,
                   enum ink vector)
{
    bool edge[CUT + 2];
    for (int n = 0; n < count; n++)
        edge[n] = !on_a_mirror(p[n]) || !on_a_mirror(p[(n + 1) % count]);
    for (int k = 0; k < 2 * MIRRORS; k++) {
        struct point2 q[CUT + 2];
        for (int n = 0; n < count; n++)
            q[n] = image(p[n], k / 2, k % 2);
        art_area(s, q, count, colour, INK_BLACK);
        stage_heads(s, STAGE_VECTOR);
        stage_ink(s, vector);
        for (int n = 0; n < count; n++)
            if (edge[n])
                stage_line(s, q[n].x, q[n].y, q[(n + 1) % count].x, q[(n + 1) % count].y);
        stage_heads(s, STAGE_BOTH);
    }
}

void art_kaleidoscope(struct stage *s, float seconds)
{
    static const enum ink_ramp ramps[] = {RAMP_GOLD, RAMP_BLUE, RAMP_COPPER, RAMP_BLUE, RAMP_GREEN};
    static const enum ink inks[] = {INK_CYAN, INK_BRIGHT, INK_TEXT};
    for (int i = SHARDS - 1; i >= 0; i--) {
        struct point2 p[CORNERS], half[CUT], whole[CUT + 2];
        shard(i, seconds + 4, p);
        int count = cut(p, CORNERS, 0, true, half);
        count = cut(half, count, PI / 6, false, whole);
        float light = 0.15f + 0.5f * (0.5f + 0.5f * sinf(0.7f * seconds + 1.3f * (float)i));
        if (count >= 3)
            images(s, whole, count, ink_shade(ramps[i % 5], light), inks[i % 3]);
    }
}
