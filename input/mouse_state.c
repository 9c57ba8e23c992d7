/* A mouse in a snapshot. */
#include "input/mouse_motion.h"

#define VERSION 1

/* Longest time between two counts that the slowest counters take, ps. */
#define SLOWEST (10 * CRT_PS_PER_MS + 1)

static void signed_state(int64_t *v, struct crt_state *s)
{
    uint64_t bits = (uint64_t)*v;
    crt_state_u64(s, &bits);
    *v = bits <= INT64_MAX ? (int64_t)bits : -(int64_t)(UINT64_MAX - bits) - 1;
}

static void axis_state(struct inp_mouse *mouse, struct inp_mouse_axis *axis, struct crt_state *s)
{
    signed_state(&axis->from, s);
    signed_state(&axis->way, s);
    crt_state_u64(s, &axis->done);
    crt_state_u64(s, &axis->free);
    crt_state_u32(s, &axis->count);

    int64_t period = 4 * inp_mouse_pitch(mouse->desc.setup).quarter;
    int64_t most = (int64_t)INP_FURTHEST * 1000000;
    bool sane = axis->from >= 0 && axis->from < period && axis->way >= -most && axis->way <= most &&
                axis->free <= mouse->t1 + SLOWEST && (mouse->moving || axis->way == 0);
    if (!crt_state_check(s, sane, "place of the mouse"))
        axis->from = axis->way = 0;
}

static bool sane_registers(const struct inp_mouse *mouse)
{
    if (mouse->desc.setup->kind == MOUSE_NONE)
        return mouse->status == 0 && mouse->buttons == 0 && !mouse->moving;
    return mouse->status <= (MOUSE_MOVED | MOUSE_OVERRUN);
}

/* No more has been counted than will be crossed. */
static bool sane_counts(const struct inp_mouse *mouse, const struct inp_mouse_axis *axis)
{
    struct inp_mouse_move move = {mouse->t0, mouse->t1};
    struct inp_mouse_pitch pitch = inp_mouse_pitch(mouse->desc.setup);
    if (!mouse->moving || mouse->lifted)
        return axis->done == 0;
    return axis->done <= inp_mouse_crossed(axis, move, pitch, move.t1);
}

void inp_mouse_state(struct inp_mouse *mouse, struct crt_state *s)
{
    crt_state_begin(s, "MOUS", VERSION);
    crt_state_unsigned(s, &mouse->buttons, 7);
    crt_state_u32(s, &mouse->status);
    crt_state_bool(s, &mouse->lifted);
    crt_state_bool(s, &mouse->moving);
    crt_state_u64(s, &mouse->t0);
    crt_state_u64(s, &mouse->t1);
    bool times = mouse->t0 <= mouse->t1 && mouse->t1 < CRT_STATE_LATEST &&
                 (!mouse->moving || mouse->t0 < mouse->t1);
    if (!crt_state_check(s, times, "time of the mouse")) {
        mouse->t0 = mouse->t1 = 0;
        mouse->moving = false;
    }
    for (int i = 0; i < 2; i++)
        axis_state(mouse, &mouse->axis[i], s);
    crt_state_check(s, sane_registers(mouse), "register of the mouse");
    crt_state_check(s, sane_counts(mouse, &mouse->axis[0]) && sane_counts(mouse, &mouse->axis[1]),
                    "count of the mouse");
    crt_state_end(s);
}
