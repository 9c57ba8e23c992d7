/* pointer_devices.c — handlers of the devices: what they report goes into the pointer's queue. */
#include <stddef.h>

#include "roms/bsp/interrupts.h"
#include "roms/interact/pointer.h"

enum { SETTLED_US = 300 /* more than lines between neighbouring rows take */ };

static uint32_t now(void)
{
    return (uint32_t)timer_now();
}

/* Called with interrupts off. A report that has no room replaces the last one: how things are now
 * matters more than how they were. */
static void store(struct pointer *p, const struct pointer_report *report)
{
    if (p->put - p->taken < POINTER_QUEUE) {
        p->queue[p->put % POINTER_QUEUE] = *report;
        p->put++;
        return;
    }
    p->queue[(p->put - 1) % POINTER_QUEUE] = *report;
    p->overflow = true;
}

void pointer_push(struct pointer *p, const struct pointer_report *report)
{
    uint32_t state = irq_lock();
    store(p, report);
    irq_unlock(state);
}

static void on_tablet(void *ctx)
{
    struct tablet_report t;
    while (tablet_take(&t)) {
        struct pointer_report r = {.device = POINTER_TABLET,
                                   .placed = t.proximity != TABLET_FAR,
                                   .near = t.proximity != TABLET_FAR,
                                   .pressed = t.proximity != TABLET_FAR && (t.buttons & 1),
                                   .lost = t.lost,
                                   .buttons = t.buttons,
                                   .x = t.x,
                                   .y = t.y,
                                   .z = t.z,
                                   .time = now()};
        store(ctx, &r);
    }
}

/* A finger whose place is not sure is where it was; it cannot come that way. */
static void on_touch(void *ctx)
{
    struct touch_report t;
    while (touch_take(&t)) {
        struct pointer_report r = {.device = POINTER_TOUCH,
                                   .placed = t.touched && !t.unsure,
                                   .near = t.touched,
                                   .pressed = t.touched,
                                   .lost = t.lost,
                                   .x = t.x_um,
                                   .y = t.y_um,
                                   .z = (int32_t)(t.x << 16 | (t.y & 0xFFFF)),
                                   .time = now()};
        store(ctx, &r);
    }
}

/* Counts add up while they wait, and nothing is lost but the time between them. */
static void on_mouse(void *ctx)
{
    struct pointer *p = ctx;
    struct mouse_state m;
    if (!mouse_read(&m))
        return;
    struct pointer_report r = {.device = POINTER_MOUSE,
                               .placed = m.dx != 0 || m.dy != 0,
                               .near = true,
                               .pressed = m.buttons & 1,
                               .lost = m.overrun,
                               .buttons = m.buttons,
                               .x = m.dx,
                               .y = m.dy,
                               .since = p->mouse_time,
                               .time = now()};
    struct pointer_report *last = &p->queue[(p->put - 1) % POINTER_QUEUE];
    bool waits = p->put != p->taken && last->device == POINTER_MOUSE;
    p->mouse_time = r.time;
    if (waits && last->buttons == r.buttons) {
        last->x += r.x;
        last->y += r.y;
        last->placed |= r.placed;
        last->lost |= r.lost;
        last->time = r.time;
    } else {
        store(p, &r);
    }
}

/* What the firings of a field say together. */
static void store_rows(struct pointer *p)
{
    float line, dot;
    if (!pen_rows_middle(&p->rows, &line, &dot, NULL))
        return;
    struct pointer_report r = {.device = POINTER_PEN,
                               .placed = true,
                               .near = true,
                               .pressed = p->tip,
                               .sure = p->fired_blue,
                               .x = (int32_t)(dot + 0.5f),
                               .y = (int32_t)(line + 0.5f),
                               .z = (int32_t)p->rows.field,
                               .place = pointer_pen_point(p, line, dot),
                               .time = p->fired_time};
    p->rows.count = 0;
    store(p, &r);
}

/* The beam has gone on from where the pen looks: nothing more will come in this field. */
void pointer_settle(struct pointer *p)
{
    if (p->rows.count > 0 && now() - p->fired_time > SETTLED_US * (TIMER_HZ / 1000000))
        store_rows(p);
}

static void take_firings(struct pointer *p)
{
    struct pen_hit hit;
    while (pen_hit_take(&hit)) {
        if (!pen_rows_add(&p->rows, &hit)) {
            store_rows(p);
            pen_rows_add(&p->rows, &hit);
        }
        p->fired = true;
        p->fired_blue = p->blue;
        p->fired_time = now();
    }
}

static void store_tip(struct pointer *p, bool pressed)
{
    struct pointer_report r = {
        .device = POINTER_PEN, .near = true, .pressed = pressed, .time = now()};
    p->tip = pressed;
    store(p, &r);
}

/* A switch that has moved and is as it was has moved twice. */
static void on_pen(void *ctx)
{
    struct pointer *p = ctx;
    take_firings(p);
    if (!pen_tip_moved(INPUT_RASTER))
        return;
    pointer_settle(p); /* what came before it */
    bool pressed = pen_tip(INPUT_RASTER);
    if (pressed == p->tip)
        store_tip(p, !pressed);
    store_tip(p, pressed);
}

void pointer_listen(struct pointer *p)
{
    struct mouse_state m;
    mouse_read(&m); /* counts until now are nobody's */
    p->mouse_time = now();
    p->tip = pen_tip(INPUT_RASTER);
    input_on(INPUT_BIT_TABLET, on_tablet, p);
    input_on(INPUT_BIT_TOUCH, on_touch, p);
    input_on(INPUT_BIT_MOUSE, on_mouse, p);
    input_on(INPUT_BIT_PEN_RASTER, on_pen, p);
    tablet_on(false);
    touch_on(false);
    pen_raster_on(false);
}
