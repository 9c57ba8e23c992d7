/* space.c — the lesson on space: rotations, the rotation about a line step by step, projections. */
#include "roms/lessons/lesson.h"
#include "roms/lessons/space_chapters.h"

static const struct space_chapter chapters[] = {
    {18, space_chapter_axes},      {28, space_chapter_line},      {14, space_chapter_parallel},
    {12, space_chapter_one_point}, {12, space_chapter_two_point}, {12, space_chapter_three_point},
};
enum { CHAPTERS = sizeof chapters / sizeof chapters[0] };

struct state {
    int chapter;
    float within, last; /* seconds of the chapter; when it was drawn last */
    bool paused;
    struct space_viewer viewer;
};

static void begin(void *ctx)
{
    *(struct state *)ctx = (struct state){.chapter = 0};
}

static void go(struct state *s, int by)
{
    s->chapter = (s->chapter + by + CHAPTERS) % CHAPTERS;
    s->within = 0;
    s->viewer = (struct space_viewer){0, 0};
}

static void key(void *ctx, int k)
{
    enum { STEP = 5, MOST = 40 };
    struct state *s = ctx;
    struct space_viewer *v = &s->viewer;
    if (k == ' ')
        go(s, 1);
    else if (k == 'b')
        go(s, -1);
    else if (k == 'p')
        s->paused = !s->paused;
    else if (k == KEY_LEFT && v->turn > -MOST)
        v->turn -= STEP;
    else if (k == KEY_RIGHT && v->turn < MOST)
        v->turn += STEP;
    else if (k == KEY_UP && v->tilt < MOST)
        v->tilt += STEP;
    else if (k == KEY_DOWN && v->tilt > -MOST)
        v->tilt -= STEP;
}

static float draw(void *ctx, struct stage *stage, float seconds)
{
    struct state *s = ctx;
    if (!s->paused)
        s->within += seconds - s->last;
    s->last = seconds;
    if (s->within > chapters[s->chapter].lasts)
        go(s, 1);
    chapters[s->chapter].draw(stage, s->within, s->viewer);
    return 0;
}

static struct state state;

extern const struct lesson lesson_space;
const struct lesson lesson_space = {"space",
                                    "Space and projections",
                                    "space next  b back  p pause  arrows: viewer",
                                    &state,
                                    begin,
                                    key,
                                    draw};
