#include "roms/monitor/keys.h"

#include <stdbool.h>

#include "emu/memmap.h"
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"
#include "roms/bsp/uart_regs.h"

enum { PATIENCE = TIMER_HZ / 50, DELETE = 127 };

/* The last byte was the end of input. */
static bool ended;

static volatile uint8_t *uart(uint32_t offset)
{
    return (volatile uint8_t *)(MAP_UART + offset);
}

/* The line drops when its source is disabled. */
static void on_byte(void *ctx)
{
    (void)ctx;
    *uart(UART_IER) = 0;
}

static void on_time(void *ctx)
{
    (void)ctx;
}

/* Waits for a byte or for the time; either may be a little early. */
static void doze(uint64_t until)
{
    struct timer timer = {.callback = on_time};
    uint64_t now = timer_now();
    if (now >= until)
        return;
    if (!board_is_knsc()) { /* its interrupt controller is another */
        timer_sleep(TIMER_HZ / 1000);
        return;
    }
    irq_attach(IRQ_LINE_UART, on_byte, 0);
    irq_enable(IRQ_LINE_UART);
    if (until != KEYS_FOREVER)
        timer_once(&timer, until - now);
    uint32_t state = irq_lock();
    *uart(UART_IER) = UART_IER_RECEIVED;
    if ((*uart(UART_LSR) & UART_LSR_RECEIVED) == 0)
        irq_wait();
    irq_unlock(state);
    *uart(UART_IER) = 0;
    timer_stop(&timer);
}

static int byte_by(uint64_t until)
{
    for (;;) {
        int c = console_poll();
        if (c >= 0)
            ended = c == KEYS_INPUT_END;
        if (c >= 0 || timer_now() >= until)
            return c;
        doze(until);
    }
}

/* Behind ESC. */
static int sequence(void)
{
    int c = byte_by(timer_now() + PATIENCE);
    if (c < 0 || c == KEYS_INPUT_END) /* that is told next */
        return KEYS_ESCAPE;
    if (c != '[' && c != 'O')
        return KEY_OTHER;
    int number = 0;
    while (((c = byte_by(timer_now() + PATIENCE)) >= '0' && c <= '9') || c == ';')
        number = number < 100 ? 10 * number + c - '0' : number;
    switch (c) {
    case '~':
        return number == 5 ? KEY_PAGE_UP : number == 6 ? KEY_PAGE_DOWN : KEY_OTHER;
    case 'A':
        return KEY_UP;
    case 'B':
        return KEY_DOWN;
    case 'C':
        return KEY_RIGHT;
    case 'D':
        return KEY_LEFT;
    case 'H':
        return KEY_HOME;
    case 'F':
        return KEY_END;
    default:
        return KEY_OTHER;
    }
}

static int key_of(int c)
{
    switch (c) {
    case -1:
        return KEYS_NONE;
    case KEYS_ESCAPE:
        return sequence();
    case DELETE:
        return KEYS_BACKSPACE;
    default:
        return c;
    }
}

int keys_next(uint64_t until)
{
    int key = key_of(byte_by(ended ? 0 : until));
    return key == KEYS_NONE && ended ? KEYS_INPUT_END : key;
}
