/* Solids as polygon tables (roms/solids): Euler's formula and the guidelines for every model,
 * volumes and areas against closed forms in double precision, normals, planes, and tables with one
 * mistake each. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/curves/bezier.c"
#include "roms/geometry/matrix4.c"
#include "roms/solids/box.c"
#include "roms/solids/bracket.c"
#include "roms/solids/broken.c"
#include "roms/solids/normals.c"
#include "roms/solids/object.c"
#include "roms/solids/object_check.c"
#include "roms/solids/plane.c"
#include "roms/solids/revolve.c"
#include "roms/solids/rings.c"
#include "roms/solids/tube.c"
#include "roms/solids/vessel.c"

static const double turn = 6.283185307179586;

static struct {
    struct object object;
    struct object_check check;
    uint32_t random;
} rig = {.random = 99};

static double uniform(double low, double high)
{
    rig.random = rig.random * 1664525u + 1013904223u;
    return low + (high - low) * (double)(rig.random >> 8) / 16777216.0;
}

static int whole(int low, int high)
{
    return low + (int)uniform(0, high - low + 0.999);
}

/* ---- measures in double precision ------------------------------------------------------------ */

struct triple {
    double x, y, z;
};

static struct triple corner_of(int polygon, int k)
{
    struct vector3 v = rig.object.vertex[object_corner(&rig.object, polygon, k)];
    return (struct triple){v.x, v.y, v.z};
}

static struct triple minus(struct triple a, struct triple b)
{
    return (struct triple){a.x - b.x, a.y - b.y, a.z - b.z};
}

static struct triple cross(struct triple a, struct triple b)
{
    return (struct triple){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static double dot(struct triple a, struct triple b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static void measure(double *volume, double *area)
{
    *volume = *area = 0;
    for (int p = 0; p < rig.object.polygons; p++)
        for (int k = 1; k + 1 < rig.object.polygon[p].count; k++) {
            struct triple a = corner_of(p, 0), b = corner_of(p, k), c = corner_of(p, k + 1);
            struct triple n = cross(minus(b, a), minus(c, a));
            *volume += dot(a, n) / 6;
            *area += sqrt(dot(n, n)) / 2;
        }
}

/* How many separate surfaces there are. */
static int components(void)
{
    static int of[OBJECT_VERTICES];
    int count = 0;
    for (int i = 0; i < rig.object.vertices; i++)
        of[i] = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (int e = 0; e < rig.object.edges; e++) {
            int a = rig.object.edge[e].vertex[0], b = rig.object.edge[e].vertex[1];
            int low = of[a] < of[b] ? of[a] : of[b];
            changed = changed || of[a] != low || of[b] != low;
            of[a] = of[b] = low;
        }
    }
    for (int i = 0; i < rig.object.vertices; i++)
        count += of[i] == i;
    return count;
}

/* ---- what must hold for every closed model --------------------------------------------------- */

static void assert_no_faults(void)
{
    struct object_fault fault;
    object_check_begin(&rig.check, &rig.object);
    assert_false(object_check_next(&rig.check, &fault));
}

/* Both polygons of each edge, in opposite directions. */
static void assert_closed(void)
{
    static int forward[OBJECT_EDGES], back[OBJECT_EDGES];
    const struct object *o = &rig.object;
    memset(forward, 0, sizeof forward);
    memset(back, 0, sizeof back);
    for (int i = 0; i < o->sides; i++) {
        const struct object_side *s = &o->side[i];
        if (o->edge[s->edge].vertex[0] == s->start)
            forward[s->edge]++;
        else
            back[s->edge]++;
    }
    for (int e = 0; e < o->edges; e++) {
        assert_int_equal(forward[e], 1);
        assert_int_equal(back[e], 1);
    }
}

static void assert_planar_and_convex(double tolerance)
{
    for (int p = 0; p < rig.object.polygons; p++) {
        struct plane plane = plane_of_polygon(&rig.object, p);
        struct vector3 n = plane_normal(&plane);
        struct triple normal = {n.x, n.y, n.z};
        int count = rig.object.polygon[p].count;
        assert_true(sqrt(dot(normal, normal)) > 0.999);
        for (int k = 0; k < count; k++) {
            struct triple a = corner_of(p, k), b = corner_of(p, (k + 1) % count);
            struct triple c = corner_of(p, (k + 2) % count);
            assert_true(fabs(dot(normal, minus(a, corner_of(p, 0)))) < tolerance);
            assert_true(dot(normal, cross(minus(b, a), minus(c, b))) > -tolerance);
        }
    }
}

static void assert_model(bool made, int euler, int parts)
{
    const struct object *o = &rig.object;
    assert_true(made);
    assert_int_equal(o->vertices - o->edges + o->polygons, euler);
    assert_int_equal(components(), parts);
    assert_no_faults();
    assert_closed();
    double volume, area;
    measure(&volume, &area);
    assert_true(volume > 0);
}

static void boxes_are_exact(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        float w = (float)uniform(0.1, 9), h = (float)uniform(0.1, 9), d = (float)uniform(0.1, 9);
        double volume, area;
        object_clear(&rig.object);
        assert_model(object_box(&rig.object, w, h, d, 0), 2, 1);
        assert_planar_and_convex(1e-5);
        measure(&volume, &area);
        assert_true(fabs(volume - (double)w * h * d) < 1e-5 * volume);
        assert_true(fabs(area - 2 * ((double)w * h + (double)h * d + (double)d * w)) < 1e-5 * area);
    }
}

/* The closed form of what is inscribed: a polygon of n sides for each circle. */
static double polygon_area(double r, int n)
{
    return n * r * r * sin(turn / n) / 2;
}

static void spheres_are_those_inscribed(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        int n = whole(3, 36), rings = whole(2, 36);
        double r = uniform(0.2, 5), exact = 0, volume, area;
        object_clear(&rig.object);
        assert_model(object_sphere(&rig.object, (float)r, n, rings, 0), 2, 1);
        assert_planar_and_convex(1e-4 * r);
        measure(&volume, &area);
        /* Frustums between similar polygons. */
        for (int k = 0; k < rings; k++) {
            double a = turn / 2 * k / rings, b = turn / 2 * (k + 1) / rings;
            double ra = r * sin(a), rb = r * sin(b), height = r * (cos(a) - cos(b));
            exact += height / 3 *
                     (polygon_area(ra, n) + polygon_area(rb, n) + n * ra * rb * sin(turn / n) / 2);
        }
        assert_true(fabs(volume - exact) < 1e-4 * exact);
        assert_true(volume < 2 * turn / 3 * r * r * r && area < 2 * turn * r * r);
        if (n >= 24 && rings >= 24) {
            assert_true(volume > 0.96 * 2 * turn / 3 * r * r * r);
            assert_true(area > 0.97 * 2 * turn * r * r);
        }
    }
}

static void cylinders_are_prisms(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        int n = whole(3, 64);
        double r = uniform(0.2, 5), h = uniform(0.2, 5), volume, area;
        object_clear(&rig.object);
        assert_model(object_cylinder(&rig.object, (float)r, (float)h, n, 0), 2, 1);
        assert_int_equal(rig.object.polygons, n + 2);
        assert_planar_and_convex(1e-4 * (r + h));
        measure(&volume, &area);
        assert_true(fabs(volume - polygon_area(r, n) * h) < 1e-4 * volume);
        double exact = 2 * polygon_area(r, n) + n * 2 * r * sin(turn / 2 / n) * h;
        assert_true(fabs(area - exact) < 1e-4 * area);
    }
}

/* Pappus for the polygon of the section, shortened as chords are. */
static void tori_are_those_of_pappus(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        int n = whole(3, 36), rings = whole(3, 36);
        double R = uniform(1, 5), r = uniform(0.1, 0.9) * R, volume, area;
        object_clear(&rig.object);
        assert_model(object_torus(&rig.object, (float)R, (float)r, n, rings, 0), 0, 1);
        assert_planar_and_convex(1e-4 * R);
        measure(&volume, &area);
        /* The section's first moment about the axis: a prismatoid's volume is linear in it. */
        double exact = polygon_area(r, rings) * R * n * sin(turn / n);
        assert_true(fabs(volume - exact) < 2e-4 * exact + 1e-4);
        if (n >= 24 && rings >= 24)
            assert_true(fabs(volume - turn * turn / 2 * R * r * r) < 0.03 * volume &&
                        fabs(area - turn * turn * R * r) < 0.03 * area);
    }
}

static void vessels_are_four_solids(void **state)
{
    (void)state;
    for (int n = 8; n <= VESSEL_SEGMENTS; n += 4) {
        object_clear(&rig.object);
        assert_model(object_vessel(&rig.object, 1, n, 0), 2 * VESSEL_PARTS, VESSEL_PARTS);
        assert_planar_and_convex(1e-5);
    }
    object_clear(&rig.object);
    assert_false(object_vessel(&rig.object, 1, 4, 0));
    object_clear(&rig.object);
    assert_true(object_vessel(&rig.object, 1, 16, 0));
    assert_true(object_normals(&rig.object, NORMALS_CREASE));
    assert_in_range(rig.object.sides - 2 * rig.object.polygons, 900, 1200); /* triangles */
}

static void brackets_have_two_tunnels(void **state)
{
    (void)state;
    int made = 0;
    for (int i = 0; i < 2000; i++) {
        struct bracket b = {(float)uniform(20, 80), (float)uniform(20, 80), (float)uniform(20, 80),
                            (float)uniform(2, 20),  (float)uniform(2, 60),  (float)uniform(2, 60)};
        object_clear(&rig.object);
        bool fits = bracket_fits(&b);
        assert_int_equal(object_bracket(&rig.object, &b, 0), fits);
        if (!fits)
            continue;
        made++;
        assert_model(true, -2, 1);
        assert_planar_and_convex(2e-3);
        double volume, area, w = b.width, t = b.thickness, d1 = b.upper_diameter,
                             d2 = b.lower_diameter;
        measure(&volume, &area);
        double exact = w * b.depth * t + (b.height - t) * w * t + turn / 16 * w * w * t -
                       turn / 8 * (d1 * d1 + d2 * d2) * t;
        assert_true(fabs(volume - exact) < 0.012 * turn / 8 * (w * w + d1 * d1 + d2 * d2) * t);
    }
    print_message("brackets: %d of 2000 fit\n", made);
    assert_true(made > 300);
}

/* ---- tables and checks ----------------------------------------------------------------------- */

static void each_mistake_breaks_one_rule(void **state)
{
    (void)state;
    for (int i = 0; broken_names[i] != NULL; i++) {
        struct object_fault fault;
        int faults = 0;
        object_broken(&rig.object, i);
        object_check_begin(&rig.check, &rig.object);
        while (object_check_next(&rig.check, &fault)) {
            assert_int_equal(fault.rule, i);
            faults++;
        }
        assert_int_equal(faults, i == OBJECT_RULES ? 0 : i == RULE_RECIPROCAL ? 2 : 1);
    }
}

/* The offending entry is named. */
static void mistakes_are_found_where_they_are(void **state)
{
    (void)state;
    static const struct object_fault first[OBJECT_RULES] = {{RULE_VERTEX_ENDS, 5, 0},
                                                            {RULE_EDGE_USED, 8, 0},
                                                            {RULE_POLYGON_CLOSED, 0, 0},
                                                            {RULE_POLYGON_SHARED, 5, 0},
                                                            {RULE_RECIPROCAL, 4, 3}};
    for (int i = 0; i < OBJECT_RULES; i++) {
        struct object_fault fault;
        object_broken(&rig.object, i);
        object_check_begin(&rig.check, &rig.object);
        assert_true(object_check_next(&rig.check, &fault));
        assert_int_equal(fault.rule, first[i].rule);
        assert_int_equal(fault.index, first[i].index);
        assert_int_equal(fault.other, first[i].other);
    }
}

/* Any damage to a sound table is seen. */
static void damage_is_seen(void **state)
{
    (void)state;
    for (int i = 0; i < 3000; i++) {
        struct object *o = &rig.object;
        struct object_fault fault;
        object_clear(o);
        assert_true(object_torus(o, 2, 1, 6, 5, 0));
        int kind = whole(0, 3), e = whole(0, o->edges - 1), s = whole(0, o->sides - 1);
        if (kind == 0) {
            uint16_t *p = &o->edge[e].polygon[whole(0, 1)];
            uint16_t other = (uint16_t)whole(0, o->polygons - 1);
            if (other == o->edge[e].polygon[0] || other == o->edge[e].polygon[1])
                continue;
            *p = other;
        } else if (kind == 1) {
            o->edge[e].polygon[whole(0, 1)] = OBJECT_NONE;
        } else if (kind == 2) {
            uint16_t other = (uint16_t)whole(0, o->edges - 1);
            if (other == o->side[s].edge)
                continue;
            o->side[s].edge = other;
        } else {
            object_vertex(o, 0, 0, 0);
        }
        object_check_begin(&rig.check, o);
        assert_true(object_check_next(&rig.check, &fault));
    }
}

/* There and back along one edge comes back to its start, but encloses nothing. */
static void two_sides_are_no_polygon(void **state)
{
    (void)state;
    struct object *o = &rig.object;
    struct object_fault fault;
    object_broken(o, OBJECT_RULES);
    o->side[1] = (struct object_side){o->side[0].edge, o->side[1].start};
    o->polygon[0].count = 2;
    object_check_begin(&rig.check, o);
    while (object_check_next(&rig.check, &fault) && fault.rule != RULE_POLYGON_CLOSED)
        ;
    assert_int_equal(fault.rule, RULE_POLYGON_CLOSED);
    assert_int_equal(fault.index, 0);
}

static void edges_are_made_once_with_pointers_back(void **state)
{
    (void)state;
    struct object *o = &rig.object;
    static const int s1[] = {0, 1, 2}, s2[] = {0, 2, 3, 4}, again[] = {2, 0, 3};
    object_clear(o);
    for (int i = 0; i < 5; i++)
        assert_int_equal(object_vertex(o, (float)i, (float)(i * i), 0), i);
    assert_int_equal(object_polygon(o, s1, 3, 0), 0);
    assert_int_equal(object_polygon(o, s2, 4, 0), 1);
    assert_int_equal(o->edges, 6);
    /* As in the tables: E3 between V3 and V1 belongs to S1 and S2. */
    assert_int_equal(object_edge_between(o, 0, 2), 2);
    assert_int_equal(o->edge[2].polygon[0], 0);
    assert_int_equal(o->edge[2].polygon[1], 1);
    assert_int_equal(o->side[3].edge, 2);
    assert_int_equal(object_polygon(o, again, 3, 0), -1); /* a third polygon */
    assert_int_equal(object_polygon(o, (const int[]){0, 1, 9}, 3, 0), -1);
    assert_int_equal(object_polygon(o, (const int[]){0, -1, 1}, 3, 0), -1);
    assert_int_equal(object_polygon(o, (const int[]){0, 0, 1}, 3, 0), -1);
    assert_int_equal(object_polygon(o, s1, 2, 0), -1);
    assert_int_equal(object_edge_between(o, 1, 3), -1);
}

static void what_does_not_fit_is_refused(void **state)
{
    (void)state;
    struct object *o = &rig.object;
    struct object_attribute a = {0};
    object_clear(o);
    assert_false(object_sphere(o, 1, 64, 64, 0));
    object_clear(o);
    assert_false(object_sphere(o, 1, 2, 8, 0));
    assert_false(object_sphere(o, 1, 8, 1, 0));
    assert_false(object_torus(o, 1, 0.2f, 8, MODEL_RINGS + 1, 0));
    assert_false(object_cylinder(o, 1, 1, MODEL_SEGMENTS + 1, 0));
    object_clear(o);
    while (object_box(o, 1, 1, 1, 0))
        ;
    assert_true(o->vertices <= OBJECT_VERTICES && o->polygons <= OBJECT_POLYGONS);
    assert_true(o->sides <= OBJECT_SIDES && o->edges <= OBJECT_EDGES);
    for (int i = 0; i < OBJECT_ATTRIBUTES; i++)
        assert_int_equal(object_attribute(o, &a), i);
    assert_int_equal(object_attribute(o, &a), -1);
}

/* ---- normals --------------------------------------------------------------------------------- */

static void normals_of_a_sphere_are_radial(void **state)
{
    (void)state;
    object_clear(&rig.object);
    assert_true(object_sphere(&rig.object, 2, 32, 16, 0));
    assert_true(object_normals(&rig.object, NORMALS_CREASE));
    assert_int_equal(rig.object.normals, rig.object.vertices);
    for (int i = 0; i < rig.object.sides; i++) {
        struct vector3 n = rig.object.normal[rig.object.side_normal[i]];
        struct vector3 v = vector3_direction(rig.object.vertex[rig.object.side[i].start]);
        assert_true(fabsf(vector3_length(n) - 1) < 1e-5f);
        assert_true(vector3_dot(n, v) > 0.995f);
    }
}

/* Nv = ΣN / |ΣN| over all polygons of a vertex, when nothing is a crease. */
static void round_normals_are_the_mean(void **state)
{
    (void)state;
    struct object *o = &rig.object;
    object_clear(o);
    assert_true(object_vessel(o, 1, 12, 0));
    assert_true(object_normals(o, NORMALS_ROUND));
    assert_int_equal(o->normals, o->vertices);
    for (int v = 0; v < o->vertices; v++) {
        struct vector3 sum = {0, 0, 0}, normal = {0, 0, 0};
        for (int p = 0; p < o->polygons; p++)
            for (int k = 0; k < o->polygon[p].count; k++)
                if (object_corner(o, p, k) == v) {
                    struct plane plane = plane_of_polygon(o, p);
                    sum = vector3_sum(sum, plane_normal(&plane));
                    normal = o->normal[o->side_normal[o->polygon[p].first + k]];
                }
        sum = vector3_direction(sum);
        assert_true(vector3_length(vector3_difference(sum, normal)) < 1e-4f);
    }
}

static void a_box_keeps_its_edges(void **state)
{
    (void)state;
    object_clear(&rig.object);
    assert_true(object_box(&rig.object, 1, 2, 3, 0));
    assert_true(object_normals(&rig.object, NORMALS_CREASE));
    assert_int_equal(rig.object.normals, 24);
    assert_true(object_normals(&rig.object, NORMALS_ROUND));
    assert_int_equal(rig.object.normals, 8);
    object_clear(&rig.object);
    assert_true(object_cylinder(&rig.object, 1, 2, 16, 0));
    assert_true(object_normals(&rig.object, NORMALS_CREASE));
    assert_int_equal(rig.object.normals, 64); /* side and end at each corner */
}

/* The triangles that a polygon's corners make with its first one face outward as it does, and cover
 * it; its corners' normals do, too. */
static void polygons_are_fans_of_triangles(void **state)
{
    (void)state;
    const struct object *o = &rig.object;
    object_clear(&rig.object);
    assert_true(object_vessel(&rig.object, 1, 16, 0));
    assert_true(object_normals(&rig.object, NORMALS_CREASE));
    double sum = 0, volume, area;
    for (int p = 0; p < o->polygons; p++) {
        struct plane plane = plane_of_polygon(o, p);
        struct vector3 a = o->vertex[object_corner(o, p, 0)], outward = plane_normal(&plane);
        for (int k = 0; k < o->polygon[p].count; k++)
            assert_true(vector3_dot(o->normal[o->side_normal[o->polygon[p].first + k]], outward) >
                        0);
        for (int k = 1; k + 1 < o->polygon[p].count; k++) {
            struct vector3 b = o->vertex[object_corner(o, p, k)];
            struct vector3 c = o->vertex[object_corner(o, p, k + 1)];
            struct vector3 n = vector3_cross(vector3_difference(b, a), vector3_difference(c, a));
            assert_true(vector3_dot(n, outward) >= 0);
            sum += (double)vector3_length(n) / 2;
        }
    }
    measure(&volume, &area);
    assert_true(fabs(sum - area) < 1e-4 * area);
}

/* ---- planes ---------------------------------------------------------------------------------- */

static void planes_hold_their_points(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        struct vector3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = (struct vector3){(float)uniform(-5, 5), (float)uniform(-5, 5),
                                    (float)uniform(-5, 5)};
        struct plane q = plane_through(p[0], p[1], p[2]);
        double scale = fabs((double)q.a) + fabs((double)q.b) + fabs((double)q.c);
        for (int k = 0; k < 3; k++)
            assert_true(fabs((double)plane_value(&q, p[k])) < 2e-5 * scale * 5 + 1e-4);
        /* Counter-clockwise: outside is where the cross product points. */
        struct vector3 n =
            vector3_cross(vector3_difference(p[1], p[0]), vector3_difference(p[2], p[0]));
        struct vector3 out = vector3_sum(p[0], vector3_direction(n));
        if (vector3_length(n) > 0.1f) {
            assert_true(plane_value(&q, out) > 0);
            assert_true(fabsf(vector3_length(n) - sqrtf(q.a * q.a + q.b * q.b + q.c * q.c)) <
                        1e-3f * vector3_length(n));
        }
    }
}

static void the_unit_plane(void **state)
{
    (void)state;
    struct plane q = plane_through((struct vector3){1, 0, 0}, (struct vector3){0, 1, 0},
                                   (struct vector3){0, 0, 1});
    assert_true(q.a == 1 && q.b == 1 && q.c == 1 && q.d == -1);
    assert_true(plane_value(&q, (struct vector3){1, 1, 1}) == 2);
    assert_true(plane_value(&q, (struct vector3){0, 0, 0}) == -1);
}

static void a_box_contains_what_it_should(void **state)
{
    (void)state;
    object_clear(&rig.object);
    assert_true(object_box(&rig.object, 2, 4, 6, 0));
    int in = 0, first = -1;
    for (int i = 0; i < 20000; i++) {
        struct vector3 p = {(float)uniform(-2, 2), (float)uniform(-4, 4), (float)uniform(-6, 6)};
        bool inside = fabsf(p.x) <= 1 && fabsf(p.y) <= 2 && fabsf(p.z) <= 3;
        assert_int_equal(solid_planes_outside(&rig.object, p, &first) == 0, inside);
        if (!inside) {
            struct plane plane = plane_of_polygon(&rig.object, first);
            assert_true(plane_value(&plane, p) > 0);
        }
        in += inside;
    }
    assert_true(in > 2000);
    /* Beyond a corner it is outside of three planes; the first is the lowest. */
    assert_int_equal(solid_planes_outside(&rig.object, (struct vector3){3, 3, 4}, &first), 3);
    for (int i = 0; i < first; i++) {
        struct plane plane = plane_of_polygon(&rig.object, i);
        assert_true(plane_value(&plane, (struct vector3){3, 3, 4}) <= 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_are_exact),
        cmocka_unit_test(spheres_are_those_inscribed),
        cmocka_unit_test(cylinders_are_prisms),
        cmocka_unit_test(tori_are_those_of_pappus),
        cmocka_unit_test(vessels_are_four_solids),
        cmocka_unit_test(brackets_have_two_tunnels),
        cmocka_unit_test(each_mistake_breaks_one_rule),
        cmocka_unit_test(mistakes_are_found_where_they_are),
        cmocka_unit_test(damage_is_seen),
        cmocka_unit_test(two_sides_are_no_polygon),
        cmocka_unit_test(edges_are_made_once_with_pointers_back),
        cmocka_unit_test(what_does_not_fit_is_refused),
        cmocka_unit_test(normals_of_a_sphere_are_radial),
        cmocka_unit_test(round_normals_are_the_mean),
        cmocka_unit_test(a_box_keeps_its_edges),
        cmocka_unit_test(polygons_are_fans_of_triangles),
        cmocka_unit_test(planes_hold_their_points),
        cmocka_unit_test(the_unit_plane),
        cmocka_unit_test(a_box_contains_what_it_should),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
