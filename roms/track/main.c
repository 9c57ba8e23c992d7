/* track — a tracking cross follows the light pen on the vector head.
 *
 *      kinescope run roms/track.elf --view vector
 *      kinescope run roms/track.elf --input roms/track.script --headless --console
 *
 * The pen takes the cross up by pointing at it. Its trail, its speed and what the four strokes of the
 * cross saw are shown; pressed against the glass it draws. A line on the console for each change of state,
 * and where the pen came to rest.
 *
 * Keys: s scans the screen for the pen, p prediction off and on, c clears the drawing, q figures and end.
 * Marks: 1 when the first picture is shown.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/interrupts.h"
#include "roms/track/track.h"

/* The vector head's tube, unless another is asked for: a pen sees how fast light comes, and P39 is slow. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

struct program {
    struct stage stage;
    struct tracking tracking;
    struct course course;
    struct strokes strokes;
};

static void taken(void *ctx, const struct tracking_sample *sample)
{
    struct program *p = ctx;
    course_take(&p->course, sample, &p->tracking);
    strokes_take(&p->strokes, sample);
}

static void show(struct program *p)
{
    stage_begin(&p->stage);
    view_draw(&p->stage, &p->tracking, &p->course, &p->strokes);
    stage_chain(&p->stage, p->tracking.low);
    stage_end(&p->stage);
}

/* False: that is all. */
static bool obey(struct program *p, int key)
{
    switch (key) {
    case 's':
        printf("track scans\n");
        tracking_scan(&p->tracking);
        return true;
    case 'p':
        p->tracking.predicts = !p->tracking.predicts;
        printf("track %s\n", p->tracking.predicts ? "predicts" : "does not predict");
        return true;
    case 'c':
        strokes_clear(&p->strokes);
        return true;
    case 'q':
        return false;
    default:
        return true;
    }
}

int main(void)
{
    static struct program p;
    if (!board_has_vector_head()) {
        console_write("track: this board has no vector head.\n");
        return 1;
    }
    stage_open(&p.stage);
    tracking_begin(&p.tracking, STAGE_FREE_LOW, 0);
    p.tracking.place = taken;
    p.tracking.place_ctx = &p;
    show(&p);
    board_mark(1);
    while (obey(&p, console_poll()))
        if (tracking_frame(&p.tracking))
            show(&p);
    course_summary(&p.course, &p.tracking);
    return 0;
}
