/* shading.c — light and shading: eight scenes of light on solids. */
#include <math.h>
#include <stdio.h>

#include "roms/scenery/eye.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/shading.h"

static struct shading_lesson lesson;

static const struct scene_part {
    const char *title;
    float seconds; /* until the next scene, when nobody holds it */
    void (*begin)(struct shading_lesson *l);
    void (*draw)(struct shading_lesson *l, struct stage *stage, float t);
} scenes[] = {
    {"Four shadings of one solid", 14, shading_compare_begin, shading_compare},
    {"A solid turns", 20, shading_turn_begin, shading_turn},
    {"Ambient, diffuse, specular", 12, shading_terms_begin, shading_terms},
    {"Shininess: the exponent n", 12, shading_shine_begin, shading_shine},
    {"Lights move", 14, shading_lights_begin, shading_lights},
    {"A lamp with an extent", 15, shading_lamp_begin, shading_lamp},
    {"Mach bands", 16, shading_mach_begin, shading_mach},
    {"Few levels: dithering", 16, shading_dither_begin, shading_dither},
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

static void go(struct shading_lesson *l, int scene)
{
    l->scene = (scene + SCENES) % SCENES;
    l->entered = false;
}

static void begin(void *state)
{
    struct shading_lesson *l = state;
    *l =
        (struct shading_lesson){.studio = studio(), .shading = -1, .model = STUDIO_VESSEL, .n = 20};
    go(l, 0);
}

static void change_model(struct shading_lesson *l)
{
    l->model = l->model + 1 == STUDIO_MODELS ? STUDIO_PRESENT : l->model + 1;
    go(l, 1);
    l->hold = true;
}

static void key(void *state, int k)
{
    struct shading_lesson *l = state;
    if (k == ' ' || k == KEY_RIGHT)
        go(l, l->scene + 1);
    else if (k == KEY_LEFT)
        go(l, l->scene - 1);
    else if (k >= '1' && k < '1' + SHADINGS)
        l->shading = l->shading == k - '1' ? -1 : k - '1';
    else if (k == '+' || k == '=' || k == KEY_UP)
        l->n = l->n * 1.5f < POWER_MOST ? l->n * 1.5f : POWER_MOST;
    else if (k == '-' || k == KEY_DOWN)
        l->n = l->n / 1.5f > POWER_LEAST ? l->n / 1.5f : POWER_LEAST;
    else if (k == 'o')
        change_model(l);
    else if (k == 'h')
        l->hold = !l->hold;
}

static float draw(void *state, struct stage *stage, float seconds)
{
    struct shading_lesson *l = state;
    if (l->entered && !l->hold && seconds - l->since > scenes[l->scene].seconds)
        go(l, l->scene + 1);
    if (!l->entered) {
        l->entered = true;
        l->since = seconds;
        studio_reset(l->studio);
        scenes[l->scene].begin(l);
    }
    l->rate = seconds > l->last ? 1 / (seconds - l->last) : 0;
    l->last = seconds;
    stage_title(stage, scenes[l->scene].title);
    scenes[l->scene].draw(l, stage, seconds - l->since);
    return 0;
}

extern const struct lesson lesson_shading;
const struct lesson lesson_shading = {"shading",
                                      "Light and shading",
                                      "space scene  1-4 shading  + - n  o object  h hold",
                                      &lesson,
                                      begin,
                                      key,
                                      draw};
