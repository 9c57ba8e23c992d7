/* space.c — the lesson on space: rotations, the rotation about a line step by step, projections. */
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/lessons/space_pages.h"

static const struct space_page table[] = {
    {18, space_page_axes},      {28, space_page_line},      {14, space_page_parallel},
    {12, space_page_one_point}, {12, space_page_two_point}, {12, space_page_three_point},
};
enum { PAGES = sizeof table / sizeof table[0] };

static struct space_viewer viewer;

static void turn(void *own, int page)
{
    (void)page;
    *(struct space_viewer *)own = (struct space_viewer){0, 0};
}

static bool key(void *own, int k)
{
    enum { STEP = 5, MOST = 40 };
    struct space_viewer *v = own;
    if (k == KEY_LEFT && v->turn > -MOST)
        v->turn -= STEP;
    else if (k == KEY_RIGHT && v->turn < MOST)
        v->turn += STEP;
    else if (k == KEY_UP && v->tilt < MOST)
        v->tilt += STEP;
    else if (k == KEY_DOWN && v->tilt > -MOST)
        v->tilt -= STEP;
    else
        return false;
    return true;
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    table[page].draw(stage, seconds, *(struct space_viewer *)own);
    return table[page].lasts;
}

static struct pages pages = {
    .count = PAGES, .own = &viewer, .turn = turn, .draw = draw, .key = key};

extern const struct lesson lesson_space;
const struct lesson lesson_space = {"space",
                                    "Space and projections",
                                    PAGES_KEYS "  arrows viewer",
                                    &pages,
                                    pages_begin,
                                    pages_key,
                                    pages_draw};
