/* show_hands.c — the host's mouse and keys as what a person does at the terminal: acts, which reach the
 * devices at the simulated time at which they come. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "emu/picture.h"
#include "emu/show.h"
#include "emu/side.h"
#include "input/script.h"

#define MOUSE_UM_PER_PIXEL                                                                         \
    250                     /* a quarter of a millimetre of the hand: one pixel of usual monitors */
#define STYLUS_NEAR_UM 5000 /* hovering */

/* ---- acts ---------------------------------------------------------------------------------------
 */

/* At the next whole microsecond, so that a script can say it. */
static uint64_t stamp(const struct vm_machine *m)
{
    return (m->now + CRT_PS_PER_US - 1) / CRT_PS_PER_US * CRT_PS_PER_US;
}

static int32_t um(double mm)
{
    return (int32_t)floor(fmin(fmax(mm * 1000, -INP_FURTHEST), INP_FURTHEST) + 0.5);
}

/* A place in millimetres on another machine's tube. */
static struct inp_act act_on(const struct vm_show *show, int side, struct inp_act act)
{
    if (side == 0 || act.space != INP_MM || (act.device != INP_PEN && act.device != INP_TOUCH))
        return act;
    const struct crt_tube_row *left = &show->program->settings.monitor[act.screen].row;
    const struct crt_tube_row *row = &show->side[side]->settings.monitor[act.screen].row;
    act.x = um((double)act.x / 1000 * row->width.value / left->width.value);
    act.y = um((double)act.y / 1000 * row->height.value / left->height.value);
    return act;
}

void vm_show_do(struct vm_show *show, struct inp_act act)
{
    act.t = stamp(show->program->rig.machine);
    for (int i = 0; i < show->sides; i++) {
        struct vm_rig *rig = &show->side[i]->rig;
        const struct inp_act one = act_on(show, i, act);
        if (!inp_unit_has(&rig->machine->devices, &one))
            continue;
        if (!vm_operator_do(rig->person, &one)) {
            vm_show_say(show, "not enough memory for what you do");
            return;
        }
        show->event_since = show->event_since > 0 ? show->event_since : show->event_time;
    }
}

/* ---- one hand after the other -------------------------------------------------------------------
 */

static void move_pen(struct vm_show *show, const struct vm_spot *spot)
{
    struct inp_act act = {.device = INP_PEN,
                          .verb = spot->on ? INP_MOVE : INP_AWAY,
                          .screen = (uint8_t)(spot->on ? spot->head : show->pen_head),
                          .space = INP_MM,
                          .x = um(spot->x_mm),
                          .y = um(spot->y_mm)};
    if (!spot->on && !show->hand_there)
        return;
    show->pen_head = (enum vm_head)act.screen;
    show->hand_there = spot->on;
    vm_show_do(show, act);
}

/* Where the program takes the place on the screen to be (emu/hand.h). */
static void move_stylus(struct vm_show *show, const struct vm_spot *spot)
{
    const struct inp_tablet_setup *tablet = &show->program->settings.setup.tablet;
    struct inp_act act = {.device = INP_TABLET, .verb = INP_AWAY};
    if (spot->on) {
        const struct crt_tube_row *row = &show->program->settings.monitor[spot->head].row;
        struct vm_hand_picture picture = vm_hand_picture(show->program->input.tablet, spot->head,
                                                         row->width.value, row->height.value);
        double x = spot->x_mm, y = spot->y_mm;
        vm_hand_on_tablet(&picture, tablet, &x, &y);
        act.verb = INP_MOVE;
        act.x = um(x);
        act.y = um(y);
        act.z = show->pressed & 1 ? 0 : STYLUS_NEAR_UM;
    }
    if (!spot->on && !show->hand_there)
        return;
    show->hand_there = spot->on;
    vm_show_do(show, act);
}

/* A finger is on the panel while the button is held. */
static void move_finger(struct vm_show *show, const struct vm_spot *spot)
{
    enum vm_head head = (enum vm_head)show->program->settings.setup.touch.screen;
    bool touches = spot->on && spot->head == head && (show->pressed & 1);
    if (!touches && !show->hand_there)
        return;
    show->hand_there = touches;
    vm_show_do(show, (struct inp_act){.device = INP_TOUCH,
                                      .verb = touches ? INP_MOVE : INP_AWAY,
                                      .screen = (uint8_t)head,
                                      .space = INP_MM,
                                      .x = um(spot->x_mm),
                                      .y = um(spot->y_mm)});
}

static void move_mouse(struct vm_show *show, double x, double y)
{
    double dx = x - show->mouse_x, dy = show->mouse_y - y;
    if (!show->mouse_known || (dx == 0 && dy == 0))
        return;
    vm_show_do(show, (struct inp_act){.device = INP_MOUSE,
                                      .verb = INP_MOVE,
                                      .x = um(dx * MOUSE_UM_PER_PIXEL / 1000),
                                      .y = um(dy * MOUSE_UM_PER_PIXEL / 1000)});
}

static void move(struct vm_show *show, double x, double y)
{
    struct vm_spot spot = vm_show_left_spot(show, vm_show_spot(show, x, y));
    if (show->hand == VM_HAND_PEN)
        move_pen(show, &spot);
    else if (show->hand == VM_HAND_STYLUS)
        move_stylus(show, &spot);
    else if (show->hand == VM_HAND_FINGER)
        move_finger(show, &spot);
    else
        move_mouse(show, x, y);
    show->mouse_x = x;
    show->mouse_y = y;
    show->mouse_known = true;
}

/* Buttons of the host: left, right, middle; of the devices: left or tip, middle, right. */
static void press(struct vm_show *show, int number, bool pressed)
{
    static const uint8_t code[] = {0, 2, 1};
    struct inp_act act = {.verb = pressed ? INP_PRESS : INP_RELEASE,
                          .screen = (uint8_t)show->pen_head};
    if (number > 2)
        return;
    unsigned bit = 1u << code[number];
    show->pressed = pressed ? show->pressed | bit : show->pressed & ~bit;
    act.code = code[number];
    act.device = show->hand == VM_HAND_PEN      ? INP_PEN
                 : show->hand == VM_HAND_STYLUS ? INP_TABLET
                 : show->hand == VM_HAND_MOUSE  ? INP_MOUSE
                                                : INP_TOUCH;
    bool has = show->hand == VM_HAND_PEN ? number == 0 : show->hand != VM_HAND_FINGER;
    if (has && pressed && show->hand == VM_HAND_STYLUS)
        move(show, show->mouse_x, show->mouse_y); /* down to the surface, then the switch */
    if (has)
        vm_show_do(show, act);
    if (show->hand == VM_HAND_FINGER || (show->hand == VM_HAND_STYLUS && !pressed))
        move(show, show->mouse_x, show->mouse_y);
}

/* Whatever it holds it lets go. */
static void let_go(struct vm_show *show)
{
    static const int number[] = {0, 2, 1};
    for (int i = 0; i < 3; i++)
        if (show->pressed >> i & 1)
            press(show, number[i], false);
}

void vm_show_take_away(struct vm_show *show)
{
    static const struct vm_spot nowhere = {0};
    let_go(show);
    if (show->hand == VM_HAND_PEN)
        move_pen(show, &nowhere);
    else if (show->hand == VM_HAND_STYLUS)
        move_stylus(show, &nowhere);
    show->hand_there = show->mouse_known = false;
}

static void take_up(struct vm_show *show, enum vm_hand hand)
{
    show->hand = hand;
    vm_window_show_cursor(show->window, hand != VM_HAND_MOUSE);
}

void vm_show_first_hand(struct vm_show *show)
{
    const struct vm_shown *p = show->program;
    enum vm_hand hand = vm_hand_of_name(p->input.hand);
    if (hand == VM_HANDS)
        hand = p->input.has_firmware ? VM_HAND_STYLUS : VM_HAND_PEN;
    show->pressed = 0;
    show->hand_there = show->mouse_known = false;
    memset(show->held, 0, sizeof show->held);
    show->key_waits = false;
    for (int i = 0; i < VM_HANDS && !vm_hand_present(hand, &p->settings.setup); i++)
        hand = (enum vm_hand)((hand + 1) % VM_HANDS);
    take_up(show, hand);
}

void vm_show_next_hand(struct vm_show *show)
{
    const struct inp_setup *setup = &show->program->settings.setup;
    char text[80];
    enum vm_hand hand = show->hand;
    if (vm_show_scope_let_go(show))
        return;
    for (int i = 0; i < VM_HANDS; i++) {
        hand = (enum vm_hand)((hand + 1) % VM_HANDS);
        if (!vm_hand_present(hand, setup))
            continue;
        vm_show_take_away(show);
        take_up(show, hand);
        snprintf(text, sizeof text, "the mouse is a %s - F9", vm_hand_title(hand));
        vm_show_say(show, text);
        return;
    }
    vm_show_say(show, "no pointing device is connected");
}

bool vm_show_ring(const struct vm_show *show, double *x, double *y, double *radius)
{
    if (show->hand != VM_HAND_PEN || !show->hand_there)
        return false;
    struct vm_spot here = vm_show_spot(show, show->mouse_x, show->mouse_y);
    struct vm_spot beside = vm_show_spot(show, show->mouse_x + 8, show->mouse_y);
    if (!here.on || !beside.on || beside.head != here.head || beside.side != here.side)
        return false;
    double pitch = hypot(beside.x_mm - here.x_mm, beside.y_mm - here.y_mm) / 8;
    *x = show->mouse_x;
    *y = show->mouse_y;
    *radius = pitch > 0 ? show->program->settings.setup.pen.aperture.value / 2 / pitch : 0;
    return *radius > 0;
}

/* ---- knobs --------------------------------------------------------------------------------------
 */

void vm_show_turn(struct vm_show *show, enum vm_head head)
{
    const struct crt_knobs *k = &show->knobs;
    const double value[INP_KNOBS] = {k->brightness, k->contrast, k->focus};
    for (int knob = 0; knob < INP_KNOBS; knob++)
        vm_show_do(show, (struct inp_act){.device = INP_KNOB,
                                          .verb = INP_TURN,
                                          .screen = (uint8_t)head,
                                          .code = (uint8_t)knob,
                                          .x = um(value[knob])});
}

/* ---- events -------------------------------------------------------------------------------------
 */

void vm_show_hand_event(struct vm_show *show, const struct vm_event *event)
{
    show->event_time = event->time;
    if (vm_show_scope_event(show, event))
        return;
    if (event->kind == VM_EVENT_TEXT) {
        vm_show_text_event(show, event->u.text.character);
        return;
    }
    vm_show_key_settle(show);
    switch (event->kind) {
    case VM_EVENT_GUEST_KEY:
    case VM_EVENT_HOST_KEY:
        vm_show_key_event(show, event);
        break;
    case VM_EVENT_MOUSE:
        move(show, event->x, event->y);
        break;
    case VM_EVENT_BUTTON:
        if (event->x != show->mouse_x || event->y != show->mouse_y || !show->mouse_known)
            move(show, event->x, event->y);
        press(show, event->u.button.number, event->u.button.pressed);
        break;
    case VM_EVENT_FOCUS:
        if (!event->u.focus.gained) {
            vm_show_release_keys(show);
            vm_show_take_away(show);
        }
        break;
    default:
        break;
    }
}

void vm_show_hand_flush(struct vm_show *show)
{
    vm_show_key_settle(show);
}
