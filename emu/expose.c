#include "emu/expose.h"

static uint64_t instant(const struct vm_shots *s, uint64_t n)
{
    return n ? s->from + crt_tick_time(s->fps, n) : s->from;
}

static uint64_t opening(const struct vm_shots *s, uint64_t n)
{
    uint64_t t = instant(s, n);
    return t > s->exposure ? t - s->exposure : 0;
}

uint64_t vm_shots_overlap(const struct vm_shots *s)
{
    uint64_t n = s->count > 1 ? crt_tick_at(s->fps, s->exposure) + 2 : 1;
    return n < s->count ? n : s->count;
}

/* Opens frame n, or clears it when its instant is power-on and there is nothing to gather. */
static void open_frame(struct vm_rig *rig, const struct vm_shots *s, struct vm_progress *progress,
                       uint64_t n, struct vm_frame *frame)
{
    uint64_t t0 = opening(s, n), t1 = instant(s, n);
    vm_progress_run(progress, rig->machine, t0);
    if (t1 > t0)
        vm_frame_open(frame, rig, t0, t1);
    else
        vm_frame_clear(frame);
}

static bool expose_all(struct vm_rig *rig, const struct vm_shots *s, struct vm_progress *progress,
                       struct vm_frame *ring, uint64_t room, vm_frame_sink sink, void *ctx,
                       struct crt_error *err)
{
    uint64_t opened = 0;
    for (uint64_t n = 0; n < s->count; n++) {
        uint64_t t = instant(s, n);
        while (opened < s->count && (opened <= n || opening(s, opened) < t)) {
            open_frame(rig, s, progress, opened, &ring[opened % room]);
            opened++;
        }
        vm_progress_run(progress, rig->machine, t);
        if (!sink(ctx, &ring[n % room], n, err)) {
            for (uint64_t k = n + 1; k < opened; k++)
                vm_frame_cancel(&ring[k % room], rig);
            return false;
        }
    }
    return true;
}

bool vm_expose(struct vm_rig *rig, const struct vm_shots *shots, struct vm_progress *progress,
               vm_frame_sink sink, void *ctx, struct crt_error *err)
{
    struct vm_frame ring[VM_OVERLAP_MAX];
    uint64_t room = vm_shots_overlap(shots), ready = 0;
    bool ok = true;
    if (room > VM_OVERLAP_MAX)
        return crt_fail(err, "the exposure overlaps more than %d frames; shorten it or lower --fps",
                        VM_OVERLAP_MAX);
    while (ready < room && (ok = vm_frame_init(&ring[ready], rig, err)))
        ready++;
    if (ok)
        ok = expose_all(rig, shots, progress, ring, room, sink, ctx, err);
    while (ready > 0)
        vm_frame_free(&ring[--ready]);
    return ok;
}
