/* gallery_publishing.c — publishing: a page of headline, initial, justified columns, rules and a
 * figure, with a view that zooms. */
#include "roms/lessons/gallery_publishing.h"

#include <math.h>

#include "roms/lessons/lesson.h"

struct publishing {
    struct point2 middle;
    float zoom;
    float begun; /* when the tour did */
    float now;
    bool alone;
};

static const float whole = 0.7f, nearest = 4;

/* ---- the tour -------------------------------------------------------------------------------- */

struct stop {
    struct point2 middle;
    float zoom, stays;
};

static const struct stop stops[] = {
    {{425, 550}, 0.7f, 4}, {{425, 890}, 1.35f, 3}, {{330, 660}, 1.8f, 5},
    {{330, 330}, 1.8f, 3}, {{620, 680}, 2.4f, 4},  {{560, 320}, 1.8f, 4},
};
enum { STOPS = sizeof stops / sizeof stops[0] };

/* From stop to stop: slowly off, slowly on. */
static void travel(struct publishing *p, float seconds)
{
    const float way = 3; /* seconds */
    int i = 0;
    float round = 0;
    for (int k = 0; k < STOPS; k++)
        round += stops[k].stays + way;
    seconds = fmodf(seconds, round);
    for (; seconds > stops[i].stays + way; i++)
        seconds -= stops[i].stays + way;
    const struct stop *a = &stops[i], *b = &stops[(i + 1) % STOPS];
    float t = seconds > a->stays ? (seconds - a->stays) / way : 0;
    t = t * t * (3 - 2 * t);
    p->middle = (struct point2){a->middle.x + t * (b->middle.x - a->middle.x),
                                a->middle.y + t * (b->middle.y - a->middle.y)};
    p->zoom = a->zoom * powf(b->zoom / a->zoom, t);
}

/* ---- the program ----------------------------------------------------------------------------- */

static void begin(void *state)
{
    *(struct publishing *)state = (struct publishing){.alone = true};
}

static void move(struct publishing *p, float x, float y)
{
    const float step = 60; /* stage units */
    p->middle.x = fminf(fmaxf(p->middle.x + x * step / p->zoom, 0), PAGE_WIDTH);
    p->middle.y = fminf(fmaxf(p->middle.y + y * step / p->zoom, 0), PAGE_HEIGHT);
}

static void key(void *state, int k)
{
    struct publishing *p = (struct publishing *)state;
    p->alone = k == ' ';
    if (k == '+' || k == '=')
        p->zoom = fminf(p->zoom * 1.25f, nearest);
    else if (k == '-')
        p->zoom = fmaxf(p->zoom / 1.25f, whole);
    else if (k == KEY_LEFT || k == KEY_RIGHT)
        move(p, k == KEY_LEFT ? -1 : 1, 0);
    else if (k == KEY_UP || k == KEY_DOWN)
        move(p, 0, k == KEY_UP ? 1 : -1);
    else if (k == ' ')
        p->begun = p->now;
}

static float draw(void *state, struct stage *s, float seconds)
{
    struct publishing *p = (struct publishing *)state;
    p->now = seconds;
    if (p->alone)
        travel(p, seconds - p->begun);
    struct page_view view = page_look(s, p->middle, p->zoom);
    page_draw(&view, seconds);
    stage_title(s, "Electronic publishing");
    stage_caption(
        s, "What will be printed is what is seen: lines are broken and justified here, letters "
           "are as dark as they cover a pixel.");
    return 0.03f;
}

static struct publishing lesson_state;

extern const struct lesson lesson_gallery_publishing;
const struct lesson lesson_gallery_publishing = {"publishing",
                                                 "Gallery: electronic publishing",
                                                 "+ - zoom  arrows move  space tour",
                                                 &lesson_state,
                                                 begin,
                                                 key,
                                                 draw};
