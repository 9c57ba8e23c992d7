#include "emu/calm.h"

#include <math.h>
#include <stdlib.h>

struct vm_calm {
    struct vm_frame shown;                      /* light: mean cd/m² times the exposure */
    float *stage[2][VM_HEADS][CRT_MAX_COLOURS]; /* cd/m² */
};

static size_t cells_of(const struct crt_film *film)
{
    return (size_t)film->grid.cols * (size_t)film->grid.rows;
}

struct vm_calm *vm_calm_create(const struct vm_rig *rig, struct crt_error *err)
{
    struct vm_calm *calm = calloc(1, sizeof *calm);
    bool ok = calm && vm_frame_init(&calm->shown, rig, err);
    for (int stage = 0; ok && stage < 2; stage++)
        for (int h = 0; ok && h < VM_HEADS; h++)
            for (int c = 0; ok && (calm->shown.heads >> h & 1) && c < calm->shown.film[h].colours;
                 c++) {
                calm->stage[stage][h][c] = calloc(cells_of(&calm->shown.film[h]), sizeof(float));
                ok = calm->stage[stage][h][c] != NULL;
            }
    if (ok)
        return calm;
    vm_calm_destroy(calm);
    crt_fail(err, "not enough memory for a picture without flashes");
    return NULL;
}

void vm_calm_destroy(struct vm_calm *calm)
{
    if (!calm)
        return;
    for (int stage = 0; stage < 2; stage++)
        for (int h = 0; h < VM_HEADS; h++)
            for (int c = 0; c < CRT_MAX_COLOURS; c++)
                free(calm->stage[stage][h][c]);
    vm_frame_free(&calm->shown);
    free(calm);
}

/* Both filters' exact response to a light that is steady for the time that enters `share`; the second takes
 * the first's new value. */
static void pass(float *first, float *second, float *shown, const float *light, size_t cells,
                 float share, double exposure_s)
{
    float per_s = (float)(1 / exposure_s), s = (float)exposure_s;
    for (size_t i = 0; i < cells; i++) {
        first[i] += share * (light[i] * per_s - first[i]);
        second[i] += share * (first[i] - second[i]);
        shown[i] = second[i] * s;
    }
}

const struct vm_frame *vm_calm_show(struct vm_calm *calm, const struct vm_frame *frame,
                                    double seconds)
{
    float share = (float)(1 - exp(-fmax(seconds, 0) / VM_CALM_S));
    calm->shown.t0 = frame->t0;
    calm->shown.t1 = frame->t1;
    for (int h = 0; h < VM_HEADS; h++) {
        struct crt_film *film = &calm->shown.film[h];
        const struct crt_film *from = &frame->film[h];
        if (!(calm->shown.heads >> h & 1) || !from->complete)
            continue;
        film->t0 = from->t0;
        film->t1 = from->t1;
        film->complete = true;
        for (int c = 0; c < film->colours; c++)
            pass(calm->stage[0][h][c], calm->stage[1][h][c], film->light[c], from->light[c],
                 cells_of(film), share, (double)(from->t1 - from->t0) / (double)CRT_PS_PER_S);
    }
    return &calm->shown;
}
