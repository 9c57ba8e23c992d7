#include <string.h>

#include "roms/choice/choice.h"
#include "roms/geometry/scalar.h"

enum { TRACK = 18, KNOB = 14, EDGE = 8 };

static float track_low(const struct slider *s)
{
    return s->left + EDGE + KNOB;
}

static float track_high(const struct slider *s)
{
    return s->left + s->width - EDGE - KNOB;
}

void slider_set(struct slider *s, float value)
{
    s->value = scalar_clamp(value, s->low, s->high);
}

static void fill(struct stage *stage, float x, float y, float width, float height, enum ink ink)
{
    const struct point2 corners[] = {
        {x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    stage_ink(stage, ink);
    stage_area(stage, corners, 4);
}

void slider_draw(const struct slider *s, struct stage *stage, bool marked, const char *words)
{
    float part = (s->value - s->low) / (s->high - s->low);
    float knob = track_low(s) + part * (track_high(s) - track_low(s)), y = s->bottom + 4;
    stage_ink(stage, marked ? INK_ORANGE : INK_TEXT);
    stage_text(stage, s->left, s->bottom + 34, s->label);
    float room = (float)(STAGE_CHARACTER * strlen(words));
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, s->left + s->width - room, s->bottom + 34, words);
    fill(stage, s->left, y, s->width, TRACK, (enum ink)ink_shade(RAMP_BLUE, marked ? 0.36f : 0.2f));
    fill(stage, knob - KNOB, y - 4, 2 * KNOB, TRACK + 8, s->held ? INK_YELLOW : INK_CYAN);
}

static bool within(const struct slider *s, struct point2 at)
{
    return at.x >= s->left && at.x <= s->left + s->width && at.y >= s->bottom - 4 &&
           at.y <= s->bottom + 34;
}

bool slider_event(struct slider *s, const struct pointer *p, bool *done)
{
    float before = s->value;
    if (p->pressed_now)
        s->held = within(s, p->pressed_at);
    *done = s->held && !p->pressed;
    if (s->held) {
        float x = p->released_now ? p->released_at.x : p->at.x;
        slider_set(s, s->low +
                          (x - track_low(s)) / (track_high(s) - track_low(s)) * (s->high - s->low));
    }
    s->held &= p->pressed;
    return s->value != before;
}
