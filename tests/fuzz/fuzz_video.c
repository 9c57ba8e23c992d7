/* fuzz_video.c — feeds the raster head register writes, time and snapshots.
 *
 * Input:      byte 0   1 three guns, 2 a border, 4 a narrow monitor, 8 interlaced at power-on
 *             then steps: a byte that says what (below), and what it needs:
 *               0–15   write a register: offset / 4, value (4 bytes)
 *               16     write the look-up table: entry, value (4 bytes)
 *               17–19  time passes: 2 bytes, in ns, us, 16 us
 *               20     save, load into another head, compare, go on with that
 *               21     save, change bytes of it: count, then place (2 bytes) and value each; load
 *               22     load the rest of the input as a snapshot; the last step
 *               23     power-on
 *               24     what of the machine's start: sync on, a timing of the table loaded (1 byte)
 * Checks:     lines in order, not overlapping, of possible size, not before their event; events move on;
 *             the beam within its counts; wires called on changes only; a head that was refused bytes
 *             works.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "raster/head.h"

#define MAX_EVENTS 400u /* in all: an input may ask for hours */

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #condition);                \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

struct watch {
    struct ras_head *head;
    uint64_t now, last_t1;
    bool level[RAS_INT_COUNT];
    unsigned events;
    unsigned long sum; /* of drives, so that they are looked at */
};

static uint8_t buffer[VIDEO_BUFFER_BYTES];

static void see_line(void *ctx, const struct crt_scan_line *l)
{
    struct watch *w = ctx;
    CHECK(l->t0 >= w->now && l->t0 >= w->last_t1 && l->t1 > l->t0);
    CHECK(l->dots > 0 && l->dots <= CRT_MAX_DOTS && l->guns == w->head->desc.guns);
    CHECK(l->x1 > l->x0 && l->y0 == l->y1 && l->x0 >= -200 && l->x1 <= 200);
    CHECK(l->y0 >= -150 && l->y0 <= 150);
    for (int g = 0; g < l->guns; g++)
        w->sum += (unsigned long)l->drive[g][0] + l->drive[g][l->dots - 1];
    w->last_t1 = l->t1;
}

static void see_interrupt(void *ctx, enum ras_interrupt which, bool level, uint64_t t)
{
    struct watch *w = ctx;
    CHECK(level != w->level[which] && t == w->now);
    w->level[which] = level;
}

static void see_retime(void *ctx, struct crt_rate field, uint64_t origin)
{
    struct watch *w = ctx;
    CHECK(origin == w->now && field.num > 0 && field.den > 0);
    CHECK(field.num <= 1000 * field.den);
}

static void check_now(const struct watch *w)
{
    uint32_t line, dot, value;
    const struct ras_timing *t = &w->head->timing;
    if (ras_head_beam(w->head, w->now, &line, &dot))
        CHECK(line < t->v.total && dot < t->h.total);
    CHECK(ras_head_next(w->head) >= w->now);
    for (uint32_t offset = 0; offset <= VIDEO_LOAD; offset += 4)
        ras_head_read(w->head, offset, w->now, &value);
    for (int i = 0; i < RAS_INT_COUNT; i++)
        CHECK(w->level[i] == ras_head_interrupt(w->head, (enum ras_interrupt)i));
}

static void pass(struct watch *w, uint64_t ps)
{
    uint64_t until = w->now + ps;
    while (ras_head_next(w->head) <= until) {
        if (w->events++ == MAX_EVENTS)
            return;
        CHECK(ras_head_next(w->head) >= w->now);
        w->now = ras_head_next(w->head);
        ras_head_event(w->head, w->now);
        CHECK(ras_head_next(w->head) > w->now);
    }
    w->now = until;
    check_now(w);
}

static void connect(struct watch *w, struct ras_head *head, unsigned settings)
{
    struct ras_head_desc desc = {
        .buffer = buffer,
        .width_mm = 320,
        .height_mm = 240,
        .border_mm = settings & 2 ? 20 : 0,
        .guns = settings & 1 ? 3 : 1,
        .monitor = {0, 2000, 0, 2000, 2000},
        .timing = {.clock = {25175000, 1},
                   .h = {640, 656, 752, 800},
                   .v = {480, 490, 492, 525},
                   .interlaced = (settings & 8) != 0},
        .wires = {w, see_line, see_interrupt, see_retime, NULL},
    };
    if (settings & 4)
        desc.monitor = (struct ras_monitor){15, 40, 40, 130, 60};
    w->head = head;
    ras_head_init(head, &desc);
}

/* A caller refuses a head whose next event is over, and knows the wires. */
static void load(struct watch *w, const uint8_t *bytes, size_t size)
{
    struct crt_state s;
    crt_state_load(&s, bytes, size);
    ras_head_state(w->head, &s);
    w->last_t1 = 0;
    for (int i = 0; i < RAS_INT_COUNT; i++)
        w->level[i] = ras_head_interrupt(w->head, (enum ras_interrupt)i);
    if (ras_head_next(w->head) < w->now)
        ras_head_reset(w->head, w->now);
    check_now(w);
}

static struct crt_state save(struct watch *w)
{
    struct crt_state s;
    crt_state_save(&s);
    ras_head_state(w->head, &s);
    CHECK(!s.failed);
    return s;
}

static void reload(struct watch *w, struct ras_head *other)
{
    struct crt_state s = save(w);
    uint64_t next = ras_head_next(w->head), last_t1 = w->last_t1;
    *other = *w->head;
    memset(other->dots, 0, sizeof other->dots);
    w->head = other;
    load(w, s.out, s.size);
    w->last_t1 = last_t1;
    CHECK(ras_head_next(w->head) == next);
    struct crt_state again = save(w);
    CHECK(again.size == s.size && memcmp(again.out, s.out, s.size) == 0);
    crt_state_free(&again);
    crt_state_free(&s);
}

static void begin(struct watch *w, unsigned n)
{
    size_t count;
    const struct ras_timing *t = &ras_modes(&count)[n % 31].timing;
    struct ras_head *h = w->head;
    const uint32_t values[] = {
        t->h.visible,  t->h.sync_start, t->h.sync_end,
        t->h.total,    t->v.visible,    t->v.sync_start,
        t->v.sync_end, t->v.total,      t->interlaced ? VIDEO_SYNC_INTERLACED : 0};
    ras_head_write(h, VIDEO_CLOCK, (uint32_t)t->clock.num, w->now);
    for (uint32_t i = 0; i < 9; i++)
        ras_head_write(h, VIDEO_H_VISIBLE + 4 * i, values[i], w->now);
    ras_head_write(h, VIDEO_LOAD, 1, w->now);
    ras_head_write(h, VIDEO_CONTROL, VIDEO_CONTROL_ON, w->now);
    CHECK(h->on);
}

/* The input, read from its front; zeros when it is over. */
struct input {
    const uint8_t *at;
    size_t left;
};

static uint32_t take(struct input *in, unsigned bytes)
{
    uint32_t v = 0;
    for (unsigned i = 0; i < bytes && in->left > 0; i++, in->left--)
        v |= (uint32_t)*in->at++ << 8 * i;
    return v;
}

static void damage(struct watch *w, struct input *in)
{
    struct crt_state s = save(w);
    for (uint32_t n = take(in, 1) % 8; n > 0; n--) {
        uint32_t place = take(in, 2);
        s.out[place % s.size] = (uint8_t)take(in, 1);
    }
    load(w, s.out, s.size);
    crt_state_free(&s);
}

static void step(struct watch *w, struct ras_head *other, struct input *in)
{
    static const uint64_t units[] = {1000, CRT_PS_PER_US, 16 * CRT_PS_PER_US};
    uint32_t what = take(in, 1) % 32, n;
    if (what < 16) {
        n = take(in, 1);
        ras_head_write(w->head, 4 * (n % 28), take(in, 4), w->now);
    } else if (what == 16) {
        n = take(in, 1);
        ras_head_lut_write(w->head, n, take(in, 4));
    } else if (what <= 19) {
        pass(w, take(in, 2) * units[what - 17]);
    } else if (what == 20) {
        reload(w, other);
    } else if (what == 21) {
        damage(w, in);
    } else if (what == 22) {
        load(w, in->at, in->left);
        in->left = 0;
    } else if (what == 23) {
        ras_head_reset(w->head, w->now);
    } else if (what == 24) {
        begin(w, take(in, 1));
    } else {
        pass(w, (what - 24) * 100 * CRT_PS_PER_US);
    }
    check_now(w);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct ras_head heads[2];
    struct watch w = {.now = 0};
    struct input in = {data, size};
    connect(&w, &heads[0], take(&in, 1));
    while (in.left > 0 && w.events < MAX_EVENTS)
        step(&w, w.head == &heads[0] ? &heads[1] : &heads[0], &in);
    pass(&w, CRT_PS_PER_MS);
    return 0;
}
