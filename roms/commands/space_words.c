#include "roms/commands/space_words.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

bool space_at(struct words *w, struct space_points *out)
{
    out->count = 0;
    const struct words_wanted wanted = {1, SPACE_POINTS, WORDS_FARTHEST};
    return (!words_take(w, "at") || words_points(w, 3, wanted, out->at, &out->count)) &&
           words_end(w);
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
    if (!words_vector(w, WORDS_FARTHEST, &by))
        return false;
    transform3_step(&o->transform, "T", transform3_translate(by));
    return true;
}

static bool scale(struct words *w, struct space_operation *o)
{
    struct vector3 factors;
    if (!words_vector(w, WORDS_FARTHEST, &factors))
        return false;
    transform3_step(&o->transform, "S", transform3_scale(factors));
    return true;
}

static bool scale_about(struct words *w, struct space_operation *o)
{
    struct vector3 factors, fixed;
    if (!words_vector(w, WORDS_FARTHEST, &factors) || !words_vector(w, WORDS_FARTHEST, &fixed))
        return false;
    o->transform = transform3_scale_about(factors, fixed);
    return true;
}

static bool rotate(struct words *w, struct space_operation *o)
{
    static const char *const names[] = {"Rx", "Ry", "Rz"};
    enum axis3 about;
    float degrees;
    if (!axis(w, &about) || !words_amount(w, &degrees))
        return false;
    transform3_step(&o->transform, names[about], transform3_rotate(about, degrees));
    return true;
}

static bool rotate_parallel(struct words *w, struct space_operation *o)
{
    enum axis3 about;
    float degrees;
    struct vector3 through;
    if (!axis(w, &about) || !words_amount(w, &degrees))
        return false;
    if (!words_take(w, "through"))
        return words_refuse(w, "\"through\" and a point of the axis are missing");
    if (!words_vector(w, WORDS_FARTHEST, &through))
        return false;
    o->transform = transform3_rotate_parallel(about, degrees, through);
    return true;
}

static bool rotate_line(struct words *w, struct space_operation *o)
{
    float degrees;
    if (!words_vector(w, WORDS_FARTHEST, &o->p1) || !words_vector(w, WORDS_FARTHEST, &o->p2) ||
        !words_amount(w, &degrees))
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
    if (!axis(w, &along) || !words_amount(w, &a) || !words_amount(w, &b))
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
