#include "roms/commands/space_words.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

bool space_number(struct words *w, float *out)
{
    float value;
    if (!words_number(w, &value))
        return false;
    if (fabsf(value) > SPACE_LARGEST)
        return words_refuse(w, "numbers go up to %.0f", (double)SPACE_LARGEST);
    *out = value;
    return true;
}

bool space_vector(struct words *w, struct vector3 *out)
{
    return space_number(w, &out->x) && space_number(w, &out->y) && space_number(w, &out->z);
}

bool space_points(struct words *w, int least, struct space_points *out)
{
    out->count = 0;
    while (words_left(w) > 0) {
        if (out->count == SPACE_POINTS)
            return words_refuse(w, "at most %d points", SPACE_POINTS);
        if (!space_vector(w, &out->at[out->count]))
            return false;
        out->count++;
    }
    if (out->count < least)
        return words_refuse(w, "at least %d point%s of three numbers", least, least > 1 ? "s" : "");
    return true;
}

bool space_at(struct words *w, struct space_points *out)
{
    out->count = 0;
    return words_take(w, "at") ? space_points(w, 1, out) : words_end(w);
}

bool space_vector_fits(struct vector3 v)
{
    return fabsf(v.x) <= SPACE_LARGEST_PRODUCT && fabsf(v.y) <= SPACE_LARGEST_PRODUCT &&
           fabsf(v.z) <= SPACE_LARGEST_PRODUCT;
}

bool space_matrix_fits(const struct matrix4 *m)
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            if (!(fabsf(m->at[i][k]) <= SPACE_LARGEST_PRODUCT))
                return false;
    return true;
}

bool space_refuse_form(struct words *w, const char *name, const char *form)
{
    size_t length = strlen(w->trouble);
    snprintf(w->trouble + length, sizeof w->trouble - length, "; %s %s", name, form);
    return false;
}

/* ---- operations ------------------------------------------------------------------------------ */

static bool axis(struct words *w, enum axis3 *out)
{
    static const char *const names[] = {"x", "y", "z", NULL};
    int which;
    if (!words_choice(w, names, &which))
        return false;
    *out = (enum axis3)which;
    return true;
}

static bool translate(struct words *w, struct space_operation *o)
{
    struct vector3 by;
    if (!space_vector(w, &by))
        return false;
    transform3_step(&o->transform, "T", transform3_translate(by));
    return true;
}

static bool scale(struct words *w, struct space_operation *o)
{
    struct vector3 factors;
    if (!space_vector(w, &factors))
        return false;
    transform3_step(&o->transform, "S", transform3_scale(factors));
    return true;
}

static bool scale_about(struct words *w, struct space_operation *o)
{
    struct vector3 factors, fixed;
    if (!space_vector(w, &factors) || !space_vector(w, &fixed))
        return false;
    o->transform = transform3_scale_about(factors, fixed);
    return true;
}

static bool rotate(struct words *w, struct space_operation *o)
{
    static const char *const names[] = {"Rx", "Ry", "Rz"};
    enum axis3 about;
    float degrees;
    if (!axis(w, &about) || !space_number(w, &degrees))
        return false;
    transform3_step(&o->transform, names[about], transform3_rotate(about, degrees));
    return true;
}

static bool rotate_parallel(struct words *w, struct space_operation *o)
{
    enum axis3 about;
    float degrees;
    struct vector3 through;
    if (!axis(w, &about) || !space_number(w, &degrees))
        return false;
    if (!words_take(w, "through"))
        return words_refuse(w, "\"through\" and a point of the axis are missing");
    if (!space_vector(w, &through))
        return false;
    o->transform = transform3_rotate_parallel(about, degrees, through);
    return true;
}

static bool rotate_line(struct words *w, struct space_operation *o)
{
    float degrees;
    if (!space_vector(w, &o->p1) || !space_vector(w, &o->p2) || !space_number(w, &degrees))
        return false;
    if (!rotate_axis(o->p1, o->p2, degrees, &o->line))
        return words_refuse(w, "the axis needs two points that differ");
    o->transform = o->line.transform;
    o->about_line = true;
    return true;
}

static bool reflect(struct words *w, struct space_operation *o)
{
    static const char *const names[] = {"x", "y", "z", "xy", "yz", "xz", NULL};
    int which;
    if (!words_choice(w, names, &which))
        return false;
    transform3_step(&o->transform, "Rf",
                    which < 3 ? transform3_reflect_axis((enum axis3)which)
                              : transform3_reflect_plane((enum plane3)(which - 3)));
    return true;
}

static bool shear(struct words *w, struct space_operation *o)
{
    enum axis3 along;
    float a, b;
    if (!axis(w, &along) || !space_number(w, &a) || !space_number(w, &b))
        return false;
    transform3_step(&o->transform, "Sh", transform3_shear(along, a, b));
    return true;
}

bool space_operation(struct words *w, struct space_operation *out)
{
    static const struct {
        const char *name, *form;
        bool (*take)(struct words *w, struct space_operation *o);
    } operations[] = {
        {"translate", "x y z", translate},
        {"scale", "sx sy sz", scale},
        {"scale-about", "sx sy sz x y z", scale_about},
        {"rotate", "x|y|z degrees", rotate},
        {"rotate-axis", "x1 y1 z1 x2 y2 z2 degrees", rotate_line},
        {"rotate-parallel", "x|y|z degrees through x y z", rotate_parallel},
        {"reflect", "x|y|z|xy|yz|xz", reflect},
        {"shear", "x|y|z a b", shear},
    };
    *out = (struct space_operation){.about_line = false};
    for (size_t i = 0; i < sizeof operations / sizeof operations[0]; i++) {
        if (!words_take(w, operations[i].name))
            continue;
        out->name = operations[i].name;
        return operations[i].take(w, out) ||
               space_refuse_form(w, operations[i].name, operations[i].form);
    }
    if (words_left(w) == 0)
        return words_refuse(w, "an operation is missing");
    return words_refuse(w, "there is no operation \"%.40s\"", words_peek(w));
}
