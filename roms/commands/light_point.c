/* light_point.c — illuminate: the light of one point, term by term, with its vectors. */
#include <math.h>
#include <stdio.h>

#include "roms/commands/light.h"
#include "roms/scenery/studio.h"
#include "roms/monitor/print.h"

struct point {
    struct vector3 place, normal, eye;
};

static bool take_point(struct words *w, struct point *p)
{
    if (!words_take(w, "at"))
        return words_refuse(w, "\"at\" is missing");
    if (!words_vector(w, WORDS_FARTHEST, &p->place))
        return false;
    if (!words_take(w, "normal"))
        return words_refuse(w, "\"normal\" is missing");
    if (!words_direction(w, 3, WORDS_FARTHEST, &p->normal))
        return false;
    if (!words_take(w, "eye"))
        return words_refuse(w, "\"eye\" is missing");
    if (!words_vector(w, WORDS_FARTHEST, &p->eye) || !words_end(w))
        return false;
    return vector3_length(vector3_difference(p->eye, p->place)) > 1e-6f ||
           words_refuse(w, "the eye is at the point");
}

/* ---- the table ------------------------------------------------------------------------------- */

static void print_working(const struct light_term *t, int number)
{
    printf("%5d %8.4f %8.4f %8.4f %9.4f %7.4f %7.4f\n", number + 1, print_tidy(t->toward.x),
           print_tidy(t->toward.y), print_tidy(t->toward.z), print_tidy(t->distance),
           print_tidy(t->attenuation), print_tidy(t->w));
}

static void print_term(const struct light_term *t, int number)
{
    printf("%5d %8.4f %8.4f %9.4f %9.4f\n", number + 1, print_tidy(t->incidence),
           print_tidy(t->reflection), print_tidy(t->diffuse), print_tidy(t->specular));
}

static void print_terms(const struct studio *s, const struct lighting *g, const struct point *p,
                        bool table)
{
    const struct material *m = &s->material;
    struct illumination sum = illuminate(g, m, p->place, p->normal);
    if (table) {
        printf("light       Lx       Ly       Lz  distance       f       w\n");
        for (int i = 0; i < g->count; i++) {
            struct light_term t = illumination_term(g, m, p->place, p->normal, i);
            print_working(&t, i);
        }
    }
    printf("light      N.L      %s   diffuse  specular\n", m->halfway ? "N.H" : "R.V");
    for (int i = 0; i < g->count; i++) {
        struct light_term t = illumination_term(g, m, p->place, p->normal, i);
        print_term(&t, i);
    }
    printf("ambient %.4f + diffuse %.4f + specular %.4f = %.4f\n", print_tidy(sum.ambient),
           print_tidy(sum.diffuse), print_tidy(sum.specular), print_tidy(illumination_sum(sum)));
}

/* ---- the picture: in the plane of N and V ---------------------------------------------------- */

struct drawing {
    struct stage *stage;
    struct vector3 along, up; /* the picture's axes in space */
};

static void arrow(const struct drawing *d, struct vector3 v, float length, enum ink ink,
                  const char *name)
{
    enum { X = 600, Y = 200 };
    struct stage *s = d->stage;
    float x = vector3_dot(v, d->along) * length, y = vector3_dot(v, d->up) * length;
    float r = sqrtf(x * x + y * y);
    stage_ink(s, ink);
    stage_line(s, X, Y, X + x, Y + y);
    if (r < 30)
        return;
    float ux = x / r * 18, uy = y / r * 18;
    stage_line(s, X + x, Y + y, X + x - ux + uy / 2, Y + y - uy - ux / 2);
    stage_line(s, X + x, Y + y, X + x - ux - uy / 2, Y + y - uy + ux / 2);
    stage_text_middle(s, X + x * 1.07f, Y + y * 1.07f + 8, name);
}

/* The plane of N and V; of N and L where V is along N. */
static struct drawing drawing_of(struct stage *stage, struct vector3 n, struct vector3 view,
                                 struct vector3 light)
{
    struct vector3 along = vector3_difference(view, vector3_times(n, vector3_dot(view, n)));
    if (vector3_length(along) < 0.05f)
        along = vector3_difference(light, vector3_times(n, vector3_dot(light, n)));
    if (vector3_length(along) < 0.05f)
        along = vector3_cross(n, fabsf(n.x) < 0.7f ? (struct vector3){1, 0, 0}
                                                   : (struct vector3){0, 1, 0});
    return (struct drawing){stage, vector3_direction(along), n};
}

static void draw_point(struct monitor *m, const struct lighting *g, const struct point *p)
{
    enum { LENGTH = 430 };
    struct stage *s = &m->stage;
    const struct material *material = &studio()->material;
    struct vector3 n = vector3_direction(p->normal), view = lighting_view(g, p->place);
    struct vector3 first = n;
    if (g->count > 0)
        first = illumination_term(g, material, p->place, n, 0).toward;
    struct drawing d = drawing_of(s, n, view, first);
    stage_begin(s);
    stage_title(s, "The light of a point");
    stage_ink(s, INK_TEXT);
    stage_line(s, 100, 200, 1100, 200);
    for (int i = 0; i < 25; i++)
        stage_line(s, 100 + (float)i * 40, 200, 80 + (float)i * 40, 170);
    arrow(&d, n, LENGTH, INK_BRIGHT, "N");
    arrow(&d, view, LENGTH, INK_CYAN, "V");
    for (int i = 0; i < g->count; i++) {
        struct light_term t = illumination_term(g, material, p->place, n, i);
        struct vector3 r =
            vector3_difference(vector3_times(n, 2 * vector3_dot(n, t.toward)), t.toward);
        arrow(&d, t.toward, LENGTH, INK_YELLOW, "L");
        if (t.incidence > 0)
            arrow(&d, r, LENGTH, INK_ORANGE, "R");
    }
    stage_caption(s, "Seen at right angles to N and V. R leaves at the angle at which L arrives; "
                     "what is left of a "
                     "vector's length lies in this plane.");
    stage_end(s);
}

bool light_illuminate(struct monitor *m, struct words *w)
{
    struct point p;
    if (!take_point(w, &p))
        return false;
    struct lighting g = studio()->lighting;
    g.eye = p.eye;
    g.eye_far = false;
    print_terms(studio(), &g, &p, m->table);
    draw_point(m, &g, &p);
    return true;
}
