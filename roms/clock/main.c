/* clock — an analogue clock: firmware rewrites a display file while it is being refreshed.
 *
 * The dial is written once. Sixty times a second the hands are written into the part of display
 * memory that is not shown, and one store, to the address of a jump, shows them (flip.h): no refresh
 * ever shows half of the old hands and half of the new. The time is mtime's: 0 is 24 seconds past
 * nine past ten, when the hands frame the name.
 *
 * Marks: n when the n-th second since power-on is shown first, 0 for the first picture.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/flip.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"
#include "roms/clock/clock.h"

#define START ((10 * 60 + 9) * 60 + 24)

struct clock {
    struct flip flip;
    uint32_t shown; /* the last second shown since power-on */
};

static void update(void *ctx)
{
    struct clock *clock = ctx;
    struct display d;
    if (!flip_draw(&clock->flip, &d))
        return; /* the beam is still there: next time */
    uint64_t now = timer_now();
    uint32_t second = (uint32_t)(now / TIMER_HZ);
    clock_hands(&d, START + second, (float)(now % TIMER_HZ) / (float)TIMER_HZ);
    flip_show(&clock->flip, &d);
    if (second != clock->shown) {
        clock->shown = second;
        board_mark(second);
    }
}

int main(void)
{
    static struct clock clock = {.shown = UINT32_MAX};
    static struct timer timer = {.callback = update, .ctx = &clock};
    if (!board_has_vector_head()) {
        console_write("clock: this board has no vector head.\n");
        return 1;
    }
    struct display still = flip_begin(&clock.flip, 0);
    clock_dial(&still);
    flip_start(&clock.flip, &still);
    update(&clock);
    timer_every(&timer, TIMER_HZ / 60);
    irq_lock();
    for (;;)
        irq_wait();
}
