#include "emu/frame.h"

#include <string.h>

static bool has(const struct vm_frame *f, int head)
{
    return f->heads >> head & 1;
}

bool vm_frame_init(struct vm_frame *f, const struct vm_rig *rig, struct crt_error *err)
{
    *f = (struct vm_frame){0};
    for (int h = 0; h < VM_HEADS; h++) {
        if (!rig->tube[h])
            continue;
        if (!crt_film_init(&f->film[h], rig->tube[h], err)) {
            vm_frame_free(f);
            return false;
        }
        f->heads |= 1u << h;
    }
    return true;
}

void vm_frame_free(struct vm_frame *f)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (has(f, h))
            crt_film_free(&f->film[h]);
    f->heads = 0;
}

void vm_frame_open(struct vm_frame *f, const struct vm_rig *rig, uint64_t t0, uint64_t t1)
{
    f->t0 = t0;
    f->t1 = t1;
    for (int h = 0; h < VM_HEADS; h++)
        if (has(f, h))
            crt_film_open(rig->tube[h], &f->film[h], t0, t1);
}

bool vm_frame_complete(const struct vm_frame *f)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (has(f, h) && !f->film[h].complete)
            return false;
    return true;
}

bool vm_frame_end(struct vm_frame *f, const struct vm_rig *rig)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (has(f, h) && !f->film[h].complete && !crt_film_end(rig->tube[h], &f->film[h]))
            return false;
    for (int h = 0; h < VM_HEADS; h++)
        if (has(f, h))
            f->t1 = f->film[h].t1;
    return true;
}

void vm_frame_cancel(struct vm_frame *f, const struct vm_rig *rig)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (has(f, h) && !f->film[h].complete)
            crt_film_cancel(rig->tube[h], &f->film[h]);
}

void vm_frame_clear(struct vm_frame *f)
{
    f->t0 = 0;
    f->t1 = 1;
    for (int h = 0; h < VM_HEADS; h++) {
        struct crt_film *film = &f->film[h];
        if (!has(f, h))
            continue;
        size_t cells = (size_t)film->grid.cols * (size_t)film->grid.rows;
        for (int c = 0; c < film->colours; c++)
            memset(film->light[c], 0, cells * sizeof(float));
        film->t0 = 0;
        film->t1 = 1;
        film->complete = true;
    }
}
