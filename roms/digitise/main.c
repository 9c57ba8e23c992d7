/* digitise — a drawing on the tablet becomes coordinates.
 *
 *      kinescope run roms/digitise.elf --console
 *      kinescope capture roms/digitise.elf --input roms/digitise.script -o outline.png
 *
 * First the paper is placed: touch points whose coordinates are known (0 0, 200 0, 0 150 unless others
 * are typed: = 30 40 Enter), two at least. Then p points, l lines of points, s a stream while the stylus
 * touches; h shows heights. Each point is the mean of what is measured while the stylus rests on it, and
 * the panel says how much that scatters. Buttons of a puck: enter, new line, delete last, close. w writes
 * a table onto the console.
 *
 * Marks: n when the n-th picture is shown.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"
#include "roms/digitise/table.h"
#include "roms/digitise/view.h"

/* The vector head's tube, unless another is asked for: P39 glows on for long. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

struct program {
    struct stage stage;
    struct reports reports;
    struct session session;
};

static void put(void *ctx, const char *line)
{
    (void)ctx;
    console_write(line);
}

static bool take(struct program *p)
{
    struct report report;
    bool any = false;
    while (reports_take(&p->reports, &report)) {
        session_report(&p->session, &report);
        any = true;
    }
    return any;
}

static bool typed(struct program *p)
{
    bool any = false;
    for (int c; (c = console_poll()) >= 0; any = true)
        session_key(&p->session, c);
    return any;
}

static void console(struct program *p)
{
    struct session *s = &p->session;
    if (s->print)
        table_write(s, put, 0);
    s->print = false;
    if (s->quit) {
        console_drain();
        board_exit(0);
    }
}

static void draw(struct program *p)
{
    stage_begin(&p->stage);
    view_draw(&p->session, &p->stage);
    stage_end(&p->stage);
    board_mark(p->stage.pictures);
}

int main(void)
{
    static struct program p;
    struct tablet_facts facts = tablet_facts();
    stage_open(&p.stage);
    session_begin(&p.session, &facts);
    reports_open(&p.reports);
    draw(&p);
    for (;;) {
        bool reports = take(&p), keys = typed(&p);
        console(&p);
        if (reports || keys)
            draw(&p);
        else
            timer_sleep(TIMER_HZ / 250);
    }
}
