/* light_series.c — fast-phong: a triangle's series and how far it is from what it stands for. */
#include <math.h>
#include <stdio.h>

#include "roms/commands/light.h"
#include "roms/light/fast_phong.h"
#include "roms/monitor/print.h"

enum { FARTHEST = 10000 /* pixels */ };

struct corner {
    struct point2 at;
    struct vector3 normal;
};

static bool take_corner(struct words *w, struct corner *c)
{
    if (!words_point(w, FARTHEST, &c->at) || !words_direction(w, 3, WORDS_FARTHEST, &c->normal))
        return false;
    c->normal = vector3_direction(c->normal);
    return true;
}

static float area_of(const struct corner *c)
{
    return (c[1].at.x - c[0].at.x) * (c[2].at.y - c[0].at.y) -
           (c[2].at.x - c[0].at.x) * (c[1].at.y - c[0].at.y);
}

/* N = A x + B y + C about the middle, from N_k = A x_k + B y_k + C. */
static struct fast_phong_normal solve(const struct corner *c)
{
    float per_area = 1 / area_of(c);
    struct vector3 u = vector3_times(vector3_difference(c[1].normal, c[0].normal), per_area);
    struct vector3 v = vector3_times(vector3_difference(c[2].normal, c[0].normal), per_area);
    struct vector3 a = vector3_difference(vector3_times(u, c[2].at.y - c[0].at.y),
                                          vector3_times(v, c[1].at.y - c[0].at.y));
    struct vector3 b = vector3_difference(vector3_times(v, c[1].at.x - c[0].at.x),
                                          vector3_times(u, c[2].at.x - c[0].at.x));
    struct vector3 sum = vector3_sum(vector3_sum(c[0].normal, c[1].normal), c[2].normal);
    return fast_phong_normal(a, b, vector3_times(sum, 1.0f / 3));
}

struct worst {
    float error, x, y, exact, series;
};

/* Over the corners' weighted means with whole weights. */
static struct worst search(const struct corner *c, struct point2 middle, struct vector3 light,
                           const struct fast_phong_series *s)
{
    enum { PARTS = 24 };
    struct worst worst = {.error = -1};
    for (int i = 0; i <= PARTS; i++) {
        for (int k = 0; i + k <= PARTS; k++) {
            float p = (float)i / PARTS, q = (float)k / PARTS, r = 1 - p - q;
            float x = p * c[0].at.x + q * c[1].at.x + r * c[2].at.x;
            float y = p * c[0].at.y + q * c[1].at.y + r * c[2].at.y;
            struct vector3 n = vector3_sum(
                vector3_sum(vector3_times(c[0].normal, p), vector3_times(c[1].normal, q)),
                vector3_times(c[2].normal, r));
            float exact = vector3_dot(light, vector3_direction(n));
            float series = fast_phong_value(s, x - middle.x, y - middle.y);
            if (fabsf(series - exact) > worst.error)
                worst = (struct worst){fabsf(series - exact), x, y, exact, series};
        }
    }
    return worst;
}

static void print_row(const char *names, const float *values, int count)
{
    for (int i = 0; i < count; i++)
        printf("%9.1s", names + i);
    printf("\n");
    for (int i = 0; i < count; i++)
        printf(" %8.4f", print_tidy(values[i]));
    printf("\n");
}

static void print_vector(const char *name, struct vector3 v)
{
    printf("%s ", name);
    print_vector3(v);
    printf("\n");
}

bool light_fast_phong(struct monitor *m, struct words *w)
{
    struct corner c[3];
    struct vector3 light;
    (void)m;
    for (int i = 0; i < 3; i++)
        if (!take_corner(w, &c[i]))
            return false;
    if (!words_take(w, "light"))
        return words_refuse(w, "\"light\" is missing");
    if (!words_direction(w, 3, WORDS_FARTHEST, &light) || !words_end(w))
        return false;
    if (fabsf(area_of(c)) < 1e-4f)
        return words_refuse(w, "the corners lie on a line");
    light = vector3_direction(light);
    struct fast_phong_normal n = solve(c);
    struct fast_phong_series s = fast_phong_series(&n, light);
    struct point2 middle = {(c[0].at.x + c[1].at.x + c[2].at.x) / 3,
                            (c[0].at.y + c[1].at.y + c[2].at.y) / 3};
    printf("N = A x + B y + C, x and y from the middle ");
    print_point2(middle);
    printf("\n");
    print_vector("A", n.a);
    print_vector("B", n.b);
    print_vector("C", n.c);
    print_row("abcdefghi", (float[]){s.a, s.b, s.c, n.d, n.e, n.f, n.g, n.h, n.i}, 9);
    printf("       T0       T1       T2       T3       T4       T5\n");
    for (int i = 0; i < 6; i++)
        printf(" %8.4f", print_tidy(s.t[i]));
    struct worst worst = search(c, middle, light, &s);
    printf("\nlargest error %.4f at ", print_tidy(worst.error));
    print_point2((struct point2){worst.x, worst.y});
    printf(": series %.4f, N.L/|N| %.4f\n", print_tidy(worst.series), print_tidy(worst.exact));
    return true;
}
