#include "roms/monitor/lesson_run.h"

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"

enum { ESCAPE = 27 };

/* A key, or -1 when none came until `until`. */
static int key_until(uint64_t until, bool forever)
{
    for (;;) {
        int c = console_poll();
        if (c >= 0 || (!forever && timer_now() >= until))
            return c;
        timer_sleep(TIMER_HZ / 500);
    }
}

/* At the end of input: somebody may look on. */
static bool runs_on(void)
{
    return board_has_vector_head() || board_has_raster_head();
}

void lesson_run(struct monitor *m, const struct lesson *lesson)
{
    uint64_t start = timer_now();
    lesson->begin(lesson->state);
    for (;;) {
        stage_begin(&m->stage);
        float again =
            lesson->draw(lesson->state, &m->stage, (float)(timer_now() - start) / TIMER_HZ);
        stage_end(&m->stage);
        int c = key_until(timer_now() + (uint64_t)(again > 0 ? again * TIMER_HZ : 0), again < 0);
        if (c == CONSOLE_EOF && runs_on())
            continue;
        if (c == 'q' || c == ESCAPE || c == CONSOLE_EOF)
            return;
        if (c >= 0)
            lesson->key(lesson->state, c);
    }
}
