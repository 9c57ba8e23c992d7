/* curves.c — the lesson about curves: its pages, time and keys. */
#include "roms/lessons/curves.h"

#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"

static const struct curves_page *const pages[] = {
    &curves_page_casteljau, &curves_page_blending, &curves_page_splines, &curves_page_tension,
    &curves_page_b_spline,  &curves_page_join,     &curves_page_patch,
};
enum { PAGES = sizeof pages / sizeof pages[0], PAGE_SECONDS = 16, STEP = 20 };

struct curves_lesson {
    int page;
    bool steered; /* a key was pressed: pages stay */
    bool paused, moved, set;
    float seconds; /* when it was drawn last */
    struct curves_view view;
};

static struct curves_lesson lesson;

static void turn_to(struct curves_lesson *l, int page)
{
    const struct curves_page *p = pages[page];
    l->page = page;
    l->paused = l->moved = l->set = false;
    l->view = (struct curves_view){.chosen = -1, .count = p->count};
}

static void begin(void *state)
{
    struct curves_lesson *l = state;
    *l = (struct curves_lesson){0};
    turn_to(l, 0);
}

static void move(struct curves_lesson *l, float dx, float dy)
{
    struct curves_view *v = &l->view;
    if (v->count == 0)
        return;
    l->moved = true;
    v->chosen = v->chosen < 0 ? 0 : v->chosen;
    struct vector3 *p = &v->point[v->chosen];
    p->x = fminf(fmaxf(p->x + dx, STEP), STAGE_WIDTH - STEP);
    p->y = fminf(fmaxf(p->y + dy, STEP), STAGE_HEIGHT - STEP);
}

static void change(struct curves_lesson *l, float by)
{
    l->set = true;
    l->view.value = fminf(fmaxf(l->view.value + by, 0), 1);
}

static void key(void *state, int k)
{
    struct curves_lesson *l = state;
    l->steered = true;
    if (k == ' ')
        turn_to(l, (l->page + 1) % PAGES);
    else if (k == 'b')
        turn_to(l, (l->page + PAGES - 1) % PAGES);
    else if (k == 'p')
        l->paused = !l->paused;
    else if ((k == 'n' || k == '\t') && l->view.count > 0)
        l->view.chosen = (l->view.chosen + 1) % l->view.count;
    else if (k == KEY_UP || k == 'w')
        move(l, 0, STEP);
    else if (k == KEY_DOWN || k == 's')
        move(l, 0, -STEP);
    else if (k == KEY_LEFT || k == 'a')
        move(l, -STEP, 0);
    else if (k == KEY_RIGHT || k == 'd')
        move(l, STEP, 0);
    else if (k == '+' || k == '=')
        change(l, 0.05f);
    else if (k == '-')
        change(l, -0.05f);
}

/* What nobody steers moves by itself. */
static void run(struct curves_lesson *l)
{
    const struct curves_page *page = pages[l->page];
    struct curves_view *v = &l->view;
    float t = v->clock;
    for (int i = 0; i < v->count && !l->moved; i++) {
        float phase = 0.45f * t + 1.9f * (float)i, away = page->drift * fminf(t / 4, 1);
        v->point[i] = (struct vector3){page->start[i].x + 22 * away * sinf(phase),
                                       page->start[i].y + 40 * away * sinf(1.3f * phase + 1), 0};
    }
    if (!l->set)
        v->value = 0.5f - 0.5f * cosf(t * TURN / page->period);
}

static float draw(void *state, struct stage *s, float seconds)
{
    struct curves_lesson *l = state;
    char title[64];
    float passed = seconds - l->seconds;
    l->seconds = seconds;
    l->view.clock += l->paused ? 0 : passed;
    if (!l->steered && l->view.clock > PAGE_SECONDS)
        turn_to(l, (l->page + 1) % PAGES);
    run(l);
    snprintf(title, sizeof title, "%d/%d  %s", l->page + 1, PAGES, pages[l->page]->title);
    pages[l->page]->draw(&l->view, s);
    stage_title(s, title);
    stage_caption(s, pages[l->page]->caption);
    return 0.02f;
}

void curves_draw_controls(const struct curves_view *v, struct stage *s, enum ink ink)
{
    char name[16];
    for (int i = 0; i < v->count; i++) {
        bool chosen = i == v->chosen;
        pen_point(s, v->point[i], chosen ? 16 : 10, chosen ? INK_BRIGHT : ink);
        snprintf(name, sizeof name, "p%d", i);
        stage_text(s, v->point[i].x + 16, v->point[i].y + 12, name);
    }
}

extern const struct lesson lesson_curves;
const struct lesson lesson_curves = {.name = "curves",
                                     .title = "Curves and surfaces",
                                     .keys = "space page  n point  wasd move  + - value  p pause",
                                     .state = &lesson,
                                     .begin = begin,
                                     .key = key,
                                     .draw = draw};
