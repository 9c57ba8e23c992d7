/* Ticks over many random axes: how many, where, and that a label says exactly where it stands. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/plot/ticks.h"

static uint32_t seed = 1;
static double between(double low, double high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * (seed >> 8) / 16777216.0;
}

/* Plain ASCII of a label: − to -, ×10⁻³ and 10⁻³ to e-3. */
static double value_of(const char *label, int exponent)
{
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char text[80] = "";
    bool power = strncmp(label, "10", 2) == 0 && (unsigned char)label[2] >= 0x80;
    const char *p = label;
    if (power) {
        strcpy(text, "1e");
        p += 2;
    }
    while (*p) {
        size_t n = strlen(text);
        if (strncmp(p, "−", 3) == 0) {
            strcat(text, "-");
            p += 3;
        } else if (strncmp(p, "×10", 4) == 0) {
            strcat(text, "e");
            p += 4;
        } else if (strncmp(p, "⁻", 3) == 0) {
            strcat(text, "-");
            p += 3;
        } else if ((unsigned char)*p >= 0x80) {
            for (int d = 0; d < 10; d++)
                if (strncmp(p, raised[d], strlen(raised[d])) == 0) {
                    text[n] = (char)('0' + d);
                    text[n + 1] = '\0';
                    p += strlen(raised[d]);
                    break;
                }
            assert_true(strlen(text) > n);
        } else {
            text[n] = *p++;
            text[n + 1] = '\0';
        }
    }
    if (exponent != 0)
        snprintf(text + strlen(text), 8, "e%d", exponent);
    char *end;
    double value = strtod(text, &end);
    assert_true(*end == '\0');
    return value;
}

static void check(const struct vm_ticks *t, double low, double high)
{
    double room = (high - low) * 1e-6 + fabs(low) * 1e-9;
    for (int i = 0; i < t->count; i++) {
        assert_true(t->major[i].at >= low - room && t->major[i].at <= high + room);
        double said = value_of(t->major[i].label, t->exponent);
        if (fabs(said - t->major[i].at) > 1e-13 * fabs(said))
            fail_msg("%s (e%d) stands at %.17g", t->major[i].label, t->exponent, t->major[i].at);
        assert_true(i == 0 || t->major[i].at > t->major[i - 1].at);
        assert_true(i == 0 || strcmp(t->major[i].label, t->major[i - 1].label) != 0);
    }
    for (int i = 0; i < t->minor_count; i++)
        assert_true(t->minor[i] >= low - room && t->minor[i] <= high + room);
}

static void linear_axes(void **state)
{
    (void)state;
    struct vm_ticks t;
    for (int i = 0; i < 2500; i++) {
        double size = pow(10, between(-30, 30)),
               middle = i % 3 ? size * between(-3, 3) : size * between(-1e6, 1e6);
        double low = middle - size * between(0, 1), high = middle + size * between(0.05, 1);
        for (int most = 4; most <= 12; most += 3) {
            vm_ticks_find(&t, false, low, high, most);
            assert_true(t.count <= most);
            assert_true(t.count >= (most >= 10 ? 4 : 1));
            check(&t, low, high);
            assert_true(t.exponent % 3 == 0);
            for (int k = 2; k < t.count; k++) { /* evenly */
                double a = t.major[k].at - t.major[k - 1].at, b = t.major[1].at - t.major[0].at;
                assert_true(fabs(a - b) < 1e-9 * b + 4e-16 * fabs(t.major[k].at) * 4);
            }
        }
    }
}

static void labels_are_short_unless_the_axis_is_narrow(void **state)
{
    (void)state;
    struct vm_ticks t;
    for (int i = 0; i < 1500; i++) {
        double high = pow(10, between(-20, 20));
        vm_ticks_find(&t, false, i % 2 ? 0 : -high, high, 10);
        for (int k = 0; k < t.count; k++)
            assert_true(strlen(t.major[k].label) <= 6 + strlen("−"));
    }
}

static void known_axes(void **state)
{
    (void)state;
    struct vm_ticks t;
    vm_ticks_find(&t, false, 0, 1, 6);
    assert_int_equal(t.count, 6);
    const char *const fifths[] = {"0", "0.2", "0.4", "0.6", "0.8", "1.0"};
    for (int i = 0; i < 6; i++)
        assert_string_equal(t.major[i].label, fifths[i]);
    vm_ticks_find(&t, false, 0, 200e-6, 10);
    assert_int_equal(t.exponent, -6);
    assert_string_equal(t.major[1].label, "50"); /* 11 multiples of 20 are one too many */
    vm_ticks_find(&t, false, -300, 300, 7);
    assert_string_equal(t.major[0].label, "−300");
    vm_ticks_find(&t, true, 1e-6, 100, 10);
    assert_int_equal(t.count, 9);
    assert_string_equal(t.major[0].label, "10⁻⁶");
    assert_string_equal(t.major[8].label, "10²");
    assert_int_equal(t.minor_count, 8 * 8);
    vm_ticks_find(&t, true, 0.01, 1000, 10);
    assert_string_equal(t.major[0].label, "0.01");
    assert_string_equal(t.major[5].label, "1000");
    char text[40];
    vm_exponent_text(-12, text);
    assert_string_equal(text, "×10⁻¹²");
}

static void logarithmic_axes(void **state)
{
    (void)state;
    struct vm_ticks t;
    for (int i = 0; i < 2500; i++) {
        double decades = i % 2 ? between(0.02, 3) : between(0.02, 200);
        double low = pow(10, between(-100, 90)), high = low * pow(10, decades);
        for (int most = 3; most <= 12; most += 3) {
            vm_ticks_find(&t, true, low, high, most);
            assert_true(t.count >= (most >= 6 ? 2 : 1) && t.count <= most + 1);
            double room = 1e-6;
            for (int k = 0; k < t.count; k++) {
                assert_true(t.major[k].at >= low * (1 - room) &&
                            t.major[k].at <= high * (1 + room));
                double said = value_of(t.major[k].label, t.exponent);
                assert_true(fabs(said - t.major[k].at) <= 1e-12 * said);
                assert_true(k == 0 || t.major[k].at > t.major[k - 1].at);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_axes),
        cmocka_unit_test(labels_are_short_unless_the_axis_is_narrow),
        cmocka_unit_test(known_axes),
        cmocka_unit_test(logarithmic_axes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
