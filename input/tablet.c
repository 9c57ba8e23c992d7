#include "input/tablet.h"

#include <math.h>

#include "input/noise.h"
#include "input/tablet_kinds.h"

#define VERSION 1

/* ---- figures as the registers have them --------------------------------------------------------- */

static uint32_t nearest(double v)
{
    return (uint32_t)floor(v + 0.5);
}

static uint32_t unit_nm(const struct inp_tablet *tablet)
{
    return nearest(tablet->desc.setup->resolution.value * 1e6);
}

static uint32_t rate_of(const struct inp_tablet *tablet)
{
    return nearest(tablet->desc.setup->rate.value * 1000);
}

static struct crt_rate ticks(const struct inp_tablet *tablet)
{
    return (struct crt_rate){rate_of(tablet), 1000};
}

static unsigned buttons_of(const struct inp_tablet *tablet)
{
    return (unsigned)nearest(tablet->desc.setup->buttons.value);
}

static int32_t counts(const struct inp_tablet *tablet, double mm)
{
    double n = floor(mm * 1e6 / unit_nm(tablet) + 0.5);
    return (int32_t)(n < -1e9 ? -1e9 : n > 1e9 ? 1e9 : n);
}

/* ---- power-on, acts ------------------------------------------------------------------------------ */

void inp_tablet_init(struct inp_tablet *tablet, const struct inp_tablet_desc *desc)
{
    *tablet = (struct inp_tablet){.desc = *desc};
}

void inp_tablet_reset(struct inp_tablet *tablet, uint64_t t)
{
    struct inp_tablet was = *tablet;
    *tablet = (struct inp_tablet){
        .desc = was.desc, .hand = was.hand, .buttons = was.buttons, .origin = t};
}

void inp_tablet_act(struct inp_tablet *tablet, const struct inp_act *act, uint64_t t)
{
    struct inp_place to = {act->x / 1000.0, act->y / 1000.0, act->z / 1000.0};
    switch (act->verb) {
    case INP_MOVE:
        inp_hand_move(&tablet->hand, to, t, act->duration);
        break;
    case INP_AWAY:
        inp_hand_away(&tablet->hand);
        tablet->buttons = 0;
        break;
    case INP_PRESS:
        if (act->code < buttons_of(tablet))
            tablet->buttons |= 1u << act->code;
        break;
    case INP_RELEASE:
        if (act->code < buttons_of(tablet))
            tablet->buttons &= ~(1u << act->code);
        break;
    default:
        break;
    }
}

/* ---- measuring ----------------------------------------------------------------------------------- */

double tablet_noise_next(struct tablet_noise *noise)
{
    return inp_noise_normal(noise->seed, noise->count++);
}

static bool measure(const struct inp_tablet *tablet, struct inp_place stylus, uint64_t t,
                    struct tablet_measure *got)
{
    const struct inp_tablet_setup *setup = tablet->desc.setup;
    struct tablet_noise noise = {tablet->desc.seed, t * TABLET_DEVIATES};
    switch (setup->kind) {
    case TABLET_ELECTRICAL:
        return tablet_electrical(setup, stylus, &noise, got);
    case TABLET_SONIC:
        return tablet_sonic(setup, stylus, &noise, got);
    case TABLET_RESISTIVE:
        return tablet_resistive(setup, stylus, &noise, got);
    default:
        return false;
    }
}

/* What is to be reported of time t into tablet->latest; false: nothing. */
static bool observe(struct inp_tablet *tablet, uint64_t t)
{
    struct inp_tablet_report *r = &tablet->latest;
    struct inp_place stylus = inp_hand_at(&tablet->hand, t);
    struct tablet_measure got;
    bool rests = tablet->hand.there && stylus.z <= 0;
    bool is_stylus = buttons_of(tablet) == 1, was = tablet->sensed;
    stylus.z = rests ? 0 : stylus.z;
    tablet->sensed = tablet->hand.there && measure(tablet, stylus, t, &got);
    r->buttons = tablet->buttons | (is_stylus && rests ? 1u : 0u);
    r->proximity = TABLET_FAR;
    if (!tablet->sensed)
        return was;
    bool touches = got.touches || rests || (is_stylus && r->buttons);
    r->proximity = touches ? TABLET_TOUCH : TABLET_NEAR;
    r->x = counts(tablet, got.place.x);
    r->y = counts(tablet, got.place.y);
    r->z = counts(tablet, got.place.z);
    for (int i = 0; i < TABLET_RAW_WORDS; i++)
        r->raw[i] = got.raw[i];
    return true;
}

uint64_t inp_tablet_next(const struct inp_tablet *tablet)
{
    if (tablet->desc.setup->kind == TABLET_NONE || !(tablet->control & TABLET_ON))
        return UINT64_MAX;
    return tablet->origin + crt_tick_time(ticks(tablet), tablet->measured + 1);
}

bool inp_tablet_event(struct inp_tablet *tablet, uint64_t t)
{
    uint64_t due = inp_tablet_next(tablet);
    if (t < due)
        return false;
    tablet->measured++;
    if (!observe(tablet, due))
        return false;
    tablet->latest.serial = ++tablet->serial;
    if ((tablet->status & TABLET_REPORT) && !(tablet->control & TABLET_LATEST)) {
        tablet->status |= TABLET_LOST;
    } else {
        tablet->report = tablet->latest;
        tablet->status |= TABLET_REPORT;
    }
    return true;
}

/* ---- registers ----------------------------------------------------------------------------------- */

static uint32_t extent(const struct inp_tablet *tablet, bool up)
{
    const struct inp_tablet_setup *setup = tablet->desc.setup;
    struct inp_place size = {setup->width.value, setup->height.value, 0};
    if (setup->kind == TABLET_RESISTIVE)
        size = tablet_sheet(setup);
    return (uint32_t)counts(tablet, up ? size.y : size.x);
}

static bool read_any(const struct inp_tablet *tablet, uint32_t offset, uint32_t *value)
{
    const struct inp_tablet_report *r = &tablet->report;
    switch (offset) {
    case INPUT_TABLET_KIND:
        *value = tablet->desc.setup->kind;
        return true;
    case INPUT_TABLET_STATUS:
        *value = tablet->status;
        return true;
    case INPUT_TABLET_CONTROL:
        *value = tablet->control;
        return true;
    case INPUT_TABLET_X:
        *value = (uint32_t)r->x;
        return true;
    case INPUT_TABLET_Y:
        *value = (uint32_t)r->y;
        return true;
    case INPUT_TABLET_Z:
        *value = (uint32_t)r->z;
        return true;
    case INPUT_TABLET_PROXIMITY:
        *value = r->proximity;
        return true;
    case INPUT_TABLET_BUTTONS:
        *value = r->buttons;
        return true;
    case INPUT_TABLET_SERIAL:
        *value = r->serial;
        return true;
    case INPUT_TABLET_UNIT:
        *value = unit_nm(tablet);
        return true;
    case INPUT_TABLET_WIDTH:
        *value = extent(tablet, false);
        return true;
    case INPUT_TABLET_HEIGHT:
        *value = extent(tablet, true);
        return true;
    case INPUT_TABLET_RATE:
        *value = rate_of(tablet);
        return true;
    default:
        break;
    }
    uint32_t word = (offset - INPUT_TABLET_RAW) / 4;
    if (offset < INPUT_TABLET_RAW || offset % 4 || word >= TABLET_RAW_WORDS)
        return false;
    *value = r->raw[word];
    return true;
}

bool inp_tablet_read(const struct inp_tablet *tablet, uint32_t offset, uint32_t *value)
{
    if (!read_any(tablet, offset, value))
        return false;
    if (tablet->desc.setup->kind == TABLET_NONE)
        *value = 0;
    return true;
}

static void control(struct inp_tablet *tablet, uint32_t value, uint64_t t)
{
    if ((value & TABLET_ON) && !(tablet->control & TABLET_ON)) {
        tablet->origin = t;
        tablet->measured = 0;
        tablet->sensed = false;
    }
    tablet->control = value & (TABLET_ON | TABLET_LATEST);
}

bool inp_tablet_write(struct inp_tablet *tablet, uint32_t offset, uint32_t value, uint64_t t)
{
    uint32_t is;
    if (!read_any(tablet, offset, &is))
        return false;
    if (tablet->desc.setup->kind == TABLET_NONE)
        return true;
    if (offset == INPUT_TABLET_STATUS)
        tablet->status &= ~value;
    if (offset == INPUT_TABLET_CONTROL)
        control(tablet, value, t);
    return true;
}

bool inp_tablet_ready(const struct inp_tablet *tablet)
{
    return (tablet->status & TABLET_REPORT) != 0;
}

/* ---- snapshot ------------------------------------------------------------------------------------ */

static void report_state(struct inp_tablet_report *r, struct crt_state *s)
{
    crt_state_i32(s, &r->x);
    crt_state_i32(s, &r->y);
    crt_state_i32(s, &r->z);
    crt_state_unsigned(s, &r->proximity, TABLET_TOUCH);
    crt_state_unsigned(s, &r->buttons, 15);
    for (int i = 0; i < TABLET_RAW_WORDS; i++)
        crt_state_u32(s, &r->raw[i]);
    crt_state_u32(s, &r->serial);
}

/* The time of the next measurement stays far from the end of 64 bits. */
static bool possible(const struct inp_tablet *tablet)
{
    uint64_t most = crt_tick_at(ticks(tablet), CRT_STATE_LATEST);
    return tablet->origin < CRT_STATE_LATEST && tablet->measured <= most &&
           crt_tick_time(ticks(tablet), tablet->measured) <= CRT_STATE_LATEST - tablet->origin;
}

void inp_tablet_state(struct inp_tablet *tablet, struct crt_state *s)
{
    unsigned status = tablet->status, bits = tablet->control;
    crt_state_begin(s, "TABL", VERSION);
    inp_hand_state(&tablet->hand, s);
    crt_state_unsigned(s, &tablet->buttons, (1u << buttons_of(tablet)) - 1);
    crt_state_unsigned(s, &status, TABLET_REPORT | TABLET_LOST);
    crt_state_unsigned(s, &bits, TABLET_ON | TABLET_LATEST);
    crt_state_u64(s, &tablet->origin);
    crt_state_u64(s, &tablet->measured);
    if (!crt_state_check(s, possible(tablet), "time of a tablet's measurement"))
        tablet->origin = tablet->measured = 0;
    crt_state_u32(s, &tablet->serial);
    crt_state_bool(s, &tablet->sensed);
    report_state(&tablet->latest, s);
    report_state(&tablet->report, s);
    crt_state_end(s);
    tablet->status = status;
    tablet->control = bits;
}
