/* A raster head saved at any instant and loaded into another goes on alike; bytes that were changed are
 * refused or make a head that works. */
#include "tests/raster/head_rig.h"

struct walker {
    struct head_rig *r;
    uint64_t seed, now, seen; /* seen: hash of what came out */
};

static void mix(uint64_t *h, uint64_t v)
{
    *h = (*h ^ v) * UINT64_C(0x100000001b3);
    *h ^= *h >> 29;
}

static void hash_line(void *ctx, const struct crt_scan_line *l)
{
    struct walker *w = ctx;
    uint32_t bits[4];
    memcpy(bits, &l->x0, sizeof bits);
    mix(&w->seen, l->t0);
    mix(&w->seen, l->t1);
    for (int i = 0; i < 4; i++)
        mix(&w->seen, bits[i]);
    for (int g = 0; g < l->guns; g++)
        for (int x = 0; x < l->dots; x++)
            mix(&w->seen, l->drive[g][x]);
    assert_true(l->t0 >= w->now && l->t1 > l->t0);
}

static void hash_irq(void *ctx, enum ras_interrupt which, bool level, uint64_t t)
{
    mix(&((struct walker *)ctx)->seen, t * 4 + (unsigned)which * 2 + level);
}

static void hash_retime(void *ctx, struct crt_rate field, uint64_t origin)
{
    struct walker *w = ctx;
    mix(&w->seen, field.num);
    mix(&w->seen, field.den);
    mix(&w->seen, origin);
}

static struct walker open_walker(uint64_t seed, uint8_t *buffer)
{
    struct ras_timing t = RIG_SMALL;
    struct walker w = {.r = rig_open(&t, seed % 2 ? 3 : 1, seed % 3 ? 45 : 0), .seed = seed};
    if (buffer) {
        free(w.r->buffer);
        w.r->buffer = w.r->head.desc.buffer = buffer;
    }
    return w;
}

static void attach(struct walker *w)
{
    w->r->head.desc.wires = (struct ras_wires){w, hash_line, hash_irq, hash_retime, NULL};
}

static void write_at_random(struct walker *w, uint32_t offset, uint32_t value)
{
    assert_true(ras_head_write(&w->r->head, offset, value, w->now));
}

/* Some time passes, then something is written or looked at. */
static void go(struct walker *w)
{
    struct ras_head *head = &w->r->head;
    uint64_t n = rig_random(&w->seed), until = w->now + n % (40 * CRT_PS_PER_US);
    while (ras_head_next(head) <= until) {
        assert_true(ras_head_next(head) >= w->now);
        w->now = ras_head_next(head);
        ras_head_event(head, w->now);
    }
    w->now = until;
    uint32_t value = (uint32_t)rig_random(&w->seed);
    static const uint32_t format[] = {1, 2, 4, 8, 16, 24, 32, 3};
    switch (n >> 40 & 31) {
    case 0:
        write_at_random(w, VIDEO_CONTROL, value % 8 ? 1 : value >> 8);
        break;
    case 1:
        write_at_random(w, VIDEO_BASE, value % 3 ? value % 4096 : value);
        break;
    case 2:
        write_at_random(w, VIDEO_PITCH, value % 3 ? value % 100 : value);
        break;
    case 3:
        write_at_random(w, VIDEO_FORMAT, format[value % 8]);
        break;
    case 4:
        write_at_random(w, VIDEO_LINE_COMPARE, value % 14);
        break;
    case 5:
        write_at_random(w, VIDEO_OVERSCAN, value % 2 ? value : 0);
        break;
    case 6:
        write_at_random(w, VIDEO_H_TOTAL, 24 + value % 4);
        break;
    case 7:
        write_at_random(w, VIDEO_SYNC, value);
        break;
    case 8:
        write_at_random(w, VIDEO_LOAD, value);
        break;
    case 9:
    case 10:
        write_at_random(w, VIDEO_STATUS, value);
        break;
    case 11:
        write_at_random(w, VIDEO_IRQ_ENABLE, value);
        break;
    case 12:
        ras_head_lut_write(head, value % 256, value >> 8);
        break;
    default:
        break;
    }
    for (uint32_t offset = 0; offset <= VIDEO_SYNC; offset += 4)
        if (ras_head_read(head, offset, w->now, &value))
            mix(&w->seen, value);
}

static struct crt_state save(struct walker *w)
{
    struct crt_state s;
    crt_state_save(&s);
    ras_head_state(&w->r->head, &s);
    if (s.failed)
        fail_msg("%s", s.err.text);
    return s;
}

static bool load(struct walker *w, const uint8_t *bytes, size_t size)
{
    struct crt_state s;
    crt_state_load(&s, bytes, size);
    ras_head_state(&w->r->head, &s);
    return !s.failed;
}

static void goes_on_alike(void **state)
{
    (void)state;
    unsigned on = 0, interlaced = 0, blank = 0, lit = 0;
    for (uint64_t seed = 1; seed <= 6; seed++) {
        struct walker one = open_walker(seed, NULL);
        attach(&one);
        uint64_t fill = seed;
        for (int i = 0; i < 8192; i++)
            one.r->buffer[i] = (uint8_t)rig_random(&fill);
        ras_head_write(&one.r->head, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
        for (int n = 0; n < 500; n++) {
            go(&one);
            struct crt_state saved = save(&one);
            struct walker two = open_walker(seed, one.r->buffer);
            attach(&two);
            assert_true(load(&two, saved.out, saved.size));
            two.seed = one.seed;
            two.now = one.now;
            two.seen = one.seen;
            struct crt_state again = save(&two);
            assert_int_equal(saved.size, again.size);
            assert_memory_equal(saved.out, again.out, saved.size);
            uint64_t later = one.now; /* the first goes on from here, too */
            for (int i = 0; i < 12; i++) {
                go(&one);
                go(&two);
            }
            assert_true(one.seen == two.seen && one.now == two.now && later < one.now);
            on += one.r->head.on;
            interlaced += one.r->head.timing.interlaced;
            blank += one.r->head.blank;
            lit += one.r->head.overscan != 0;
            two.r->buffer = NULL;
            crt_state_free(&saved);
            crt_state_free(&again);
            rig_close(two.r);
        }
        rig_close(one.r);
    }
    assert_true(on > 1000 && interlaced > 300 && blank > 30 && lit > 1000);
}

/* Whether a line looks at it or not, the bytes are the same. */
static void observing_changes_nothing(void **state)
{
    (void)state;
    struct walker one = open_walker(8, NULL), two = open_walker(8, one.r->buffer);
    attach(&one);
    two.r->head.desc.wires = (struct ras_wires){0};
    for (int n = 0; n < 3000; n++) {
        go(&one);
        go(&two);
        if (n % 50)
            continue;
        struct crt_state a = save(&one), b = save(&two);
        assert_memory_equal(a.out, b.out, a.size);
        crt_state_free(&a);
        crt_state_free(&b);
    }
    two.r->buffer = NULL;
    rig_close(two.r);
    rig_close(one.r);
}

/* ---- hostile bytes ---------------------------------------------------------------------------- */

static void see_sane_line(void *ctx, const struct crt_scan_line *l)
{
    struct walker *w = ctx;
    assert_true(l->t0 >= w->now && l->t1 > l->t0);
    assert_true(l->dots > 0 && l->dots <= CRT_MAX_DOTS);
    w->seen++;
}

/* Some frames of it, and a new timing. */
static void works(struct walker *w)
{
    struct ras_head *head = &w->r->head;
    uint32_t value;
    w->now = ras_head_next(head) == UINT64_MAX ? 0 : ras_head_next(head);
    for (int n = 0; n < 60 && ras_head_next(head) != UINT64_MAX; n++) {
        w->now = ras_head_next(head);
        ras_head_event(head, w->now);
        assert_true(ras_head_next(head) > w->now);
    }
    for (uint32_t offset = 0; offset <= VIDEO_LOAD; offset += 4)
        ras_head_read(head, offset, w->now, &value);
    ras_head_write(head, VIDEO_LOAD, 1, w->now);
    ras_head_write(head, VIDEO_CONTROL, VIDEO_CONTROL_ON, w->now);
    for (int n = 0; n < 30; n++) {
        w->now = ras_head_next(head);
        ras_head_event(head, w->now);
    }
}

static void changed_bytes(void **state)
{
    (void)state;
    struct walker one = open_walker(5, NULL), two = open_walker(5, one.r->buffer);
    attach(&one);
    two.r->head.desc.wires = (struct ras_wires){.ctx = &two, .line = see_sane_line};
    ras_head_write(&one.r->head, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    for (int n = 0; n < 20; n++)
        go(&one);
    ras_head_write(&one.r->head, VIDEO_CONTROL, VIDEO_CONTROL_ON, one.now);
    struct crt_state s = save(&one);
    int refused = 0, taken = 0;
    for (size_t i = 0; i < s.size; i++)
        for (unsigned bit = 1; bit < 256; bit *= 2) {
            s.out[i] ^= (uint8_t)bit;
            bool ok = load(&two, s.out, s.size);
            refused += !ok;
            taken += ok;
            works(&two);
            s.out[i] ^= (uint8_t)bit;
        }
    for (size_t size = 0; size < s.size; size++)
        assert_false(load(&two, s.out, size));
    assert_true(refused > 1000 && taken > 1000);
    assert_true(load(&two, s.out, s.size));
    crt_state_free(&s);
    two.r->buffer = NULL;
    rig_close(two.r);
    rig_close(one.r);
}

/* A next event must be one of the timing's, and the first that is due. */
static void next_event_is_checked(void **state)
{
    (void)state;
    struct walker w = open_walker(2, NULL);
    ras_head_write(&w.r->head, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    rig_run(w.r, CRT_PS_PER_MS);
    const struct ras_head good = w.r->head;
    for (int n = 0; n < 6; n++) {
        w.r->head = good;
        if (n < 3)
            w.r->head.next_dot += (uint64_t)n - 1; /* n = 1: as it was */
        else if (n < 5)
            w.r->head.next_kind = (good.next_kind + (unsigned)n - 2) % 3;
        else
            w.r->head.next_dot = UINT64_MAX / 2;
        struct crt_state s;
        crt_state_save(&s);
        ras_head_state(&w.r->head, &s);
        assert_int_equal(s.failed, n != 1);
        crt_state_free(&s);
    }
    rig_close(w.r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on_alike),
        cmocka_unit_test(observing_changes_nothing),
        cmocka_unit_test(changed_bytes),
        cmocka_unit_test(next_event_is_checked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
