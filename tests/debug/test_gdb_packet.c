/* Framing of the GDB protocol: packets in and out, damage, escapes, fields. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/debug/gdb_packet.h"

/* The events but VM_GDB_NOTHING as letters, bodies in brackets. */
static const char *heard(struct vm_gdb_receiver *r, const char *bytes, size_t size)
{
    static char log[4096];
    size_t used = 0;
    for (size_t i = 0; i < size; i++) {
        enum vm_gdb_event event = vm_gdb_receive(r, (uint8_t)bytes[i]);
        assert_true(used + r->size + 3 < sizeof log || event != VM_GDB_BODY);
        if (event == VM_GDB_BODY)
            used += (size_t)snprintf(log + used, sizeof log - used, "[%.*s]", (int)r->size,
                                     (const char *)r->body);
        else if (event != VM_GDB_NOTHING)
            log[used++] = ".?!L+-^"[event];
    }
    log[used] = '\0';
    return log;
}

static void hears(const char *bytes, const char *expected)
{
    struct vm_gdb_receiver r;
    vm_gdb_receiver_init(&r);
    assert_string_equal(heard(&r, bytes, strlen(bytes)), expected);
}

static void good_packets(void **state)
{
    (void)state;
    hears("$g#67", "[g]");
    hears("+$?#3f", "+[?]");
    hears("$#00", "[]");
    hears("$OK#9A$OK#9a", "[OK][OK]");
    hears("-\x03", "-^");
    hears("\x03$\x03#03", "^[\x03]");
}

static void damaged_packets(void **state)
{
    (void)state;
    hears("$g#68", "!");
    hears("$g#6x$g#67", "![g]");
    hears("$g#zz$g#67", "![g]");
    hears("noise#12$g#67", "[g]");
    hears("$lost in trans$g#67", "[g]"); /* "$" is never within a body */
    hears("$g#6", "");
}

static void escapes(void **state)
{
    (void)state;
    hears("$}\x03}\x04}\x0a}]#62", "[#$*}]");
    hears("$}#7d$g#67", "[][g]"); /* what it would escape is missing */
}

/* One byte more than fits, and the packet after it. */
static void too_long(void **state)
{
    (void)state;
    for (size_t extra = 0; extra < 2; extra++) {
        struct vm_gdb_receiver r;
        char end[4];
        vm_gdb_receiver_init(&r);
        vm_gdb_receive(&r, '$');
        for (size_t i = 0; i < VM_GDB_BODY_MAX + extra; i++)
            assert_int_equal(vm_gdb_receive(&r, 'a'), VM_GDB_NOTHING);
        snprintf(end, sizeof end, "#%02x", (unsigned)(('a' * (VM_GDB_BODY_MAX + extra)) & 255));
        assert_int_equal(vm_gdb_receive(&r, '#'), VM_GDB_NOTHING);
        assert_int_equal(vm_gdb_receive(&r, (uint8_t)end[1]), VM_GDB_NOTHING);
        assert_int_equal(vm_gdb_receive(&r, (uint8_t)end[2]),
                         extra ? VM_GDB_TOO_LONG : VM_GDB_BODY);
        assert_string_equal(heard(&r, "$g#67", 5), "[g]");
    }
}

/* Whatever comes, a whole packet after "$" is understood; random bytes, a fixed seed. */
static void after_noise(void **state)
{
    (void)state;
    struct vm_gdb_receiver r;
    uint32_t random = 1;
    vm_gdb_receiver_init(&r);
    for (int round = 0; round < 2000; round++) {
        for (int i = 0; i < 40; i++) {
            random = random * 1664525 + 1013904223;
            vm_gdb_receive(&r, (uint8_t)(random >> 24));
        }
        while (r.state == VM_GDB_IN_SUM_1 || r.state == VM_GDB_IN_SUM_2)
            vm_gdb_receive(&r, '0');
        assert_string_equal(heard(&r, "$m80000000,4#55", 15), "[m80000000,4]");
    }
}

/* ---- fields ---- */

static struct vm_gdb_fields of(const char *text)
{
    return vm_gdb_fields_of((const uint8_t *)text, strlen(text));
}

static void numbers(void **state)
{
    (void)state;
    uint32_t value = 7;
    struct vm_gdb_fields f = of("80000000,4;");
    assert_true(vm_gdb_take_number(&f, &value));
    assert_int_equal(value, 0x80000000);
    assert_true(vm_gdb_take(&f, ','));
    assert_false(vm_gdb_take(&f, ','));
    assert_true(vm_gdb_take_number(&f, &value));
    assert_int_equal(value, 4);
    assert_false(vm_gdb_take_number(&f, &value));
    assert_true(vm_gdb_take_text(&f, ";"));
    assert_int_equal(vm_gdb_left(&f), 0);
    assert_false(vm_gdb_take(&f, ';'));

    f = of("00000000ffffFFFF");
    assert_true(vm_gdb_take_number(&f, &value));
    assert_int_equal(value, 0xffffffff);
    f = of("100000000");
    assert_false(vm_gdb_take_number(&f, &value));
    assert_int_equal(vm_gdb_left(&f), 9);
}

static void bytes_and_parts(void **state)
{
    (void)state;
    uint8_t bytes[3] = {0};
    struct vm_gdb_fields f = of("01aBfg");
    assert_false(vm_gdb_take_bytes(&f, bytes, 3));
    assert_false(vm_gdb_take_bytes(&f, bytes, SIZE_MAX));
    assert_true(vm_gdb_take_bytes(&f, bytes, 2));
    assert_int_equal(bytes[0], 0x01);
    assert_int_equal(bytes[1], 0xab);
    assert_int_equal(vm_gdb_left(&f), 2);

    f = of("a;;bc");
    struct vm_gdb_fields part = vm_gdb_take_until(&f, ';');
    assert_int_equal(vm_gdb_left(&part), 1);
    part = vm_gdb_take_until(&f, ';');
    assert_int_equal(vm_gdb_left(&part), 0);
    part = vm_gdb_take_until(&f, ';');
    assert_int_equal(vm_gdb_left(&part), 2);
    assert_int_equal(vm_gdb_left(&f), 0);
}

/* ---- sending ---- */

static void sent(const struct vm_gdb_packet *p, const char *expected)
{
    assert_int_equal(p->size, strlen(expected));
    assert_memory_equal(p->bytes, expected, p->size);
}

static void made_packets(void **state)
{
    (void)state;
    struct vm_gdb_packet *p = malloc(sizeof *p);
    assert_non_null(p);
    vm_gdb_begin(p);
    vm_gdb_end(p);
    sent(p, "$#00");
    vm_gdb_begin(p);
    vm_gdb_add_text(p, "OK");
    vm_gdb_end(p);
    sent(p, "$OK#9a");
    vm_gdb_begin(p);
    vm_gdb_add_number(p, 0);
    vm_gdb_add_number(p, 0xa0);
    vm_gdb_add_number(p, 0xffffffff);
    vm_gdb_add_word(p, 0x12345678);
    vm_gdb_end(p);
    sent(p, "$0a0ffffffff78563412#95");
    vm_gdb_begin(p);
    vm_gdb_add_text(p, "a#$}*");
    vm_gdb_end(p);
    sent(p, "$a}\x03}\x04}]}\x0a#c3");
    free(p);
}

/* What we send, we receive: every byte, and a body of the longest kind. */
static void round_trip(void **state)
{
    (void)state;
    struct vm_gdb_packet *p = malloc(sizeof *p);
    uint8_t bytes[VM_GDB_BODY_MAX];
    assert_non_null(p);
    for (size_t fill = 0; fill < 2; fill++) {
        for (size_t i = 0; i < sizeof bytes; i++)
            bytes[i] = fill ? '#' : (uint8_t)i;
        struct vm_gdb_receiver r;
        enum vm_gdb_event event = VM_GDB_NOTHING;
        vm_gdb_receiver_init(&r);
        vm_gdb_begin(p);
        vm_gdb_add_escaped(p, bytes, sizeof bytes);
        vm_gdb_end(p);
        for (size_t i = 0; i < p->size; i++)
            event = vm_gdb_receive(&r, p->bytes[i]);
        assert_int_equal(event, VM_GDB_BODY);
        assert_int_equal(r.size, sizeof bytes);
        assert_memory_equal(r.body, bytes, sizeof bytes);
    }
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good_packets),    cmocka_unit_test(damaged_packets),
        cmocka_unit_test(escapes),         cmocka_unit_test(too_long),
        cmocka_unit_test(after_noise),     cmocka_unit_test(numbers),
        cmocka_unit_test(bytes_and_parts), cmocka_unit_test(made_packets),
        cmocka_unit_test(round_trip),
    };
    return cmocka_run_group_tests_name("gdb_packet", tests, NULL, NULL);
}
