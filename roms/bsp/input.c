#include "roms/bsp/input.h"

#include <stddef.h>

#include "emu/memmap.h"
#include "roms/bsp/board.h"
#include "roms/bsp/interrupts.h"

static struct {
    void (*call)(void *ctx);
    void *ctx;
} handlers[6];
static uint32_t mouse_x, mouse_y;

static volatile uint32_t *at(uint32_t offset)
{
    return (volatile uint32_t *)(uintptr_t)(MAP_INPUT + offset);
}

/* Boards without these registers have nothing at the address. */
static uint32_t get(uint32_t offset)
{
    return board_is_knsc() ? *at(offset) : 0;
}

static void put(uint32_t offset, uint32_t value)
{
    if (board_is_knsc())
        *at(offset) = value;
}

uint32_t input_present(void)
{
    return get(INPUT_PRESENT);
}

uint32_t input_status(void)
{
    return get(INPUT_STATUS);
}

static void on_line(void *ctx)
{
    (void)ctx;
    uint32_t due = get(INPUT_STATUS) & get(INPUT_IRQ_ENABLE);
    for (unsigned i = 0; i < sizeof handlers / sizeof *handlers; i++)
        if ((due >> i & 1) && handlers[i].call)
            handlers[i].call(handlers[i].ctx);
}

void input_on(uint32_t bit, void (*handler)(void *ctx), void *ctx)
{
    uint32_t state = irq_lock();
    uint32_t enabled = get(INPUT_IRQ_ENABLE);
    for (unsigned i = 0; i < sizeof handlers / sizeof *handlers; i++)
        if (bit == 1u << i) {
            handlers[i].call = handler;
            handlers[i].ctx = ctx;
        }
    put(INPUT_IRQ_ENABLE, handler ? enabled | bit : enabled & ~bit);
    irq_attach(IRQ_LINE_INPUT, on_line, NULL);
    irq_enable(IRQ_LINE_INPUT);
    irq_unlock(state);
}

/* ---- light pens ------------------------------------------------------------------------------- */

void pen_raster_on(bool only_pressed)
{
    put(INPUT_PEN_RASTER + PEN_STATUS, PEN_HIT | PEN_LOST);
    put(INPUT_PEN_RASTER + PEN_CONTROL, PEN_ENABLE | (only_pressed ? PEN_TIP_ENABLE : 0));
}

void pen_raster_off(void)
{
    put(INPUT_PEN_RASTER + PEN_CONTROL, 0);
    put(INPUT_PEN_RASTER + PEN_STATUS, PEN_HIT | PEN_LOST);
}

bool pen_hit_take(struct pen_hit *hit)
{
    uint32_t status = get(INPUT_PEN_RASTER + PEN_STATUS);
    if (!(status & PEN_HIT))
        return false;
    hit->line = get(INPUT_PEN_RASTER + PEN_LINE);
    hit->dot = get(INPUT_PEN_RASTER + PEN_DOT);
    hit->field = get(INPUT_PEN_RASTER + PEN_FIELD);
    hit->lost = status & PEN_LOST;
    put(INPUT_PEN_RASTER + PEN_STATUS, PEN_HIT | PEN_LOST);
    return true;
}

static uint32_t block_of(enum input_head head)
{
    return head == INPUT_RASTER ? INPUT_PEN_RASTER : INPUT_PEN_VECTOR;
}

bool pen_tip(enum input_head head)
{
    return get(block_of(head) + PEN_STATUS) & PEN_TIP;
}

bool pen_tip_moved(enum input_head head)
{
    bool moved = get(block_of(head) + PEN_STATUS) & PEN_TIP_MOVED;
    put(block_of(head) + PEN_STATUS, moved ? PEN_TIP_MOVED : 0);
    return moved;
}

/* ---- tablet ------------------------------------------------------------------------------------- */

struct tablet_facts tablet_facts(void)
{
    return (struct tablet_facts){get(INPUT_TABLET_KIND), get(INPUT_TABLET_UNIT),
                                 get(INPUT_TABLET_WIDTH), get(INPUT_TABLET_HEIGHT),
                                 get(INPUT_TABLET_RATE)};
}

void tablet_on(bool latest)
{
    put(INPUT_TABLET_CONTROL, TABLET_ON | (latest ? TABLET_LATEST : 0));
}

void tablet_off(void)
{
    put(INPUT_TABLET_CONTROL, 0);
    put(INPUT_TABLET_STATUS, TABLET_REPORT | TABLET_LOST);
}

bool tablet_take(struct tablet_report *report)
{
    uint32_t status = get(INPUT_TABLET_STATUS);
    if (!(status & TABLET_REPORT))
        return false;
    report->x = (int32_t)get(INPUT_TABLET_X);
    report->y = (int32_t)get(INPUT_TABLET_Y);
    report->z = (int32_t)get(INPUT_TABLET_Z);
    report->proximity = get(INPUT_TABLET_PROXIMITY);
    report->buttons = get(INPUT_TABLET_BUTTONS);
    report->serial = get(INPUT_TABLET_SERIAL);
    report->lost = status & TABLET_LOST;
    put(INPUT_TABLET_STATUS, TABLET_REPORT | TABLET_LOST);
    return true;
}

uint32_t tablet_raw(unsigned word)
{
    return word < TABLET_RAW_WORDS ? get(INPUT_TABLET_RAW + 4 * word) : 0;
}

/* ---- touch panel -------------------------------------------------------------------------------- */

struct touch_facts touch_facts(void)
{
    return (struct touch_facts){get(INPUT_TOUCH_KIND),
                                get(INPUT_TOUCH_HEAD) ? INPUT_RASTER : INPUT_VECTOR,
                                get(INPUT_TOUCH_COLUMNS), get(INPUT_TOUCH_ROWS)};
}

void touch_on(bool latest)
{
    put(INPUT_TOUCH_CONTROL, TOUCH_ON | (latest ? TOUCH_LATEST : 0));
}

void touch_off(void)
{
    put(INPUT_TOUCH_CONTROL, 0);
    put(INPUT_TOUCH_STATUS, TOUCH_REPORT | TOUCH_LOST);
}

bool touch_take(struct touch_report *report)
{
    uint32_t status = get(INPUT_TOUCH_STATUS);
    if (!(status & TOUCH_REPORT))
        return false;
    report->touched = status & TOUCH_TOUCHED;
    report->unsure = status & TOUCH_UNSURE;
    report->lost = status & TOUCH_LOST;
    report->x = get(INPUT_TOUCH_X);
    report->y = get(INPUT_TOUCH_Y);
    report->x_um =
        (int32_t)get(INPUT_TOUCH_LEFT) + (int32_t)(report->x * get(INPUT_TOUCH_PITCH_X) / 2);
    report->y_um =
        (int32_t)get(INPUT_TOUCH_BOTTOM) + (int32_t)(report->y * get(INPUT_TOUCH_PITCH_Y) / 2);
    report->serial = get(INPUT_TOUCH_SERIAL);
    put(INPUT_TOUCH_STATUS, TOUCH_REPORT | TOUCH_LOST);
    return true;
}

/* ---- keyboard ----------------------------------------------------------------------------------- */

void keyboard_on(bool console)
{
    put(INPUT_KEY_CONTROL, KEY_STORE | (console ? KEY_CONSOLE : 0));
}

void keyboard_off(void)
{
    put(INPUT_KEY_CONTROL, KEY_CONSOLE);
}

bool key_take(struct key_event *event)
{
    uint32_t word = get(INPUT_KEY_EVENT);
    if (!(word & KEY_VALID))
        return false;
    event->character = (uint8_t)(word & KEY_ASCII);
    event->code = (uint8_t)((word & KEY_CODE) >> 8);
    event->modifiers = (uint8_t)((word & KEY_MODIFIERS) >> 16);
    event->up = word & KEY_UP;
    event->repeat = word & KEY_REPEAT;
    return true;
}

bool key_lost(void)
{
    bool lost = get(INPUT_KEY_STATUS) & KEY_LOST;
    if (lost)
        put(INPUT_KEY_STATUS, KEY_LOST);
    return lost;
}

/* ---- mouse -------------------------------------------------------------------------------------- */

unsigned mouse_kind(void)
{
    return get(INPUT_MOUSE_KIND);
}

uint32_t mouse_unit_nm(void)
{
    return get(INPUT_MOUSE_UNIT);
}

bool mouse_read(struct mouse_state *state)
{
    uint32_t status = get(INPUT_MOUSE_STATUS);
    put(INPUT_MOUSE_STATUS, status & (MOUSE_MOVED | MOUSE_OVERRUN));
    uint32_t x = get(INPUT_MOUSE_X), y = get(INPUT_MOUSE_Y);
    state->dx = (int32_t)(x - mouse_x);
    state->dy = (int32_t)(y - mouse_y);
    state->buttons = get(INPUT_MOUSE_BUTTONS);
    state->overrun = status & MOUSE_OVERRUN;
    mouse_x = x;
    mouse_y = y;
    return status & MOUSE_MOVED;
}
