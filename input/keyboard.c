#include "input/keyboard.h"

#include <math.h>
#include <string.h>

#include "crt/ticks.h"

void inp_keyboard_init(struct inp_keyboard *keyboard, const struct inp_keyboard_desc *desc)
{
    *keyboard = (struct inp_keyboard){.desc = *desc};
    inp_keyboard_reset(keyboard, 0);
}

void inp_keyboard_reset(struct inp_keyboard *keyboard, uint64_t t)
{
    (void)t;
    keyboard->status = 0;
    keyboard->control = KEY_CONSOLE;
    keyboard->caps = false;
    keyboard->repeating = keyboard->character = 0;
    keyboard->repeat_from = keyboard->repeats = 0;
    keyboard->missed = 0;
    keyboard->first = keyboard->waiting = 0;
    memset(keyboard->store, 0, sizeof keyboard->store);
}

/* ---- keys held --------------------------------------------------------------------------------- */

static bool is_held(const struct inp_keyboard *k, uint8_t code)
{
    return k->held[code / 32] >> code % 32 & 1;
}

static void hold(struct inp_keyboard *k, uint8_t code, bool down)
{
    uint32_t bit = UINT32_C(1) << code % 32;
    k->held[code / 32] = down ? k->held[code / 32] | bit : k->held[code / 32] & ~bit;
}

static unsigned modifiers(const struct inp_keyboard *k)
{
    return (is_held(k, KEYCODE_SHIFT) ? KEYMOD_SHIFT : 0u) |
           (is_held(k, KEYCODE_CONTROL) ? KEYMOD_CONTROL : 0u) |
           (is_held(k, KEYCODE_ALT) ? KEYMOD_ALT : 0u) | (k->caps ? KEYMOD_CAPS : 0u);
}

/* ---- events ------------------------------------------------------------------------------------ */

/* True: it was stored. */
static bool happen(struct inp_keyboard *k, uint8_t code, uint8_t character, uint32_t how)
{
    if (!(k->control & KEY_STORE))
        return false;
    if (k->waiting == KEY_EVENTS_MOST) {
        k->status |= KEY_LOST;
        k->missed++;
        return false;
    }
    k->store[(k->first + k->waiting) % KEY_EVENTS_MOST] =
        KEY_VALID | how | (uint32_t)modifiers(k) << 16 | (uint32_t)code << 8 | character;
    k->waiting++;
    return true;
}

static void send(struct inp_keyboard *k, uint8_t code, uint8_t character, uint64_t t)
{
    char bytes[8];
    if (!(k->control & KEY_CONSOLE) || !k->desc.send)
        return;
    size_t length = inp_key_sent(code, character, modifiers(k), bytes);
    if (length > 0 && !k->desc.send(k->desc.ctx, bytes, length, t)) {
        k->status |= KEY_LOST;
        k->missed++;
    }
}

/* ---- repeat ------------------------------------------------------------------------------------ */

/* Millionths of a hertz are whole, so that times are exact. */
static struct crt_rate repeat_rate(const struct inp_keyboard *k)
{
    return (struct crt_rate){(uint64_t)floor(k->desc.setup->repeat_rate.value * 1e6 + 0.5),
                             1000000};
}

static bool is_modifier(uint8_t code)
{
    return code >= KEYCODE_SHIFT && code <= KEYCODE_SUPER;
}

static bool repeats(const struct inp_keyboard *k, uint8_t code)
{
    return code && !is_modifier(code) && code != KEYCODE_ESCAPE && code != KEYCODE_TAB &&
           code != KEYCODE_ENTER && code != KEYCODE_PAD_ENTER && !is_held(k, KEYCODE_CONTROL);
}

/* A press of the key: it repeats from now on, or nothing does. */
static void begin_repeat(struct inp_keyboard *k, uint8_t code, uint8_t character, uint64_t t)
{
    if (is_modifier(code) && code != KEYCODE_CONTROL)
        return;
    k->repeating = repeats(k, code) ? code : 0;
    k->character = k->repeating ? character : 0;
    k->repeat_from = k->repeats = 0;
    if (k->repeating)
        k->repeat_from = t + (uint64_t)floor(k->desc.setup->repeat_after.value * 1e6 + 0.5);
}

static void end_repeat(struct inp_keyboard *k)
{
    k->repeating = k->character = 0;
    k->repeat_from = k->repeats = 0;
}

uint64_t inp_keyboard_next(const struct inp_keyboard *keyboard)
{
    if (!keyboard->repeating)
        return UINT64_MAX;
    return keyboard->repeat_from + crt_tick_time(repeat_rate(keyboard), keyboard->repeats);
}

bool inp_keyboard_event(struct inp_keyboard *keyboard, uint64_t t)
{
    if (!keyboard->repeating || t < inp_keyboard_next(keyboard))
        return false;
    uint8_t code = keyboard->repeating, character = keyboard->character;
    keyboard->repeats = crt_tick_at(repeat_rate(keyboard), t - keyboard->repeat_from) + 1;
    send(keyboard, code, character, t);
    return happen(keyboard, code, inp_key_makes(code, character, modifiers(keyboard)), KEY_REPEAT);
}

/* ---- acts -------------------------------------------------------------------------------------- */

static void press(struct inp_keyboard *k, uint8_t code, uint8_t character, uint64_t t)
{
    if (is_held(k, code) || (!code && !character))
        return;
    if (code)
        hold(k, code, true);
    if (code == KEYCODE_CAPS_LOCK)
        k->caps = !k->caps;
    begin_repeat(k, code, character, t);
    uint8_t made = inp_key_makes(code, character, modifiers(k));
    send(k, code, character, t);
    if (code || made)
        happen(k, code, made, 0);
}

static void release(struct inp_keyboard *k, uint8_t code)
{
    if (!is_held(k, code))
        return;
    hold(k, code, false);
    if (code == k->repeating)
        end_repeat(k);
    happen(k, code, 0, KEY_UP);
}

void inp_keyboard_act(struct inp_keyboard *keyboard, const struct inp_act *act, uint64_t t)
{
    if (act->verb == INP_PRESS)
        press(keyboard, act->code, act->character, t);
    else if (act->verb == INP_RELEASE)
        release(keyboard, act->code);
}

/* ---- registers --------------------------------------------------------------------------------- */

static uint32_t take(struct inp_keyboard *k)
{
    if (k->waiting == 0)
        return 0;
    uint32_t event = k->store[k->first];
    k->store[k->first] = 0;
    k->first = (k->first + 1) % KEY_EVENTS_MOST;
    k->waiting--;
    return event;
}

bool inp_keyboard_ready(const struct inp_keyboard *keyboard)
{
    return keyboard->waiting > 0;
}

bool inp_keyboard_read(struct inp_keyboard *keyboard, uint32_t offset, uint32_t *value)
{
    switch (offset) {
    case INPUT_KEY_STATUS:
        *value = keyboard->status | (inp_keyboard_ready(keyboard) ? KEY_READY : 0u);
        return true;
    case INPUT_KEY_EVENT:
        *value = take(keyboard);
        return true;
    case INPUT_KEY_CONTROL:
        *value = keyboard->control;
        return true;
    case INPUT_KEY_WAITING:
        *value = keyboard->waiting;
        return true;
    case INPUT_KEY_MISSED:
        *value = keyboard->missed;
        return true;
    default:
        return false;
    }
}

bool inp_keyboard_write(struct inp_keyboard *keyboard, uint32_t offset, uint32_t value, uint64_t t)
{
    (void)t;
    switch (offset) {
    case INPUT_KEY_STATUS:
        keyboard->status &= ~(value & KEY_LOST);
        return true;
    case INPUT_KEY_CONTROL:
        keyboard->control = value & (KEY_CONSOLE | KEY_STORE);
        return true;
    case INPUT_KEY_EVENT: /* read only */
    case INPUT_KEY_WAITING:
    case INPUT_KEY_MISSED:
        return true;
    default:
        return false;
    }
}

/* ---- snapshot ---------------------------------------------------------------------------------- */

#define VERSION 1

static void held_state(struct inp_keyboard *k, struct crt_state *s)
{
    for (size_t i = 0; i < sizeof k->held / sizeof *k->held; i++)
        crt_state_u32(s, &k->held[i]);
    crt_state_bool(s, &k->caps);
    if (!crt_state_check(s, !is_held(k, 0), "held key"))
        memset(k->held, 0, sizeof k->held);
}

static void repeat_state(struct inp_keyboard *k, struct crt_state *s)
{
    crt_state_u8(s, &k->repeating);
    crt_state_u8(s, &k->character);
    crt_state_u64(s, &k->repeat_from);
    crt_state_u64(s, &k->repeats);
    bool rest = !k->character && !k->repeat_from && !k->repeats;
    bool possible = k->repeating ? is_held(k, k->repeating) && repeats(k, k->repeating) : rest;
    bool in_time = k->repeat_from < CRT_STATE_LATEST &&
                   k->repeats <= crt_tick_at(repeat_rate(k), CRT_STATE_LATEST);
    if (!crt_state_check(s, possible && in_time, "key that repeats"))
        end_repeat(k);
}

static bool sane_event(uint32_t event)
{
    const uint32_t bits =
        KEY_VALID | KEY_REPEAT | KEY_UP | KEY_MODIFIERS | KEY_CODE | (KEY_ASCII >> 1);
    return event & KEY_VALID && !(event & ~bits);
}

/* Those that wait, the oldest first: where they lie in the ring means nothing. */
static void store_state(struct inp_keyboard *k, struct crt_state *s)
{
    unsigned waiting = k->waiting;
    crt_state_unsigned(s, &waiting, KEY_EVENTS_MOST);
    if (s->loading) {
        memset(k->store, 0, sizeof k->store);
        k->first = 0;
        k->waiting = s->failed ? 0 : waiting;
    }
    bool sane = true;
    for (unsigned i = 0; i < k->waiting; i++) {
        uint32_t *event = &k->store[(k->first + i) % KEY_EVENTS_MOST];
        crt_state_u32(s, event);
        sane = sane && sane_event(*event);
    }
    if (!crt_state_check(s, sane, "key event") && s->loading)
        k->waiting = 0;
}

void inp_keyboard_state(struct inp_keyboard *keyboard, struct crt_state *s)
{
    crt_state_begin(s, "KEYB", VERSION);
    crt_state_u32(s, &keyboard->status);
    crt_state_u32(s, &keyboard->control);
    crt_state_u32(s, &keyboard->missed);
    if (!crt_state_check(s,
                         !(keyboard->status & ~(uint32_t)KEY_LOST) &&
                             !(keyboard->control & ~(uint32_t)(KEY_CONSOLE | KEY_STORE)),
                         "keyboard register"))
        keyboard->status = keyboard->control = 0;
    held_state(keyboard, s);
    repeat_state(keyboard, s);
    store_state(keyboard, s);
    crt_state_end(s);
}
