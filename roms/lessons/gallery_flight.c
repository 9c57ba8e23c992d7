/* gallery_flight.c — a flight simulator: one flies it, or the autopilot shows how.
 *
 * The model and its equations: flight_model.h. The autopilot: flight_pilot.h.
 */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/flight_panel.h"
#include "roms/lessons/flight_pilot.h"
#include "roms/lessons/flight_view.h"
#include "roms/lessons/lesson.h"

enum { BEGIN_BEFORE = 1100, CRASHED_FOR = 6 };

struct state {
    struct flight flight;
    struct pilot pilot;
    bool automatic;
    float last; /* when it was drawn last */
    float owed; /* time that the model is behind */
    float over; /* seconds since the crash */
};

static void start(struct state *s)
{
    flight_on_approach(&s->flight, BEGIN_BEFORE, 25);
    pilot_takes_over(&s->pilot, &s->flight);
    s->automatic = true;
    s->over = 0;
}

static void begin(void *ctx)
{
    struct state *s = ctx;
    *s = (struct state){.automatic = true};
    start(s);
}

/* The stick from where the aircraft is, so that it does not jump. */
static void take_over(struct state *s)
{
    if (s->automatic) {
        s->flight.stick.pitch = s->flight.pitch;
        s->flight.stick.brakes = false;
    }
    s->automatic = false;
}

static bool move_stick(struct flight_stick *k, int key)
{
    const float nose = 1.5f * DEGREE, wing = 5 * DEGREE;
    switch (key) {
    case KEY_UP:
        k->pitch = scalar_clamp(k->pitch + nose, -0.4f, 0.45f);
        return true;
    case KEY_DOWN:
        k->pitch = scalar_clamp(k->pitch - nose, -0.4f, 0.45f);
        return true;
    case KEY_LEFT:
        k->bank = scalar_clamp(k->bank - wing, -1, 1);
        return true;
    case KEY_RIGHT:
        k->bank = scalar_clamp(k->bank + wing, -1, 1);
        return true;
    case '+':
    case '=':
        k->throttle = scalar_clamp(k->throttle + 0.1f, 0, 1);
        return true;
    case '-':
        k->throttle = scalar_clamp(k->throttle - 0.1f, 0, 1);
        return true;
    case 'b':
        k->brakes = !k->brakes;
        return true;
    default:
        return false;
    }
}

static void key(void *ctx, int k)
{
    struct state *s = ctx;
    struct flight_stick stick = s->flight.stick;
    if (k == 'r') {
        start(s);
    } else if (k == ' ') {
        s->automatic = true;
        pilot_takes_over(&s->pilot, &s->flight);
    } else if (move_stick(&stick, k)) {
        take_over(s);
        move_stick(&s->flight.stick, k);
    }
}

/* The model up to now, step by step. */
static void advance(struct state *s, float seconds)
{
    const float most = 0.5f;
    struct flight *f = &s->flight;
    s->owed = fminf(s->owed + seconds - s->last, most);
    if (f->phase == FLIGHT_CRASHED && (s->over += seconds - s->last) > CRASHED_FOR)
        start(s);
    s->last = seconds;
    for (; s->owed >= FLIGHT_STEP; s->owed -= FLIGHT_STEP) {
        if (s->automatic && f->phase != FLIGHT_CRASHED)
            pilot_flies(&s->pilot, f);
        flight_step(f);
        if (flight_view_hit(f))
            f->phase = FLIGHT_CRASHED;
    }
}

static void say(const struct state *s, char *text, size_t room)
{
    const struct flight *f = &s->flight;
    if (f->phase == FLIGHT_CRASHED)
        snprintf(text, room, "Crashed. A landing wants a sink rate below 3 m/s and level wings");
    else if (s->automatic)
        snprintf(text, room, "Autopilot %s. Take the stick: you fly", pilot_says(&s->pilot));
    else if (f->phase == FLIGHT_ROLLING && f->speed < 0.5f)
        snprintf(text, room,
                 "Stopped; touched down at %.1f m/s. + + + power, then nose up at 28 m/s",
                 (double)f->touch);
    else if (f->phase == FLIGHT_ROLLING)
        snprintf(text, room, "%s. b: brakes; nose up from 28 m/s to take off",
                 flight_over_runway(f) ? "On the runway" : "On the grass");
    else
        snprintf(text, room, "You fly. Two white and two red lights: on the glide path");
}

static float draw(void *ctx, struct stage *stage, float seconds)
{
    struct state *s = ctx;
    char text[96];
    advance(s, seconds);
    flight_view(stage, &s->flight);
    flight_panel(stage, &s->flight);
    stage_ink(stage, INK_RED);
    if (s->flight.phase == FLIGHT_CRASHED)
        stage_text_middle(stage, STAGE_WIDTH / 2, 600, "C R A S H");
    else if (s->flight.stalled)
        stage_text_middle(stage, STAGE_WIDTH / 2, 600, "S T A L L");
    say(s, text, sizeof text);
    stage_title(stage, "Flight simulator");
    stage_caption(stage, text);
    return 0;
}

static struct state state;

extern const struct lesson lesson_gallery_flight;
const struct lesson lesson_gallery_flight = {
    "flight",
    "Gallery: flight simulator",
    "arrows stick  + - power  b brakes  r again  space autopilot",
    &state,
    begin,
    key,
    draw};
