/* A mouse saved at any instant and loaded into another goes on alike; bytes that were changed are refused or
 * make a mouse that works. */
#include <string.h>

#include "tests/input/mouse_rig.h"

#define MS CRT_PS_PER_MS
#define S  CRT_PS_PER_S

/* Something that a person or a program does, and what the program sees then. */
static uint64_t act_at_random(struct mouse_rig *r, uint64_t *row, uint64_t t)
{
    int32_t x = (int32_t)mouse_rig_roll(row, -40000, 40000);
    int32_t y = (int32_t)mouse_rig_roll(row, -40000, 40000);
    uint64_t way = (uint64_t)mouse_rig_roll(row, 0, 9e10);
    switch ((int)mouse_rig_roll(row, 0, 8)) {
    case 0:
        mouse_rig_act(r, INP_AWAY, 0, t);
        break;
    case 1:
    case 2:
        mouse_rig_act(r, INP_BACK, 0, t);
        break;
    case 3:
        mouse_rig_act(r, way % 2 ? INP_PRESS : INP_RELEASE, (unsigned)(way % 3), t);
        break;
    case 4:
        mouse_rig_clear(r, t);
        break;
    case 5:
        mouse_rig_move(r, t, 0, x, y);
        break;
    default:
        mouse_rig_move(r, t, way, x, y);
        break;
    }
    uint64_t hash = inp_mouse_next(&r->mouse);
    for (uint32_t offset = INPUT_MOUSE_KIND; offset <= INPUT_MOUSE_UNIT; offset += 4)
        hash = hash * 31 + mouse_rig_get(r, offset, t);
    return hash;
}

static uint64_t walk(struct mouse_rig *r, uint64_t *row, uint64_t *t, int steps)
{
    uint64_t hash = 0;
    for (int i = 0; i < steps; i++) {
        *t += (uint64_t)mouse_rig_roll(row, 0, 3e10);
        for (uint64_t next; (next = inp_mouse_next(&r->mouse)) <= *t;)
            hash = hash * 31 + next + inp_mouse_event(&r->mouse, next);
        hash = hash * 31 + act_at_random(r, row, *t);
    }
    return hash;
}

static void saved_it_goes_on_alike(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 200; i++) {
        struct mouse_rig a, b;
        mouse_rig_open(&a, i % 3);
        mouse_rig_open(&b, i % 3);
        uint64_t row = 1000 * i, t = 0;
        walk(&a, &row, &t, (int)i);
        struct crt_state s;
        crt_state_save(&s);
        inp_mouse_state(&a.mouse, &s);
        assert_false(s.failed);
        struct crt_state l;
        crt_state_load(&l, s.out, s.size);
        inp_mouse_state(&b.mouse, &l);
        assert_false(l.failed);
        uint64_t row_b = row, t_b = t;
        assert_true(walk(&a, &row, &t, 100) == walk(&b, &row_b, &t_b, 100));
        crt_state_free(&s);
    }
}

/* A number in the bytes: any; one that is often impossible; or one bit of it. */
static void spoil(uint8_t *bytes, size_t size, uint64_t *row)
{
    size_t at = 12 + (size_t)mouse_rig_roll(row, 0, (double)(size - 12));
    size_t n = (size_t)mouse_rig_roll(row, 1, 9);
    for (size_t i = at; i < size && i < at + n; i++) {
        uint64_t any = inp_noise_bits(99, (*row)++);
        bytes[i] = any % 3 == 0   ? (uint8_t)(any >> 8)
                   : any % 3 == 1 ? 0xFF
                                  : (uint8_t)(any >> 16 & 0x80);
    }
}

static void spoilt_bytes_do_no_harm(void **state)
{
    (void)state;
    int refused = 0, taken = 0;
    uint64_t row = 7000000;
    for (unsigned i = 0; i < 20000; i++) {
        struct mouse_rig r;
        mouse_rig_open(&r, i % 3);
        uint64_t t = 0;
        walk(&r, &row, &t, 4);
        struct crt_state s;
        crt_state_save(&s);
        inp_mouse_state(&r.mouse, &s);
        spoil(s.out, s.size, &row);
        struct crt_state l;
        crt_state_load(&l, s.out, s.size);
        inp_mouse_state(&r.mouse, &l);
        if (l.failed)
            refused++;
        else {
            taken++;
            walk(&r, &row, &t, 10);
            struct crt_state again;
            crt_state_save(&again);
            inp_mouse_state(&r.mouse, &again);
            crt_state_free(&again);
        }
        crt_state_free(&s);
    }
    assert_true(refused > 3000 && taken > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(saved_it_goes_on_alike),
        cmocka_unit_test(spoilt_bytes_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
