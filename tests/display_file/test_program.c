/* Programs as words at addresses, and the times of a tube row. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/program.h"
#include "display_file/timing.h"

static void program_keeps_words_and_bounds(void **state)
{
    (void)state;
    struct df_program p;
    struct crt_error err;
    assert_true(df_program_init(&p, &err));
    assert_int_equal(p.low, p.high);
    df_program_put(&p, 01000, 0114000);
    assert_int_equal(p.low, 01000);
    assert_int_equal(p.high, 01002);
    df_program_put(&p, 02000, 1);
    df_program_put(&p, 0, 2);
    df_program_put(&p, 01000, 0110000);
    assert_int_equal(p.low, 0);
    assert_int_equal(p.high, 02002);
    assert_int_equal(p.words[01000 / 2], 0110000);
    assert_int_equal(p.words[0], 2);
    unsigned loaded = 0;
    for (unsigned i = 0; i < DF_MEMORY_BYTES / 2; i++)
        loaded += p.loaded[i];
    assert_int_equal(loaded, 3);
    df_program_put(&p, DF_MEMORY_BYTES - 2, 7);
    assert_int_equal(p.high, DF_MEMORY_BYTES);
    p.files = malloc(sizeof *p.files);
    p.files[0] = malloc(4);
    p.file_count = 1;
    df_program_free(&p);
    assert_null(p.words);
    df_program_free(&p);
}

static void times_of_a_tube_row(void **state)
{
    (void)state;
    static struct crt_tube_row row;
    row.fetch = (struct crt_figure){1.5, 1.2, 1.8, "estimate"};
    row.vector_setup = (struct crt_figure){2, 1, 4, "estimate"};
    row.vector_unit = (struct crt_figure){0.1, 0.05, 0.2, "estimate"};
    row.vector_rest = (struct crt_figure){0.2, 0, 0.3, "estimate"};
    row.settle = (struct crt_figure){1, 0.5, 2, "estimate"};
    row.settle_unit = (struct crt_figure){0.0176, 0.0150, 0.02, "estimate"};
    row.settle_max = (struct crt_figure){18, 17, 19, "estimate"};
    row.point = (struct crt_figure){1, 0.9, 1.1, "estimate"};
    row.character = (struct crt_figure){15, 12, 20, "estimate"};
    row.dot = (struct crt_figure){0.25, 0.2, 0.3, "estimate"};
    row.intensify = (struct crt_figure){20, 20, 20, "estimate"};
    row.colour_switch = (struct crt_figure){100, 50, 200, "estimate"};
    struct df_timing value = df_timing_of_tube(&row, DF_TIMING_VALUE);
    const struct df_timing expected = {1500000,  2000000,   100000,  200000,   1000000,
                                       17600,    18000000,  1000000, 15000000, 250000,
                                       20000000, 100000000, 0};
    assert_memory_equal(&value, &expected, sizeof value);
    struct df_timing low = df_timing_of_tube(&row, DF_TIMING_LOW);
    assert_int_equal(low.fetch_ps, 1200000);
    assert_int_equal(low.settle_unit_ps, 15000);
    struct df_timing high = df_timing_of_tube(&row, DF_TIMING_HIGH);
    assert_int_equal(high.fetch_ps, 1800000);
    assert_int_equal(high.vector_unit_ps, 200000);
    assert_int_equal(high.colour_switch_ps, 200000000);
    assert_int_equal(high.average_ps, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(program_keeps_words_and_bounds),
        cmocka_unit_test(times_of_a_tube_row),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
