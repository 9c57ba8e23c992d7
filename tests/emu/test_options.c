/* Options and quantities: what people type, and what they are told when it is wrong. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "emu/options.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))

static void times_are_exact(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        uint64_t ps;
    } good[] = {
        {"0", 0},
        {"1ps", 1},
        {"1ns", 1000},
        {"33.33us", 33330000},
        {"16.7ms", UINT64_C(16700000000)},
        {"0.1s", UINT64_C(100000000000)},
        {".5s", UINT64_C(500000000000)},
        {"0.516666666666s", UINT64_C(516666666666)},
        {"0.0000000000019s", 1},
        {"3600s", UINT64_C(3600000000000000)},
    };
    for (size_t i = 0; i < COUNT(good); i++) {
        struct vm_time t = {0};
        struct crt_error err;
        assert_true(vm_parse_time(good[i].text, &t, &err));
        assert_true(t.given && !t.in_ticks);
        assert_int_equal(t.value, good[i].ps);
    }
}

static void ticks_follow_the_rate(void **state)
{
    (void)state;
    struct vm_time t;
    struct crt_error err;
    uint64_t ps;
    assert_true(vm_parse_time("3f", &t, &err));
    assert_true(vm_time_ps(&t, (struct crt_rate){60, 1}, &ps, &err));
    assert_int_equal(ps, UINT64_C(50000000000));
    assert_true(vm_time_ps(&t, (struct crt_rate){60000, 1001}, &ps, &err));
    assert_int_equal(ps, UINT64_C(50050000000));
    assert_true(vm_parse_time("216000f", &t, &err));
    assert_true(vm_time_ps(&t, (struct crt_rate){60, 1}, &ps, &err));
    assert_true(vm_parse_time("216001f", &t, &err));
    assert_false(vm_time_ps(&t, (struct crt_rate){60, 1}, &ps, &err));
}

#define Z16 "0000000000000000"
#define Z64 Z16 Z16 Z16 Z16

static void absurd_times_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text, *says;
    } bad[] = {
        {"-1s", "negative"},
        {"nan", "not a time"},
        {"inf", "not a time"},
        {"", "not a time"},
        {".", "not a time"},
        {"1", "needs a unit"},
        {"1.5f", "whole"},
        {"1h", "unit of time"},
        {"3601s", "one hour"},
        {"1e3s", "unit"},
        {"1.2.3s", "unit"},
        {"99999999999999999999s", "not a time"},
        {"0.0000000000000000001s", "not a time"},
        {"." Z64 Z64 "1s", "not a time"}, /* 10^128 is 0 mod 2^128 */
        {"1 s", "unit"},
        {"0x10s", "unit"},
    };
    for (size_t i = 0; i < COUNT(bad); i++) {
        struct vm_time t;
        struct crt_error err;
        assert_false(vm_parse_time(bad[i].text, &t, &err));
        if (!strstr(err.text, bad[i].says))
            fail_msg("'%s' was answered by: %s", bad[i].text, err.text);
    }
}

static void sizes_and_bytes(void **state)
{
    (void)state;
    struct vm_size size;
    struct crt_error err;
    uint32_t bytes;
    assert_true(vm_parse_size("1024x768", &size, &err));
    assert_int_equal(size.width, 1024);
    assert_int_equal(size.height, 768);
    static const char *const bad[] = {"0x0",    "1024",        "1024x",     "x768",
                                      "-1x5",   "15x1024",     "16385x100", "1e3x100",
                                      "10 x10", "100x100x100", "",          "99999999x9999"};
    for (size_t i = 0; i < COUNT(bad); i++)
        assert_false(vm_parse_size(bad[i], &size, &err));
    assert_true(vm_parse_bytes("16K", &bytes, &err));
    assert_int_equal(bytes, 16384);
    assert_true(vm_parse_bytes("65536", &bytes, &err));
    assert_int_equal(bytes, 65536);
    assert_false(vm_parse_bytes("16M", &bytes, &err));
    assert_false(vm_parse_bytes("-1", &bytes, &err));
    assert_false(vm_parse_bytes("1.5K", &bytes, &err));
    assert_false(vm_parse_bytes("999999999K", &bytes, &err));
}

static void rates_are_reduced(void **state)
{
    (void)state;
    struct crt_rate r;
    struct crt_error err;
    assert_true(vm_parse_rate("60", &r, &err));
    assert_true(r.num == 60 && r.den == 1);
    assert_true(vm_parse_rate("59.94", &r, &err));
    assert_true(r.num == 2997 && r.den == 50);
    assert_true(vm_parse_rate("60000/1001", &r, &err));
    assert_true(r.num == 60000 && r.den == 1001);
    static const char *const bad[] = {"0",   "60/0", "-60",  "nan", "60/",
                                      "/60", "1e9",  "0.01", "60Hz"};
    for (size_t i = 0; i < COUNT(bad); i++)
        assert_false(vm_parse_rate(bad[i], &r, &err));
    r = vm_rate_of_hz(60);
    assert_true(r.num == 60 && r.den == 1);
    r = vm_rate_of_hz(50.5);
    assert_true(r.num == 101 && r.den == 2);
}

static void numbers_have_limits(void **state)
{
    (void)state;
    struct crt_error err;
    double real;
    long integer;
    uint32_t octal;
    assert_true(vm_parse_real("-0.5", -1, 1, &real, &err));
    assert_true(real == -0.5);
    static const char *const bad[] = {"nan", "inf", "0x1", "1.5.5", "", "1 ", "1e", "2", "-2"};
    for (size_t i = 0; i < COUNT(bad); i++)
        assert_false(vm_parse_real(bad[i], -1, 1, &real, &err));
    assert_true(vm_parse_integer("7", 1, 8, &integer, &err));
    assert_int_equal(integer, 7);
    assert_false(vm_parse_integer("9", 1, 8, &integer, &err));
    assert_false(vm_parse_integer("99999999999999999999", 1, 8, &integer, &err));
    assert_false(vm_parse_integer(" 7", 1, 8, &integer, &err));
    assert_true(vm_parse_octal("1000", &octal, &err));
    assert_int_equal(octal, 512);
    assert_false(vm_parse_octal("8", &octal, &err));
    assert_false(vm_parse_octal("1000000", &octal, &err));
    assert_false(vm_parse_octal("", &octal, &err));
}

static void times_print_for_people(void **state)
{
    (void)state;
    static const struct {
        uint64_t ps;
        const char *text, *exact;
    } cases[] = {
        {999, "999 ps", "0.000000000999 s"},
        {1500, "1.500 ns", "0.0000000015 s"},
        {33330000, "33.33 us", "0.00003333 s"},
        {UINT64_C(999960000), "1.000 ms", "0.00099996 s"},
        {UINT64_C(16666666666), "16.67 ms", "0.016666666666 s"},
        {UINT64_C(2000000000000), "2.000 s", "2.0 s"},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[40];
        vm_format_time(cases[i].ps, text, sizeof text);
        assert_string_equal(text, cases[i].text);
        vm_format_seconds(cases[i].ps, text, sizeof text);
        assert_string_equal(text, cases[i].exact);
    }
}

/* ---- the parser ---------------------------------------------------------------------------------
 */

struct fields {
    bool flag;
    const char *name, *mode;
    struct vm_time at;
    struct vm_list set;
    long threads;
};

static const struct vm_option rows[] = {
    {"flag", 0, VM_OPT_FLAG, offsetof(struct fields, flag), "", "", 0, 0},
    {"name", 'n', VM_OPT_STRING, offsetof(struct fields, name), "NAME", "", 0, 0},
    {"mode", 0, VM_OPT_CHOICE, offsetof(struct fields, mode), "auto|manual", "", 0, 0},
    {"at", 0, VM_OPT_TIME, offsetof(struct fields, at), "T", "", 0, 0},
    {"set", 0, VM_OPT_LIST, offsetof(struct fields, set), "K=V", "", 0, 0},
    {"threads", 0, VM_OPT_INTEGER, offsetof(struct fields, threads), "N", "", 1, 8},
};

/* Arguments are separated by blanks. */
static enum vm_parsed parse(const char *line, struct fields *f, struct vm_args *args,
                            struct crt_error *err)
{
    static char text[512];
    char *argv[32];
    int argc = 0;
    memset(f, 0, sizeof *f);
    strcpy(text, line);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, f)};
    return vm_options_parse(tables, 1, argc, argv, args, err);
}

static void every_form_of_option(void **state)
{
    (void)state;
    struct fields f;
    struct vm_args args;
    struct crt_error err;
    assert_int_equal(
        parse("a.df --at 0.5s --flag -nfoo --set a=1 --set=b=2 --threads=4 b.df", &f, &args, &err),
        VM_PARSED);
    assert_true(f.flag && f.at.given && f.threads == 4 && f.set.count == 2);
    assert_string_equal(f.name, "foo");
    assert_string_equal(f.set.item[1], "b=2");
    assert_int_equal(args.count, 2);
    assert_string_equal(args.item[1], "b.df");
    assert_int_equal(parse("-n x -n=y -- --flag", &f, &args, &err), VM_PARSED);
    assert_string_equal(f.name, "y");
    assert_false(f.flag);
    assert_string_equal(args.item[0], "--flag");
    assert_int_equal(parse("-", &f, &args, &err), VM_PARSED);
    assert_string_equal(args.item[0], "-");
    assert_int_equal(parse("x --help --nonsense", &f, &args, &err), VM_PARSED_HELP);
}

static void errors_name_the_option(void **state)
{
    (void)state;
    static const struct {
        const char *line, *says;
    } bad[] = {
        {"--thread 2", "did you mean --threads"},
        {"--nmae x", "did you mean --name"},
        {"--zzzzzzzz", "no option --zzzzzzzz"},
        {"-q", "no option -q"},
        {"--at", "needs a value"},
        {"--at=-1s", "--at: the time '-1s' is negative"},
        {"--flag=1", "takes no value"},
        {"--mode sideways", "not one of auto|manual"},
        {"--mode aut", "not one of"},
        {"--threads 9", "out of range"},
        {"--name=", "empty"},
        {"1 2 3 4 5 6 7 8 9", "more than"},
    };
    for (size_t i = 0; i < COUNT(bad); i++) {
        struct fields f;
        struct vm_args args;
        struct crt_error err;
        assert_int_equal(parse(bad[i].line, &f, &args, &err), VM_PARSED_ERROR);
        if (!strstr(err.text, bad[i].says))
            fail_msg("'%s' was answered by: %s", bad[i].line, err.text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_are_exact),          cmocka_unit_test(ticks_follow_the_rate),
        cmocka_unit_test(absurd_times_are_refused), cmocka_unit_test(sizes_and_bytes),
        cmocka_unit_test(rates_are_reduced),        cmocka_unit_test(numbers_have_limits),
        cmocka_unit_test(times_print_for_people),   cmocka_unit_test(every_form_of_option),
        cmocka_unit_test(errors_name_the_option),
    };
    return cmocka_run_group_tests_name("options", tests, NULL, NULL);
}
