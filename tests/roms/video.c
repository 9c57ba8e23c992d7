/* video — calls everything of roms/bsp/video.h and says what came of it. For tests. */
#include <stdbool.h>
#include <stdio.h>

#include "roms/bsp/video.h"

static void timing(const char *when)
{
    struct video_timing t = video_timing();
    printf("%s: %lux%lu of %lux%lu, %lu Hz, line %lu field %lu mHz\n", when,
           (unsigned long)t.h_visible, (unsigned long)t.v_visible, (unsigned long)t.h_total,
           (unsigned long)t.v_total, (unsigned long)t.clock_hz,
           (unsigned long)video_line_millihertz(&t), (unsigned long)video_field_millihertz(&t));
}

static void set(const char *what, const struct video_timing *t)
{
    printf("%s: %s\n", what, video_set_timing(t) ? "taken" : "refused");
    timing("then");
}

static void timings(void)
{
    struct video_timing own = video_timing(), t = own;
    timing("at first");
    t.h_total = 0;
    set("impossible", &t);
    t = own;
    t.clock_hz = 300000000;
    set("too fast", &t);
    t = (struct video_timing){31500000, 640, 656, 720, 840, 480, 481, 484, 500, 0};
    set("640x480@75", &t);
    set("its own", &own);
}

static void pages(void)
{
    static const unsigned formats[] = {1, 2, 4, 8, 16, 32};
    for (unsigned i = 0; i < 6; i++) {
        struct canvas c = video_open(formats[i]), second = video_page(&c, 1);
        canvas_clear(&second, 1);
        printf("%u bits: %d by %d, pitch %lu, second page %lu on\n", c.bits, c.width, c.height,
               (unsigned long)c.pitch, (unsigned long)(second.pixels - c.pixels));
    }
}

struct seen {
    volatile uint32_t count, row;
};

static void at_row(void *ctx)
{
    struct seen *seen = ctx;
    seen->row = video_beam_row();
    seen->count++;
    video_compare(seen->count < 3 ? 100 + 7 * seen->count : VIDEO_NO_ROW);
}

static void at_retrace(void *ctx)
{
    ((struct seen *)ctx)->count++;
}

static void beam(void)
{
    static struct seen rows, retraces;
    struct canvas c = video_open(8);
    video_wait_retrace(); /* while it is off: returns at once */
    printf("off: row %lu dot %lu, %lu retraces\n", (unsigned long)video_beam_row(),
           (unsigned long)video_beam_dot(), (unsigned long)video_retraces());
    video_on_row(at_row, &rows);
    video_on_retrace(at_retrace, &retraces);
    video_compare(100);
    video_on();
    for (int i = 0; i < 3; i++)
        video_wait_retrace();
    bool below = video_beam_row() >= (uint32_t)c.height; /* before anything is printed */
    printf("rows: %lu, the last in row %lu\n", (unsigned long)rows.count, (unsigned long)rows.row);
    printf("retraces: %lu and %lu, below the picture: %s\n", (unsigned long)video_retraces(),
           (unsigned long)retraces.count, below ? "yes" : "no");
    video_on_retrace(NULL, NULL);
    video_wait_retrace();
    printf("and then: %lu and %lu\n", (unsigned long)video_retraces(),
           (unsigned long)retraces.count);
    video_off();
    video_wait_retrace();
    printf("off again: %lu\n", (unsigned long)video_retraces());
}

int main(void)
{
    printf("raster head: %s, %lu by %lu um\n", video_present() ? "yes" : "no",
           (unsigned long)video_width_um(), (unsigned long)video_height_um());
    timings();
    pages();
    video_set_colour(3, 0x123456);
    video_set_colour(999, 0x123456);
    video_set_overscan(0x123456);
    beam();
    return 0;
}
