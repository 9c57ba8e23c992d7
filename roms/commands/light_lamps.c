/* light_lamps.c — light, material, fresnel: what shines, and what surfaces reflect. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "roms/commands/light.h"
#include "roms/geometry/scalar.h"
#include "roms/scenery/studio.h"
#include "roms/light/fresnel.h"
#include "roms/monitor/print.h"

static const char *const kind_names[] = {"far", "near", "line", "rectangle", NULL};

/* ---- light ----------------------------------------------------------------------------------- */

static void print_light(int number, const struct light *l)
{
    printf("%d: %-9s ", number + 1, kind_names[l->kind]);
    print_vector3(l->at);
    if (l->kind == LIGHT_LINE || l->kind == LIGHT_RECTANGLE) {
        printf(" side ");
        print_vector3(l->side);
    }
    if (l->kind == LIGHT_RECTANGLE) {
        printf(" other ");
        print_vector3(l->other);
    }
    printf(" intensity %.4f", print_tidy(l->intensity));
    if (l->kind == LIGHT_LINE)
        printf(", %d samples", l->samples);
    if (l->kind == LIGHT_RECTANGLE)
        printf(", %d by %d samples", l->samples, l->samples);
    printf("\n");
}

static void list(const struct lighting *g)
{
    printf("ambient %.4f; attenuation 1/(%.4f + %.4f d + %.4f d^2), at most 1\n",
           print_tidy(g->ambient), print_tidy(g->a0), print_tidy(g->a1), print_tidy(g->a2));
    for (int i = 0; i < g->count; i++)
        print_light(i, &g->light[i]);
    if (g->count == 0)
        printf("no lights\n");
}

/* A vector as long as a light is wide. */
static bool take_side(struct words *w, struct vector3 *side)
{
    if (!words_vector(w, WORDS_FARTHEST, side))
        return false;
    return vector3_length(*side) > 1e-6f || words_refuse(w, "a side has no length");
}

static bool take_place(struct words *w, struct light *l)
{
    if (l->kind == LIGHT_FAR)
        return words_direction(w, 3, WORDS_FARTHEST, &l->at);
    if (!words_vector(w, WORDS_FARTHEST, &l->at))
        return false;
    if (l->kind == LIGHT_NEAR)
        return true;
    if (!take_side(w, &l->side))
        return false;
    if (l->kind == LIGHT_RECTANGLE && !take_side(w, &l->other))
        return false;
    return words_whole(w, 1, LIGHT_SAMPLES, &l->samples);
}

static bool add(struct words *w, struct lighting *g)
{
    struct light l = {.samples = 1};
    int kind;
    if (!words_choice(w, kind_names, &kind))
        return false;
    l.kind = (enum light_kind)kind;
    if (!take_place(w, &l) || !words_bounded(w, 0, 10, &l.intensity) || !words_end(w))
        return false;
    if (!lighting_add(g, l))
        return words_refuse(w, "there are %d lights already: light clear", LIGHTS_MOST);
    print_light(g->count - 1, &g->light[g->count - 1]);
    return true;
}

static bool attenuation(struct words *w, struct lighting *g)
{
    float a[3];
    for (int i = 0; i < 3; i++)
        if (!words_bounded(w, 0, 100, &a[i]))
            return false;
    if (!words_end(w))
        return false;
    if (a[0] + a[1] + a[2] <= 0)
        return words_refuse(w, "one of a0, a1 and a2 must be above 0");
    g->a0 = a[0];
    g->a1 = a[1];
    g->a2 = a[2];
    list(g);
    return true;
}

static bool ambient(struct words *w, struct lighting *g)
{
    float value;
    if (!words_bounded(w, 0, 10, &value) || !words_end(w))
        return false;
    g->ambient = value;
    list(g);
    return true;
}

bool light_lights(struct monitor *m, struct words *w)
{
    enum { LIST, CLEAR, AMBIENT, ATTENUATION, ADD };
    static const char *const names[] = {"list", "clear", "ambient", "attenuation", "add", NULL};
    struct lighting *g = &studio()->lighting;
    int what = LIST;
    (void)m;
    if (words_left(w) > 0 && !words_choice(w, names, &what))
        return false;
    if (what == AMBIENT)
        return ambient(w, g);
    if (what == ATTENUATION)
        return attenuation(w, g);
    if (what == ADD)
        return add(w, g);
    if (!words_end(w))
        return false;
    if (what == CLEAR)
        g->count = 0;
    list(g);
    return true;
}

/* ---- material -------------------------------------------------------------------------------- */

static void print_material(const struct material *m)
{
    printf("ka %.4f  kd %.4f  ", print_tidy(m->ka), print_tidy(m->kd));
    if (m->index > 0)
        printf("w(theta) by Fresnel for index %.4f", print_tidy(m->index));
    else
        printf("ks %.4f", print_tidy(m->ks));
    printf("  n %.4f, %s\n", print_tidy(m->n), m->halfway ? "(N.H)^n" : "(R.V)^n");
}

bool light_material(struct monitor *m, struct words *w)
{
    struct material got = {0};
    (void)m;
    if (words_left(w) == 0) {
        print_material(&studio()->material);
        return true;
    }
    if (!words_bounded(w, 0, 1, &got.ka) || !words_bounded(w, 0, 1, &got.kd) ||
        !words_bounded(w, 0, 1, &got.ks) || !words_bounded(w, POWER_LEAST, POWER_MOST, &got.n))
        return false;
    if (words_take(w, "fresnel") && !words_bounded(w, 1, 10, &got.index))
        return false;
    got.halfway = words_take(w, "halfway");
    if (!words_end(w))
        return false;
    studio()->material = got;
    print_material(&got);
    return true;
}

/* ---- fresnel --------------------------------------------------------------------------------- */

static void fresnel_row(float index, float degrees)
{
    float cosine = degrees == 90 ? 0 : cosf(degrees * DEGREE);
    printf("%8.4f %8.4f %8.4f\n", print_tidy(degrees), print_tidy(fresnel(index, cosine)),
           print_tidy(fresnel_schlick(index, cosine)));
}

bool light_fresnel(struct monitor *m, struct words *w)
{
    float index, angle = -1;
    (void)m;
    if (!words_bounded(w, 1, 10, &index) ||
        (words_left(w) > 0 && !words_bounded(w, 0, 90, &angle)) || !words_end(w))
        return false;
    printf("   angle        w  Schlick\n");
    if (angle >= 0)
        fresnel_row(index, angle);
    for (int i = 0; i <= 9 && angle < 0; i++)
        fresnel_row(index, (float)(10 * i));
    return true;
}
