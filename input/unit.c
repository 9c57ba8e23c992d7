#include "input/unit.h"

#include <assert.h>
#include <string.h>

static const uint32_t pen_bit[INP_SCREENS] = {INPUT_BIT_PEN_VECTOR, INPUT_BIT_PEN_RASTER};
static const uint32_t pen_block[INP_SCREENS] = {INPUT_PEN_VECTOR, INPUT_PEN_RASTER};
#define PEN_BLOCK_SIZE 0x40

/* ---- which are there ----------------------------------------------------------------------------
 */

static bool has_pen(const struct inp_unit *unit, int screen)
{
    return unit->desc.setup->has_pen && unit->desc.screen[screen].row;
}

static bool has_touch(const struct inp_unit *unit)
{
    const struct inp_touch_setup *touch = &unit->desc.setup->touch;
    return touch->kind != TOUCH_NONE && unit->desc.screen[touch->screen].row;
}

static uint32_t present(const struct inp_unit *unit)
{
    const struct inp_setup *setup = unit->desc.setup;
    uint32_t bits = 0;
    for (int s = 0; s < INP_SCREENS; s++)
        bits |= has_pen(unit, s) ? pen_bit[s] : 0;
    bits |= setup->tablet.kind != TABLET_NONE ? INPUT_BIT_TABLET : 0;
    bits |= has_touch(unit) ? INPUT_BIT_TOUCH : 0;
    bits |= setup->has_keyboard ? INPUT_BIT_KEYBOARD : 0;
    bits |= setup->mouse.kind != MOUSE_NONE ? INPUT_BIT_MOUSE : 0;
    return bits;
}

bool inp_unit_has(const struct inp_unit *unit, const struct inp_act *act)
{
    const struct inp_setup *setup = unit->desc.setup;
    bool button = act->verb == INP_PRESS || act->verb == INP_RELEASE;
    switch (act->device) {
    case INP_PEN:
        return has_pen(unit, act->screen);
    case INP_TABLET:
        return setup->tablet.kind != TABLET_NONE &&
               !(button && act->code >= setup->tablet.buttons.value);
    case INP_TOUCH:
        return has_touch(unit) && act->screen == setup->touch.screen;
    case INP_KEYBOARD:
        return setup->has_keyboard;
    case INP_MOUSE:
        return setup->mouse.kind != MOUSE_NONE;
    default:
        return true;
    }
}

/* ---- time ----
 */

bool inp_unit_looks(const struct inp_unit *unit, enum inp_screen screen)
{
    return has_pen(unit, screen) && inp_pen_looks(&unit->pen[screen]);
}

static uint64_t earlier(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

static uint64_t next_of(const struct inp_unit *unit)
{
    uint64_t next = earlier(inp_tablet_next(&unit->tablet), inp_touch_next(&unit->touch));
    next = earlier(next, unit->due);
    next = earlier(next, inp_keyboard_next(&unit->keyboard));
    next = earlier(next, inp_mouse_next(&unit->mouse));
    for (int s = 0; s < INP_SCREENS; s++)
        if (inp_unit_looks(unit, (enum inp_screen)s))
            next = earlier(next, inp_pen_next(&unit->pen[s]));
    return next;
}

/* ---- the interrupt ------------------------------------------------------------------------------
 */

static uint32_t status(const struct inp_unit *unit)
{
    uint32_t bits = 0;
    for (int s = 0; s < INP_SCREENS; s++)
        if (unit->port[s].status & (PEN_HIT | PEN_TIP_MOVED))
            bits |= pen_bit[s];
    bits |= inp_tablet_ready(&unit->tablet) ? INPUT_BIT_TABLET : 0;
    bits |= inp_touch_ready(&unit->touch) ? INPUT_BIT_TOUCH : 0;
    bits |= inp_keyboard_ready(&unit->keyboard) ? INPUT_BIT_KEYBOARD : 0;
    bits |= inp_mouse_ready(&unit->mouse) ? INPUT_BIT_MOUSE : 0;
    return bits & present(unit);
}

static void settle(struct inp_unit *unit, uint64_t t)
{
    unit->next = next_of(unit);
    bool level = status(unit) & unit->enable;
    if (level == unit->level)
        return;
    unit->level = level;
    if (unit->desc.wires.interrupt)
        unit->desc.wires.interrupt(unit->desc.wires.ctx, level, t);
}

/* ---- power-on -----------------------------------------------------------------------------------
 */

static void init_pen(struct inp_unit *unit, int screen)
{
    const struct inp_screen_desc *s = &unit->desc.screen[screen];
    if (has_pen(unit, screen))
        inp_pen_init(&unit->pen[screen], &(struct inp_pen_desc){
                                             .setup = &unit->desc.setup->pen,
                                             .row = s->row,
                                             .phosphor = s->phosphor,
                                             .knobs = s->knobs,
                                             .seed = UINT64_C(0x70656E00) + (unsigned)screen,
                                         });
}

void inp_unit_init(struct inp_unit *unit, const struct inp_unit_desc *desc)
{
    const struct inp_setup *setup = desc->setup;
    memset(unit, 0, sizeof *unit);
    unit->desc = *desc;
    unit->due = INP_NEVER;
    for (int s = 0; s < INP_SCREENS; s++)
        init_pen(unit, s);
    inp_tablet_init(&unit->tablet, &(struct inp_tablet_desc){&setup->tablet, 0x7461626C});
    const struct crt_tube_row *row = desc->screen[setup->touch.screen].row;
    inp_touch_init(&unit->touch, &(struct inp_touch_desc){.setup = &setup->touch,
                                                          .width_mm = row ? row->width.value : 1,
                                                          .height_mm = row ? row->height.value : 1,
                                                          .seed = 0x746F7563});
    inp_keyboard_init(&unit->keyboard, &(struct inp_keyboard_desc){
                                           &setup->keyboard, desc->wires.ctx, desc->wires.send});
    inp_mouse_init(&unit->mouse, &(struct inp_mouse_desc){&setup->mouse});
    unit->next = next_of(unit);
}

void inp_unit_reset(struct inp_unit *unit, uint64_t t)
{
    for (int s = 0; s < INP_SCREENS; s++)
        unit->port[s] = (struct inp_pen_port){0};
    inp_tablet_reset(&unit->tablet, t);
    inp_touch_reset(&unit->touch, t);
    inp_keyboard_reset(&unit->keyboard, t);
    inp_mouse_reset(&unit->mouse, t);
    unit->enable = 0;
    settle(unit, t);
}

/* ---- pens ---------------------------------------------------------------------------------------
 */

/* There is but one pen: where it comes to one screen it leaves the other. */
static void act_pen(struct inp_unit *unit, const struct inp_act *act)
{
    struct inp_pen *pen = &unit->pen[act->screen];
    struct inp_pen_port *port = &unit->port[act->screen];
    bool tip = pen->tip;
    switch (act->verb) {
    case INP_MOVE:
        for (int s = 0; s < INP_SCREENS; s++)
            if (s != act->screen && unit->pen[s].hand.there)
                act_pen(unit, &(struct inp_act){.t = act->t,
                                                .device = INP_PEN,
                                                .verb = INP_AWAY,
                                                .screen = (uint8_t)s});
        inp_hand_move(&pen->hand, (struct inp_place){act->x / 1000.0, act->y / 1000.0, 0}, act->t,
                      act->duration);
        break;
    case INP_AWAY:
        inp_hand_away(&pen->hand);
        tip = false;
        break;
    case INP_PRESS:
        tip = pen->hand.there;
        break;
    case INP_RELEASE:
        tip = false;
        break;
    default:
        break;
    }
    if (tip != pen->tip)
        port->status |= PEN_TIP_MOVED;
    pen->tip = tip;
    if (unit->desc.wires.look)
        unit->desc.wires.look(unit->desc.wires.ctx);
}

/* A pulse arrives at t. */
static void fire(struct inp_unit *unit, int screen, uint64_t t)
{
    struct inp_pen_port *port = &unit->port[screen];
    const struct inp_wires *wires = &unit->desc.wires;
    uint32_t line, dot, field;
    port->firings++;
    if (screen == INP_RASTER) {
        bool counts = (port->control & PEN_ENABLE) &&
                      (unit->pen[screen].tip || !(port->control & PEN_TIP_ENABLE));
        if (!counts || !wires->beam || !wires->beam(wires->ctx, t, &line, &dot, &field))
            return;
        if (port->status & PEN_HIT) {
            port->status |= PEN_LOST;
            return;
        }
        port->line = line;
        port->dot = dot;
        port->field = field;
    }
    port->status |= PEN_HIT;
    settle(unit, t);
}

/* The stroke lies in the future while its word is being drawn: the registers change when the pulse comes. */
void inp_unit_stroke(struct inp_unit *unit, const struct crt_stroke *stroke)
{
    uint64_t when;
    if (!inp_pen_stroke(&unit->pen[INP_VECTOR], stroke, &when))
        return;
    unit->due = unit->due_count ? unit->due : when;
    unit->due_count++;
    unit->next = earlier(unit->next, unit->due);
}

static void fire_due(struct inp_unit *unit, uint64_t t)
{
    for (; unit->due_count > 0; unit->due_count--)
        fire(unit, INP_VECTOR, t);
    unit->due = INP_NEVER;
}

void inp_unit_line(struct inp_unit *unit, const struct crt_scan_line *line)
{
    inp_pen_line(&unit->pen[INP_RASTER], line);
    unit->next = next_of(unit);
}

void inp_unit_set_knobs(struct inp_unit *unit, enum inp_screen screen, struct crt_knobs knobs)
{
    if (has_pen(unit, screen))
        inp_pen_set_knobs(&unit->pen[screen], knobs);
}

/* ---- acts ---------------------------------------------------------------------------------------
 */

void inp_unit_act(struct inp_unit *unit, const struct inp_act *act)
{
    assert(act->space == INP_MM || (act->device != INP_PEN && act->device != INP_TOUCH));
    if (!inp_unit_has(unit, act))
        return;
    switch (act->device) {
    case INP_PEN:
        act_pen(unit, act);
        break;
    case INP_TABLET:
        inp_tablet_act(&unit->tablet, act, act->t);
        break;
    case INP_TOUCH:
        inp_touch_act(&unit->touch, act, act->t);
        break;
    case INP_KEYBOARD:
        inp_keyboard_act(&unit->keyboard, act, act->t);
        break;
    case INP_MOUSE:
        inp_mouse_act(&unit->mouse, act, act->t);
        break;
    default:
        break;
    }
    settle(unit, act->t);
}

void inp_unit_event(struct inp_unit *unit, uint64_t t)
{
    if (unit->due <= t)
        fire_due(unit, t);
    for (int s = 0; s < INP_SCREENS; s++)
        if (inp_unit_looks(unit, (enum inp_screen)s) && inp_pen_next(&unit->pen[s]) <= t &&
            inp_pen_event(&unit->pen[s], t))
            fire(unit, s, t);
    if (inp_tablet_next(&unit->tablet) <= t)
        inp_tablet_event(&unit->tablet, t);
    if (inp_touch_next(&unit->touch) <= t)
        inp_touch_event(&unit->touch, t);
    if (inp_keyboard_next(&unit->keyboard) <= t)
        inp_keyboard_event(&unit->keyboard, t);
    if (inp_mouse_next(&unit->mouse) <= t)
        inp_mouse_event(&unit->mouse, t);
    settle(unit, t);
}

/* ---- registers ----------------------------------------------------------------------------------
 */

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
        port->control = screen == INP_RASTER && has_pen(unit, screen)
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
        *value = status(unit);
        return true;
    case INPUT_IRQ_ENABLE:
        *value = unit->enable;
        return true;
    case INPUT_PRESENT:
        *value = present(unit);
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
        return pen_bit[screen];
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
    if (known && bit && !(present(unit) & bit))
        *value = 0;  /* nothing answers */
    settle(unit, t); /* reading takes events of the keyboard */
    return known;
}

bool inp_unit_write(struct inp_unit *unit, uint32_t offset, uint32_t value, uint64_t t)
{
    int screen = pen_at(offset);
    uint32_t bit = bit_at(offset), ignored;
    bool known = false;
    if (bit && !(present(unit) & bit))
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
    settle(unit, t);
    return known;
}

/* ---- snapshots ----------------------------------------------------------------------------------
 */

static void port_state(struct inp_pen_port *port, struct crt_state *s)
{
    crt_state_u32(s, &port->status);
    crt_state_u32(s, &port->control);
    crt_state_u32(s, &port->firings);
    crt_state_u32(s, &port->line);
    crt_state_u32(s, &port->dot);
    crt_state_u32(s, &port->field);
    crt_state_check(s,
                    !(port->status & ~(uint32_t)(PEN_HIT | PEN_LOST | PEN_TIP_MOVED)) &&
                        !(port->control & ~(uint32_t)(PEN_ENABLE | PEN_TIP_ENABLE)),
                    "status of a pen");
}

void inp_unit_state(struct inp_unit *unit, struct crt_state *s)
{
    for (int p = 0; p < INP_SCREENS; p++)
        if (has_pen(unit, p))
            inp_pen_state(&unit->pen[p], s);
    inp_tablet_state(&unit->tablet, s);
    inp_touch_state(&unit->touch, s);
    inp_keyboard_state(&unit->keyboard, s);
    inp_mouse_state(&unit->mouse, s);
    crt_state_begin(s, "INPT", 1);
    for (int p = 0; p < INP_SCREENS; p++)
        port_state(&unit->port[p], s);
    crt_state_u64(s, &unit->due);
    crt_state_u32(s, &unit->due_count);
    crt_state_check(s, (unit->due == INP_NEVER) == (unit->due_count == 0) && unit->due_count < 1000,
                    "pulse of a pen");
    crt_state_u32(s, &unit->enable);
    crt_state_bool(s, &unit->level);
    crt_state_check(s, !(unit->enable & ~(uint32_t)INPUT_BITS), "enabled input");
    if (!s->failed)
        crt_state_check(s, unit->level == ((status(unit) & unit->enable) != 0), "input interrupt");
    crt_state_end(s);
    unit->next = next_of(unit);
}
