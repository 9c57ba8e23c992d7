/* Acts of a script in order of time, and what keys make then. */
#include <stdlib.h>
#include <string.h>

#include "input/keyboard.h"
#include "input/script_parts.h"

static bool in_order(const struct inp_act *act, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (act[i].t < act[i - 1].t)
            return false;
    return true;
}

/* Two parts that are in order, one after the other, to one at `to`; of equal times the first part's first. */
static void merge(struct inp_act *to, const struct inp_act *from, size_t middle, size_t count)
{
    size_t a = 0, b = middle;
    for (size_t i = 0; i < count; i++)
        to[i] = b == count || (a < middle && from[a].t <= from[b].t) ? from[a++] : from[b++];
}

/* Merge sort from runs of one act up. */
static bool sort(struct inp_act *act, size_t count)
{
    struct inp_act *other = malloc(count * sizeof *other), *from = act, *to = other;
    if (!other)
        return false;
    for (size_t run = 1; run < count; run *= 2) {
        for (size_t i = 0; i < count; i += 2 * run) {
            size_t left = count - i, middle = run < left ? run : left;
            merge(to + i, from + i, middle, 2 * run < left ? 2 * run : left);
        }
        struct inp_act *swap = from;
        from = to;
        to = swap;
    }
    if (from != act)
        memcpy(act, from, count * sizeof *act);
    free(other);
    return true;
}

/* Keys that change what others make. */
struct held {
    bool shift, control, alt, caps;
};

static void follow(struct held *held, const struct inp_act *act)
{
    bool down = act->verb == INP_PRESS;
    if (act->code == KEYCODE_SHIFT)
        held->shift = down;
    if (act->code == KEYCODE_CONTROL)
        held->control = down;
    if (act->code == KEYCODE_ALT)
        held->alt = down;
    if (act->code == KEYCODE_CAPS_LOCK && down)
        held->caps = !held->caps;
}

static unsigned modifiers(const struct held *held)
{
    return (held->shift ? KEYMOD_SHIFT : 0u) | (held->control ? KEYMOD_CONTROL : 0u) |
           (held->alt ? KEYMOD_ALT : 0u) | (held->caps ? KEYMOD_CAPS : 0u);
}

bool inp_script_order(struct inp_script *script)
{
    struct held held = {.shift = false};
    if (!in_order(script->act, script->count) && !sort(script->act, script->count))
        return false;
    for (size_t i = 0; i < script->count; i++) {
        struct inp_act *act = &script->act[i];
        if (act->device != INP_KEYBOARD)
            continue;
        follow(&held, act);
        if (act->z == INP_MAKES_OWN) {
            act->z = 0;
            act->character = inp_key_us(act->code, modifiers(&held));
        }
    }
    return true;
}
