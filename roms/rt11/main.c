/* rt11 — serves the display file loaded beside it with subroutines, names and status (handler.h).
 *
 *      kinescope run roms/village.df
 *
 * The processor waits between interrupts; what there is to say it says on the console: a pen hit, a
 * halt, trouble (exit status 1).
 *
 * Marks: 1 when the first refresh has begun, 2 at a halt.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/interrupts.h"
#include "roms/rt11/handler.h"

static void tell_hit(struct rt11 *handler)
{
    const struct rt11_status *pen = &handler->pen;
    printf("Pen: name %o, subroutine %06o, at %u, %u.\n", pen->name, pen->tag, pen->x, pen->y);
    handler->pen.flag = 0;
}

/* Sleeps until the handler has news; sleeping and looking must not let one slip between. */
static void wait_for_news(const struct rt11 *handler)
{
    uint32_t state = irq_lock();
    if (handler->pen.flag == 0 && !handler->halted)
        irq_wait();
    irq_unlock(state);
}

static int serve(struct rt11 *handler)
{
    bool begun = false;
    while (!handler->halted) {
        wait_for_news(handler);
        if (!begun && handler->refreshes > 0) {
            board_mark(1);
            begun = true;
        }
        if (handler->pen.flag != 0)
            tell_hit(handler);
    }
    if (handler->trouble == RT11_FINE) {
        printf("The display file has halted the display.\n");
        board_mark(2);
        irq_lock();
        for (;;)
            irq_wait();
    }
    printf("rt11: %s, at %06lo.\n", rt11_trouble_text(handler->trouble),
           (unsigned long)handler->where);
    return 1;
}

int main(void)
{
    static struct rt11 handler;
    if (!board_has_vector_head() || board_entry() == BOARD_NO_ENTRY) {
        console_write("rt11: there is no display file to serve here; run one that asks for this "
                      "firmware.\n");
        return 1;
    }
    rt11_start(&handler, board_entry());
    return serve(&handler);
}
