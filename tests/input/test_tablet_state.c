/* A tablet saved at any instant and loaded into another goes on alike; bytes that were changed are refused or
 * make a tablet that works. */
#include "tests/input/tablet_rig.h"

static void mix(uint64_t *h, uint64_t v)
{
    *h = (*h ^ v) * UINT64_C(0x100000001b3);
    *h ^= *h >> 29;
}

static uint64_t all_registers(const struct tablet_rig *r)
{
    uint64_t h = 1;
    for (uint32_t offset = INPUT_TABLET_KIND; offset < 0x260; offset += 4) {
        uint32_t value;
        if (inp_tablet_read(&r->tablet, offset, &value))
            mix(&h, value);
    }
    mix(&h, inp_tablet_next(&r->tablet));
    mix(&h, inp_tablet_ready(&r->tablet));
    return h;
}

/* A hand and a program that do anything, until some time later. */
static uint64_t go(struct tablet_rig *r, int turns)
{
    uint64_t h = 7;
    for (int i = 0; i < turns; i++) {
        uint64_t until = r->now + rig_bits(r) % (40 * CRT_PS_PER_MS);
        while (inp_tablet_next(&r->tablet) <= until) {
            assert_true(inp_tablet_next(&r->tablet) >= r->now);
            r->now = inp_tablet_next(&r->tablet);
            mix(&h, inp_tablet_event(&r->tablet, r->now));
            mix(&h, all_registers(r));
        }
        r->now = until;
        uint32_t value = (uint32_t)(rig_bits(r) >> 30);
        switch (rig_bits(r) >> 40 & 15) {
        case 0:
            rig_act(r, INP_AWAY, 0);
            break;
        case 1:
            rig_act(r, INP_PRESS, value % 5);
            break;
        case 2:
            rig_act(r, INP_RELEASE, value % 5);
            break;
        case 3:
            rig_write(r, INPUT_TABLET_CONTROL, value % 8 ? value | TABLET_ON : value);
            break;
        case 4:
            rig_write(r, INPUT_TABLET_STATUS, TABLET_LOST);
            break;
        case 5:
        case 6:
        case 7:
            rig_write(r, INPUT_TABLET_STATUS, TABLET_REPORT);
            break;
        default:
            rig_move(r, rig_between(r, -20, 300), rig_between(r, -20, 300), rig_between(r, -5, 20),
                     value % 3 ? rig_bits(r) % (90 * CRT_PS_PER_MS) : 0);
        }
        mix(&h, all_registers(r));
    }
    return h;
}

static struct crt_state save(struct tablet_rig *r)
{
    struct crt_state s;
    crt_state_save(&s);
    inp_tablet_state(&r->tablet, &s);
    if (s.failed)
        fail_msg("%s", s.err.text);
    return s;
}

static bool load(struct tablet_rig *r, const uint8_t *bytes, size_t size)
{
    struct crt_state s;
    crt_state_load(&s, bytes, size);
    inp_tablet_state(&r->tablet, &s);
    return !s.failed;
}

static void open_any(struct tablet_rig *r, int i)
{
    rig_open(r, 1 + (unsigned)i % 3);
    r->setup.buttons.value = 1 + i % 4;
    r->seed += (uint64_t)i * 15485863;
}

static void goes_on_alike(void **state)
{
    (void)state;
    unsigned on = 0, ready = 0, moving = 0, sensed = 0, lost = 0;
    for (int i = 0; i < 24; i++) {
        struct tablet_rig one, two;
        open_any(&one, i);
        rig_on(&one, 0);
        for (int n = 0; n < 40; n++) {
            (void)go(&one, 5);
            struct crt_state saved = save(&one);
            open_any(&two, i);
            (void)go(&two, 13); /* whatever it held before */
            assert_true(load(&two, saved.out, saved.size));
            two.now = one.now;
            two.seed = one.seed;
            struct crt_state again = save(&two);
            assert_int_equal(saved.size, again.size);
            assert_memory_equal(saved.out, again.out, saved.size);
            on += one.tablet.control & TABLET_ON;
            ready += inp_tablet_ready(&one.tablet);
            moving += one.tablet.hand.there && one.tablet.hand.t1 > one.now;
            sensed += one.tablet.sensed;
            lost += (one.tablet.status & TABLET_LOST) != 0;
            assert_true(go(&one, 20) == go(&two, 20));
            crt_state_free(&saved);
            crt_state_free(&again);
        }
    }
    assert_true(on > 400 && ready > 200 && moving > 200 && sensed > 100 && lost > 100);
}

/* Any byte anything, in turn; then several at once. What loads works as long as one cares to look, and
 * can be saved. */
static void hostile_bytes(void **state)
{
    (void)state;
    unsigned loaded = 0, refused = 0;
    for (int i = 0; i < 6; i++) {
        struct tablet_rig one, two;
        open_any(&one, i);
        rig_on(&one, 0);
        (void)go(&one, 60);
        struct crt_state saved = save(&one);
        for (size_t n = 0; n < 12 * saved.size; n++) {
            uint8_t bytes[1024];
            assert_true(saved.size <= sizeof bytes);
            memcpy(bytes, saved.out, saved.size);
            static const uint8_t odd[] = {0, 1, 2, 0x7F, 0x80, 0xFF, 0xF0, 0x43};
            bytes[n % saved.size] =
                n / saved.size < 8 ? odd[n / saved.size] : (uint8_t)rig_bits(&one);
            for (int more = 0; more < (n / saved.size < 9 ? 0 : 7); more++)
                bytes[16 + rig_bits(&one) % (saved.size - 16)] = (uint8_t)(rig_bits(&one) >> 20);
            open_any(&two, i);
            bool fine = load(&two, bytes, saved.size);
            loaded += fine;
            refused += !fine;
            two.now = 0; /* refused, too, it is a tablet */
            for (int k = 0; k < 3 && inp_tablet_next(&two.tablet) != UINT64_MAX; k++) {
                uint64_t next = inp_tablet_next(&two.tablet);
                assert_true(next >= two.tablet.origin && next < CRT_STATE_LATEST + CRT_PS_PER_S);
                inp_tablet_event(&two.tablet, next);
                assert_true(inp_tablet_next(&two.tablet) > next);
                assert_true(rig_read(&two, INPUT_TABLET_PROXIMITY) <= TABLET_TOUCH);
                assert_true(rig_read(&two, INPUT_TABLET_BUTTONS) <= 15);
            }
            open_any(&two, i);
            if (fine && load(&two, bytes, saved.size)) {
                struct crt_state again = save(&two);
                assert_memory_equal(again.out, bytes, saved.size);
                crt_state_free(&again);
            }
        }
        for (size_t size = 0; size < saved.size; size++)
            assert_false(load(&two, saved.out, size));
        crt_state_free(&saved);
    }
    assert_true(loaded > 1000 && refused > 1000);
}

/* Times that leave no room, buttons that the tablet has not: neither saved nor loaded. */
static void impossible_is_refused(void **state)
{
    (void)state;
    for (int i = 0; i < 9; i++) {
        struct tablet_rig one;
        open_any(&one, 0);
        rig_on(&one, 0);
        struct crt_state s;
        struct inp_tablet *t = &one.tablet;
        switch (i) {
        case 0:
            t->origin = CRT_STATE_LATEST;
            break;
        case 1:
            t->measured = UINT64_MAX;
            break;
        case 2:
            t->origin = t->measured = UINT64_C(1) << 62;
            break;
        case 3:
            t->buttons = 2;
            break;
        case 4:
            t->status = 4;
            break;
        case 5:
            t->control = 8;
            break;
        case 6:
            t->report.proximity = 3;
            break;
        case 7:
            t->hand.to.z = (double)NAN;
            break;
        case 8:
            t->measured = 1106804645; /* reports till 2^64 ps: their time begins at 0 again */
            break;
        }
        crt_state_save(&s);
        inp_tablet_state(&one.tablet, &s);
        assert_true(s.failed);
        crt_state_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on_alike),
        cmocka_unit_test(hostile_bytes),
        cmocka_unit_test(impossible_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
