/* bounce — a figure that flies about in a room, moved by the timer interrupt.
 *
 * The timer moves the body 120 times a second, by the same amount each time, whatever else happens,
 * and every second time shows it (flip.h). Between interrupts the processor waits.
 *
 * Marks: n at the n-th bounce.
 */
#include "roms/bounce/bounce.h"
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/flip.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"

enum { STEPS = 120 /* a second */ };

struct scene {
    struct flip flip;
    struct body body;
    unsigned steps;
};

static void step(void *ctx)
{
    struct scene *scene = ctx;
    struct display d;
    if (body_move(&scene->body, 1.0f / STEPS))
        board_mark(scene->body.bounces);
    if (++scene->steps % 2 == 0 && flip_draw(&scene->flip, &d)) {
        draw_body(&d, &scene->body);
        flip_show(&scene->flip, &d);
    }
}

int main(void)
{
    static struct scene scene;
    static struct timer timer = {.callback = step, .ctx = &scene};
    if (!board_has_vector_head()) {
        console_write("bounce: this board has no vector head.\n");
        return 1;
    }
    body_init(&scene.body);
    struct display still = flip_begin(&scene.flip, 0);
    draw_room(&still);
    flip_start(&scene.flip, &still);
    timer_every(&timer, TIMER_HZ / STEPS);
    irq_lock();
    for (;;)
        irq_wait();
}
