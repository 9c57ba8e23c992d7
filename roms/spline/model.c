#include "roms/spline/model.h"

#include <math.h>

#include "roms/geometry/scalar.h"

static const struct vector3 no_handle = {0, 0, 0};

static bool is_finite(struct vector3 v)
{
    return isfinite(v.x) && isfinite(v.y);
}

static float on_grid(float v, float low, float high)
{
    return scalar_min(scalar_max(floorf(v * MODEL_GRID + 0.5f) / MODEL_GRID, low), high);
}

static struct vector3 inside(struct vector3 p)
{
    return (struct vector3){on_grid(p.x, MODEL_LEFT, MODEL_RIGHT),
                            on_grid(p.y, MODEL_BOTTOM, MODEL_TOP), 0};
}

/* Index of a neighbour; of ends of an open curve the end itself. */
static int beside(const struct model *m, int index, int step)
{
    int i = index + step;
    if (m->closed)
        return (i + m->count) % m->count;
    return i < 0 ? 0 : i >= m->count ? m->count - 1 : i;
}

void model_follow(struct model *m)
{
    for (int i = 0; i < m->count; i++) {
        struct model_point *p = &m->point[i];
        int before = beside(m, i, -1), after = beside(m, i, 1);
        if (p->own)
            continue;
        float part = before == i || after == i ? 1 / 3.0f : 1 / 6.0f;
        p->out = vector3_times(vector3_difference(m->point[after].at, m->point[before].at), part);
        p->in = vector3_times(p->out, -1);
    }
}

bool model_add(struct model *m, int at, struct vector3 place)
{
    if (m->count >= MODEL_POINTS_MOST || at < 0 || at > m->count || !is_finite(place))
        return false;
    for (int i = m->count; i > at; i--)
        m->point[i] = m->point[i - 1];
    m->point[at] = (struct model_point){.at = inside(place)};
    m->count++;
    model_follow(m);
    return true;
}

bool model_delete(struct model *m, int index)
{
    if (index < 0 || index >= m->count)
        return false;
    m->count--;
    for (int i = index; i < m->count; i++)
        m->point[i] = m->point[i + 1];
    model_follow(m);
    return true;
}

bool model_move(struct model *m, int index, struct vector3 place)
{
    if (index < 0 || index >= m->count || !is_finite(place))
        return false;
    m->point[index].at = inside(place);
    model_follow(m);
    return true;
}

/* ---- handles ----------------------------------------------------------------------------------- */

/* The other one, when one was moved. A handle of length 0 has no direction: the other stays. */
static struct vector3 followed(enum model_joint joint, struct vector3 moved, struct vector3 other)
{
    float length = vector3_length(moved);
    if (joint == JOINT_CORNER || length == 0)
        return joint == JOINT_C1 ? no_handle : other;
    if (joint == JOINT_C1)
        return vector3_times(moved, -1);
    return vector3_times(moved, -vector3_length(other) / length);
}

bool model_move_handle(struct model *m, int index, bool out, struct vector3 place)
{
    if (index < 0 || index >= m->count || !is_finite(place))
        return false;
    struct model_point *p = &m->point[index];
    struct vector3 moved = vector3_difference(place, p->at);
    float length = vector3_length(moved);
    if (!(length <= MODEL_HANDLE_MOST))
        return false;
    p->own = true;
    *(out ? &p->out : &p->in) = moved;
    struct vector3 *other = out ? &p->in : &p->out;
    *other = followed(p->joint, moved, *other);
    return true;
}

bool model_set_joint(struct model *m, int index, enum model_joint joint)
{
    if (index < 0 || index >= m->count)
        return false;
    struct model_point *p = &m->point[index];
    p->joint = joint;
    p->in = followed(joint, p->out, p->in);
    return true;
}

bool model_free_handles(struct model *m, int index)
{
    if (index < 0 || index >= m->count)
        return false;
    m->point[index].own = false;
    model_follow(m);
    return true;
}

struct vector3 model_handle(const struct model *m, int index, bool out)
{
    const struct model_point *p = &m->point[index];
    return vector3_sum(p->at, out ? p->out : p->in);
}

bool model_has_handle(const struct model *m, int index, bool out)
{
    return m->kind == MODEL_PIECES && (m->closed || (out ? index < m->count - 1 : index > 0));
}

int model_polygon(const struct model *m, struct vector3 *out)
{
    int count = 0;
    for (; count < m->count; count++)
        out[count] = m->point[count].at;
    if (m->closed && count > 2)
        out[count++] = m->point[0].at;
    return count;
}

/* A wave with a loop's beginning. */
void model_example(struct model *m)
{
    static const struct vector3 places[] = {{90, 200, 0},  {200, 620, 0}, {420, 700, 0},
                                            {560, 300, 0}, {760, 180, 0}, {880, 560, 0}};
    *m = (struct model){.kind = MODEL_BEZIER};
    for (int i = 0; i < (int)(sizeof places / sizeof *places); i++)
        model_add(m, i, places[i]);
}
