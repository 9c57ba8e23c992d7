#include "emu/expose.h"

#include <assert.h>
#include <stdlib.h>

/* ---- shots --------------------------------------------------------------------------------------
 */

bool vm_shots_init(struct vm_shots *shots, uint64_t count, struct crt_error *err)
{
    *shots = (struct vm_shots){malloc((size_t)count * sizeof *shots->shot), count};
    return shots->shot ||
           crt_fail(err, "not enough memory for %llu pictures", (unsigned long long)count);
}

void vm_shots_free(struct vm_shots *shots)
{
    free(shots->shot);
    *shots = (struct vm_shots){NULL, 0};
}

void vm_shots_at_rate(struct vm_shots *shots, uint64_t from, struct crt_rate fps)
{
    for (uint64_t n = 0; n < shots->count; n++) {
        uint64_t at = n ? from + crt_tick_time(fps, n) : from;
        shots->shot[n] = (struct vm_shot){at, at};
    }
}

uint64_t vm_shots_chosen(uint64_t n, uint64_t count, uint64_t most)
{
    return count <= most ? n : most > 1 ? n * (count - 1) / (most - 1) : 0;
}

void vm_shots_choose(struct vm_shots *shots, uint64_t most)
{
    if (shots->count <= most)
        return;
    for (uint64_t n = 0; n < most; n++)
        shots->shot[n] = shots->shot[vm_shots_chosen(n, shots->count, most)];
    shots->count = most;
}

static uint64_t opening(const struct vm_shot *shot, uint64_t exposure)
{
    if (exposure == 0)
        return shot->begin;
    return shot->at > exposure ? shot->at - exposure : 0;
}

uint64_t vm_shots_overlap(const struct vm_shots *s, uint64_t exposure)
{
    uint64_t most = 1, opened = 0;
    for (uint64_t n = 0; n < s->count; n++) {
        while (opened < s->count &&
               (opened <= n || opening(&s->shot[opened], exposure) < s->shot[n].at))
            opened++;
        most = opened - n > most ? opened - n : most;
    }
    return most;
}

/* ---- one side -----------------------------------------------------------------------------------
 */

/* The frames of a side that are open, and the one that is handed out, each at its number modulo `room`. */
struct ring {
    const struct vm_exposed *side;
    struct vm_frame frame[VM_OVERLAP_MAX];
    uint64_t room, ready, opened;
};

static bool init_ring(struct ring *r, const struct vm_exposed *side, const struct vm_shots *shots,
                      struct crt_error *err)
{
    r->side = side;
    r->room = vm_shots_overlap(shots, side->exposure);
    if (r->room > VM_OVERLAP_MAX)
        return crt_fail(err, "the exposure overlaps more than %d pictures; shorten it",
                        VM_OVERLAP_MAX);
    while (r->ready < r->room) {
        if (!vm_frame_init(&r->frame[r->ready], side->rig, err))
            return false;
        r->ready++;
    }
    return true;
}

static void free_ring(struct ring *r)
{
    while (r->ready > 0)
        vm_frame_free(&r->frame[--r->ready]);
}

/* Opens the next frame, or clears it when its instant is power-on and there is nothing to gather. */
static void open_next(struct ring *r, const struct vm_shots *s, struct vm_progress *progress)
{
    const struct vm_shot *shot = &s->shot[r->opened];
    struct vm_frame *frame = &r->frame[r->opened++ % r->room];
    uint64_t from = opening(shot, r->side->exposure);
    vm_progress_run(progress, r->side->rig->machine, from);
    if (shot->at > from)
        vm_frame_open(frame, r->side->rig, from, shot->at);
    else
        vm_frame_clear(frame);
}

/* To the instant of shot n, which is complete then. */
static const struct vm_frame *run_to_shot(struct ring *r, const struct vm_shots *s, uint64_t n,
                                          struct vm_progress *progress)
{
    uint64_t t = s->shot[n].at;
    while (r->opened < s->count &&
           (r->opened <= n || opening(&s->shot[r->opened], r->side->exposure) < t))
        open_next(r, s, progress);
    vm_progress_run(progress, r->side->rig->machine, t);
    return &r->frame[n % r->room];
}

static void cancel_after(struct ring *r, uint64_t n)
{
    for (uint64_t k = n + 1; k < r->opened; k++)
        vm_frame_cancel(&r->frame[k % r->room], r->side->rig);
}

/* ---- all ----------------------------------------------------------------------------------------
 */

static bool expose_all(struct ring *ring, int count, const struct vm_shots *s,
                       struct vm_progress *progress, vm_frame_sink sink, void *ctx,
                       struct crt_error *err)
{
    for (uint64_t n = 0; n < s->count; n++) {
        const struct vm_frame *frame[VM_SIDES] = {NULL};
        for (int i = 0; i < count; i++)
            frame[i] = run_to_shot(&ring[i], s, n, progress);
        if (!sink(ctx, frame, n, err)) {
            for (int i = 0; i < count; i++)
                cancel_after(&ring[i], n);
            return false;
        }
    }
    return true;
}

bool vm_expose(const struct vm_exposed *sides, int count, const struct vm_shots *shots,
               struct vm_progress *progress, vm_frame_sink sink, void *ctx, struct crt_error *err)
{
    struct ring *ring = calloc((size_t)count, sizeof *ring);
    bool ok = ring || crt_fail(err, "not enough memory for the pictures; close other programs");
    assert(count <= VM_SIDES);
    for (int i = 0; ok && i < count; i++)
        ok = init_ring(&ring[i], &sides[i], shots, err);
    ok = ok && expose_all(ring, count, shots, progress, sink, ctx, err);
    for (int i = 0; ring && i < count; i++)
        free_ring(&ring[i]);
    free(ring);
    return ok;
}
