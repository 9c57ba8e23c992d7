/* Statements of a script: pen, tablet, touch, mouse, knob. */
#include "input/script_parts.h"

#define MS   UINT64_C(1000000000)
#define TAP  (80 * MS) /* of a pen, a stylus, a finger, a button, where nothing else is said */
#define NEAR 5000      /* thousandths of a mm: a stylus that is held above the surface */

const char *const inp_screen_names[INP_SCREENS + 1] = {"vector", "raster", NULL};
const char *const inp_mouse_names[4] = {"left", "middle", "right", NULL};
const char *const inp_knob_names[INP_KNOBS + 1] = {"brightness", "contrast", "focus", NULL};

void inp_knob_range(unsigned knob, int32_t *low, int32_t *high)
{
    *low = knob == INP_BRIGHTNESS ? -1000 : 0;
    *high = knob == INP_BRIGHTNESS ? 1000 : 4000;
}

/* ---- parts of statements ------------------------------------------------------------------------- */

/* [vector|raster]: the screen of this device, as long as none else is named. */
static bool take_screen(struct inp_reader *r, enum inp_device device, uint8_t *screen)
{
    for (unsigned i = 0; inp_screen_names[i]; i++)
        if (inp_word_is(r, inp_screen_names[i])) {
            r->screen[device] = (uint8_t)i;
            *screen = (uint8_t)i;
            return inp_word_next(r);
        }
    *screen = r->screen[device];
    return true;
}

static bool take_coordinate(struct inp_reader *r, const char *what, int32_t *value)
{
    return inp_word_thousandths(r, what, -INP_FURTHEST, INP_FURTHEST, value);
}

static bool take_xy(struct inp_reader *r, struct inp_act *act)
{
    return take_coordinate(r, "a coordinate x", &act->x) &&
           take_coordinate(r, "a coordinate y", &act->y);
}

/* [mm] of what lies on a screen. */
static bool take_space(struct inp_reader *r, struct inp_act *act)
{
    bool mm;
    if (!inp_word_take(r, "mm", &mm))
        return false;
    act->space = mm ? INP_MM : INP_UNITS;
    return true;
}

/* [mm], which means nothing. */
static bool take_mm(struct inp_reader *r)
{
    bool mm;
    return inp_word_take(r, "mm", &mm);
}

static bool add_verb(struct inp_reader *r, struct inp_act act, enum inp_verb verb, uint64_t after)
{
    act.verb = (uint8_t)verb;
    return inp_script_add(r, act, after);
}

/* Pressed now and released after [in T]. */
static bool take_tap(struct inp_reader *r, struct inp_act act)
{
    uint64_t held;
    return inp_script_in(r, TAP, &held) && add_verb(r, act, INP_PRESS, 0) &&
           add_verb(r, act, INP_RELEASE, held);
}

/* [in T], and the move. */
static bool take_move(struct inp_reader *r, struct inp_act act)
{
    return inp_script_in(r, 0, &act.duration) && add_verb(r, act, INP_MOVE, 0);
}

/* ---- pen --------------------------------------------------------------------------------------- */

bool inp_script_pen(struct inp_reader *r)
{
    static const char *const words[] = {"move", "down", "up", "tap", "away", NULL};
    struct inp_act act = {.device = INP_PEN};
    unsigned which;
    if (!take_screen(r, INP_PEN, &act.screen) ||
        !inp_word_choose(r, "something a pen does", words, &which))
        return false;
    switch (which) {
    case 0:
        return take_xy(r, &act) && take_space(r, &act) && take_move(r, act);
    case 1:
        return add_verb(r, act, INP_PRESS, 0);
    case 2:
        return add_verb(r, act, INP_RELEASE, 0);
    case 3:
        return take_tap(r, act);
    default:
        return add_verb(r, act, INP_AWAY, 0);
    }
}

/* ---- tablet ------------------------------------------------------------------------------------ */

/* X Y [Z] [mm] [in T]: above the surface, button 0 not pressed. */
static bool tablet_near(struct inp_reader *r, struct inp_act act)
{
    act.z = NEAR;
    if (!take_xy(r, &act) || (inp_word_is_number(r) && !take_coordinate(r, "a height z", &act.z)) ||
        !take_mm(r))
        return false;
    if (r->tip && !add_verb(r, (struct inp_act){.device = INP_TABLET}, INP_RELEASE, 0))
        return false;
    r->tip = false;
    return take_move(r, act);
}

/* X Y [mm] [in T]: on the surface; there button 0 is pressed, if it is not already. */
static bool tablet_touch(struct inp_reader *r, struct inp_act act)
{
    if (!take_xy(r, &act) || !take_mm(r) || !take_move(r, act))
        return false;
    if (!r->tip &&
        !add_verb(r, (struct inp_act){.device = INP_TABLET}, INP_PRESS, r->ended - r->begin))
        return false;
    r->tip = true;
    return true;
}

static bool tablet_button(struct inp_reader *r, struct inp_act act, enum inp_verb verb)
{
    unsigned button = 0;
    if (!inp_word_whole(r, "a button", INP_TABLET_BUTTONS - 1, &button))
        return false;
    act.code = (uint8_t)button;
    if (button == 0)
        r->tip = verb == INP_PRESS;
    return add_verb(r, act, verb, 0);
}

static bool tablet_tap(struct inp_reader *r, struct inp_act act)
{
    r->tip = false;
    return take_tap(r, act);
}

static bool tablet_move(struct inp_reader *r, struct inp_act act)
{
    return take_xy(r, &act) && take_coordinate(r, "a height z", &act.z) && take_mm(r) &&
           take_move(r, act);
}

bool inp_script_tablet(struct inp_reader *r)
{
    static const char *const words[] = {"near",    "touch", "move", "press",
                                        "release", "tap",   "away", NULL};
    struct inp_act act = {.device = INP_TABLET};
    unsigned which;
    if (!inp_word_choose(r, "something done on a tablet", words, &which))
        return false;
    switch (which) {
    case 0:
        return tablet_near(r, act);
    case 1:
        return tablet_touch(r, act);
    case 2:
        return tablet_move(r, act);
    case 3:
        return tablet_button(r, act, INP_PRESS);
    case 4:
        return tablet_button(r, act, INP_RELEASE);
    case 5:
        return tablet_tap(r, act);
    default:
        return add_verb(r, act, INP_AWAY, 0);
    }
}

/* ---- touch panel ------------------------------------------------------------------------------- */

/* X Y [mm] [force N] */
static bool take_finger(struct inp_reader *r, struct inp_act *act)
{
    bool force;
    return take_xy(r, act) && take_space(r, act) && inp_word_take(r, "force", &force) &&
           (!force || inp_word_thousandths(r, "a force in newtons", 1, INP_FORCE_MOST, &act->z));
}

/* There at once, away after [in T]. */
static bool touch_tap(struct inp_reader *r, struct inp_act act)
{
    uint64_t held;
    struct inp_act away = act;
    return take_finger(r, &act) && inp_script_in(r, TAP, &held) && add_verb(r, act, INP_MOVE, 0) &&
           add_verb(r, away, INP_AWAY, held);
}

bool inp_script_touch(struct inp_reader *r)
{
    static const char *const words[] = {"up", "tap", "X Y", NULL};
    struct inp_act act = {.device = INP_TOUCH};
    unsigned which;
    if (!take_screen(r, INP_TOUCH, &act.screen))
        return false;
    if (inp_word_is_number(r))
        return take_finger(r, &act) && take_move(r, act);
    if (!inp_word_choose(r, "something a finger does", words, &which))
        return false;
    return which == 0 ? add_verb(r, act, INP_AWAY, 0) : touch_tap(r, act);
}

/* ---- mouse ------------------------------------------------------------------------------------- */

static bool mouse_button(struct inp_reader *r, struct inp_act *act)
{
    unsigned button = 0;
    bool ok = inp_word_choose(r, "a button", inp_mouse_names, &button);
    act->code = (uint8_t)button;
    return ok;
}

bool inp_script_mouse(struct inp_reader *r)
{
    static const char *const words[] = {"move", "press", "release", "click", "lift", "drop", NULL};
    struct inp_act act = {.device = INP_MOUSE};
    unsigned which;
    if (!inp_word_choose(r, "something done with a mouse", words, &which))
        return false;
    switch (which) {
    case 0:
        return take_xy(r, &act) && take_mm(r) && take_move(r, act);
    case 1:
        return mouse_button(r, &act) && add_verb(r, act, INP_PRESS, 0);
    case 2:
        return mouse_button(r, &act) && add_verb(r, act, INP_RELEASE, 0);
    case 3:
        return mouse_button(r, &act) && take_tap(r, act);
    case 4:
        return add_verb(r, act, INP_AWAY, 0);
    default:
        return add_verb(r, act, INP_BACK, 0);
    }
}

/* ---- knobs ------------------------------------------------------------------------------------- */

bool inp_script_knob(struct inp_reader *r)
{
    struct inp_act act = {.device = INP_KNOB, .verb = INP_TURN};
    unsigned screen = 0, knob = 0;
    int32_t low, high;
    if (!inp_word_choose(r, "a screen", inp_screen_names, &screen) ||
        !inp_word_choose(r, "a knob", inp_knob_names, &knob))
        return false;
    act.screen = (uint8_t)screen;
    act.code = (uint8_t)knob;
    inp_knob_range(knob, &low, &high);
    return inp_word_thousandths(r, inp_knob_names[knob], low, high, &act.x) &&
           inp_script_add(r, act, 0);
}
