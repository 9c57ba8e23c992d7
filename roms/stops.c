/* stops — counts the stop interrupts of a display file that does not wait for the sync tick.
 *
 * Lesson: how often a picture is refreshed follows from how long its display file takes. Each refresh
 * ends in a stop; the handler of its interrupt writes the new count into the display file, which nobody
 * fetches just then, and starts it again. After a second the console says how many there were.
 *
 * Marks: 1 when the second is over.
 */
#include <math.h>
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/display.h"
#include "roms/bsp/dpu.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"

enum {
    MIDDLE = 512,
    RADIUS = 490,
    CORNERS = 48, /* of the star; each is joined to the 17th after it */
    STEP = 17,
    WIDTH = 60, /* of a digit, with room of 24 after it */
    HEIGHT = 110,
    PITCH = 84,
    ROOM = 0x2000, /* for the display file, bytes */
};

struct count {
    struct display digits; /* the writer where the digits begin */
    unsigned stops;
    volatile bool over;
};

static void star(struct display *d)
{
    display_intensity(d, 3);
    for (int i = 0; i <= CORNERS; i++) {
        float angle = 6.2831853f * (float)(i * STEP % CORNERS) / CORNERS;
        int x = MIDDLE + (int)lrintf(RADIUS * sinf(angle));
        int y = MIDDLE + (int)lrintf(RADIUS * cosf(angle));
        if (i == 0)
            display_at(d, x, y);
        else
            display_line(d, x, y);
    }
}

/* Seven segments: bit n of a digit's row is segment n. */
static void digit(struct display *d, int x, int y, unsigned value)
{
    static const unsigned char rows[] = {0x77, 0x24, 0x5D, 0x6D, 0x2E,
                                         0x6B, 0x7B, 0x25, 0x7F, 0x6F};
    static const struct {
        signed char x0, y0, x1, y1; /* in widths and half heights */
    } segments[] = {{0, 2, 1, 2}, {0, 1, 0, 2}, {1, 1, 1, 2}, {0, 1, 1, 1},
                    {0, 0, 0, 1}, {1, 0, 1, 1}, {0, 0, 1, 0}};
    for (unsigned i = 0; i < 7; i++) {
        if ((rows[value] >> i & 1) == 0)
            continue;
        display_at(d, x + segments[i].x0 * WIDTH, y + segments[i].y0 * HEIGHT / 2);
        display_line(d, x + segments[i].x1 * WIDTH, y + segments[i].y1 * HEIGHT / 2);
    }
}

/* The digits and the end of the file, from where the star ends. */
static void write_digits(const struct count *count)
{
    struct display d = count->digits;
    unsigned rest = count->stops;
    int digits = 1;
    for (unsigned n = rest; n >= 10; n /= 10)
        digits++;
    int x = MIDDLE + (digits * PITCH - (PITCH - WIDTH)) / 2 - WIDTH; /* of the last */
    display_intensity(&d, 7);
    for (; digits > 0; digits--, x -= PITCH, rest /= 10)
        digit(&d, x, MIDDLE - HEIGHT / 2, rest % 10);
    display_stop(&d);
}

static void stopped(void *ctx)
{
    struct count *count = ctx;
    if (count->over)
        return;
    count->stops++;
    write_digits(count);
    board_refresh(count->stops);
    dpu_start(0);
}

static void second_is_over(void *ctx)
{
    struct count *count = ctx;
    count->over = true;
}

int main(void)
{
    static struct count count;
    static struct timer timer = {.callback = second_is_over, .ctx = &count};
    display_begin(&count.digits, 0, ROOM);
    star(&count.digits);
    write_digits(&count);
    dpu_on_stop(stopped, &count);

    uint32_t state = irq_lock();
    timer_once(&timer, TIMER_HZ);
    board_refresh(0);
    dpu_start(0);
    while (!count.over)
        irq_wait();
    irq_unlock(state);

    board_mark(1);
    printf("%u stops in a second", count.stops);
    if (count.stops > 0)
        printf(": a refresh takes %u us", 1000000 / count.stops);
    printf(".\n");
    return 0;
}
