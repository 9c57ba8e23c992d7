/* curves.c — the lesson about curves: its pages, time and keys. */
#include "roms/lessons/curves.h"

#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"

static const struct curves_page *const table[] = {
    &curves_page_casteljau, &curves_page_blending, &curves_page_splines, &curves_page_tension,
    &curves_page_b_spline,  &curves_page_join,     &curves_page_patch,
};
enum { PAGES = sizeof table / sizeof table[0], PAGE_SECONDS = 16, STEP = 20 };

static struct curves_lesson {
    bool moved, set; /* by keys: a point, the value */
    struct curves_view view;
} lesson;

static void turn(void *own, int page)
{
    *(struct curves_lesson *)own =
        (struct curves_lesson){.view = {.chosen = -1, .count = table[page]->count}};
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

static bool key(void *own, int k)
{
    struct curves_lesson *l = own;
    if (k == '\t' && l->view.count > 0)
        l->view.chosen = (l->view.chosen + 1) % l->view.count;
    else if (k == KEY_UP)
        move(l, 0, STEP);
    else if (k == KEY_DOWN)
        move(l, 0, -STEP);
    else if (k == KEY_LEFT)
        move(l, -STEP, 0);
    else if (k == KEY_RIGHT)
        move(l, STEP, 0);
    else if (k == '+' || k == '=')
        change(l, 0.05f);
    else if (k == '-')
        change(l, -0.05f);
    else
        return false;
    return true;
}

/* What nobody steers moves by itself. */
static void run(struct curves_lesson *l, const struct curves_page *page)
{
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

static float draw(void *own, struct stage *s, int page, float seconds)
{
    struct curves_lesson *l = own;
    l->view.clock = seconds;
    run(l, table[page]);
    table[page]->draw(&l->view, s);
    stage_title(s, table[page]->title);
    stage_caption(s, table[page]->caption);
    return PAGE_SECONDS;
}

void curves_draw_controls(const struct curves_view *v, struct stage *s, enum ink ink)
{
    char name[16];
    for (int i = 0; i < v->count; i++) {
        bool chosen = i == v->chosen;
        brush_point(s, v->point[i], chosen ? 16 : 10, chosen ? INK_BRIGHT : ink);
        snprintf(name, sizeof name, "p%d", i);
        stage_text(s, v->point[i].x + 16, v->point[i].y + 12, name);
    }
}

static struct pages pages = {
    .count = PAGES, .again = 0.02f, .own = &lesson, .turn = turn, .draw = draw, .key = key};

extern const struct lesson lesson_curves;
const struct lesson lesson_curves = {
    "curves",  "Curves and surfaces", PAGES_TURN "  tab arrows point  + - value",
    &pages,    pages_begin,           pages_key,
    pages_draw};
