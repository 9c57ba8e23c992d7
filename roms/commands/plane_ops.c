#include "roms/commands/plane_ops.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "roms/commands/flat_words.h"
#include "roms/geometry/scalar.h"
#include "roms/geometry/transform2.h"
#include "roms/monitor/print.h"

static struct plane_step step(struct matrix3 m, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static struct plane_step step(struct matrix3 m, const char *format, ...)
{
    struct plane_step s = {.matrix = m};
    va_list list;
    va_start(list, format);
    vsnprintf(s.name, sizeof s.name, format, list);
    va_end(list);
    return s;
}

static struct plane_step translation(float x, float y)
{
    x += 0.0f; /* no "-0" */
    y += 0.0f;
    return step(transform2_translate(x, y), "T(%g,%g)", (double)x, (double)y);
}

static struct plane_step rotation(float degrees)
{
    return step(transform2_rotate(degrees), "R(%g)", (double)degrees + 0.0);
}

/* ---- one function an operation --------------------------------------------------------------- */

static bool translate(struct words *w, struct plane_op *o)
{
    float v[2];
    if (!words_amounts(w, v, 2))
        return false;
    o->whole = translation(v[0], v[1]);
    return true;
}

static bool rotate(struct words *w, struct plane_op *o)
{
    float degrees;
    if (!words_amount(w, &degrees))
        return false;
    o->whole = rotation(degrees);
    return true;
}

/* To the origin, there the step, and back. */
static void about(struct plane_op *o, struct point2 p, struct plane_step middle)
{
    o->step[0] = translation(-p.x, -p.y);
    o->step[1] = middle;
    o->step[2] = translation(p.x, p.y);
    o->steps = 3;
}

static bool rotate_about(struct words *w, struct plane_op *o)
{
    float v[3];
    if (!words_amounts(w, v, 3))
        return false;
    struct point2 pivot = {v[1], v[2]};
    about(o, pivot, rotation(v[0]));
    o->whole = step(transform2_rotate_about(v[0], pivot), "R(%g) about (%g,%g)", (double)v[0],
                    (double)v[1], (double)v[2]);
    return true;
}

static bool scale(struct words *w, struct plane_op *o)
{
    float v[2];
    if (!words_amounts(w, v, 2))
        return false;
    o->whole = step(transform2_scale(v[0], v[1]), "S(%g,%g)", (double)v[0], (double)v[1]);
    return true;
}

static bool scale_about(struct words *w, struct plane_op *o)
{
    float v[4];
    if (!words_amounts(w, v, 4))
        return false;
    struct point2 fixed = {v[2], v[3]};
    about(o, fixed, step(transform2_scale(v[0], v[1]), "S(%g,%g)", (double)v[0], (double)v[1]));
    o->whole = step(transform2_scale_about(v[0], v[1], fixed), "S(%g,%g) about (%g,%g)",
                    (double)v[0], (double)v[1], (double)v[2], (double)v[3]);
    return true;
}

/* "x=5": the number; false: the next word is something else. */
static bool take_equation(struct words *w, const char *name, float *k)
{
    size_t length = strlen(name);
    if (strncmp(words_peek(w), name, length) != 0)
        return false;
    struct words number = {.at = {words_peek(w) + length}, .count = 1};
    if (!words_next_is_number(&number))
        return false;
    if (!words_amount(&number, k))
        return words_refuse(w, "%s", number.trouble);
    words_take(w, words_peek(w));
    return true;
}

static bool reflect(struct words *w, struct plane_op *o)
{
    static const char *const names[] = {"x", "y", "origin", "y=x", "y=-x", NULL};
    static const char *const full[] = {"reflect in the x axis", "reflect in the y axis",
                                       "reflect in the origin", "reflect in y = x",
                                       "reflect in y = -x"};
    float k;
    int which;
    if (take_equation(w, "x=", &k)) {
        o->whole = step(transform2_reflect_x_is(k), "reflect in x = %g", (double)k);
        return true;
    }
    if (take_equation(w, "y=", &k)) {
        o->whole = step(transform2_reflect_y_is(k), "reflect in y = %g", (double)k);
        return true;
    }
    if (!words_choice(w, names, &which))
        return false;
    o->whole = step(transform2_reflect((enum mirror2)which), "%s", full[which]);
    return true;
}

static bool reflect_line(struct words *w, struct plane_op *o)
{
    float v[2];
    if (!words_amounts(w, v, 2))
        return false;
    float degrees = atanf(v[0]) / DEGREE;
    o->step[0] = translation(0, -v[1]);
    o->step[1] = rotation(-degrees);
    o->step[2] = step(transform2_reflect(MIRROR_X_AXIS), "reflect in the x axis");
    o->step[3] = rotation(degrees);
    o->step[4] = translation(0, v[1]);
    o->steps = 5;
    o->whole = step(transform2_reflect_line(v[0], v[1]), "reflect in y = %g x + %g", (double)v[0],
                    (double)v[1]);
    return true;
}

static bool shear(struct words *w, struct plane_op *o)
{
    static const char *const names[] = {"x", "y", NULL};
    int axis;
    float k, reference = 0;
    if (!words_choice(w, names, &axis) || !words_amount(w, &k) ||
        (words_take(w, "about") && !words_amount(w, &reference)))
        return false;
    struct matrix3 m =
        axis == 0 ? transform2_shear_x(k, reference) : transform2_shear_y(k, reference);
    if (reference == 0)
        o->whole = step(m, "%s-shear %g", names[axis], (double)k);
    else
        o->whole = step(m, "%s-shear %g about %s = %g", names[axis], (double)k, names[1 - axis],
                        (double)reference);
    return true;
}

/* ---- all of them ----------------------------------------------------------------------------- */

static const struct {
    const char *name;
    bool (*take)(struct words *w, struct plane_op *o);
} operations[] = {
    {"translate", translate},       {"rotate", rotate},
    {"rotate-about", rotate_about}, {"scale", scale},
    {"scale-about", scale_about},   {"reflect", reflect},
    {"reflect-line", reflect_line}, {"shear", shear},
};
enum { OPERATIONS = sizeof operations / sizeof operations[0] };

bool plane_ops_next(const struct words *w)
{
    for (int i = 0; i < OPERATIONS; i++)
        if (words_next_is(w, operations[i].name))
            return true;
    return false;
}

static bool take_one(struct words *w, struct plane_op *o)
{
    *o = (struct plane_op){.steps = 0};
    for (int i = 0; i < OPERATIONS; i++)
        if (words_take(w, operations[i].name))
            return operations[i].take(w, o);
    if (words_left(w) == 0)
        return words_refuse(w, "a transformation is missing");
    return words_refuse(w, "\"%.40s\" is not a transformation", words_peek(w));
}

bool plane_ops_take(struct words *w, struct plane_ops *ops)
{
    ops->count = 0;
    ops->product = matrix3_identity();
    do {
        if (ops->count == PLANE_OPS)
            return words_refuse(w, "at most %d transformations one after the other", PLANE_OPS);
        struct plane_op *o = &ops->op[ops->count];
        if (!take_one(w, o))
            return false;
        ops->product = transform2_then(&ops->product, &o->whole.matrix);
        ops->count++;
    } while (words_take(w, "then"));
    for (int i = 0; i < 9; i++)
        if (!(fabsf(ops->product.at[i / 3][i % 3]) <= 1e9f))
            return words_refuse(w, "the product is beyond +-1e9");
    return true;
}

static void print_step(const struct plane_step *s, const char *indent)
{
    printf("%s%s\n", indent, s->name);
    print_matrix3(indent, &s->matrix);
}

void plane_ops_print(const struct plane_ops *ops)
{
    for (int i = 0; i < ops->count; i++) {
        const struct plane_op *o = &ops->op[i];
        for (int k = 0; k < o->steps; k++)
            print_step(&o->step[k], "    ");
        print_step(&o->whole, "");
    }
}
