/* light_shade.c — shade: a solid in one of the shadings, and what it cost. */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/commands/light.h"
#include "roms/scenery/studio.h"

enum { FINEST = 32, USUAL = 32, SAMPLES_MOST = 64 /* a pixel: some seconds */ };

static int samples(const struct lighting *g)
{
    int sum = 0;
    for (int i = 0; i < g->count; i++) {
        const struct light *l = &g->light[i];
        sum += l->kind == LIGHT_RECTANGLE ? l->samples * l->samples
               : l->kind == LIGHT_LINE    ? l->samples
                                          : 1;
    }
    return sum;
}

static void print_cost(const struct studio_cost *c)
{
    uint32_t all = c->clear + c->place + c->shade, hz = board_clock_hz();
    printf("%lu triangles seen, %lu pixels", (unsigned long)c->triangles, (unsigned long)c->pixels);
    if (c->pixels == 0 || hz == 0) {
        printf("\n");
        return;
    }
    printf(", %.1f instructions a pixel\n", (double)c->shade / c->pixels);
    printf("vertices %lu + depth buffer %lu + shading %lu = %lu instructions, %.2f ms\n",
           (unsigned long)c->place, (unsigned long)c->clear, (unsigned long)c->shade,
           (unsigned long)all, 1000.0 * all / hz);
}

bool light_shade(struct monitor *m, struct words *w)
{
    static const char *const captions[] = {
        "Flat: one intensity a polygon. Edges look sharper than they are: Mach bands.",
        "Gouraud: light at the corners, interpolated. Edges are gone, highlights are blurred.",
        "Phong: normals interpolated, light at every pixel. Highlights keep their shape.",
        "Fast Phong: the same by a polynomial of second degree, two additions a pixel."};
    int shading, model = STUDIO_TORUS, fineness = USUAL;
    if (!words_choice(w, shading_names, &shading))
        return false;
    if (words_left(w) > 0 && !words_next_is_number(w) && !words_choice(w, studio_names, &model))
        return false;
    if (words_left(w) > 0 && !words_whole(w, 8, FINEST, &fineness))
        return false;
    if (!words_end(w))
        return false;
    struct studio *s = studio();
    struct studio_pose pose = {600, 400, 370, 30, 35, 5};
    if (shading == SHADE_PHONG && samples(&s->lighting) > SAMPLES_MOST)
        return words_refuse(w, "%d samples of light at every pixel are too many: at most %d",
                            samples(&s->lighting), SAMPLES_MOST);
    studio_solid(s, (enum studio_model)model, fineness);
    if (s->mesh.triangles == 0)
        return words_refuse(w, "the object has more than %d triangles", MESH_TRIANGLES);
    if (m->stage.canvas.width == 0)
        return words_refuse(w, "this board has no raster head to draw on");
    stage_begin(&m->stage);
    stage_title(&m->stage, shading_names[shading]);
    struct studio_cost cost = studio_shade(s, &m->stage, &pose, (enum shading)shading, RAMP_COPPER);
    stage_heads(&m->stage, STAGE_VECTOR);
    studio_wires(s, &m->stage, &pose);
    stage_heads(&m->stage, STAGE_BOTH);
    stage_caption(&m->stage, captions[shading]);
    stage_end(&m->stage);
    print_cost(&cost);
    return true;
}
