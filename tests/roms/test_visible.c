/* Visible surfaces (roms/visible): the methods against one another pixel for pixel, the depth
 * buffer against a ray through every pixel's middle in double precision, hidden lines against
 * points close together along every edge, back faces against the solids themselves. */
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
#include "roms/raster/fill.c"
#include "roms/solids/box.c"
#include "roms/solids/normals.c"
#include "roms/solids/object.c"
#include "roms/solids/plane.c"
#include "roms/solids/revolve.c"
#include "roms/solids/rings.c"
#include "roms/solids/tube.c"
#include "roms/solids/vessel.c"
#include "roms/visible/depth_buffer.c"
#include "roms/visible/depth_surface.c"
#include "roms/visible/hidden_lines.c"
#include "roms/visible/painter.c"
#include "roms/visible/scan_line.c"
#include "roms/visible/scene.c"
#include "roms/visible/surface_scan.c"

enum { WIDTH = 200, HEIGHT = 160, BACKGROUND = 255 };

static struct {
    struct object object;
    struct scene scene;
    struct scan_line scan_line;
    struct painter painter;
    struct hidden_lines hidden;
    _Alignas(4) uint8_t pixels[3][WIDTH * HEIGHT];
    float depth[WIDTH * HEIGHT];
    uint32_t random;
} rig = {.random = 4711};

static float uniform(float low, float high)
{
    rig.random = rig.random * 1664525u + 1013904223u;
    return low + (high - low) * (float)(rig.random >> 8) / 16777216.0f;
}

static struct canvas canvas_of(int number)
{
    memset(rig.pixels[number], BACKGROUND, sizeof rig.pixels[number]);
    return (struct canvas){rig.pixels[number], WIDTH, WIDTH, HEIGHT, 8, 1.0f};
}

static struct matrix4 turn_about(int axis, float angle)
{
    struct matrix4 m = matrix4_identity();
    int i = (axis + 1) % 3, k = (axis + 2) % 3;
    m.at[i][i] = m.at[k][k] = cosf(angle);
    m.at[i][k] = -sinf(angle);
    m.at[k][i] = sinf(angle);
    return m;
}

static struct matrix4 random_turn(void)
{
    struct matrix4 x = turn_about(0, uniform(-3, 3)), y = turn_about(1, uniform(-3, 3));
    struct matrix4 z = turn_about(2, uniform(-3, 3)), yx = matrix4_product(&y, &x);
    return matrix4_product(&z, &yx);
}

static struct view random_view(void)
{
    return (struct view){.turn = random_turn(),
                         .eye = uniform(0, 1) < 0.5f ? 0 : uniform(9, 20),
                         .scale = uniform(18, 26),
                         .x = uniform(70, 130),
                         .y = uniform(60, 100),
                         .up = -1};
}

static void add_solid(int which)
{
    static const int segments[] = {3, 5, 8, 12};
    int n = segments[(int)uniform(0, 4) & 3];
    if (which == 0)
        assert_true(
            object_box(&rig.object, uniform(0.2f, 1), uniform(0.2f, 1), uniform(0.2f, 1), 0));
    else if (which == 1)
        assert_true(object_sphere(&rig.object, uniform(0.3f, 0.9f), n, n / 2 + 2, 0));
    else
        assert_true(object_cylinder(&rig.object, uniform(0.2f, 0.6f), uniform(0.2f, 1.2f), n, 0));
}

/* Convex solids, each in a sphere of its own of radius 0.9 about a place of a grid 2 apart. */
static void random_solids(struct view *view)
{
    *view = random_view();
    object_clear(&rig.object);
    for (int i = 0; i < 27; i++) {
        if (uniform(0, 1) < 0.5f)
            continue;
        int first = rig.object.vertices;
        struct matrix4 m = random_turn();
        add_solid((int)uniform(0, 2.99f));
        m.at[0][3] = 2.0f * (float)(i % 3 - 1);
        m.at[1][3] = 2.0f * (float)(i / 3 % 3 - 1);
        m.at[2][3] = 2.0f * (float)(i / 9 - 1);
        object_transform(&rig.object, first, &m);
    }
}

static void colour_surfaces(void)
{
    for (int i = 0; i < rig.scene.surfaces; i++)
        rig.scene.surface[i].colour = (uint32_t)(i % BACKGROUND);
}

static void random_scene(unsigned flags)
{
    struct view view;
    random_solids(&view);
    scene_clear(&rig.scene);
    assert_true(scene_add(&rig.scene, &rig.object, &view, flags, 0));
    colour_surfaces();
}

/* Triangles and quadrilaterals through one another. */
static void random_piercing(void)
{
    struct view view = random_view();
    object_clear(&rig.object);
    int count = 2 + (int)uniform(0, 20);
    for (int i = 0; i < count; i++) {
        int corner[4], corners = uniform(0, 1) < 0.5f ? 3 : 4;
        struct vector3 p = {uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)};
        struct vector3 u = {uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)};
        struct vector3 v = {uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)};
        static const float place[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (int k = 0; k < corners; k++) {
            struct vector3 at = vector3_sum(
                p, vector3_sum(vector3_times(u, place[k][0]), vector3_times(v, place[k][1])));
            corner[k] = object_vertex(&rig.object, at.x, at.y, at.z);
        }
        assert_true(object_polygon(&rig.object, corner, corners, 0) >= 0);
    }
    scene_clear(&rig.scene);
    assert_true(scene_add(&rig.scene, &rig.object, &view, 0, 0));
    colour_surfaces();
}

static void draw_by_depth(int number)
{
    struct canvas c = canvas_of(number);
    struct depth_buffer b = {rig.depth, WIDTH, HEIGHT};
    depth_clear(&b, -1e9f);
    depth_scene(&c, &b, &rig.scene);
}

static void draw_by_scan_line(int number)
{
    struct canvas c = canvas_of(number);
    scan_line_scene(&rig.scan_line, &c, &rig.scene);
}

static int differences(int a, int b)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        count += rig.pixels[a][i] != rig.pixels[b][i];
    return count;
}

/* ---- the methods against one another --------------------------------------------------------- */

static void methods_agree_on_solids_apart(void **state)
{
    (void)state;
    int painted = 0;
    for (int i = 0; i < 600; i++) {
        random_scene(SCENE_CULLED);
        draw_by_depth(0);
        draw_by_scan_line(1);
        assert_int_equal(differences(0, 1), 0);
        struct canvas c = canvas_of(2);
        painter_scene(&rig.painter, &c, &rig.scene);
        if (rig.painter.circles == 0)
            assert_int_equal(differences(0, 2), 0);
        painted += rig.painter.circles == 0;
    }
    print_message("painter's: an order in %d of 600\n", painted);
    assert_true(painted > 570);
}

/* Where two planes come equally near rounding may decide: a few pixels in a million. */
static void scan_line_agrees_where_surfaces_pierce(void **state)
{
    (void)state;
    int different = 0;
    for (int i = 0; i < 600; i++) {
        random_piercing();
        draw_by_depth(0);
        draw_by_scan_line(1);
        different += differences(0, 1);
    }
    print_message("piercing: %d pixels of %d differ\n", different, 600 * WIDTH * HEIGHT);
    assert_true(different < 190);
}

/* ---- the depth buffer against rays ----------------------------------------------------------- */

struct ray {
    double nearest, second; /* depths */
    int surface;
    bool doubtful; /* close to an outline */
};

/* Where a surface's plane is hit; in double precision from three of its corners. */
static double hit(const struct surface *s, double x, double y)
{
    struct vector3 a = scene_corner(&rig.scene, s, 0), b = scene_corner(&rig.scene, s, 1);
    struct vector3 c = scene_corner(&rig.scene, s, 2);
    double ux = (double)b.x - a.x, uy = (double)b.y - a.y, uz = (double)b.z - a.z;
    double vx = (double)c.x - a.x, vy = (double)c.y - a.y, vz = (double)c.z - a.z;
    double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    return a.z - (nx * (x - a.x) + ny * (y - a.y)) / nz;
}

/* 1 within, 0 outside, -1 within a fiftieth of a pixel of the outline. */
static int inside(const struct surface *s, double x, double y)
{
    int right = 0, left = 0;
    for (int i = 0; i < s->count; i++) {
        struct vector3 a = scene_corner(&rig.scene, s, i);
        struct vector3 b = scene_corner(&rig.scene, s, (i + 1) % s->count);
        double dx = (double)b.x - a.x, dy = (double)b.y - a.y;
        double length = sqrt(dx * dx + dy * dy) + 1e-12;
        double away = (dx * (y - a.y) - dy * (x - a.x)) / length;
        double along = (dx * (x - a.x) + dy * (y - a.y)) / length;
        if (fabs(away) < 0.02 && along > -0.02 && along < length + 0.02)
            return -1;
        right += away > 0;
        left += away < 0;
    }
    return right == 0 || left == 0;
}

static struct ray ray_through(int x, int y)
{
    struct ray r = {-1e9, -1e9, -1, false};
    for (int i = 0; i < rig.scene.surfaces; i++) {
        const struct surface *s = &rig.scene.surface[i];
        int in = inside(s, x, y);
        r.doubtful = r.doubtful || in < 0;
        if (in <= 0)
            continue;
        double z = hit(s, x, y);
        if (z > r.nearest) {
            r.second = r.nearest;
            r.nearest = z;
            r.surface = i;
        } else if (z > r.second) {
            r.second = z;
        }
    }
    return r;
}

static void depth_buffer_shows_what_rays_hit(void **state)
{
    (void)state;
    int judged = 0;
    for (int i = 0; i < 30; i++) {
        if (i % 2 == 0)
            random_piercing();
        else
            random_scene(0);
        draw_by_depth(0);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                struct ray r = ray_through(x, y);
                if (r.doubtful || (r.surface >= 0 && r.nearest - r.second < 0.05))
                    continue;
                judged++;
                int shown = rig.pixels[0][y * WIDTH + x];
                assert_int_equal(shown, r.surface < 0 ? BACKGROUND : r.surface % BACKGROUND);
                if (r.surface >= 0)
                    assert_true(fabs((double)rig.depth[y * WIDTH + x] - r.nearest) <
                                0.02 + 1e-3 * fabs(r.nearest));
            }
    }
    print_message("rays: %d judged\n", judged);
    assert_true(judged > 30 * WIDTH * HEIGHT * 8 / 10);
}

/* A closed solid's faces cover each pixel of its outline once, before and behind. */
static void faces_that_share_edges_share_no_pixel(void **state)
{
    (void)state;
    static uint8_t front[WIDTH * HEIGHT], back[WIDTH * HEIGHT];
    for (int i = 0; i < 300; i++) {
        struct view view = random_view();
        object_clear(&rig.object);
        add_solid(i % 3);
        view.scale *= 3;
        scene_clear(&rig.scene);
        assert_true(scene_add(&rig.scene, &rig.object, &view, 0, 0));
        memset(front, 0, sizeof front);
        memset(back, 0, sizeof back);
        for (int k = 0; k < rig.scene.surfaces; k++) {
            struct surface_scan row;
            uint8_t *to = rig.scene.surface[k].plane.c > 0 ? back : front;
            surface_scan_begin(&row, &rig.scene, &rig.scene.surface[k], WIDTH, HEIGHT);
            while (surface_scan_next(&row))
                for (int x = row.x0; x < row.x1; x++)
                    to[row.y * WIDTH + x]++;
        }
        int covered = 0;
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            assert_true(front[k] <= 1);
            assert_int_equal(front[k], back[k]);
            covered += front[k];
        }
        assert_true(covered > 20);
    }
}

/* What lies at z <= 0 is lost in a buffer that begins with 0; nothing else is. */
static void a_buffer_that_begins_with_0_hides_the_rear(void **state)
{
    (void)state;
    for (int i = 0; i < 100; i++) {
        random_scene(SCENE_CULLED);
        draw_by_depth(0);
        static float right[WIDTH * HEIGHT];
        memcpy(right, rig.depth, sizeof right);
        struct canvas c = canvas_of(1);
        struct depth_buffer b = {rig.depth, WIDTH, HEIGHT};
        depth_clear(&b, 0);
        depth_scene(&c, &b, &rig.scene);
        int lost = 0;
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            assert_int_equal(rig.pixels[1][k], right[k] > 0 ? rig.pixels[0][k] : BACKGROUND);
            lost += rig.pixels[1][k] != rig.pixels[0][k];
        }
        assert_true(lost > 0);
    }
}

/* ---- painter's failing cases ----------------------------------------------------------------- */

static void add_bar(struct vector3 from, struct vector3 to, struct vector3 side)
{
    int corner[4];
    struct vector3 p[4] = {vector3_difference(from, side), vector3_difference(to, side),
                           vector3_sum(to, side), vector3_sum(from, side)};
    for (int k = 0; k < 4; k++)
        corner[k] = object_vertex(&rig.object, p[k].x, p[k].y, p[k].z);
    assert_true(object_polygon(&rig.object, corner, 4, 0) >= 0);
}

static void no_order_in_a_circle(void **state)
{
    (void)state;
    struct view view = {matrix4_identity(), 0, 20, 100, 80, -1};
    object_clear(&rig.object);
    for (int i = 0; i < 3; i++) {
        float a = 2.0943951f * (float)i, b = a + 2.0943951f;
        struct vector3 along = {cosf(b) - cosf(a), sinf(b) - sinf(a), 0};
        struct vector3 mid = {(cosf(a) + cosf(b)) / 2, (sinf(a) + sinf(b)) / 2, 0};
        struct vector3 from = vector3_difference(mid, vector3_times(along, 0.9f));
        struct vector3 to = vector3_sum(mid, vector3_times(along, 0.9f));
        from.z = -1;
        to.z = 1;
        add_bar(from, to, vector3_times(vector3_direction(mid), 0.25f));
    }
    scene_clear(&rig.scene);
    assert_true(scene_add(&rig.scene, &rig.object, &view, 0, 0));
    colour_surfaces();
    draw_by_depth(0);
    draw_by_scan_line(1);
    assert_int_equal(differences(0, 1), 0);
    struct canvas c = canvas_of(2);
    painter_scene(&rig.painter, &c, &rig.scene);
    assert_true(rig.painter.circles > 0);
    assert_true(differences(0, 2) > 20);
    /* Two of the three have an order. */
    rig.scene.surfaces = 2;
    draw_by_depth(0);
    c = canvas_of(2);
    painter_scene(&rig.painter, &c, &rig.scene);
    assert_int_equal(rig.painter.circles, 0);
    assert_int_equal(differences(0, 2), 0);
}

static void every_surface_is_painted_once(void **state)
{
    (void)state;
    static int times[SCENE_SURFACES];
    for (int i = 0; i < 200; i++) {
        random_piercing();
        memset(times, 0, sizeof times);
        painter_begin(&rig.painter, &rig.scene);
        for (int s = painter_next(&rig.painter); s >= 0; s = painter_next(&rig.painter))
            times[s]++;
        for (int k = 0; k < rig.scene.surfaces; k++)
            assert_int_equal(times[k], rig.scene.surface[k].plane.c != 0);
    }
}

/* ---- hidden lines ---------------------------------------------------------------------------- */

/* Is a point of an edge hidden? -1: too close to say. */
static int point_hidden(const struct scene_edge *e, struct vector3 p)
{
    int hidden = 0;
    for (int i = 0; i < rig.scene.surfaces; i++) {
        const struct surface *s = &rig.scene.surface[i];
        if (i == e->surface[0] || i == e->surface[1] || s->plane.c == 0)
            continue;
        int in = inside(s, p.x, p.y);
        double above = hit(s, p.x, p.y) - p.z;
        double slope =
            (fabs((double)s->plane.a) + fabs((double)s->plane.b)) / fabs((double)s->plane.c);
        bool close = fabs(above) < 0.2 + 0.05 * slope;
        if (in < 0 && above > -0.2)
            return -1;
        if (in > 0 && close)
            return -1;
        hidden = hidden || (in > 0 && above > 0);
    }
    return hidden;
}

static void parts_of_edges_are_what_points_say(void **state)
{
    (void)state;
    int judged = 0, seen = 0, hidden = 0;
    for (int i = 0; i < 30; i++) {
        if (i % 2 == 0)
            random_scene(SCENE_CULLED);
        else
            random_piercing();
        hidden_begin(&rig.hidden, &rig.scene, EDGES_ALL);
        struct hidden_part part;
        while (hidden_next(&rig.hidden, &part)) {
            for (int k = 1; k < 8; k++) {
                float t = (float)k / 8;
                struct vector3 p =
                    vector3_sum(part.a, vector3_times(vector3_difference(part.b, part.a), t));
                int says = point_hidden(&rig.scene.edge[part.edge], p);
                if (says < 0)
                    continue;
                judged++;
                assert_int_equal(says, !part.seen);
            }
            seen += part.seen;
            hidden += !part.seen;
        }
    }
    print_message("hidden lines: %d points judged, %d parts seen, %d hidden\n", judged, seen,
                  hidden);
    assert_true(judged > 10000 && seen > 500 && hidden > 500);
}

/* The parts of an edge make up the edge. */
static void parts_of_edges_are_whole_edges(void **state)
{
    (void)state;
    static float length[SCENE_EDGES];
    for (int i = 0; i < 100; i++) {
        random_scene(SCENE_CULLED);
        memset(length, 0, sizeof length);
        hidden_begin(&rig.hidden, &rig.scene, EDGES_ALL);
        struct hidden_part part;
        while (hidden_next(&rig.hidden, &part))
            length[part.edge] += hypotf(part.b.x - part.a.x, part.b.y - part.a.y);
        for (int k = 0; k < rig.scene.edges; k++) {
            struct vector3 a = rig.scene.vertex[rig.scene.edge[k].vertex[0]];
            struct vector3 b = rig.scene.vertex[rig.scene.edge[k].vertex[1]];
            float whole = hypotf(b.x - a.x, b.y - a.y);
            assert_true(length[k] <= whole + 0.01f);
            assert_true(length[k] >= whole - 6 * HIDDEN_SHORTEST);
        }
    }
}

static void a_convex_solid_alone_hides_its_rear_only(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        struct view view = random_view();
        object_clear(&rig.object);
        add_solid(i % 3);
        view.scale *= 2;
        scene_clear(&rig.scene);
        assert_true(scene_add(&rig.scene, &rig.object, &view, SCENE_CULLED, 0));
        hidden_begin(&rig.hidden, &rig.scene, EDGES_ALL);
        struct hidden_part part;
        while (hidden_next(&rig.hidden, &part))
            assert_true(part.seen);
    }
}

/* Hidden parts in any order, joined where they meet, against a thousand points of the edge. */
static void hidden_parts_are_joined(void **state)
{
    (void)state;
    enum { POINTS = 1000 };
    for (int i = 0; i < 5000; i++) {
        bool hidden[POINTS] = {false};
        struct hidden_lines *h = &rig.hidden;
        int count = 1 + (int)uniform(0, 20);
        h->parts = 0;
        for (int k = 0; k < count; k++) {
            int from = (int)uniform(0, POINTS - 1),
                to = from + 1 + (int)uniform(0, uniform(0, 300));
            to = to < POINTS ? to : POINTS;
            add_hidden(h, (float)from / POINTS, (float)to / POINTS);
            for (int p = from; p < to; p++)
                hidden[p] = true;
        }
        for (int k = 1; k < h->parts; k++)
            assert_true(h->hidden[k - 1].to < h->hidden[k].from);
        for (int p = 0; p < POINTS; p++) {
            float at = ((float)p + 0.5f) / POINTS;
            bool in = false;
            for (int k = 0; k < h->parts; k++)
                in = in || (at > h->hidden[k].from && at < h->hidden[k].to);
            assert_int_equal(in, hidden[p]);
        }
    }
}

/* More parts than there is room for, in any order: the list stays in order, nothing hidden is
 * lost, and no more is hidden than a gap for each part that is too many. */
static void too_many_parts_hide_more(void **state)
{
    (void)state;
    enum { PARTS = 2 * HIDDEN_PARTS };
    for (int i = 0; i < 2000; i++) {
        struct hidden_lines *h = &rig.hidden;
        int order[PARTS], count = HIDDEN_PARTS + 1 + i % HIDDEN_PARTS;
        float covered = 0;
        for (int k = 0; k < count; k++) {
            int other = (int)uniform(0, (float)k + 0.99f);
            order[k] = order[other];
            order[other] = k;
        }
        h->parts = 0;
        for (int k = 0; k < count; k++)
            add_hidden(h, (float)(2 * order[k]) / 100, (float)(2 * order[k] + 1) / 100);
        assert_int_equal(h->parts, HIDDEN_PARTS);
        for (int k = 0; k < h->parts; k++) {
            assert_true(h->hidden[k].from < h->hidden[k].to);
            assert_true(k == 0 || h->hidden[k - 1].to < h->hidden[k].from);
            covered += h->hidden[k].to - h->hidden[k].from;
        }
        assert_true(fabsf(covered - (float)(2 * count - HIDDEN_PARTS) / 100) < 0.0001f);
        for (int k = 0; k < count; k++) {
            float at = (2 * (float)k + 0.5f) / 100;
            bool in = false;
            for (int n = 0; n < h->parts; n++)
                in = in || (at > h->hidden[n].from && at < h->hidden[n].to);
            assert_true(in);
        }
    }
}

/* ---- projection ------------------------------------------------------------------------------ */

/* xp = x·d/(d − z); a middle in space lies on the picture's line with the depth that is linear
 * there; what is nearer on a ray has the larger depth. */
static void perspective_keeps_lines_and_order(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        double d = (double)uniform(4, 20);
        struct view view = {matrix4_identity(), (float)d, 30, 100, 80, -1};
        struct vector3 a = {uniform(-2, 2), uniform(-2, 2), uniform(-3, 3)};
        struct vector3 b = {uniform(-2, 2), uniform(-2, 2), uniform(-3, 3)};
        struct vector3 m = vector3_times(vector3_sum(a, b), 0.5f);
        struct vector3 pa = view_place(&view, a), pb = view_place(&view, b),
                       pm = view_place(&view, m);
        assert_true(fabs((double)pa.x - (100 + 30 * (double)a.x * d / (d - (double)a.z))) < 1e-3);
        assert_true(fabs((double)pa.y - (80 - 30 * (double)a.y * d / (d - (double)a.z))) < 1e-3);
        double dx = (double)pb.x - pa.x, dy = (double)pb.y - pa.y;
        double t =
            (((double)pm.x - pa.x) * dx + ((double)pm.y - pa.y) * dy) / (dx * dx + dy * dy + 1e-9);
        if (dx * dx + dy * dy > 25) {
            assert_true(fabs((double)pa.y + t * dy - pm.y) < 1e-2);
            assert_true(fabs((double)pa.z + t * ((double)pb.z - pa.z) - pm.z) < 2e-2);
        }
        /* Toward the eye at (0, 0, d). */
        struct vector3 eye = {0, 0, (float)d};
        struct vector3 nearer = vector3_sum(a, vector3_times(vector3_difference(eye, a), 0.1f));
        struct vector3 pn = view_place(&view, nearer);
        assert_true(fabsf(pn.x - pa.x) < 1e-2f && fabsf(pn.y - pa.y) < 1e-2f && pn.z > pa.z);
    }
}

/* ---- back faces ------------------------------------------------------------------------------ */

/* Visible polygons of a convex solid are those whose middle, moved a little toward the eye, is
 * outside. */
static void back_faces_are_those_seen_through_the_solid(void **state)
{
    (void)state;
    static bool kept[OBJECT_POLYGONS];
    for (int i = 0; i < 500; i++) {
        struct view view = random_view();
        object_clear(&rig.object);
        add_solid(i % 3);
        object_transform(&rig.object, 0, &view.turn);
        view.turn = matrix4_identity();
        scene_clear(&rig.scene);
        assert_true(scene_add(&rig.scene, &rig.object, &view, SCENE_CULLED, 0));
        memset(kept, 0, sizeof kept);
        for (int k = 0; k < rig.scene.surfaces; k++)
            kept[rig.scene.surface[k].polygon] = true;
        for (int p = 0; p < rig.object.polygons; p++) {
            struct vector3 mid = {0, 0, 0};
            for (int k = 0; k < rig.object.polygon[p].count; k++)
                mid = vector3_sum(mid, rig.object.vertex[object_corner(&rig.object, p, k)]);
            mid = vector3_times(mid, 1.0f / (float)rig.object.polygon[p].count);
            struct vector3 to = {0, 0, 1};
            if (view.eye > 0)
                to = vector3_direction(vector3_difference((struct vector3){0, 0, view.eye}, mid));
            struct plane plane = plane_of_polygon(&rig.object, p);
            if (fabsf(vector3_dot(plane_normal(&plane), to)) < 0.02f)
                continue;
            struct vector3 probe = vector3_sum(mid, vector3_times(to, 0.001f));
            int first;
            assert_int_equal(kept[p], solid_planes_outside(&rig.object, probe, &first) > 0);
        }
    }
}

/* The origin is within: D < 0 everywhere, and says nothing about who looks. */
static void the_sign_of_d_does_not_tell(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        object_clear(&rig.object);
        add_solid(i % 3);
        for (int p = 0; p < rig.object.polygons; p++)
            assert_true(plane_of_polygon(&rig.object, p).d < 0);
    }
}

static void what_is_at_the_eye_is_refused(void **state)
{
    (void)state;
    struct view view = {matrix4_identity(), 1, 20, 100, 80, -1};
    object_clear(&rig.object);
    assert_true(object_box(&rig.object, 1, 1, 3, 0));
    scene_clear(&rig.scene);
    assert_false(scene_add(&rig.scene, &rig.object, &view, 0, 0));
    assert_int_equal(rig.scene.surfaces, 0);
    view.eye = 0;
    view.scale = 1e9f;
    assert_false(scene_add(&rig.scene, &rig.object, &view, 0, 0));
    view.scale = 20;
    for (int i = 0; i < SCENE_SURFACES / 6; i++)
        (void)scene_add(&rig.scene, &rig.object, &view, 0, 0);
    assert_false(scene_add(&rig.scene, &rig.object, &view, 0, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(methods_agree_on_solids_apart),
        cmocka_unit_test(scan_line_agrees_where_surfaces_pierce),
        cmocka_unit_test(depth_buffer_shows_what_rays_hit),
        cmocka_unit_test(faces_that_share_edges_share_no_pixel),
        cmocka_unit_test(a_buffer_that_begins_with_0_hides_the_rear),
        cmocka_unit_test(no_order_in_a_circle),
        cmocka_unit_test(every_surface_is_painted_once),
        cmocka_unit_test(parts_of_edges_are_what_points_say),
        cmocka_unit_test(parts_of_edges_are_whole_edges),
        cmocka_unit_test(a_convex_solid_alone_hides_its_rear_only),
        cmocka_unit_test(hidden_parts_are_joined),
        cmocka_unit_test(too_many_parts_hide_more),
        cmocka_unit_test(perspective_keeps_lines_and_order),
        cmocka_unit_test(back_faces_are_those_seen_through_the_solid),
        cmocka_unit_test(the_sign_of_d_does_not_tell),
        cmocka_unit_test(what_is_at_the_eye_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
