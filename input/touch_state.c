/* A touch panel in a snapshot. */
#include "input/touch_kinds.h"

#define VERSION 1

static void report_state(struct inp_touch_report *r, struct crt_state *s)
{
    crt_state_bool(s, &r->touched);
    crt_state_bool(s, &r->unsure);
    crt_state_u32(s, &r->x);
    crt_state_u32(s, &r->y);
    for (int i = 0; i < TOUCH_RAW_WORDS; i++)
        crt_state_u32(s, &r->raw[i]);
}

static void found_state(struct inp_touch_found *found, struct crt_state *s)
{
    crt_state_bool(s, &found->found);
    crt_state_bool(s, &found->unsure);
    crt_state_u32(s, &found->at);
}

static void scan_state(struct inp_touch *touch, struct crt_state *s)
{
    struct inp_touch_scan *scan = &touch->scan;
    crt_state_unsigned(s, &scan->sampled, inp_touch_samples(touch->desc.setup));
    for (int i = 0; i < TOUCH_RAW_WORDS; i++)
        crt_state_u32(s, &scan->raw[i]);
    found_state(&scan->axis[0], s);
    found_state(&scan->axis[1], s);
}

/* Positions that the panel has. */
static bool on_panel(const struct inp_touch_desc *desc, uint32_t x, uint32_t y)
{
    if (desc->setup->kind == TOUCH_NONE)
        return x == 0 && y == 0;
    return x <= 2 * (inp_touch_grid(desc, 0).count - 1) &&
           y <= 2 * (inp_touch_grid(desc, 1).count - 1);
}

static bool sane_time(const struct inp_touch *touch)
{
    struct crt_rate rate = inp_touch_rate(touch->desc.setup);
    return touch->origin < CRT_STATE_LATEST &&
           touch->scans <= crt_tick_at(rate, CRT_STATE_LATEST - touch->origin);
}

static bool sane_bits(const struct inp_touch *touch)
{
    uint32_t status = TOUCH_REPORT | TOUCH_LOST, control = TOUCH_ON | TOUCH_LATEST;
    if (touch->desc.setup->kind == TOUCH_NONE)
        return touch->status == 0 && touch->control == 0;
    return (touch->status & ~status) == 0 && (touch->control & ~control) == 0;
}

static bool sane_report(const struct inp_touch_desc *desc, const struct inp_touch_report *r)
{
    return on_panel(desc, r->x, r->y) && (r->touched || !r->unsure);
}

static void check(struct inp_touch *touch, struct crt_state *s)
{
    const struct inp_touch_desc *desc = &touch->desc;
    const struct inp_touch_found *axis = touch->scan.axis;
    crt_state_check(s, sane_bits(touch), "register of the touch panel");
    if (!crt_state_check(s, sane_time(touch), "time of the touch panel"))
        touch->origin = touch->scans = 0;
    crt_state_check(s, sane_report(desc, &touch->report) && sane_report(desc, &touch->last),
                    "report of the touch panel");
    crt_state_check(s, on_panel(desc, axis[0].at, axis[1].at), "scan of the touch panel");
}

void inp_touch_state(struct inp_touch *touch, struct crt_state *s)
{
    crt_state_begin(s, "TOUC", VERSION);
    inp_hand_state(&touch->hand, s);
    crt_state_u32(s, &touch->status);
    crt_state_u32(s, &touch->control);
    crt_state_u64(s, &touch->origin);
    crt_state_u64(s, &touch->scans);
    crt_state_u32(s, &touch->serial);
    crt_state_u32(s, &touch->made);
    report_state(&touch->report, s);
    report_state(&touch->last, s);
    scan_state(touch, s);
    check(touch, s);
    crt_state_end(s);
}
