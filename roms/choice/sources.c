/* sources.c — which device chose, how often, and what it reported. */
#include <stdio.h>
#include <string.h>

#include "roms/choice/choice.h"

static const struct {
    const char *name;
    enum ink ink;
} sources_of[SOURCES] = {
    [POINTER_NONE] = {"NOBODY", INK_GRID},   [POINTER_TABLET] = {"TABLET", INK_GREEN},
    [POINTER_TOUCH] = {"TOUCH", INK_YELLOW}, [POINTER_MOUSE] = {"MOUSE", INK_CYAN},
    [POINTER_PEN] = {"PEN", INK_ORANGE},     [SOURCE_KEYS] = {"KEYS", INK_VIOLET},
};

const char *source_name(int source)
{
    return sources_of[source].name;
}

enum ink source_ink(int source)
{
    return sources_of[source].ink;
}

/* In the device's own counts. */
static void pointed(char *text, size_t size, const struct pointer *p)
{
    const struct pointer_report *r = &p->report;
    switch (p->device) {
    case POINTER_TABLET:
        snprintf(text, size, "x %d y %d counts, raw %u %u %u %u", (int)r->x, (int)r->y,
                 (unsigned)tablet_raw(0), (unsigned)tablet_raw(1), (unsigned)tablet_raw(2),
                 (unsigned)tablet_raw(3));
        break;
    case POINTER_TOUCH:
        snprintf(text, size, "x %d y %d half positions, %d %d um", (int)((uint32_t)r->z >> 16),
                 (int)(r->z & 0xFFFF), (int)r->x, (int)r->y);
        break;
    case POINTER_MOUSE:
        snprintf(text, size, "x %d y %d counts of %u nm", (int)p->mouse_x, (int)p->mouse_y,
                 (unsigned)p->mouse_nm);
        break;
    case POINTER_PEN:
        if (r->tracked)
            snprintf(text, size, "x %d y %d tracked", (int)p->at.x, (int)p->at.y);
        else
            snprintf(text, size, "dot %d line %d field %d", (int)r->x, (int)r->y, (int)r->z);
        break;
    default:
        snprintf(text, size, "nothing");
    }
}

static void choose(struct sources *s, int source, const char *label)
{
    s->count[source]++;
    s->last = source;
    snprintf(s->label, sizeof s->label, "%s", label);
    printf("choice: %s by %s: %s\n", label, source_name(source), s->report[source]);
}

void source_pointed(struct sources *s, const struct pointer *p, const char *label)
{
    int source = (int)p->device;
    pointed(s->report[source], sizeof s->report[source], p);
    s->place[s->places % PLACES].at = p->released_now ? p->released_at : p->at;
    s->place[s->places % PLACES].source = source;
    s->places++;
    choose(s, source, label);
}

void source_typed(struct sources *s, const struct key_event *key, const char *label)
{
    snprintf(s->report[SOURCE_KEYS], sizeof s->report[SOURCE_KEYS],
             "character %u code %u modifiers %u", key->character, key->code, key->modifiers);
    choose(s, SOURCE_KEYS, label);
}

/* One cell a device, lit for the one that was last. */
static void cell(const struct sources *s, struct stage *stage, int source)
{
    enum { LEFT = 20, WIDTH = 232, BOTTOM = 54, HEIGHT = 40 };
    char text[24];
    float x = LEFT + (float)(source - 1) * WIDTH;
    const struct point2 corners[] = {{x, BOTTOM},
                                     {x + WIDTH - 10, BOTTOM},
                                     {x + WIDTH - 10, BOTTOM + HEIGHT},
                                     {x, BOTTOM + HEIGHT}};
    bool last = source == s->last;
    if (last) {
        stage_heads(stage, STAGE_RASTER);
        stage_ink(stage, source_ink(source));
        stage_area(stage, corners, 4);
        stage_heads(stage, STAGE_VECTOR);
        stage_ink(stage, INK_BRIGHT);
    } else {
        stage_ink(stage, INK_GRID);
    }
    stage_polygon(stage, corners, 4);
    snprintf(text, sizeof text, "%-7s%3u", source_name(source), s->count[source] % 1000);
    stage_text(stage, x + 20, BOTTOM + 12, text);
    stage_heads(stage, STAGE_RASTER);
    stage_ink(stage, last ? INK_BLACK : s->count[source] > 0 ? INK_TEXT : INK_GRID);
    stage_text(stage, x + 20, BOTTOM + 12, text);
    stage_heads(stage, STAGE_BOTH);
}

void sources_draw(const struct sources *s, struct stage *stage)
{
    char text[112];
    for (int i = 1; i < SOURCES; i++)
        cell(s, stage, i);
    if (s->last == 0)
        return;
    stage_ink(stage, source_ink(s->last));
    stage_text(stage, 20, 18, s->label);
    stage_ink(stage, INK_TEXT);
    snprintf(text, sizeof text, "%s", s->report[s->last]);
    stage_text(stage, 30 + (float)(STAGE_CHARACTER * strlen(s->label)), 18, text);
}
