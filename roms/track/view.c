/* The picture: trail, ink, speed; what the strokes of the cross saw, enlarged; figures. */
#include <math.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/track/track.h"

enum { LEFT = 8, TOP = 770, LENS_X = 1060, LENS_Y = 660, LENS = 120, LENS_UNITS = 20, CROSS = 28 };

static struct point2 place(const struct stage *stage, struct point2 head)
{
    return stage_from_head(stage, head.x, head.y);
}

static void line(struct stage *stage, struct point2 a, struct point2 b)
{
    a = place(stage, a);
    b = place(stage, b);
    stage_line(stage, a.x, a.y, b.x, b.y);
}

static void draw_ink(struct stage *stage, const struct strokes *s)
{
    stage_ink(stage, INK_YELLOW);
    for (int i = 1; i < s->count; i++) {
        int to = (s->first + i) % STROKES_POINTS, from = (s->first + i - 1) % STROKES_POINTS;
        if (!s->begins[to])
            line(stage, s->ink[from], s->ink[to]);
    }
}

static void draw_trail(struct stage *stage, const struct strokes *s)
{
    stage_ink(stage, INK_GREEN);
    for (int i = 1; i < s->trail_count; i++) {
        int to = (s->trail_first + i) % TRAIL_POINTS,
            from = (s->trail_first + i - 1) % TRAIL_POINTS;
        if (i == s->trail_count / 2)
            stage_ink(stage, INK_CYAN);
        if (!s->gap[to])
            line(stage, s->trail[from], s->trail[to]);
    }
}

/* Where the pen will be in a tenth of a second. */
static void draw_velocity(struct stage *stage, const struct tracking *t)
{
    struct point2 to = {t->at.x + 6 * t->velocity.x, t->at.y + 6 * t->velocity.y};
    if (t->state != TRACKING_FOLLOWING || hypotf(t->velocity.x, t->velocity.y) < 1)
        return;
    stage_ink(stage, INK_ORANGE);
    line(stage, t->at, to);
    to = place(stage, to);
    stage_marker(stage, to.x, to.y);
}

/* The vector head has the cross itself. */
static void draw_cross(struct stage *stage, const struct tracking *t)
{
    struct point2 at = place(stage, t->cross);
    stage_heads(stage, STAGE_RASTER);
    stage_ink(stage, t->state == TRACKING_LOST ? INK_RED : INK_BRIGHT);
    stage_line(stage, at.x - CROSS, at.y, at.x + CROSS, at.y);
    stage_line(stage, at.x, at.y - CROSS, at.x, at.y + CROSS);
    stage_heads(stage, STAGE_BOTH);
}

/* ---- enlarged -------------------------------------------------------------------------------------- */

static float lens(float units)
{
    return units * LENS / LENS_UNITS;
}

/* The strokes each way, a little apart; where each was stopped. */
static void draw_strokes(struct stage *stage, const struct tracking *t, struct point2 about)
{
    static const float apart = 6;
    for (int arm = 0; arm < TRACKING_ARMS; arm++) {
        const struct tracking_hit *hit = &t->arm[arm];
        bool across = arm % 2 == 0;
        float aside = arm < 2 ? apart : -apart,
              along = lens((float)hit->at - (across ? about.x : about.y));
        stage_ink(stage, INK_GRID);
        if (across)
            stage_line(stage, LENS_X - LENS, LENS_Y + aside, LENS_X + LENS, LENS_Y + aside);
        else
            stage_line(stage, LENS_X + aside, LENS_Y - LENS, LENS_X + aside, LENS_Y + LENS);
        if (!hit->seen || fabsf(along) > LENS)
            continue;
        stage_ink(stage, INK_BRIGHT);
        if (across)
            stage_line(stage, LENS_X + along, LENS_Y + aside,
                       arm == TRACKING_RIGHT ? LENS_X + LENS : LENS_X - LENS, LENS_Y + aside);
        else
            stage_line(stage, LENS_X + aside, LENS_Y + along, LENS_X + aside,
                       arm == TRACKING_TOP ? LENS_Y + LENS : LENS_Y - LENS);
    }
}

static void draw_lens(struct stage *stage, const struct tracking *t)
{
    stage_ink(stage, INK_GRID);
    stage_rectangle(stage, LENS_X - LENS, LENS_Y - LENS, 2 * LENS, 2 * LENS);
    draw_strokes(stage, t, t->at);
    if (t->state == TRACKING_FOLLOWING) {
        stage_ink(stage, INK_GREEN);
        stage_marker(stage, LENS_X, LENS_Y);
        struct point2 late = {LENS_X + lens(t->one_way.x - t->at.x),
                              LENS_Y + lens(t->one_way.y - t->at.y)};
        stage_ink(stage, INK_RED);
        if (fabsf(late.x - LENS_X) < LENS && fabsf(late.y - LENS_Y) < LENS)
            stage_marker(stage, late.x, late.y);
    }
    stage_ink(stage, INK_TEXT);
    stage_text_middle(stage, LENS_X, LENS_Y - LENS - 30, "what the arms saw");
    stage_text_middle(stage, LENS_X, LENS_Y - LENS - 60, "+ off: one way");
}

/* ---- figures ------------------------------------------------------------------------------------------ */

static void say(struct stage *stage, int row, const char *text)
{
    stage_text(stage, LEFT, (float)(TOP - STAGE_TEXT_LINE * row), text);
}

static void draw_figures(struct stage *stage, const struct tracking *t, const struct course *c)
{
    char text[64];
    stage_ink(stage, c->state == TRACKING_FOLLOWING ? INK_GREEN : INK_RED);
    say(stage, 0, track_state_name(c->state));
    stage_ink(stage, INK_TEXT);
    snprintf(text, sizeof text, "place  %4d %4d", scalar_nearest(t->at.x), scalar_nearest(t->at.y));
    say(stage, 1, text);
    snprintf(text, sizeof text, "speed  %4d mm/s", scalar_nearest(c->speed));
    say(stage, 2, text);
    snprintf(text, sizeof text, "most   %4d mm/s", scalar_nearest(c->greatest));
    say(stage, 3, text);
    snprintf(text, sizeof text, "spirals %lu, lost %lu", (unsigned long)t->counts.searches,
             (unsigned long)t->counts.losses);
    say(stage, 4, text);
    if (!t->predicts)
        say(stage, 5, "no prediction");
}

void view_draw(struct stage *stage, const struct tracking *t, const struct course *c,
               const struct strokes *s)
{
    stage_title(stage, "A tracking cross follows the light pen");
    draw_figures(stage, t, c);
    draw_lens(stage, t);
    draw_trail(stage, s);
    draw_ink(stage, s);
    draw_velocity(stage, t);
    draw_cross(stage, t);
    stage_ink(stage, INK_TEXT);
    stage_caption(stage, c->state == TRACKING_LOST
                             ? "Point at the blinking cross to take it up, or scan the screen: s"
                             : "Press the tip to draw. p prediction, c clear, q figures and end");
}
