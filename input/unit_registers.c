/* unit_registers.c — the input unit as the processor sees it: whose block an offset lies in, the registers of
 * the pens and of the unit itself. */
#include "input/unit_parts.h"

static const uint32_t pen_block[INP_SCREENS] = {INPUT_PEN_VECTOR, INPUT_PEN_RASTER};
#define PEN_BLOCK_SIZE 0x40

static bool read_pen(const struct inp_unit *unit, int screen, uint32_t offset, uint32_t *value)
{
    const struct inp_pen_port *port = &unit->port[screen];
    switch (offset) {
    case PEN_STATUS:
        *value = port->status | (unit->pen[screen].tip ? PEN_TIP : 0);
        return true;
    case PEN_CONTROL:
        *value = port->control;
        return true;
    case PEN_LINE:
        *value = port->line;
        return true;
    case PEN_DOT:
        *value = port->dot;
        return true;
    case PEN_FIELD:
        *value = port->field;
        return true;
    case PEN_FIRINGS:
        *value = port->firings;
        return true;
    default:
        return false;
    }
}

static bool write_pen(struct inp_unit *unit, int screen, uint32_t offset, uint32_t value)
{
    struct inp_pen_port *port = &unit->port[screen];
    if (offset == PEN_STATUS)
        port->status &= ~(value & (PEN_HIT | PEN_LOST | PEN_TIP_MOVED));
    else if (offset == PEN_CONTROL)
        port->control = screen == INP_RASTER && inp_unit_has_pen(unit, screen)
                            ? value & (PEN_ENABLE | PEN_TIP_ENABLE)
                            : 0;
    else
        return offset <= PEN_FIRINGS && offset % 4 == 0;
    return true;
}

static bool read_unit(const struct inp_unit *unit, uint32_t offset, uint32_t *value)
{
    switch (offset) {
    case INPUT_STATUS:
        *value = inp_unit_status(unit);
        return true;
    case INPUT_IRQ_ENABLE:
        *value = unit->enable;
        return true;
    case INPUT_PRESENT:
        *value = inp_unit_present(unit);
        return true;
    default:
        return false;
    }
}

/* The pen whose block an offset lies in; −1: none. */
static int pen_at(uint32_t offset)
{
    for (int s = 0; s < INP_SCREENS; s++)
        if (offset >= pen_block[s] && offset - pen_block[s] < PEN_BLOCK_SIZE)
            return s;
    return -1;
}

/* The INPUT_STATUS bit of the device whose block an offset lies in; 0: the unit itself. */
static uint32_t bit_at(uint32_t offset)
{
    static const uint32_t bits[] = {
        0, 0, INPUT_BIT_TABLET, INPUT_BIT_TOUCH, INPUT_BIT_KEYBOARD, INPUT_BIT_MOUSE};
    int screen = pen_at(offset);
    if (screen >= 0)
        return inp_pen_bit[screen];
    return offset >> 8 < sizeof bits / sizeof *bits ? bits[offset >> 8] : 0;
}

bool inp_unit_read(struct inp_unit *unit, uint32_t offset, uint64_t t, uint32_t *value)
{
    int screen = pen_at(offset);
    uint32_t bit = bit_at(offset);
    bool known = false;
    if (offset % 4 != 0)
        return false;
    if (screen >= 0)
        known = read_pen(unit, screen, offset - pen_block[screen], value);
    else if (bit == INPUT_BIT_TABLET)
        known = inp_tablet_read(&unit->tablet, offset, value);
    else if (bit == INPUT_BIT_TOUCH)
        known = inp_touch_read(&unit->touch, offset, value);
    else if (bit == INPUT_BIT_KEYBOARD)
        known = inp_keyboard_read(&unit->keyboard, offset, value);
    else if (bit == INPUT_BIT_MOUSE)
        known = inp_mouse_read(&unit->mouse, offset, t, value);
    else
        known = read_unit(unit, offset, value);
    if (known && bit && !(inp_unit_present(unit) & bit))
        *value = 0;           /* nothing answers */
    inp_unit_settle(unit, t); /* reading takes events of the keyboard */
    return known;
}

bool inp_unit_write(struct inp_unit *unit, uint32_t offset, uint32_t value, uint64_t t)
{
    int screen = pen_at(offset);
    uint32_t bit = bit_at(offset), ignored;
    bool known = false;
    if (bit && !(inp_unit_present(unit) & bit))
        return inp_unit_read(unit, offset, t, &ignored);
    if (offset % 4 != 0)
        return false;
    if (screen >= 0)
        known = write_pen(unit, screen, offset - pen_block[screen], value);
    else if (bit == INPUT_BIT_TABLET)
        known = inp_tablet_write(&unit->tablet, offset, value, t);
    else if (bit == INPUT_BIT_TOUCH)
        known = inp_touch_write(&unit->touch, offset, value, t);
    else if (bit == INPUT_BIT_KEYBOARD)
        known = inp_keyboard_write(&unit->keyboard, offset, value, t);
    else if (bit == INPUT_BIT_MOUSE)
        known = inp_mouse_write(&unit->mouse, offset, value, t);
    else
        known = read_unit(unit, offset, &ignored);
    if (known && offset == INPUT_IRQ_ENABLE)
        unit->enable = value & INPUT_BITS;
    inp_unit_settle(unit, t);
    return known;
}
