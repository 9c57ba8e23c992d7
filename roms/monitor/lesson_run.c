#include "roms/monitor/lesson_run.h"

#include <stdio.h>

#include "roms/bsp/timer.h"
#include "roms/monitor/keys.h"

static void prompt(struct stage *stage, const struct lesson *lesson)
{
    char text[STAGE_PROMPT + 1];
    snprintf(text, sizeof text, "q back%s%s", lesson->keys[0] != '\0' ? "   " : "", lesson->keys);
    stage_prompt(stage, text);
}

/* Draws it; when it is to be drawn again. */
static uint64_t draw(struct monitor *m, const struct lesson *lesson, uint64_t start)
{
    stage_begin(&m->stage);
    float again = lesson->draw(lesson->state, &m->stage, (float)(timer_now() - start) / TIMER_HZ);
    stage_end(&m->stage);
    return again < 0 ? KEYS_FOREVER : timer_now() + (uint64_t)(again * TIMER_HZ);
}

void lesson_run(struct monitor *m, const struct lesson *lesson)
{
    uint64_t start = timer_now();
    printf("%s. Keys: q leaves%s%s\n", lesson->title, lesson->keys[0] != '\0' ? "   " : "",
           lesson->keys);
    prompt(&m->stage, lesson);
    lesson->begin(lesson->state);
    for (;;) {
        int key = keys_next(draw(m, lesson, start));
        if (key == 'q' || key == KEYS_ESCAPE || key == KEYS_INPUT_END)
            return;
        if (key != KEYS_NONE)
            lesson->key(lesson->state, key);
    }
}
