/* space_clip.c — clipping to the view volume: clip3d. */
#include <stdio.h>

#include "roms/clip/volume.h"
#include "roms/commands/space_commands.h"
#include "roms/commands/space_picture.h"
#include "roms/geometry/projection_parallel.h"
#include "roms/monitor/print.h"

struct request {
    struct matrix4 volume, back; /* to the volume's coordinates, and from them */
    bool polygon;
    struct space_points before;
    struct vector3 after[VOLUME_ROOM];
    int left;
    struct volume_line line;
};

static bool take_volume(struct words *w, struct request *r)
{
    static const char *const kinds[] = {"parallel", "perspective", NULL};
    int kind;
    struct vector3 prp = {0, 0, 0};
    float zvp = 0, near, far;
    struct clip_window window;
    if (!words_choice(w, kinds, &kind))
        return false;
    if (kind == 1 && (!words_amount(w, &prp.z) || !words_amount(w, &zvp)))
        return false;
    if (!words_amount(w, &window.x_min) || !words_amount(w, &window.y_min) ||
        !words_amount(w, &window.x_max) || !words_amount(w, &window.y_max) ||
        !words_amount(w, &near) || !words_amount(w, &far))
        return false;
    bool taken = kind == 1 ? volume_perspective(prp, zvp, &window, near, far, &r->volume)
                           : volume_parallel(&window, near, far, &r->volume);
    if (!taken)
        return words_refuse(w, kind == 1 ? "needs zprp > near > far, zprp > zvp and min < max"
                                         : "needs near > far and min < max");
    if (!space_matrix_fits(&r->volume) || !matrix4_inverse(&r->volume, &r->back) ||
        !space_matrix_fits(&r->back))
        return words_refuse(w, "this volume is too thin or too large");
    return true;
}

static bool take(struct words *w, struct request *r)
{
    static const char *const figures[] = {"line", "polygon", NULL};
    int figure;
    if (!take_volume(w, r) || !words_choice(w, figures, &figure))
        return false;
    r->polygon = figure == 1;
    const struct words_wanted corners = {3, VOLUME_CORNERS, WORDS_FARTHEST},
                              ends = {2, 2, WORDS_FARTHEST};
    return words_points(w, 3, r->polygon ? corners : ends, r->before.at, &r->before.count) &&
           words_end(w);
}

/* ---- on the console -------------------------------------------------------------------------- */

static void print_code(unsigned code)
{
    for (int i = VOLUME_PLANES - 1; i >= 0; i--)
        putchar(code >> i & 1 ? '1' : '0');
}

static void print_end(const char *name, const float b[VOLUME_PLANES], unsigned code)
{
    printf("%3s", name);
    for (int i = 0; i < VOLUME_PLANES; i++)
        printf(" %9.4f", print_tidy(b[i]));
    printf("   ");
    print_code(code);
    printf("\n");
}

static void clip_line(struct request *r, bool table)
{
    struct vector3 a = r->before.at[0], b = r->before.at[1];
    struct vector4 from = matrix4_homogeneous(&r->volume, a);
    struct vector4 to = matrix4_homogeneous(&r->volume, b);
    bool left = volume_clip_line(&from, &to, &r->line);
    const struct volume_line *k = &r->line;
    if (table) {
        printf("end       h+x       h-x       h+y       h-y       h+z       h-z   NFABRL\n");
        print_end("a", k->a, k->code_a);
        print_end("b", k->b, k->code_b);
        if ((k->code_a & k->code_b) == 0)
            printf("t1 = %.4f, t2 = %.4f\n", print_tidy(k->t1), print_tidy(k->t2));
    }
    r->left = left ? 2 : 0;
    struct vector3 along = vector3_difference(b, a);
    r->after[0] = vector3_sum(a, vector3_times(along, k->t1));
    r->after[1] = k->t2 < 1 ? vector3_sum(a, vector3_times(along, k->t2)) : b;
    if (!left) {
        printf("rejected\n");
        return;
    }
    print_vector3(r->after[0]);
    printf(" - ");
    print_vector3(r->after[1]);
    printf("\n");
}

/* A corner, back in the world. */
static struct vector3 corner(const struct request *r, struct vector4 v)
{
    float p[4];
    for (int i = 0; i < 4; i++)
        p[i] = r->back.at[i][0] * v.x + r->back.at[i][1] * v.y + r->back.at[i][2] * v.z +
               r->back.at[i][3] * v.h;
    return (struct vector3){p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

static void print_corners(const struct request *r, const char *name, const struct vector4 *at,
                          int count)
{
    printf("%-6s %d corners\n", name, count);
    for (int i = 0; i < count; i++) {
        printf("       ");
        print_vector3(corner(r, at[i]));
        printf("\n");
    }
}

static void clip_polygon(struct request *r, bool table)
{
    static const char *const names[] = {"left", "right", "below", "above", "far", "near"};
    struct vector4 at[VOLUME_ROOM], next[VOLUME_ROOM];
    int count = r->before.count;
    for (int i = 0; i < count; i++)
        at[i] = matrix4_homogeneous(&r->volume, r->before.at[i]);
    for (int plane = 0; plane < VOLUME_PLANES && table; plane++) {
        count = volume_clip_plane(at, count, (enum volume_plane)plane, next);
        for (int i = 0; i < count; i++)
            at[i] = next[i];
        print_corners(r, names[plane], at, count);
    }
    for (int i = 0; i < r->before.count; i++)
        next[i] = matrix4_homogeneous(&r->volume, r->before.at[i]);
    r->left = volume_clip_polygon(next, r->before.count, at);
    for (int i = 0; i < r->left; i++)
        r->after[i] = corner(r, at[i]);
    if (r->left == 0)
        printf("rejected\n");
    for (int i = 0; i < r->left; i++) {
        print_vector3(r->after[i]);
        printf("\n");
    }
}

/* ---- in the picture -------------------------------------------------------------------------- */

/* The volume's corners: bit 0 right, bit 1 above, bit 2 near. */
static void corners(const struct request *r, struct vector3 out[8])
{
    for (int i = 0; i < 8; i++)
        out[i] = corner(r, (struct vector4){i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1, 1});
}

static void draw_volume(const struct space_view *view, const struct vector3 at[8])
{
    for (int i = 0; i < 8; i++)
        for (int bit = 1; bit < 8; bit *= 2)
            if ((i & bit) == 0)
                space_line(view, at[i], at[i | bit]);
}

static void draw_left(const struct space_view *view, const struct request *r)
{
    for (int i = 0; i < r->left; i++) {
        struct point2 at;
        space_line(view, r->after[i], r->after[(i + 1) % r->left]);
        if (space_place(view, r->after[i], &at))
            stage_marker(view->stage, at.x, at.y);
    }
}

static void draw(struct stage *s, const struct request *r)
{
    struct vector3 all[8 + SPACE_POINTS];
    int count = 8;
    struct axonometric a = projection_axonometric(-55, 20);
    corners(r, all);
    for (int i = 0; i < r->before.count; i++)
        all[count++] = r->before.at[i];
    stage_begin(s);
    struct space_scene scene = space_scene(s, &a.matrix, STAGE_WIDTH, all, count);
    const struct space_view *view = &scene.view;
    space_axes(view, scene.axes, scene.negative);
    stage_ink(s, INK_BLUE);
    draw_volume(view, all);
    stage_ink(s, INK_GRID);
    space_figure(view, &r->before, false);
    stage_ink(s, INK_BRIGHT);
    draw_left(view, r);
    stage_title(s, "Clipping to the view volume");
    stage_caption(s, r->left > 0 ? "blue: the volume; grey: before; bright: what is left"
                                 : "blue: the volume; nothing is left of the grey figure");
    stage_end(s);
}

bool space_clip(struct monitor *m, struct words *w)
{
    struct request r;
    if (!take(w, &r))
        return false;
    if (r.polygon)
        clip_polygon(&r, m->table);
    else
        clip_line(&r, m->table);
    draw(&m->stage, &r);
    return true;
}
