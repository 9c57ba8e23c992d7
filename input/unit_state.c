/* unit_state.c — the input unit in a snapshot. */
#include "input/unit_parts.h"

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
        if (inp_unit_has_pen(unit, p))
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
        crt_state_check(s, unit->level == ((inp_unit_status(unit) & unit->enable) != 0),
                        "input interrupt");
    crt_state_end(s);
    unit->next = inp_unit_next(unit);
}
