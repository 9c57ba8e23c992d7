/* pointer.c — reports as they are taken: where the place is, who has it, what was pressed. */
#include "roms/interact/pointer.h"

#include "roms/bsp/interrupts.h"
#include "roms/bsp/video.h"
#include "roms/geometry/scalar.h"
#include "roms/interact/pen_place.h"

#define MOUSE_UNITS  10.0f  /* stage units a millimetre of the hand */
#define MOUSE_SLOW   60.0f  /* mm/s, up to which it is so */
#define MOUSE_FAST   240.0f /* from which it is twice as much */
#define BELIEVED     90.0f  /* stage units between firings of a pen in a hand */
#define BELIEVED_MS  150
#define VECTOR_UNITS 1024.0f

/* For the host's mouse (emu/hand.h): the stage at 640 x 480, 1.6 units a dot; on the vector head. */
extern const char kinescope_tablet[];
const char kinescope_tablet[] = "26 84 970 646  0 171 1024 683";

static struct point2 in_picture(struct point2 at)
{
    return (struct point2){scalar_clamp(at.x, 0, STAGE_WIDTH), scalar_clamp(at.y, 0, STAGE_HEIGHT)};
}

static float apart(struct point2 a, struct point2 b)
{
    return hypotf(a.x - b.x, a.y - b.y);
}

void pointer_open(struct pointer *p, struct stage *stage)
{
    *p = (struct pointer){.at = {STAGE_WIDTH / 2, STAGE_HEIGHT / 2}, .stage = stage};
    p->tablet = tablet_facts();
    p->touch = touch_facts();
    p->mouse_nm = mouse_unit_nm();
    pointer_calibrate(p, pen_usual_dots(), 0);
    pointer_listen(p);
}

void pointer_calibrate(struct pointer *p, float dots, float lines)
{
    p->pen_dots = dots;
    p->pen_lines = lines;
}

/* ---- where a device points ------------------------------------------------------------------- */

static struct point2 tablet_point(const struct pointer *p, const struct pointer_report *r)
{
    float width = (float)p->tablet.width, height = (float)p->tablet.height;
    if (width <= 0 || height <= 0)
        return p->at;
    float units = scalar_max(STAGE_WIDTH / width, STAGE_HEIGHT / height); /* a count */
    return in_picture((struct point2){STAGE_WIDTH / 2 + ((float)r->x - width / 2) * units,
                                      STAGE_HEIGHT / 2 + ((float)r->y - height / 2) * units});
}

/* On the vector head nothing says how large the screen is; the panel covers it, though. */
static struct point2 touch_point(const struct pointer *p, const struct pointer_report *r)
{
    const struct stage *s = p->stage;
    if (p->touch.head == INPUT_RASTER && video_width_um() > 0 && video_height_um() > 0) {
        float x = (float)r->x / (float)video_width_um();
        float y = 1 - (float)r->y / (float)video_height_um();
        return in_picture(stage_from_canvas(s, x * (float)s->page[0].width - 0.5f,
                                            y * (float)s->page[0].height - 0.5f));
    }
    if (p->touch.head == INPUT_RASTER || p->touch.columns == 0 || p->touch.rows == 0)
        return p->at;
    float x = (float)((uint32_t)r->z >> 16) + 1, y = (float)((uint32_t)r->z & 0xFFFF) + 1;
    float ux = x / (2 * (float)p->touch.columns) * VECTOR_UNITS - 0.5f;
    float uy = y / (2 * (float)p->touch.rows) * VECTOR_UNITS - 0.5f;
    return in_picture(stage_from_head(s, ux, uy));
}

static struct point2 mouse_point(const struct pointer *p, const struct pointer_report *r)
{
    float mm = (float)p->mouse_nm * 1e-6f;
    float seconds = scalar_max((float)(r->time - r->since) / TIMER_HZ, 0.001f);
    float speed = hypotf((float)r->x, (float)r->y) * mm / seconds;
    float more = scalar_clamp((speed - MOUSE_SLOW) / (MOUSE_FAST - MOUSE_SLOW), 0, 1);
    float units = MOUSE_UNITS * (1 + more) * mm;
    return in_picture(
        (struct point2){p->at.x + (float)r->x * units, p->at.y + (float)r->y * units});
}

struct point2 pointer_pen_point(const struct pointer *p, float line, float dot)
{
    return in_picture(pen_place(p->stage, p->pen_dots, p->pen_lines, line, dot));
}

/* ---- the raster pen's firings and tip ---------------------------------------------------------- */

static bool within_ms(uint32_t earlier, uint32_t later, uint32_t ms)
{
    return (int32_t)(later - earlier) <= (int32_t)(ms * (TIMER_HZ / 1000));
}

/* Pressed where it sees light it is at once; else that waits. */
static bool tip_report(struct pointer *p, struct pointer_report *r)
{
    bool sees = p->pen_sees && within_ms(p->pen_seen, r->time, POINTER_FRESH_MS);
    p->pen_tip = r->pressed;
    if (r->pressed && !sees) {
        p->pen_waits = true;
        p->pen_pushed = r->time;
    }
    p->pen_tap = p->pen_waits && !r->pressed;
    r->place = p->pen_place;
    r->x = p->pen_said[0];
    r->y = p->pen_said[1];
    r->z = p->pen_said[2];
    return r->pressed ? sees : p->seen[POINTER_PEN].pressed;
}

static bool firing_report(struct pointer *p, struct pointer_report *r)
{
    bool follows = p->pen_fired && within_ms(p->pen_time, r->time, BELIEVED_MS) &&
                   apart(r->place, p->pen_at) <= BELIEVED;
    p->pen_at = r->place;
    p->pen_time = r->time;
    p->pen_fired = true;
    if (!follows && !r->sure)
        return false;
    p->pen_place = r->place;
    p->pen_said[0] = r->x;
    p->pen_said[1] = r->y;
    p->pen_said[2] = r->z;
    p->pen_seen = r->time;
    p->pen_sees = true;
    if (p->pen_tap && !within_ms(p->pen_pushed, r->time, POINTER_PATIENCE_MS))
        p->pen_waits = p->pen_tap = false;
    r->pressed = p->pen_waits || (p->seen[POINTER_PEN].pressed && p->pen_tip);
    return true;
}

/* A pen that has been taken away says nothing. */
static bool pen_gone(struct pointer *p)
{
    struct pointer_seen *seen = &p->seen[POINTER_PEN];
    if (!seen->near || within_ms(p->pen_seen, (uint32_t)timer_now(), 2 * POINTER_FRESH_MS))
        return false;
    seen->near = false;
    if (p->device != POINTER_PEN || p->report.tracked || !p->near)
        return false;
    p->near = false;
    return true;
}

/* ---- who has the pointer ----------------------------------------------------------------------- */

static void press(struct pointer *p, bool pressed)
{
    if (pressed && !p->pressed) {
        p->pressed_now = true;
        p->pressed_at = p->at;
    }
    if (!pressed && p->pressed) {
        p->released_now = true;
        p->released_at = p->at;
    }
    p->pressed = pressed;
}

static bool takes_over(const struct pointer *p, const struct pointer_report *r,
                       const struct pointer_seen *seen)
{
    if (r->pressed && !seen->pressed)
        return true;
    if (p->pressed || !r->near || !r->placed)
        return false;
    return r->device == POINTER_MOUSE || !seen->near || apart(r->place, seen->at) >= POINTER_MOVED;
}

static struct point2 place_of(const struct pointer *p, const struct pointer_report *r,
                              const struct pointer_seen *seen)
{
    if (r->tracked || r->device == POINTER_PEN)
        return r->place;
    if (r->device == POINTER_MOUSE)
        return mouse_point(p, r);
    if (!r->placed)
        return seen->at;
    return r->device == POINTER_TABLET ? tablet_point(p, r) : touch_point(p, r);
}

static unsigned source_of(const struct pointer_report *r)
{
    return r->tracked ? POINTER_TRACKED : r->device;
}

/* A report whose place is known. False: it waits until it is told that the device before is released. */
static bool take(struct pointer *p, struct pointer_report *r)
{
    struct pointer_seen *seen = &p->seen[source_of(r)];
    bool has = p->device == r->device && p->report.tracked == r->tracked;
    r->place = place_of(p, r, seen);
    if (!r->placed && r->device == POINTER_TOUCH && !seen->pressed)
        r->pressed = r->near = false; /* it cannot come without a place */
    if (!has && takes_over(p, r, seen)) {
        if (p->pressed) {
            press(p, false);
            return false;
        }
        has = true;
    }
    seen->near = r->near;
    seen->pressed = r->pressed;
    if (!has)
        return true;
    seen->at = p->at = r->place;
    p->device = r->device;
    p->near = r->near;
    p->buttons = r->buttons & ~1u;
    press(p, r->pressed);
    p->report = *r;
    return true;
}

/* The tap of a pen that saw nothing until now: pressed and let go. */
static void end_tap(struct pointer *p)
{
    if (p->device == POINTER_PEN && p->pen_tap && p->pressed) {
        press(p, false);
        p->seen[POINTER_PEN].pressed = p->report.pressed = false;
    }
    p->pen_waits = p->pen_tap = false;
}

static bool take_oldest(struct pointer *p)
{
    struct pointer_report r = p->queue[p->taken % POINTER_QUEUE];
    bool raster_pen = r.device == POINTER_PEN && !r.tracked, says = true;
    if (raster_pen)
        says = r.placed ? firing_report(p, &r) : tip_report(p, &r);
    p->lost |= r.lost;
    if (says && !take(p, &r))
        return false;
    if (says && raster_pen && r.pressed)
        end_tap(p);
    if (r.device == POINTER_MOUSE) {
        p->mouse_x += r.x;
        p->mouse_y += r.y;
    }
    p->taken++;
    return true;
}

/* ---- polling ----------------------------------------------------------------------------------- */

static void begin(struct pointer *p)
{
    uint32_t state = irq_lock();
    pointer_settle(p);
    p->pressed_now = p->released_now = false;
    p->lost = p->overflow;
    p->overflow = false;
    irq_unlock(state);
}

/* The oldest may be a press: not in this poll, when it has had one already, or a release. */
static bool waits_for_next(const struct pointer *p)
{
    const struct pointer_report *r = &p->queue[p->taken % POINTER_QUEUE];
    bool may_press = r->pressed || (r->device == POINTER_PEN && p->pen_waits);
    return (p->pressed_now || p->released_now) && may_press &&
           !(p->pressed && p->device == r->device);
}

static bool take_next(struct pointer *p)
{
    uint32_t state = irq_lock();
    bool taken = p->put != p->taken && !waits_for_next(p) && take_oldest(p);
    irq_unlock(state);
    return taken;
}

/* Between reports interrupts come in: a pen fires in each row. What comes while a queue of them is taken is
 * the next poll's, so that polls end. */
bool pointer_poll(struct pointer *p)
{
    begin(p);
    bool changed = p->lost;
    for (int i = 0; i < POINTER_QUEUE && take_next(p); i++)
        changed = true;
    return pen_gone(p) || changed || p->released_now;
}

bool pointer_next(struct pointer *p)
{
    begin(p);
    uint32_t state = irq_lock();
    bool any = p->put != p->taken;
    if (any)
        take_oldest(p);
    irq_unlock(state);
    return pen_gone(p) || any;
}

void pointer_pen_place(struct pointer *p, struct point2 at, bool near, bool pressed)
{
    struct pointer_report r = {.device = POINTER_PEN,
                               .placed = near,
                               .near = near,
                               .pressed = pressed,
                               .tracked = true,
                               .place = at,
                               .time = (uint32_t)timer_now()};
    pointer_push(p, &r);
}
