#include "input/mouse.h"

#include <assert.h>
#include <string.h>

#include "input/mouse_motion.h"

#define PM_PER_UM INT64_C(1000000)
#define PM_PER_NM 1000
#define BUTTONS   3

static struct inp_mouse_move move_of(const struct inp_mouse *mouse)
{
    return (struct inp_mouse_move){mouse->t0, mouse->t1};
}

/* ---- counts ------------------------------------------------------------------------------------ */

static void count(struct inp_mouse *mouse, struct inp_mouse_axis *axis, uint64_t taken)
{
    if (taken == axis->done)
        return;
    uint32_t more = (uint32_t)(taken - axis->done);
    axis->count += axis->way < 0 ? 0 - more : more;
    axis->done = taken;
    mouse->status |= MOUSE_MOVED;
}

/* Counts all that comes until t. */
static void count_until(struct inp_mouse *mouse, uint64_t t)
{
    if (!mouse->moving || mouse->lifted)
        return;
    struct inp_mouse_pitch pitch = inp_mouse_pitch(mouse->desc.setup);
    for (int i = 0; i < 2; i++)
        count(mouse, &mouse->axis[i], inp_mouse_taken(&mouse->axis[i], move_of(mouse), pitch, t));
}

/* The wheels do not turn in the air; over a pad the mouse gets elsewhere. */
static bool carried(const struct inp_mouse *mouse)
{
    return mouse->lifted && mouse->desc.setup->kind == MOUSE_MECHANICAL;
}

/* An axis is where it is at t; what it has crossed and not counted is missing. */
static void rest_axis(struct inp_mouse *mouse, struct inp_mouse_axis *axis, uint64_t t)
{
    struct inp_mouse_pitch pitch = inp_mouse_pitch(mouse->desc.setup);
    struct inp_mouse_move move = move_of(mouse);
    if (!mouse->lifted) {
        if (inp_mouse_crossed(axis, move, pitch, t) > axis->done)
            mouse->status |= MOUSE_OVERRUN;
        axis->free = inp_mouse_through(axis, pitch, axis->done, t < move.t1 ? t : move.t1);
    }
    int64_t gone = inp_mouse_gone(axis, move, t);
    if (!carried(mouse))
        axis->from = inp_mouse_wrapped(axis->from + gone, pitch);
    axis->way -= gone;
    axis->done = 0;
}

/* Ends the stretch of movement up to t: what is left of the way stands in `way`. */
static void rest(struct inp_mouse *mouse, uint64_t t)
{
    if (!mouse->moving)
        return;
    count_until(mouse, t);
    for (int i = 0; i < 2; i++)
        rest_axis(mouse, &mouse->axis[i], t);
    mouse->moving = t < mouse->t1;
    if (mouse->moving)
        mouse->t0 = t;
    else
        mouse->t0 = mouse->t1;
}

/* The stretch from t0 to t1 begins; it may have begun up to `before` earlier for the counters. */
static void set_out(struct inp_mouse *mouse, uint64_t before)
{
    mouse->moving = true;
    uint64_t begun = mouse->t0 > before ? mouse->t0 - before : 0;
    for (int i = 0; i < 2; i++)
        if (mouse->axis[i].free < begun)
            mouse->axis[i].free = begun;
}

/* Up to t, the end of the move included. */
static void settle(struct inp_mouse *mouse, uint64_t t)
{
    if (mouse->moving && t >= mouse->t1)
        rest(mouse, t);
    else
        count_until(mouse, t);
}

uint64_t inp_mouse_next(const struct inp_mouse *mouse)
{
    if (!mouse->moving)
        return UINT64_MAX;
    uint64_t next = mouse->t1;
    if (mouse->lifted || mouse->status & MOUSE_MOVED)
        return next;
    struct inp_mouse_pitch pitch = inp_mouse_pitch(mouse->desc.setup);
    for (int i = 0; i < 2; i++) {
        uint64_t due = inp_mouse_due(&mouse->axis[i], move_of(mouse), pitch);
        next = due < next ? due : next;
    }
    return next;
}

bool inp_mouse_event(struct inp_mouse *mouse, uint64_t t)
{
    struct inp_mouse before = *mouse;
    settle(mouse, t);
    return mouse->axis[0].count != before.axis[0].count ||
           mouse->axis[1].count != before.axis[1].count || mouse->status != before.status;
}

/* ---- the hand ---------------------------------------------------------------------------------- */

static int64_t way(int32_t um)
{
    int64_t most = INP_FURTHEST;
    return (um > most ? most : um < -most ? -most : um) * PM_PER_UM;
}

static void move_by(struct inp_mouse *mouse, const struct inp_act *act, uint64_t t)
{
    uint64_t most = t < CRT_STATE_LATEST ? CRT_STATE_LATEST - 1 - t : 0;
    uint64_t duration = act->duration < most ? act->duration : most;
    mouse->t0 = t;
    mouse->t1 = t + duration;
    mouse->axis[0].way = way(act->x);
    mouse->axis[1].way = way(act->y);
    set_out(mouse, duration == 0 ? INP_MOUSE_WHILE : 0);
    settle(mouse, t);
}

static void lift(struct inp_mouse *mouse, bool lifted, uint64_t t)
{
    if (mouse->lifted == lifted)
        return;
    rest(mouse, t);
    mouse->lifted = lifted;
    if (mouse->moving)
        set_out(mouse, 0);
}

static void press(struct inp_mouse *mouse, unsigned code, bool pressed)
{
    if (code >= BUTTONS)
        return;
    unsigned bit = 1u << code;
    unsigned buttons = pressed ? mouse->buttons | bit : mouse->buttons & ~bit;
    if (buttons != mouse->buttons)
        mouse->status |= MOUSE_MOVED;
    mouse->buttons = buttons;
}

void inp_mouse_act(struct inp_mouse *mouse, const struct inp_act *act, uint64_t t)
{
    if (mouse->desc.setup->kind == MOUSE_NONE)
        return;
    settle(mouse, t);
    switch (act->verb) {
    case INP_MOVE:
        rest(mouse, t);
        move_by(mouse, act, t);
        break;
    case INP_AWAY:
    case INP_BACK:
        lift(mouse, act->verb == INP_AWAY, t);
        break;
    case INP_PRESS:
    case INP_RELEASE:
        press(mouse, act->code, act->verb == INP_PRESS);
        break;
    default:
        break;
    }
}

/* ---- power and registers ----------------------------------------------------------------------- */

void inp_mouse_init(struct inp_mouse *mouse, const struct inp_mouse_desc *desc)
{
    memset(mouse, 0, sizeof *mouse);
    mouse->desc = *desc;
    assert(desc->setup->kind <= MOUSE_OPTICAL);
    if (desc->setup->kind == MOUSE_NONE)
        return;
    /* In the middle between two counts. */
    struct inp_mouse_pitch pitch = inp_mouse_pitch(desc->setup);
    mouse->axis[0].from = mouse->axis[1].from = pitch.cell / 2;
}

void inp_mouse_reset(struct inp_mouse *mouse, uint64_t t)
{
    settle(mouse, t);
    mouse->status = 0;
    mouse->axis[0].count = mouse->axis[1].count = 0;
}

/* First detector: light in quarters 0 and 1; second: in 1 and 2. The optical kind counts where 3 and 0 meet:
 * the first changes while the second is dark. */
static uint32_t light(const struct inp_mouse *mouse, const struct inp_mouse_axis *axis, uint64_t t)
{
    if (mouse->lifted && !carried(mouse))
        return 0; /* nothing is reflected */
    struct inp_mouse_pitch pitch = inp_mouse_pitch(mouse->desc.setup);
    int64_t gone = mouse->moving && !carried(mouse) ? inp_mouse_gone(axis, move_of(mouse), t) : 0;
    unsigned quarter = inp_mouse_quarter(axis->from + gone, pitch);
    return (quarter <= 1 ? 1u : 0u) | (quarter == 1 || quarter == 2 ? 2u : 0u);
}

static uint32_t unit(const struct inp_mouse *mouse)
{
    int64_t cell = inp_mouse_pitch(mouse->desc.setup).cell;
    return (uint32_t)((cell + PM_PER_NM / 2) / PM_PER_NM);
}

static bool value_at(const struct inp_mouse *mouse, uint32_t offset, uint64_t t, uint32_t *value)
{
    switch (offset) {
    case INPUT_MOUSE_KIND:
        *value = mouse->desc.setup->kind;
        return true;
    case INPUT_MOUSE_STATUS:
        *value = mouse->status;
        return true;
    case INPUT_MOUSE_X:
        *value = mouse->axis[0].count;
        return true;
    case INPUT_MOUSE_Y:
        *value = mouse->axis[1].count;
        return true;
    case INPUT_MOUSE_BUTTONS:
        *value = mouse->buttons;
        return true;
    case INPUT_MOUSE_PHASES:
        *value = light(mouse, &mouse->axis[0], t) | light(mouse, &mouse->axis[1], t) << 2;
        return true;
    case INPUT_MOUSE_UNIT:
        *value = unit(mouse);
        return true;
    default:
        return false;
    }
}

bool inp_mouse_read(const struct inp_mouse *mouse, uint32_t offset, uint64_t t, uint32_t *value)
{
    struct inp_mouse now = *mouse;
    settle(&now, t);
    bool there = value_at(&now, offset, t, value);
    if (there && mouse->desc.setup->kind == MOUSE_NONE)
        *value = 0;
    return there;
}

bool inp_mouse_write(struct inp_mouse *mouse, uint32_t offset, uint32_t value, uint64_t t)
{
    uint32_t old;
    if (!inp_mouse_read(mouse, offset, t, &old))
        return false;
    settle(mouse, t);
    if (offset == INPUT_MOUSE_STATUS)
        mouse->status &= ~value;
    return true;
}

bool inp_mouse_ready(const struct inp_mouse *mouse)
{
    return (mouse->status & MOUSE_MOVED) != 0;
}
