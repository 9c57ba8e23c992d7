/* A snapshot's bytes: layout, both directions, and what is refused. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/state.h"

#define PAGE 4096

struct part {
    bool yes, no;
    uint8_t a;
    uint16_t b;
    uint32_t c;
    uint64_t d;
    int32_t e;
    float f, many[3];
    double g;
    char text[5];
    size_t size;
    unsigned number;
};

static const struct part example = {true,   false,      0xA1,
                                    0xB1B2, 0xC1C2C3C4, UINT64_C(0xD1D2D3D4D5D6D7D8),
                                    -2,     -1.5F,      {0.0F, FLT_MIN, FLT_MAX},
                                    0.1,    "text",     1000,
                                    7};

static void part_state(struct part *p, struct crt_state *s)
{
    crt_state_begin(s, "PART", 3);
    crt_state_bool(s, &p->yes);
    crt_state_bool(s, &p->no);
    crt_state_u8(s, &p->a);
    crt_state_u16(s, &p->b);
    crt_state_u32(s, &p->c);
    crt_state_u64(s, &p->d);
    crt_state_i32(s, &p->e);
    crt_state_f32(s, &p->f);
    crt_state_f32s(s, p->many, 3);
    crt_state_f64(s, &p->g);
    crt_state_bytes(s, p->text, sizeof p->text);
    crt_state_size(s, &p->size, 1000);
    crt_state_unsigned(s, &p->number, 7);
    crt_state_end(s);
}

/* Tag, version, length; then every field, low byte first. */
static const uint8_t layout[] = {
    'P',  'A',  'R',  'T',  3,    0,    0,    0,    62,   0,    0,    0,    0,
    0,    0,    0,                                                          /* */
    1,    0,    0xA1, 0xB2, 0xB1, 0xC4, 0xC3, 0xC2, 0xC1,                   /* */
    0xD8, 0xD7, 0xD6, 0xD5, 0xD4, 0xD3, 0xD2, 0xD1, 0xFE, 0xFF, 0xFF, 0xFF, /* */
    0x00, 0x00, 0xC0, 0xBF, 0,    0,    0,    0,    0,    0,    0x80, 0,    0xFF,
    0xFF, 0x7F, 0x7F,                                                          /* */
    0x9A, 0x99, 0x99, 0x99, 0x99, 0x99, 0xB9, 0x3F, 't',  'e',  'x',  't',  0, /* */
    0xE8, 3,    0,    0,    0,    0,    0,    0,    7,    0,    0,    0};

static void fields_lie_as_described(void **state)
{
    (void)state;
    struct crt_state s;
    struct part p = example;
    crt_state_save(&s);
    part_state(&p, &s);
    assert_false(s.failed);
    assert_int_equal(s.size, sizeof layout);
    assert_memory_equal(s.out, layout, sizeof layout);
    crt_state_free(&s);
}

static void what_was_saved_is_loaded(void **state)
{
    (void)state;
    struct crt_state s;
    struct part p = {.a = 99};
    crt_state_load(&s, layout, sizeof layout);
    part_state(&p, &s);
    assert_false(s.failed);
    assert_int_equal(s.at, sizeof layout);
    assert_true(p.yes == example.yes && p.no == example.no && p.a == example.a);
    assert_true(p.b == example.b && p.c == example.c && p.d == example.d && p.e == example.e);
    assert_memory_equal(&p.f, &example.f, sizeof p.f);
    assert_memory_equal(p.many, example.many, sizeof p.many);
    assert_memory_equal(&p.g, &example.g, sizeof p.g);
    assert_string_equal(p.text, example.text);
    assert_true(p.size == example.size && p.number == example.number);
}

/* Bits survive that comparison of numbers would not see. */
static void floats_keep_their_bits(void **state)
{
    (void)state;
    static const uint32_t bits[] = {0x80000000, 0x7FC00001, 0x7F800001, 0x00000001, 0xFF800000};
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        struct crt_state save, load;
        uint32_t again;
        float f, g = 0;
        memcpy(&f, &bits[i], sizeof f);
        crt_state_save(&save);
        crt_state_f32s(&save, &f, 1);
        crt_state_load(&load, save.out, save.size);
        crt_state_f32s(&load, &g, 1);
        memcpy(&again, &g, sizeof g);
        assert_int_equal(again, bits[i]);
        crt_state_free(&save);
    }
}

static struct crt_state load_part(const uint8_t *bytes, size_t size, struct part *p)
{
    struct crt_state s;
    uint8_t *exact = malloc(size ? size : 1); /* so that a sanitizer sees reads past the end */
    assert_non_null(exact);
    memcpy(exact, bytes, size);
    *p = example;
    crt_state_load(&s, exact, size);
    part_state(p, &s);
    free(exact);
    return s;
}

static void every_truncation_is_refused(void **state)
{
    (void)state;
    struct part p;
    for (size_t size = 0; size < sizeof layout; size++) {
        struct crt_state s = load_part(layout, size, &p);
        assert_true(s.failed);
        assert_string_equal(s.err.text, "the snapshot ends too early");
        assert_int_equal(p.number, 0); /* after an error loads give 0 */
    }
}

static void expect(size_t at, uint8_t value, const char *sentence)
{
    uint8_t bytes[sizeof layout];
    struct part p;
    memcpy(bytes, layout, sizeof bytes);
    bytes[at] = value;
    struct crt_state s = load_part(bytes, sizeof bytes, &p);
    assert_true(s.failed);
    assert_string_equal(s.err.text, sentence);
}

static void wrong_values_are_named(void **state)
{
    (void)state;
    expect(0, 'p', "the snapshot has no part PART where it should be");
    expect(4, 4, "the snapshot's part PART is of version 4; this program has version 3");
    expect(7, 1, "the snapshot's part PART is of version 16777219; this program has version 3");
    expect(8, 61, "the snapshot ends too early");
    expect(15, 0x80, "the snapshot ends too early");
    expect(16, 2, "the snapshot's flag is impossible");
    expect(17, 255, "the snapshot's flag is impossible");
    expect(66, 0xE9, "the snapshot's count is impossible");
    expect(73, 1, "the snapshot's count is impossible");
    expect(74, 8, "the snapshot's number is impossible");
}

static void a_longer_part_is_refused(void **state)
{
    (void)state;
    uint8_t bytes[sizeof layout + 1] = {0};
    struct part p;
    memcpy(bytes, layout, sizeof layout);
    bytes[8] = 63;
    struct crt_state s = load_part(bytes, sizeof bytes, &p);
    assert_true(s.failed);
    assert_string_equal(s.err.text, "the snapshot's part PART is longer than it should be");
}

/* The first error stays, and a check that fails counts when saving, too. */
static void errors_stick(void **state)
{
    (void)state;
    struct crt_state s;
    uint32_t n = 5;
    crt_state_save(&s);
    crt_state_u32(&s, &n);
    assert_true(crt_state_check(&s, true, "nothing"));
    assert_false(crt_state_check(&s, false, "first"));
    assert_false(crt_state_check(&s, false, "second"));
    assert_false(crt_state_check(&s, true, "third"));
    crt_state_begin(&s, "MORE", 1);
    crt_state_u32(&s, &n);
    crt_state_end(&s);
    assert_int_equal(s.size, 4);
    assert_int_equal(n, 5);
    assert_string_equal(s.err.text, "the snapshot's first is impossible");
    crt_state_free(&s);
}

static void a_part_ends_where_its_section_does(void **state)
{
    (void)state;
    struct crt_state save, load;
    uint32_t n = 5;
    crt_state_save(&save);
    for (int i = 0; i < 2; i++) {
        crt_state_begin(&save, "FOUR", 1);
        crt_state_u32(&save, &n);
        crt_state_end(&save);
    }
    crt_state_load(&load, save.out, save.size);
    crt_state_begin(&load, "FOUR", 1);
    crt_state_u32(&load, &n);
    crt_state_u32(&load, &n); /* would be the next section's */
    assert_true(load.failed);
    crt_state_free(&save);
}

static void a_part_can_be_passed_over(void **state)
{
    (void)state;
    struct crt_state save, load;
    uint32_t n = 5, m = 0;
    crt_state_save(&save);
    crt_state_begin(&save, "FOUR", 1);
    crt_state_u32(&save, &n);
    crt_state_end(&save);
    crt_state_u32(&save, &n);
    crt_state_load(&load, save.out, save.size);
    crt_state_skip(&load, "FOUR");
    crt_state_u32(&load, &m);
    assert_false(load.failed);
    assert_int_equal(m, 5);
    crt_state_load(&load, save.out, save.size);
    crt_state_skip(&load, "FIVE");
    assert_true(load.failed);
    crt_state_load(&load, save.out, 18);
    crt_state_skip(&load, "FOUR");
    assert_true(load.failed);
    crt_state_free(&save);
}

/* ---- memory ------------------------------------------------------------------------------------ */

static void dark_pages_are_left_out(void **state)
{
    (void)state;
    static uint8_t memory[10 * PAGE + 100], again[sizeof memory];
    struct crt_state save, load;
    memset(memory, 0, sizeof memory);
    memset(again, 0xEE, sizeof again);
    memory[0] = 1;                 /* the first byte of the first page */
    memory[4 * PAGE - 1] = 2;      /* the last of the fourth */
    memory[sizeof memory - 1] = 3; /* the last of all, on a short page */
    crt_state_save(&save);
    crt_state_pages(&save, memory, sizeof memory);
    assert_int_equal(save.size, 4 + 3 * 4 + 2 * PAGE + 100);
    crt_state_load(&load, save.out, save.size);
    crt_state_pages(&load, again, sizeof again);
    assert_false(load.failed);
    assert_int_equal(load.at, save.size);
    assert_memory_equal(again, memory, sizeof memory);
    crt_state_free(&save);
}

static void words_are_little_endian(void **state)
{
    (void)state;
    static uint16_t words[PAGE + 7], again[PAGE + 7];
    struct crt_state save, load;
    memset(again, 0xEE, sizeof again);
    words[1] = 0x1234;
    words[PAGE + 6] = 0xABCD;
    crt_state_save(&save);
    crt_state_word_pages(&save, words, PAGE + 7);
    assert_int_equal(save.size, 4 + PAGE + 4 + 14 + 4);
    assert_int_equal(save.out[6], 0x34);
    assert_int_equal(save.out[7], 0x12);
    crt_state_load(&load, save.out, save.size);
    crt_state_word_pages(&load, again, PAGE + 7);
    assert_false(load.failed);
    assert_memory_equal(again, words, sizeof words);
    crt_state_free(&save);
}

static void pages_out_of_order_are_refused(void **state)
{
    (void)state;
    static uint8_t memory[4 * PAGE];
    struct crt_state save, load;
    static const struct {
        uint8_t first, second;
    } wrong[] = {{2, 1}, {1, 1}, {0, 4}, {4, 3}, {255, 3}};
    memset(memory, 1, sizeof memory);
    memset(memory, 0, PAGE);
    memset(memory + 2 * PAGE, 0, PAGE);
    crt_state_save(&save);
    crt_state_pages(&save, memory, sizeof memory); /* pages 1 and 3 */
    assert_int_equal(save.size, 2 * (4 + PAGE) + 4);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        save.out[0] = wrong[i].first;
        save.out[4 + PAGE] = wrong[i].second;
        crt_state_load(&load, save.out, save.size);
        crt_state_pages(&load, memory, sizeof memory);
        assert_true(load.failed);
        assert_string_equal(load.err.text, "the snapshot's memory is impossible");
    }
    crt_state_free(&save);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fields_lie_as_described),
        cmocka_unit_test(what_was_saved_is_loaded),
        cmocka_unit_test(floats_keep_their_bits),
        cmocka_unit_test(every_truncation_is_refused),
        cmocka_unit_test(wrong_values_are_named),
        cmocka_unit_test(a_longer_part_is_refused),
        cmocka_unit_test(errors_stick),
        cmocka_unit_test(a_part_ends_where_its_section_does),
        cmocka_unit_test(a_part_can_be_passed_over),
        cmocka_unit_test(dark_pages_are_left_out),
        cmocka_unit_test(words_are_little_endian),
        cmocka_unit_test(pages_out_of_order_are_refused),
    };
    return cmocka_run_group_tests_name("state", tests, NULL, NULL);
}
