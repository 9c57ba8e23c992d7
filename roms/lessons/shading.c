/* shading.c — light and shading: eight pages of light on solids. */
#include <math.h>
#include <stdio.h>

#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/lessons/shading.h"

static struct shading_lesson lesson;
static struct pages pages;

static const struct {
    const char *title;
    float seconds; /* until the next page */
    void (*begin)(struct shading_lesson *l);
    void (*draw)(struct shading_lesson *l, struct stage *stage, float t);
} table[] = {
    {"Four shadings of one solid", 14, shading_compare_begin, shading_compare},
    {"A solid turns", 20, shading_turn_begin, shading_turn},
    {"Ambient, diffuse, specular", 12, shading_terms_begin, shading_terms},
    {"Shininess: the exponent n", 12, shading_shine_begin, shading_shine},
    {"Lights move", 14, shading_lights_begin, shading_lights},
    {"A lamp with an extent", 15, shading_lamp_begin, shading_lamp},
    {"Mach bands", 16, shading_mach_begin, shading_mach},
    {"Few levels: dithering", 16, shading_dither_begin, shading_dither},
};
enum { PAGES = sizeof table / sizeof table[0], TURNS = 1 };

static void begin(void *own)
{
    struct shading_lesson *l = own;
    *l =
        (struct shading_lesson){.studio = studio(), .shading = -1, .model = STUDIO_VESSEL, .n = 20};
}

static void turn(void *own, int page)
{
    struct shading_lesson *l = own;
    studio_reset(l->studio);
    table[page].begin(l);
}

static bool key(void *own, int k)
{
    struct shading_lesson *l = own;
    if (k >= '1' && k < '1' + SHADINGS)
        l->shading = l->shading == k - '1' ? -1 : k - '1';
    else if (k == '+' || k == '=')
        l->n = fminf(l->n * 1.5f, POWER_MOST);
    else if (k == '-')
        l->n = fmaxf(l->n / 1.5f, POWER_LEAST);
    else if (k == 'o') {
        l->model = l->model + 1 == STUDIO_MODELS ? STUDIO_PRESENT : l->model + 1;
        pages_go(&pages, TURNS);
    } else
        return false;
    return true;
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    struct shading_lesson *l = own;
    l->rate = pages.apart > 0 ? 1 / pages.apart : 0;
    stage_title(stage, table[page].title);
    table[page].draw(l, stage, seconds);
    return table[page].seconds;
}

static struct pages pages = {
    .count = PAGES, .own = &lesson, .begin = begin, .turn = turn, .draw = draw, .key = key};

extern const struct lesson lesson_shading;
const struct lesson lesson_shading = {
    "shading", "Light and shading", PAGES_TURN "  1-4 shading  + - n  o object",
    &pages,    pages_begin,         pages_key,
    pages_draw};
