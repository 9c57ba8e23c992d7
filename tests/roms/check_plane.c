/* check_plane — transformations of the plane in the machine: properties on random cases. Exits with
 * 0 when all hold. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "roms/clip/pipeline2.h"
#include "roms/clip/window_viewport.h"
#include "roms/geometry/transform2.h"

static uint32_t random_state = 1;

static float random_float(float limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return ((float)(random_state >> 8) / (float)(1u << 23) - 1) * limit;
}

static struct point2 random_point(void)
{
    float x = random_float(10);
    return (struct point2){x, random_float(10)};
}

static bool near(struct point2 a, struct point2 b, float slack)
{
    return fabsf(a.x - b.x) <= slack && fabsf(a.y - b.y) <= slack;
}

static struct matrix3 any_transformation(int kind)
{
    switch (kind % 5) {
    case 0:
        return transform2_rotate_about(random_float(360), random_point());
    case 1:
        return transform2_scale_about(0.5f + fabsf(random_float(2)), -0.5f - fabsf(random_float(2)),
                                      random_point());
    case 2:
        return transform2_reflect_line(random_float(5), random_float(5));
    case 3:
        return transform2_shear_x(random_float(1), random_float(5));
    default:
        return transform2_shear_y(random_float(1), random_float(5));
    }
}

static int not_undone(int cases)
{
    int bad = 0;
    for (int i = 0; i < cases; i++) {
        struct matrix3 m = any_transformation(i), back;
        struct point2 p = random_point(), q = matrix3_apply(&m, p);
        bad += !matrix3_inverse(&m, &back) || !near(matrix3_apply(&back, q), p, 1e-4f);
    }
    return bad;
}

static int not_composed(int cases)
{
    int bad = 0;
    for (int i = 0; i < cases; i++) {
        struct matrix3 a = any_transformation(i), b = any_transformation(i / 5);
        struct matrix3 both = transform2_then(&a, &b);
        struct point2 p = random_point(), q = matrix3_apply(&a, p);
        bad += !near(matrix3_apply(&both, p), matrix3_apply(&b, q), 1e-4f);
    }
    return bad;
}

static float apart(struct point2 a, struct point2 b)
{
    return hypotf(a.x - b.x, a.y - b.y);
}

static int lengths_changed(int cases)
{
    int bad = 0;
    for (int i = 0; i < cases; i++) {
        struct matrix3 turn = transform2_rotate_about(random_float(720), random_point());
        struct matrix3 mirror = transform2_reflect_line(random_float(20), random_float(5));
        struct matrix3 m = transform2_then(&turn, &mirror);
        struct point2 a = random_point(), b = random_point();
        bad += fabsf(apart(a, b) - apart(matrix3_apply(&m, a), matrix3_apply(&m, b))) > 5e-5f;
    }
    return bad;
}

/* In five steps: to the origin, onto the x axis, reflect, and back. */
static int mirrors_not_in_steps(int cases)
{
    int bad = 0;
    for (int i = 0; i < cases; i++) {
        float m = random_float(4), c = random_float(5), angle = atanf(m) * 57.29578f;
        const struct matrix3 steps[] = {transform2_translate(0, -c), transform2_rotate(-angle),
                                        transform2_reflect(MIRROR_X_AXIS), transform2_rotate(angle),
                                        transform2_translate(0, c)};
        struct matrix3 all = matrix3_identity(), once = transform2_reflect_line(m, c);
        for (int k = 0; k < 5; k++)
            all = transform2_then(&all, &steps[k]);
        struct point2 p = random_point();
        bad += !near(matrix3_apply(&all, p), matrix3_apply(&once, p), 5e-5f);
    }
    return bad;
}

/* A view's pipeline backwards leads to where a point came from. */
static int pipelines_not_undone(int cases)
{
    int bad = 0;
    for (int i = 0; i < cases; i++) {
        struct view2 v = {random_point(),
                          random_point(),
                          {-9, -7, 8, 6},
                          {0.1f, 0.2f, 0.9f, 1},
                          {0, 480, 640, 0}};
        struct pipeline2 p;
        struct matrix3 back, model = any_transformation(i);
        if (!pipeline2_begin(&p, &v))
            continue;
        pipeline2_model(&p, &model);
        struct point2 at = random_point(), from = at;
        if (pipeline2_point(&p, &at))
            bad +=
                !matrix3_inverse(&p.whole, &back) || !near(matrix3_apply(&back, at), from, 1e-3f);
    }
    return bad;
}

int main(void)
{
    static const struct {
        int (*count)(int cases);
        int cases;
        const char *what;
    } properties[] = {
        {not_undone, 5000, "transformations: the inverse leads back, to 1e-4"},
        {not_composed, 5000, "pairs: the product is one after the other, to 1e-4"},
        {lengths_changed, 5000, "rotations and reflections: lengths stay, to 5e-5"},
        {mirrors_not_in_steps, 5000,
         "mirrors y = mx + c: closed form and five steps agree, to 5e-5"},
        {pipelines_not_undone, 5000, "pipelines: device coordinates lead back, to 1e-3"},
    };
    int all = 0;
    for (unsigned i = 0; i < sizeof properties / sizeof properties[0]; i++) {
        int bad = properties[i].count(properties[i].cases);
        printf("%d %s: %d failed\n", properties[i].cases, properties[i].what, bad);
        all += bad;
    }
    return all > 0;
}
