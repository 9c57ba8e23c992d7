/* editor.c — keys. */
#include "roms/spline/editor.h"

#include <stddef.h>

#include "roms/geometry/scalar.h"

enum { NUDGE = 4 }; /* of an arrow key, stage units */

void editor_begin(struct editor *e)
{
    *e = (struct editor){
        .polygon = true, .construction = true, .part = 0.4f, .chosen = -1, .nudge = GRIP_POINT};
    model_example(&e->model);
}

static void keep(struct editor *e)
{
    history_keep(&e->history, &e->model);
}

/* After a model that may have fewer points. */
static void settle(struct editor *e)
{
    e->grip = GRIP_NONE;
    if (e->chosen >= e->model.count)
        e->chosen = e->model.count - 1;
}

void editor_take(struct editor *e, const struct model *model)
{
    keep(e);
    e->model = *model;
    e->chosen = -1;
    settle(e);
}

/* ---- what the curve is --------------------------------------------------------------------------- */

static void set_kind(struct editor *e, enum model_kind kind)
{
    if (e->model.kind == kind)
        return;
    keep(e);
    e->model.kind = kind;
    e->nudge = GRIP_POINT;
}

static void next_knots(struct editor *e)
{
    keep(e);
    e->model.parameter = (enum spline_parameter)((e->model.parameter + 1) % 3);
}

static void close_or_open(struct editor *e)
{
    keep(e);
    e->model.closed = !e->model.closed;
    model_follow(&e->model);
}

static bool has_chosen(struct editor *e)
{
    if (e->chosen < 0)
        e->message = "Choose a point first: touch it, or type Tab.";
    return e->chosen >= 0;
}

static void next_joint(struct editor *e)
{
    if (!has_chosen(e))
        return;
    keep(e);
    enum model_joint joint = e->model.point[e->chosen].joint;
    model_set_joint(&e->model, e->chosen, (enum model_joint)((joint + 1) % JOINTS));
}

static void free_handles(struct editor *e)
{
    if (!has_chosen(e))
        return;
    keep(e);
    model_free_handles(&e->model, e->chosen);
}

/* ---- points -------------------------------------------------------------------------------------- */

static void delete_chosen(struct editor *e)
{
    if (!has_chosen(e))
        return;
    keep(e);
    model_delete(&e->model, e->chosen);
    settle(e);
}

/* Half-way to the point behind the chosen one; at the end, a little beyond. */
static void add_after(struct editor *e)
{
    struct model *m = &e->model;
    int from = e->chosen >= 0 ? e->chosen : m->count - 1, to = from + 1;
    struct vector3 at = {200, 400, 0};
    if (m->count == MODEL_POINTS_MOST) {
        e->message = "There is no room for more points.";
        return;
    }
    if (m->closed && m->count > 0)
        to %= m->count;
    if (from >= 0 && to < m->count && to != from)
        at = vector3_times(vector3_sum(m->point[from].at, m->point[to].at), 0.5f);
    else if (from >= 0)
        at = vector3_sum(m->point[from].at, (struct vector3){60, -60, 0});
    keep(e);
    model_add(m, from + 1, at);
    e->chosen = from + 1;
}

static void nudge(struct editor *e, float x, float y)
{
    struct vector3 by = {x * NUDGE, y * NUDGE, 0};
    if (!has_chosen(e))
        return;
    bool out = e->nudge == GRIP_OUT;
    keep(e);
    if (e->nudge == GRIP_POINT || !model_has_handle(&e->model, e->chosen, out))
        model_move(&e->model, e->chosen, vector3_sum(e->model.point[e->chosen].at, by));
    else
        model_move_handle(&e->model, e->chosen, out,
                          vector3_sum(model_handle(&e->model, e->chosen, out), by));
}

static void next_nudge(struct editor *e)
{
    static const char *const names[] = {"", "The arrows move the point.",
                                        "The arrows move the handle in.",
                                        "The arrows move the handle out."};
    e->nudge = e->nudge == GRIP_OUT ? GRIP_POINT : e->nudge + 1;
    e->message = names[e->nudge];
}

static void clear(struct editor *e)
{
    keep(e);
    e->model.count = 0;
    e->chosen = -1;
    settle(e);
}

/* ---- steps --------------------------------------------------------------------------------------- */

static void step(struct editor *e, bool back)
{
    if (!(back ? history_undo(&e->history, &e->model) : history_redo(&e->history, &e->model)))
        e->message = back ? "There is nothing to undo." : "There is nothing to redo.";
    settle(e);
}

static void move_part(struct editor *e, float by)
{
    e->part = scalar_min(scalar_max(e->part + by, 0), 1);
}

/* ---- keys ---------------------------------------------------------------------------------------- */

static bool arrow(struct editor *e, int key)
{
    if (key < EDITOR_UP || key > EDITOR_RIGHT)
        return false;
    nudge(e,
          key == EDITOR_LEFT    ? -1.0f
          : key == EDITOR_RIGHT ? 1.0f
                                : 0.0f,
          key == EDITOR_DOWN ? -1.0f
          : key == EDITOR_UP ? 1.0f
                             : 0.0f);
    return true;
}

/* What is only shown, or asked for. */
static bool look(struct editor *e, int key)
{
    switch (key) {
    case 'g':
        e->polygon = !e->polygon;
        return true;
    case 'h':
        e->hull = !e->hull;
        return true;
    case 't':
        e->construction = !e->construction;
        return true;
    case 'm':
        e->comb = !e->comb;
        return true;
    case '\t':
        e->chosen = e->model.count > 0 ? (e->chosen + 1) % e->model.count : -1;
        return true;
    case 'o':
        next_nudge(e);
        return true;
    case ',':
    case '<':
        move_part(e, key == ',' ? -0.01f : -0.1f);
        return true;
    case '.':
    case '>':
        move_part(e, key == '.' ? 0.01f : 0.1f);
        return true;
    default:
        return false;
    }
}

static bool console(struct editor *e, int key)
{
    e->wanted = key == 'w'   ? CONSOLE_SAVE
                : key == 'l' ? CONSOLE_LOAD
                : key == 'q' ? CONSOLE_QUIT
                             : e->wanted;
    return key == 'w' || key == 'l' || key == 'q';
}

bool editor_key(struct editor *e, int key)
{
    static const struct {
        int key;
        void (*act)(struct editor *e);
    } acts[] = {{'c', close_or_open}, {'k', next_knots},    {'j', next_joint}, {'f', free_handles},
                {'a', add_after},     {'x', delete_chosen}, {'e', clear}};
    static const char kinds[] = "bpns";
    e->message = NULL;
    for (int i = 0; i < MODEL_KINDS; i++)
        if (key == kinds[i]) {
            set_kind(e, (enum model_kind)i);
            return true;
        }
    for (unsigned i = 0; i < sizeof acts / sizeof *acts; i++)
        if (key == acts[i].key) {
            acts[i].act(e);
            return true;
        }
    if (key == 'u' || key == 'r') {
        step(e, key == 'u');
        return true;
    }
    return arrow(e, key) || look(e, key) || console(e, key);
}
