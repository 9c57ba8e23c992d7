#include "input/touch.h"

#include <assert.h>
#include <string.h>

#include "input/touch_kinds.h"

/* ---- scans ------------------------------------------------------------------------------------- */

struct crt_rate inp_touch_rate(const struct inp_touch_setup *setup)
{
    return (struct crt_rate){(uint64_t)(setup->rate.value * 1000 + 0.5), 1000};
}

unsigned inp_touch_samples(const struct inp_touch_setup *setup)
{
    if (setup->kind == TOUCH_OPTICAL)
        return (unsigned)setup->columns.value + (unsigned)setup->rows.value;
    return 2;
}

static bool is_on(const struct inp_touch *touch)
{
    return touch->desc.setup->kind != TOUCH_NONE && (touch->control & TOUCH_ON) != 0;
}

/* When sample n of the scan under way is taken: evenly spread over the scan, the last at its end. */
static uint64_t sample_time(const struct inp_touch *touch, unsigned n)
{
    struct crt_rate rate = inp_touch_rate(touch->desc.setup);
    uint64_t begin = crt_tick_time(rate, touch->scans), end = crt_tick_time(rate, touch->scans + 1);
    return touch->origin + begin + (end - begin) * (n + 1) / inp_touch_samples(touch->desc.setup);
}

static void sample(struct inp_touch *touch, uint64_t t)
{
    struct inp_place place = inp_hand_at(&touch->hand, t);
    const struct inp_place *finger = touch->hand.there ? &place : NULL;
    unsigned n = touch->scan.sampled++;
    switch (touch->desc.setup->kind) {
    case TOUCH_OPTICAL:
        inp_touch_sample_optical(touch, n, finger);
        break;
    case TOUCH_SONIC:
        inp_touch_sample_sonic(touch, n, finger);
        break;
    default:
        inp_touch_sample_electrical(touch, n, finger);
        break;
    }
}

/* Takes the samples that come before t: the finger goes elsewhere then. */
static void sample_before(struct inp_touch *touch, uint64_t t)
{
    unsigned samples = inp_touch_samples(touch->desc.setup);
    while (touch->scan.sampled < samples) {
        uint64_t when = sample_time(touch, touch->scan.sampled);
        if (when >= t)
            return;
        sample(touch, when);
    }
}

static void begin_scan(struct inp_touch *touch)
{
    touch->scan = (struct inp_touch_scan){.sampled = 0};
}

/* ---- reports ----------------------------------------------------------------------------------- */

static struct inp_touch_report found(const struct inp_touch *touch)
{
    const struct inp_touch_found *x = &touch->scan.axis[0], *y = &touch->scan.axis[1];
    struct inp_touch_report r = {.touched = x->found && y->found, .x = x->at, .y = y->at};
    r.unsure = r.touched && (x->unsure || y->unsure);
    if (!r.touched) {
        r.x = touch->last.x;
        r.y = touch->last.y;
    }
    memcpy(r.raw, touch->scan.raw, sizeof r.raw);
    return r;
}

/* It came, went, moved, or the same place is sure now. */
static bool is_new(const struct inp_touch_report *last, const struct inp_touch_report *now)
{
    if (last->touched != now->touched)
        return true;
    return now->touched &&
           (last->x != now->x || last->y != now->y || (last->unsure && !now->unsure));
}

static void report(struct inp_touch *touch, const struct inp_touch_report *r)
{
    touch->made++;
    if (touch->status & TOUCH_REPORT && !(touch->control & TOUCH_LATEST)) {
        touch->status |= TOUCH_LOST;
        return;
    }
    touch->status |= TOUCH_REPORT;
    touch->report = *r;
    touch->serial = touch->made;
}

uint64_t inp_touch_next(const struct inp_touch *touch)
{
    if (!is_on(touch))
        return UINT64_MAX;
    return touch->origin + crt_tick_time(inp_touch_rate(touch->desc.setup), touch->scans + 1);
}

bool inp_touch_event(struct inp_touch *touch, uint64_t t)
{
    if (t < inp_touch_next(touch))
        return false;
    /* Scans that nobody called for are passed over: what is late is not made up for one by one. */
    uint64_t done = crt_tick_at(inp_touch_rate(touch->desc.setup), t - touch->origin);
    if (done > touch->scans + 1) {
        touch->scans = done - 1;
        begin_scan(touch);
    }
    sample_before(touch, inp_touch_next(touch) + 1);
    struct inp_touch_report r = found(touch);
    bool told = is_new(&touch->last, &r);
    if (told)
        report(touch, &r);
    touch->last = r;
    touch->scans = done;
    begin_scan(touch);
    return told;
}

/* ---- the finger -------------------------------------------------------------------------------- */

void inp_touch_act(struct inp_touch *touch, const struct inp_act *act, uint64_t t)
{
    if (is_on(touch))
        sample_before(touch, t);
    if (act->verb == INP_AWAY)
        inp_hand_away(&touch->hand);
    if (act->verb != INP_MOVE)
        return;
    double newton = act->z == 0 ? 1 : act->z / 1000.0;
    uint64_t most = t < CRT_STATE_LATEST ? CRT_STATE_LATEST - 1 - t : 0;
    inp_hand_move(&touch->hand, (struct inp_place){act->x / 1000.0, act->y / 1000.0, newton}, t,
                  act->duration < most ? act->duration : most);
}

/* ---- power and registers ----------------------------------------------------------------------- */

void inp_touch_init(struct inp_touch *touch, const struct inp_touch_desc *desc)
{
    memset(touch, 0, sizeof *touch);
    touch->desc = *desc;
    assert(desc->setup->kind <= TOUCH_ELECTRICAL);
    assert(desc->setup->kind == TOUCH_NONE || (desc->width_mm > 0 && desc->height_mm > 0));
}

void inp_touch_reset(struct inp_touch *touch, uint64_t t)
{
    struct inp_touch fresh;
    inp_touch_init(&fresh, &touch->desc);
    fresh.hand = touch->hand;
    fresh.origin = t;
    *touch = fresh;
}

static uint32_t status(const struct inp_touch *touch)
{
    return touch->status | (touch->report.touched ? TOUCH_TOUCHED : 0) |
           (touch->report.unsure ? TOUCH_UNSURE : 0);
}

static bool read_report(const struct inp_touch *touch, uint32_t offset, uint32_t *value)
{
    if (offset >= INPUT_TOUCH_RAW && offset < INPUT_TOUCH_RAW + 4 * TOUCH_RAW_WORDS &&
        offset % 4 == 0) {
        *value = touch->report.raw[(offset - INPUT_TOUCH_RAW) / 4];
        return true;
    }
    switch (offset) {
    case INPUT_TOUCH_STATUS:
        *value = status(touch);
        return true;
    case INPUT_TOUCH_CONTROL:
        *value = touch->control;
        return true;
    case INPUT_TOUCH_X:
        *value = touch->report.x;
        return true;
    case INPUT_TOUCH_Y:
        *value = touch->report.y;
        return true;
    case INPUT_TOUCH_SERIAL:
        *value = touch->serial;
        return true;
    default:
        return false;
    }
}

static bool read_panel(const struct inp_touch *touch, uint32_t offset, uint32_t *value)
{
    const struct inp_touch_setup *setup = touch->desc.setup;
    struct inp_touch_grid across = inp_touch_grid(&touch->desc, 0);
    struct inp_touch_grid up = inp_touch_grid(&touch->desc, 1);
    switch (offset) {
    case INPUT_TOUCH_KIND:
        *value = setup->kind;
        return true;
    case INPUT_TOUCH_COLUMNS:
        *value = across.count;
        return true;
    case INPUT_TOUCH_ROWS:
        *value = up.count;
        return true;
    case INPUT_TOUCH_HEAD:
        *value = setup->screen;
        return true;
    case INPUT_TOUCH_LEFT:
        *value = (uint32_t)across.first;
        return true;
    case INPUT_TOUCH_BOTTOM:
        *value = (uint32_t)up.first;
        return true;
    case INPUT_TOUCH_PITCH_X:
        *value = across.pitch;
        return true;
    case INPUT_TOUCH_PITCH_Y:
        *value = up.pitch;
        return true;
    default:
        return false;
    }
}

bool inp_touch_read(const struct inp_touch *touch, uint32_t offset, uint32_t *value)
{
    bool there = read_report(touch, offset, value) || read_panel(touch, offset, value);
    if (there && touch->desc.setup->kind == TOUCH_NONE)
        *value = 0;
    return there;
}

static void switch_on(struct inp_touch *touch, uint64_t t)
{
    touch->origin = t;
    touch->scans = 0;
    touch->last = (struct inp_touch_report){.touched = false};
    begin_scan(touch);
}

bool inp_touch_write(struct inp_touch *touch, uint32_t offset, uint32_t value, uint64_t t)
{
    uint32_t old;
    if (!inp_touch_read(touch, offset, &old))
        return false;
    if (touch->desc.setup->kind == TOUCH_NONE)
        return true;
    if (offset == INPUT_TOUCH_STATUS)
        touch->status &= ~(value & (TOUCH_REPORT | TOUCH_LOST));
    if (offset == INPUT_TOUCH_CONTROL) {
        touch->control = value & (TOUCH_ON | TOUCH_LATEST);
        if (touch->control & TOUCH_ON & ~old)
            switch_on(touch, t);
    }
    return true;
}

bool inp_touch_ready(const struct inp_touch *touch)
{
    return (touch->status & TOUCH_REPORT) != 0;
}
