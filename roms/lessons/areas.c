/* areas.c — filling: a polygon by its active edges, the two rules, from a seed; attributes of
 * lines. */
#include "roms/lessons/areas.h"

#include "roms/lessons/lesson.h"
#include "roms/lessons/scenes.h"

enum { SCENES = 5, SECONDS = 16 };

static void begin(void *state)
{
    scenes_begin((struct scenes *)state, SCENES);
}

static void key(void *state, int k)
{
    scenes_key((struct scenes *)state, k);
}

static float draw(void *state, struct stage *stage, float seconds)
{
    static void (*const scene[SCENES])(struct stage *, float) = {
        areas_scan_lines, areas_rules, areas_spreading, areas_leak, areas_attributes};
    struct scenes *s = (struct scenes *)state;
    float t = scenes_since(s, seconds);
    scene[s->scene](stage, t);
    scenes_end_after(s, SECONDS);
    return 0.04f;
}

static struct scenes lesson_state;

extern const struct lesson lesson_areas;
const struct lesson lesson_areas = {
    "areas", "Areas and how they are filled", SCENES_KEYS, &lesson_state, begin, key, draw};
