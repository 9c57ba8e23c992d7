/* machine_devices.c — input devices: what the person does to them, their wires, and their registers on
 * the processor's bus. */
#include <math.h>

#include "emu/machine_parts.h"
#include "emu/memmap.h"

#define MOST_KNOB 1e6 /* a tube's limit */

/* ---- wires --------------------------------------------------------------------------------------
 */

static void interrupt(void *ctx, bool level, uint64_t t)
{
    struct vm_machine *m = ctx;
    if (m->desc.board)
        vm_set_line(m, IRQ_LINE_INPUT, level, t);
}

static bool beam(void *ctx, uint64_t t, uint32_t *line, uint32_t *dot, uint32_t *field)
{
    const struct vm_machine *m = ctx;
    if (!m->desc.buffer || !ras_head_beam(&m->raster, t, line, dot))
        return false;
    *field = (uint32_t)ras_head_fields(&m->raster, t);
    return true;
}

static bool send(void *ctx, const char *bytes, size_t length, uint64_t t)
{
    struct vm_machine *m = ctx;
    (void)t;
    return !m->desc.console || vm_console_key(m->desc.console, bytes, length);
}

/* Light goes to pens that look, and only there. */
static void look(void *ctx)
{
    struct vm_machine *m = ctx;
    for (int s = 0; s < INP_SCREENS; s++)
        m->looks[s] = inp_unit_looks(&m->devices, (enum inp_screen)s);
    vm_wire_pen(m);
    if (m->desc.buffer)
        vm_raster_wire(m, &m->raster.desc.wires);
}

void vm_devices_init(struct vm_machine *m)
{
    const struct vm_machine_desc *d = &m->desc;
    struct inp_unit_desc desc = {.setup = d->setup};
    desc.screen[INP_VECTOR] = (struct inp_screen_desc){d->row, d->phosphor, d->knobs};
    if (d->buffer)
        desc.screen[INP_RASTER] =
            (struct inp_screen_desc){d->raster_row, d->raster_phosphor, d->raster_knobs};
    desc.wires = (struct inp_wires){m, interrupt, beam, send, look};
    inp_unit_init(&m->devices, &desc);
}

void vm_devices_wire(struct vm_machine *m)
{
    m->devices.desc.wires.ctx = m->devices.keyboard.desc.ctx = m;
    look(m);
}

/* ---- acts ---------------------------------------------------------------------------------------
 */

static struct crt_screen screen_of(const struct vm_machine *m, enum inp_screen head)
{
    const struct ras_timing *timing = &m->raster.timing;
    if (head != INP_RASTER)
        return m->dpu.desc.screen;
    return (struct crt_screen){m->raster.desc.width_mm, m->raster.desc.height_mm, timing->h.visible,
                               timing->v.visible};
}

void vm_machine_place(const struct vm_machine *m, enum inp_screen head, double x, double y,
                      double *x_mm, double *y_mm)
{
    const struct crt_screen screen = screen_of(m, head);
    float fx, fy;
    crt_screen_to_mm(&screen, x, head == INP_RASTER ? screen.units_y - 1 - y : y, &fx, &fy);
    *x_mm = (double)fx;
    *y_mm = (double)fy;
}

void vm_machine_units(const struct vm_machine *m, enum inp_screen head, double x_mm, double y_mm,
                      double *x, double *y)
{
    const struct crt_screen screen = screen_of(m, head);
    crt_mm_to_units(&screen, x_mm, y_mm, x, y);
    *y = head == INP_RASTER ? screen.units_y - 1 - *y : *y;
}

static void place(const struct vm_machine *m, struct inp_act *act)
{
    double x_mm, y_mm;
    vm_machine_place(m, (enum inp_screen)act->screen, act->x / 1000.0, act->y / 1000.0, &x_mm,
                     &y_mm);
    double most = INP_FURTHEST;
    x_mm = x_mm * 1000 < -most ? -most / 1000 : x_mm * 1000 > most ? most / 1000 : x_mm;
    y_mm = y_mm * 1000 < -most ? -most / 1000 : y_mm * 1000 > most ? most / 1000 : y_mm;
    act->x = (int32_t)floor(x_mm * 1000 + 0.5);
    act->y = (int32_t)floor(y_mm * 1000 + 0.5);
    act->space = INP_MM;
}

static bool is_placed(const struct inp_act *act)
{
    return (act->device == INP_PEN || act->device == INP_TOUCH) && act->verb == INP_MOVE &&
           act->space == INP_UNITS;
}

static void turn(struct vm_machine *m, const struct inp_act *act)
{
    struct crt_knobs knobs = act->screen == INP_RASTER ? m->desc.raster_knobs : m->desc.knobs;
    double value = act->x / 1000.0;
    if (act->code == INP_BRIGHTNESS)
        knobs.brightness = value;
    else if (act->code == INP_CONTRAST)
        knobs.contrast = value;
    else
        knobs.focus = value;
    vm_machine_turn(m, (enum inp_screen)act->screen, knobs);
}

void vm_machine_turn(struct vm_machine *m, enum inp_screen screen, struct crt_knobs knobs)
{
    struct crt_tube *tube = screen == INP_RASTER ? m->desc.raster_tube : m->desc.tube;
    *(screen == INP_RASTER ? &m->desc.raster_knobs : &m->desc.knobs) = knobs;
    if (tube)
        crt_tube_set_knobs(tube, knobs);
    if (m->desc.setup)
        inp_unit_set_knobs(&m->devices, screen, knobs);
}

static void act(struct vm_machine *m, const struct inp_act *given)
{
    struct inp_act a = *given;
    if (m->hooks.act)
        m->hooks.act(m->hooks.ctx, given);
    if (is_placed(&a) && (a.screen == INP_VECTOR || m->desc.buffer))
        place(m, &a);
    a.space = INP_MM;
    if (a.device == INP_KNOB)
        turn(m, &a);
    else
        inp_unit_act(&m->devices, &a);
}

/* ---- time ---------------------------------------------------------------------------------------
 */

uint64_t vm_devices_next(const struct vm_machine *m)
{
    if (!m->desc.setup)
        return VM_NEVER;
    uint64_t next = m->devices.next;
    const struct inp_act *a = m->desc.person ? vm_operator_next(m->desc.person, &m->done) : NULL;
    next = a && a->t < next ? a->t : next;
    return next > m->now ? next : m->now;
}

void vm_devices_event(struct vm_machine *m, uint64_t t)
{
    const struct inp_act *a;
    while (m->desc.person && (a = vm_operator_next(m->desc.person, &m->done)) && a->t <= t) {
        act(m, a);
        vm_operator_done(m->desc.person, &m->done);
    }
    if (m->devices.next > t)
        return;
    inp_unit_event(&m->devices, t);
    if (m->hooks.input)
        m->hooks.input(m->hooks.ctx, t, &m->devices);
}

static void knobs_state(struct crt_knobs *knobs, struct crt_state *s)
{
    crt_state_f64(s, &knobs->brightness);
    crt_state_f64(s, &knobs->contrast);
    crt_state_f64(s, &knobs->focus);
    crt_state_check(s,
                    fabs(knobs->brightness) <= MOST_KNOB && fabs(knobs->contrast) <= MOST_KNOB &&
                        fabs(knobs->focus) <= MOST_KNOB,
                    "knob");
}

/* Tubes and pens have their knobs themselves; the next act turns one of these. */
void vm_devices_state(struct vm_machine *m, struct crt_state *s)
{
    inp_unit_state(&m->devices, s);
    crt_state_begin(s, "KNOB", 1);
    knobs_state(&m->desc.knobs, s);
    knobs_state(&m->desc.raster_knobs, s);
    crt_state_end(s);
    if (!s->loading || s->failed)
        return;
    look(m);
}

/* ---- registers ----------------------------------------------------------------------------------
 */

static bool input_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct vm_machine *m = ctx;
    (void)width;
    return inp_unit_read(&m->devices, offset, vm_board_now(m->desc.board), value);
}

static bool input_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_machine *m = ctx;
    (void)width;
    if (!inp_unit_write(&m->devices, offset, value, vm_board_now(m->desc.board)))
        return false;
    rv_attention(&m->desc.board->cpu); /* who is next may have changed */
    return true;
}

void vm_devices_connect(struct vm_machine *m)
{
    bus_add(&m->desc.board->bus,
            &(struct bus_range){MAP_INPUT, MAP_INPUT_SIZE, BUS_32, m, input_read, input_write});
}
