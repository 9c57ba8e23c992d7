/* The bus: who answers where, in what width, and that everything else faults. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/board/bus.h"

struct answerer {
    int number; /* returned by reads, with the offset and width */
    bool refuse;
    uint32_t offset, value;
    unsigned width, accesses;
};

static bool read_it(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct answerer *a = ctx;
    a->accesses++;
    *value = (uint32_t)a->number << 24 | offset << 4 | width;
    return !a->refuse;
}

static bool write_it(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct answerer *a = ctx;
    a->accesses++;
    a->offset = offset;
    a->width = width;
    a->value = value;
    return !a->refuse;
}

static void add(struct bus *bus, struct answerer *a, uint32_t base, uint32_t size, unsigned widths)
{
    bus_add(bus, &(struct bus_range){base, size, widths, a, read_it, write_it});
}

static void nobody(void **state)
{
    (void)state;
    struct bus bus;
    uint32_t v;
    bus_init(&bus);
    assert_false(bus_load(&bus, 0, 4, &v));
    assert_false(bus_store(&bus, 0xFFFFFFFC, 4, 1));
}

static void edges(void **state)
{
    (void)state;
    struct bus bus;
    struct answerer a = {.number = 1}, b = {.number = 2};
    uint32_t v = 0;
    bus_init(&bus);
    add(&bus, &b, 0x2000, 0x100, BUS_8 | BUS_16 | BUS_32);
    add(&bus, &a, 0x1000, 0x1000, BUS_32);
    assert_false(bus_load(&bus, 0xFFC, 4, &v));
    assert_true(bus_load(&bus, 0x1000, 4, &v));
    assert_int_equal(v, 0x01000004);
    assert_true(bus_load(&bus, 0x1FFC, 4, &v));
    assert_int_equal(v, 0x0100FFC4);
    assert_true(bus_load(&bus, 0x2000, 4, &v));
    assert_int_equal(v, 0x02000004);
    assert_true(bus_load(&bus, 0x20FF, 1, &v));
    assert_int_equal(v, 0x02000FF1);
    assert_false(bus_load(&bus, 0x2100, 1, &v));
    assert_true(bus_store(&bus, 0x20FE, 2, 0xABCD));
    assert_int_equal(b.offset, 0xFE);
    assert_int_equal(b.width, 2);
    assert_int_equal(b.value, 0xABCD);
}

static void ends_of_address_space(void **state)
{
    (void)state;
    struct bus bus;
    struct answerer a = {.number = 1}, b = {.number = 2};
    uint32_t v;
    bus_init(&bus);
    add(&bus, &a, 0xFFFFF000, 0x1000, BUS_32);
    add(&bus, &b, 0, 4, BUS_32);
    assert_true(bus_load(&bus, 0xFFFFFFFC, 4, &v));
    assert_int_equal(v, 0x0100FFC4);
    assert_true(bus_load(&bus, 0, 4, &v));
    assert_int_equal(v, 0x02000004);
    assert_false(bus_load(&bus, 4, 4, &v));
}

/* Every set of widths against every width. */
static void widths(void **state)
{
    (void)state;
    for (unsigned set = 0; set < 8; set++)
        for (unsigned width = 1; width <= 4; width *= 2) {
            struct bus bus;
            struct answerer a = {.number = 1};
            uint32_t v;
            bool taken = (set & width) != 0;
            bus_init(&bus);
            add(&bus, &a, 0x40, 0x40, set);
            assert_int_equal(bus_load(&bus, 0x44, width, &v), taken);
            assert_int_equal(bus_store(&bus, 0x44, width, 0), taken);
            assert_int_equal(a.accesses, taken ? 2 : 0);
        }
}

/* A range that ends within a word does not take the word. */
static void cut_word(void **state)
{
    (void)state;
    struct bus bus;
    struct answerer a = {.number = 1};
    uint32_t v;
    bus_init(&bus);
    add(&bus, &a, 0x40, 6, BUS_8 | BUS_16 | BUS_32);
    assert_true(bus_load(&bus, 0x44, 2, &v));
    assert_false(bus_load(&bus, 0x44, 4, &v));
    assert_int_equal(a.accesses, 1);
}

static void refused(void **state)
{
    (void)state;
    struct bus bus;
    struct answerer a = {.refuse = true};
    uint32_t v;
    bus_init(&bus);
    add(&bus, &a, 0x40, 4, BUS_32);
    assert_false(bus_load(&bus, 0x40, 4, &v));
    assert_false(bus_store(&bus, 0x40, 4, 0));
    assert_int_equal(a.accesses, 2);
}

/* Sixteen ranges added in a shuffled order, looked up against a plain search of the list. */
static void many(void **state)
{
    (void)state;
    uint32_t seed = 1;
    for (int round = 0; round < 200; round++) {
        struct bus bus;
        struct answerer a[BUS_MAX_RANGES] = {{0}};
        uint32_t base[BUS_MAX_RANGES], size[BUS_MAX_RANGES], at = 0x100;
        int order[BUS_MAX_RANGES];
        for (int i = 0; i < BUS_MAX_RANGES; i++) {
            seed = seed * 1664525 + 1013904223;
            base[i] = at + (seed >> 24 & 15) * 4;
            size[i] = 4 + (seed >> 16 & 15) * 4;
            at = base[i] + size[i];
            a[i].number = i + 1;
            int j = (int)(seed >> 8 & 0xFF) % (i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        bus_init(&bus);
        for (int i = 0; i < BUS_MAX_RANGES; i++)
            add(&bus, &a[order[i]], base[order[i]], size[order[i]], BUS_32);
        for (uint32_t address = 0; address < at + 64; address += 4) {
            uint32_t v = 0, expected = 0;
            for (int i = 0; i < BUS_MAX_RANGES; i++)
                if (address >= base[i] && address < base[i] + size[i])
                    expected = (uint32_t)(i + 1) << 24 | (address - base[i]) << 4 | 4;
            assert_int_equal(bus_load(&bus, address, 4, &v), expected != 0);
            if (expected)
                assert_int_equal(v, expected);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nobody),
        cmocka_unit_test(edges),
        cmocka_unit_test(ends_of_address_space),
        cmocka_unit_test(widths),
        cmocka_unit_test(cut_word),
        cmocka_unit_test(refused),
        cmocka_unit_test(many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
