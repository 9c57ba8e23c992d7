#include "emu/sliding.h"

#include <stdlib.h>
#include <string.h>

#define BLOCKS_MAX 64
#define BLOCKS_MIN 4
#define BUDGET     ((size_t)256 << 20)

struct vm_sliding {
    const struct vm_rig *rig;
    struct vm_frame block[BLOCKS_MAX]; /* a ring of frames put together; heads 0: not allocated */
    size_t first, count, room;
    double *total[VM_HEADS][CRT_MAX_COLOURS];
};

static size_t cells_of(const struct crt_film *film)
{
    return (size_t)film->grid.cols * (size_t)film->grid.rows;
}

/* ---- making --------------------------------------------------------------------------------------
 */

static bool make_totals(struct vm_sliding *s, const struct vm_frame *like)
{
    size_t bytes = 0;
    for (int h = 0; h < VM_HEADS; h++)
        for (int c = 0; (like->heads >> h & 1) && c < like->film[h].colours; c++) {
            size_t cells = cells_of(&like->film[h]);
            s->total[h][c] = calloc(cells, sizeof(double));
            if (!s->total[h][c])
                return false;
            bytes += cells * sizeof(float);
        }
    size_t room = bytes > 0 ? BUDGET / bytes : BLOCKS_MAX;
    s->room = room < BLOCKS_MIN ? BLOCKS_MIN : room > BLOCKS_MAX ? BLOCKS_MAX : room;
    return true;
}

struct vm_sliding *vm_sliding_create(const struct vm_rig *rig, struct crt_error *err)
{
    struct vm_sliding *s = calloc(1, sizeof *s);
    if (s) {
        s->rig = rig;
        if (vm_frame_init(&s->block[0], rig, err) && make_totals(s, &s->block[0]))
            return s;
    }
    vm_sliding_destroy(s);
    crt_fail(err, "not enough memory for a long exposure; choose a shorter shutter");
    return NULL;
}

void vm_sliding_destroy(struct vm_sliding *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < BLOCKS_MAX; i++)
        vm_frame_free(&s->block[i]);
    for (int h = 0; h < VM_HEADS; h++)
        for (int c = 0; c < CRT_MAX_COLOURS; c++)
            free(s->total[h][c]);
    free(s);
}

/* ---- sums ----------------------------------------------------------------------------------------
 */

static struct vm_frame *at(struct vm_sliding *s, size_t i)
{
    return &s->block[(s->first + i) % s->room];
}

/* Does something to each colour of each film. */
typedef void (*film_work)(double *total, float *light, const float *frame, size_t cells);

static void put(double *total, float *light, const float *frame, size_t cells)
{
    memcpy(light, frame, cells * sizeof *light);
    for (size_t i = 0; i < cells; i++)
        total[i] += (double)frame[i];
}

/* The total stays that of what the blocks hold, rounded as they are. */
static void join(double *total, float *light, const float *frame, size_t cells)
{
    for (size_t i = 0; i < cells; i++) {
        float more = light[i] + frame[i];
        total[i] += (double)more - (double)light[i];
        light[i] = more;
    }
}

static void take(double *total, float *light, const float *frame, size_t cells)
{
    (void)frame;
    for (size_t i = 0; i < cells; i++)
        total[i] -= (double)light[i];
}

static void show(double *total, float *light, const float *frame, size_t cells)
{
    (void)frame;
    for (size_t i = 0; i < cells; i++)
        light[i] = total[i] > 0 ? (float)total[i] : 0;
}

static void each(struct vm_sliding *s, film_work work, struct vm_frame *block,
                 const struct vm_frame *frame)
{
    for (int h = 0; h < VM_HEADS; h++)
        for (int c = 0; (block->heads >> h & 1) && c < block->film[h].colours; c++)
            work(s->total[h][c], block->film[h].light[c], frame->film[h].light[c],
                 cells_of(&block->film[h]));
}

static void forget(struct vm_sliding *s)
{
    const struct vm_frame *like = &s->block[0];
    s->count = 0;
    for (int h = 0; h < VM_HEADS; h++)
        for (int c = 0; c < CRT_MAX_COLOURS; c++)
            if (s->total[h][c])
                memset(s->total[h][c], 0, cells_of(&like->film[h]) * sizeof(double));
}

static uint64_t apart(uint64_t a, uint64_t b)
{
    return a > b ? a - b : b - a;
}

static void drop_first(struct vm_sliding *s)
{
    each(s, take, at(s, 0), at(s, 0));
    s->first = (s->first + 1) % s->room;
    s->count--;
}

static bool append(struct vm_sliding *s, const struct vm_frame *frame, struct crt_error *err)
{
    if (s->count == s->room)
        drop_first(s);
    struct vm_frame *block = at(s, s->count);
    if (!block->heads && !vm_frame_init(block, s->rig, err)) {
        forget(s);
        return false;
    }
    s->count++;
    block->t0 = frame->t0;
    block->t1 = frame->t1;
    each(s, put, block, frame);
    return true;
}

/* As near to the shutter as it comes by whole blocks. */
static void cut(struct vm_sliding *s, uint64_t t1, uint64_t shutter)
{
    while (s->count > 1 && apart(t1 - at(s, 1)->t0, shutter) <= apart(t1 - at(s, 0)->t0, shutter))
        drop_first(s);
}

static void tell(struct vm_sliding *s, struct vm_frame *sum)
{
    sum->t0 = at(s, 0)->t0;
    sum->t1 = at(s, s->count - 1)->t1;
    for (int h = 0; h < VM_HEADS; h++) {
        sum->film[h].t0 = sum->t0;
        sum->film[h].t1 = sum->t1;
        sum->film[h].complete = true;
    }
    each(s, show, sum, sum);
}

bool vm_sliding_add(struct vm_sliding *s, const struct vm_frame *frame, uint64_t shutter,
                    struct vm_frame *sum, struct crt_error *err)
{
    struct vm_frame *last = s->count ? at(s, s->count - 1) : NULL;
    if (last && last->t1 != frame->t0) {
        forget(s);
        last = NULL;
    }
    if (last && last->t1 - last->t0 < shutter / (s->room - 2)) {
        each(s, join, last, frame);
        last->t1 = frame->t1;
    } else if (!append(s, frame, err)) {
        return false;
    }
    cut(s, frame->t1, shutter);
    tell(s, sum);
    return true;
}
