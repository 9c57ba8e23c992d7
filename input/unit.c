/* unit.c — the devices in a row: acts, light, events, their interrupt. */
#include "input/unit_parts.h"

#include <assert.h>
#include <string.h>

const uint32_t inp_pen_bit[INP_SCREENS] = {INPUT_BIT_PEN_VECTOR, INPUT_BIT_PEN_RASTER};

/* ---- which are there ----------------------------------------------------------------------------
 */

bool inp_unit_has_pen(const struct inp_unit *unit, int screen)
{
    return unit->desc.setup->has_pen && unit->desc.screen[screen].row;
}

static bool has_touch(const struct inp_unit *unit)
{
    const struct inp_touch_setup *touch = &unit->desc.setup->touch;
    return touch->kind != TOUCH_NONE && unit->desc.screen[touch->screen].row;
}

uint32_t inp_unit_present(const struct inp_unit *unit)
{
    const struct inp_setup *setup = unit->desc.setup;
    uint32_t bits = 0;
    for (int s = 0; s < INP_SCREENS; s++)
        bits |= inp_unit_has_pen(unit, s) ? inp_pen_bit[s] : 0;
    bits |= setup->tablet.kind != TABLET_NONE ? INPUT_BIT_TABLET : 0;
    bits |= has_touch(unit) ? INPUT_BIT_TOUCH : 0;
    bits |= setup->has_keyboard ? INPUT_BIT_KEYBOARD : 0;
    bits |= setup->mouse.kind != MOUSE_NONE ? INPUT_BIT_MOUSE : 0;
    return bits;
}

bool inp_unit_has(const struct inp_unit *unit, const struct inp_act *act)
{
    unsigned heads = 0;
    for (int s = 0; s < INP_SCREENS; s++)
        heads |= unit->desc.screen[s].row ? 1u << s : 0;
    return inp_setup_has(unit->desc.setup, heads, act);
}

/* ---- time ----
 */

bool inp_unit_looks(const struct inp_unit *unit, enum inp_screen screen)
{
    return inp_unit_has_pen(unit, (int)screen) && inp_pen_looks(&unit->pen[screen]);
}

static uint64_t earlier(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

uint64_t inp_unit_next(const struct inp_unit *unit)
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

uint32_t inp_unit_status(const struct inp_unit *unit)
{
    uint32_t bits = 0;
    /* A hit of the vector head's pen is the display processor's to tell. */
    static const uint32_t told[INP_SCREENS] = {PEN_TIP_MOVED, PEN_HIT | PEN_TIP_MOVED};
    for (int s = 0; s < INP_SCREENS; s++)
        if (unit->port[s].status & told[s])
            bits |= inp_pen_bit[s];
    bits |= inp_tablet_ready(&unit->tablet) ? INPUT_BIT_TABLET : 0;
    bits |= inp_touch_ready(&unit->touch) ? INPUT_BIT_TOUCH : 0;
    bits |= inp_keyboard_ready(&unit->keyboard) ? INPUT_BIT_KEYBOARD : 0;
    bits |= inp_mouse_ready(&unit->mouse) ? INPUT_BIT_MOUSE : 0;
    return bits & inp_unit_present(unit);
}

void inp_unit_settle(struct inp_unit *unit, uint64_t t)
{
    unit->next = inp_unit_next(unit);
    bool level = inp_unit_status(unit) & unit->enable;
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
    if (inp_unit_has_pen(unit, (int)screen))
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
    unit->next = inp_unit_next(unit);
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
    inp_unit_settle(unit, t);
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
    inp_unit_settle(unit, t);
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
    unit->next = inp_unit_next(unit);
}

void inp_unit_set_knobs(struct inp_unit *unit, enum inp_screen screen, struct crt_knobs knobs)
{
    if (inp_unit_has_pen(unit, (int)screen))
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
    inp_unit_settle(unit, act->t);
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
    inp_unit_settle(unit, t);
}
