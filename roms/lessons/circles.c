/* circles.c — to be written. */
#include "roms/lessons/lesson.h"

static void begin(void *state)
{
    (void)state;
}

static void key(void *state, int k)
{
    (void)state;
    (void)k;
}

static float draw(void *state, struct stage *stage, float seconds)
{
    (void)state;
    (void)seconds;
    stage_title(stage, "Circles and ellipses");
    return -1;
}

extern const struct lesson lesson_circles;
const struct lesson lesson_circles = {"circles", "Circles and ellipses", "", 0, begin, key, draw};
