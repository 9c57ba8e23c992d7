/* calibrate — how late is the light pen of the raster head?
 *
 *      kinescope run roms/calibrate.elf                          with the mouse as a pen
 *      kinescope run roms/calibrate.elf --mode 1024x768@60       another dot clock: more dots
 *      kinescope run roms/calibrate.elf --input roms/calibrate.script
 *
 * Nine targets are pressed with the pen, one after the other, then four more, which check what has been
 * found. The figures are printed; programs hand them to pointer_calibrate (roms/interact/pointer.h).
 *
 * Marks: n when target n has been measured; 100 when all is done.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/interrupts.h"
#include "roms/calibrate/calibrate.h"
#include "roms/stage/ink.h"

extern const char kinescope_hand[];
const char kinescope_hand[] = "pen"; /* what the mouse stands for in the window */

enum { DONE = 100, ROWS_OF_LARGE_TEXT = 700 };

static bool open_head(struct calibration *c)
{
    c->timing = video_timing();
    c->page[0] = video_open(8);
    if (c->page[0].height == 0 ||
        2 * c->page[0].pitch * (uint32_t)c->page[0].height > VIDEO_BUFFER_BYTES)
        return false;
    c->page[1] = video_page(&c->page[0], 1);
    c->scale = c->page[0].height >= ROWS_OF_LARGE_TEXT ? 2 : 1;
    for (unsigned i = 0; i < INK_ENTRIES; i++)
        video_set_colour(i, ink_rgb(i));
    canvas_clear(&c->page[0], INK_BLACK);
    video_on();
    return true;
}

/* ---- firings ----------------------------------------------------------------------------------------- */

/* One firing a row: none may wait for the next one. */
static void fired(void *ctx)
{
    struct pen_rows *coming = ctx;
    struct pen_hit hit;
    pen_tip_moved(INPUT_RASTER);
    while (pen_hit_take(&hit))
        if (!pen_rows_add(coming, &hit)) {
            coming->count = 0;
            pen_rows_add(coming, &hit);
        }
}

/* In retrace: those of the field that has just ended. */
static struct pen_rows field(struct pen_rows *coming)
{
    video_wait_retrace();
    uint32_t state = irq_lock();
    struct pen_rows rows = *coming;
    coming->count = 0;
    irq_unlock(state);
    return rows;
}

static void wait_for_release(struct pen_rows *coming)
{
    while (pen_tip(INPUT_RASTER))
        field(coming);
}

static void measure(struct calibration *c, struct pen_rows *coming, int number)
{
    struct firings firings = {0};
    struct place *place = &c->place[number];
    int drawn = -1;
    picture_target(c, number);
    for (bool done = false; !done;) {
        struct pen_rows rows = field(coming);
        done = measure_field(c, &firings, place, pen_tip(INPUT_RASTER), &rows);
        int now = done ? HITS : firings.count;
        if (now != drawn)
            picture_progress(c, number, now);
        drawn = now;
    }
    measure_left(c, place);
    board_mark((uint32_t)number + 1);
    wait_for_release(coming);
}

/* The pen draws, corrected, over the results. */
static void play(const struct calibration *c, struct pen_rows *coming)
{
    pen_raster_on(false);
    for (;;) {
        int key = console_poll();
        float line, dot;
        if (key == 'q' || key == CONSOLE_EOF)
            return;
        struct pen_rows rows = field(coming);
        if (pen_rows_middle(&rows, &line, &dot, NULL))
            picture_pen(c, dot, line, pen_tip(INPUT_RASTER));
    }
}

int main(void)
{
    static struct calibration calibration;
    static struct pen_rows coming;
    struct calibration *c = &calibration;
    if (!(input_present() & INPUT_BIT_PEN_RASTER) || !open_head(c)) {
        console_write("calibrate: this board has no light pen at a raster head.\n");
        return 1;
    }
    targets_place(c);
    report_begin(c);
    input_on(INPUT_BIT_PEN_RASTER, fired, &coming);
    pen_raster_on(true);
    for (int i = 0; i < TARGETS; i++)
        measure(c, &coming, i);
    measure_offset(c);
    report_offset(c);
    for (int i = TARGETS; i < PLACES; i++)
        measure(c, &coming, i);
    report_checks(c);
    picture_results(c);
    field(&coming); /* on the screen */
    board_mark(DONE);
    play(c, &coming);
    return 0;
}
