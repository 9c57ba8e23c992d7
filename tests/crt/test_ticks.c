/* Time of ticks: exact from the count, and its inverse. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "crt/ticks.h"

static void ticks_do_not_drift(void **state)
{
    (void)state;
    const struct crt_rate ntsc = {60000, 1001};
    assert_int_equal(crt_tick_time(ntsc, 0), 0);
    /* 60000 ticks of 60000/1001 Hz last exactly 1001 s. */
    assert_int_equal(crt_tick_time(ntsc, 60000), 1001 * CRT_PS_PER_S);
    /* A day of 60 Hz ticks. */
    assert_int_equal(crt_tick_time((struct crt_rate){60, 1}, 60ull * 86400), 86400 * CRT_PS_PER_S);
}

static void tick_at_is_the_inverse(void **state)
{
    (void)state;
    const struct crt_rate rates[] = {{60, 1}, {50, 1}, {60000, 1001}, {7, 3}, {1, 1}};
    for (unsigned r = 0; r < sizeof rates / sizeof rates[0]; r++)
        for (uint64_t n = 1; n < 3000; n += 7) {
            uint64_t t = crt_tick_time(rates[r], n);
            assert_int_equal(crt_tick_at(rates[r], t), n);
            assert_int_equal(crt_tick_at(rates[r], t - 1), n - 1);
            assert_int_equal(crt_tick_at(rates[r], t + 1), n);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ticks_do_not_drift),
        cmocka_unit_test(tick_at_is_the_inverse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
