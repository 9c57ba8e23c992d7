/* editor_touch.c — drags and taps. */
#include <stddef.h>

#include "roms/geometry/scalar.h"
#include "roms/spline/editor.h"
#include "roms/spline/menu.h"

enum { REACH = 26, STILL = 6 }; /* of the stylus; what a hand that rests may move; stage units */

static void keep_once(struct editor *e)
{
    if (!e->kept)
        history_keep(&e->history, &e->model);
    e->kept = true;
}

static float apart(struct vector3 a, struct vector3 b)
{
    return vector3_length(vector3_difference(a, b));
}

/* ---- what is there ------------------------------------------------------------------------------- */

static int point_near(const struct editor *e, struct vector3 at)
{
    int best = -1;
    float least = REACH;
    for (int i = 0; i < e->model.count; i++) {
        float d = apart(e->model.point[i].at, at);
        if (d <= least) {
            least = d;
            best = i;
        }
    }
    return best;
}

/* Points come before handles: those of a handle that is short stay within reach. */
static bool handle_near(const struct editor *e, struct vector3 at, int *index, bool *out)
{
    float least = REACH;
    for (int i = 0; i < e->model.count; i++)
        for (int side = 0; side < 2; side++) {
            float d = apart(model_handle(&e->model, i, side), at);
            if (!model_has_handle(&e->model, i, side) || d > least)
                continue;
            least = d;
            *index = i;
            *out = side;
        }
    return least < REACH;
}

static bool slider_near(struct vector3 at)
{
    return at.y < SLIDER_Y + REACH && at.x > SLIDER_LEFT - REACH && at.x < SLIDER_RIGHT + REACH;
}

/* The marked point on the curve can be taken, as the slider can. */
static bool mark_near(const struct editor *e, struct vector3 at)
{
    struct curve c;
    return e->construction && curve_of(&e->model, &c) == NULL &&
           apart(curve_at(&c, curve_t(&c, e->part)).at, at) <= REACH;
}

static float distance_to_leg(struct vector3 a, struct vector3 b, struct vector3 p)
{
    struct vector3 leg = vector3_difference(b, a), to = vector3_difference(p, a);
    float length2 = vector3_dot(leg, leg);
    float part = length2 > 0 ? vector3_dot(to, leg) / length2 : 0;
    part = scalar_min(scalar_max(part, 0), 1);
    return apart(vector3_sum(a, vector3_times(leg, part)), p);
}

/* Between the ends of the leg that is near, or at the end. A closed polygon takes all between. */
static int place_to_add(const struct editor *e, struct vector3 at)
{
    struct vector3 corner[MODEL_POINTS_MOST + 1];
    int corners = model_polygon(&e->model, corner), best = e->model.count;
    float least = corners > e->model.count ? 1e6f : (float)REACH;
    for (int i = 0; i + 1 < corners; i++) {
        float d = distance_to_leg(corner[i], corner[i + 1], at);
        if (d < least) {
            least = d;
            best = i + 1;
        }
    }
    return best;
}

/* ---- hold, drag, let go ------------------------------------------------------------------------ */

static void hold(struct editor *e, enum editor_grip grip, int index, struct vector3 held)
{
    e->grip = grip;
    e->offset = vector3_difference(held, e->at);
    if (grip != GRIP_PART) {
        e->chosen = index;
        e->nudge = grip;
    }
}

static void add(struct editor *e)
{
    int index = place_to_add(e, e->at);
    if (e->model.count == MODEL_POINTS_MOST) {
        e->message = "There is no room for more points.";
        return;
    }
    keep_once(e);
    model_add(&e->model, index, e->at);
    hold(e, GRIP_POINT, index, e->model.point[index].at);
}

static void press(struct editor *e)
{
    int item = menu_item_at(e->at), index = point_near(e, e->at);
    bool out = false;
    e->kept = e->drags = false;
    e->down = e->at;
    e->message = NULL;
    if (item >= 0)
        editor_key(e, menu_key(item));
    else if (index >= 0)
        hold(e, GRIP_POINT, index, e->model.point[index].at);
    else if (handle_near(e, e->at, &index, &out))
        hold(e, out ? GRIP_OUT : GRIP_IN, index, model_handle(&e->model, index, out));
    else if ((e->construction && slider_near(e->at)) || mark_near(e, e->at))
        hold(e, GRIP_PART, -1, e->at);
    else if (e->at.x < MODEL_RIGHT + REACH && e->at.y > SLIDER_Y + REACH)
        add(e);
}

static void drag_part(struct editor *e)
{
    struct curve c;
    float distance;
    if (e->at.y < SLIDER_Y + REACH)
        e->part = (e->at.x - SLIDER_LEFT) / (float)(SLIDER_RIGHT - SLIDER_LEFT);
    else if (curve_of(&e->model, &c) == NULL)
        e->part = curve_nearest(&c, e->at, &distance);
    e->part = scalar_min(scalar_max(e->part, 0), 1);
}

static void drag(struct editor *e)
{
    struct vector3 to = vector3_sum(e->at, e->offset);
    e->drags |= apart(e->at, e->down) > STILL;
    if (!e->drags)
        return;
    switch (e->grip) {
    case GRIP_NONE:
        return;
    case GRIP_PART:
        drag_part(e);
        return;
    case GRIP_POINT:
        keep_once(e);
        model_move(&e->model, e->chosen, to);
        return;
    case GRIP_IN:
    case GRIP_OUT:
        keep_once(e);
        model_move_handle(&e->model, e->chosen, e->grip == GRIP_OUT, to);
        return;
    }
}

void editor_touch(struct editor *e, const struct editor_touch *t)
{
    bool moved = t->at.x != e->at.x || t->at.y != e->at.y;
    e->at = t->at;
    e->near = t->near;
    e->pressed = t->pressed;
    if (t->pressed_now)
        press(e);
    else if (moved && t->pressed)
        drag(e);
    if (t->released_now && !t->pressed)
        e->grip = GRIP_NONE;
    if (t->second && point_near(e, e->at) >= 0) {
        e->chosen = point_near(e, e->at);
        editor_key(e, 'x');
    }
}
