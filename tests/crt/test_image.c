/* Pictures in memory: hash against known SHA-256 values, comparison against counts by hand. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "crt/image.h"

static struct crt_image picture(int width, int height, int depth)
{
    struct crt_image image;
    struct crt_error err;
    assert_true(crt_image_init(&image, width, height, depth, &err));
    return image;
}

static void a_new_picture_is_black_and_has_its_shape(void **state)
{
    (void)state;
    struct crt_image image = picture(5, 7, 16);
    assert_int_equal(image.width, 5);
    assert_int_equal(image.height, 7);
    assert_int_equal(image.depth, 16);
    for (int i = 0; i < 5 * 7 * 3; i++)
        assert_int_equal(image.samples[i], 0);
    crt_image_free(&image);
    assert_null(image.samples);
    crt_image_free(&image); /* twice is harmless */
}

static void impossible_sizes_are_refused(void **state)
{
    (void)state;
    const int sizes[][2] = {{0, 1},     {1, 0},     {-5, 5},
                            {16385, 1}, {1, 16385}, {INT32_MAX, INT32_MAX}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct crt_image image;
        struct crt_error err = {""};
        assert_false(crt_image_init(&image, sizes[i][0], sizes[i][1], 8, &err));
        assert_null(image.samples);
        assert_non_null(strstr(err.text, "16384"));
    }
}

/* printf '\0\0\0\2\0\0\0\1\0\0\0\10\1\2\3\375\376\377' | sha256sum, and the same at 16 bits. */
static void hash_is_sha256_of_shape_and_big_endian_samples(void **state)
{
    (void)state;
    const uint16_t eight[] = {1, 2, 3, 253, 254, 255};
    const uint16_t sixteen[] = {0x0102, 0x0304, 0x0506, 0xfffd, 0xfffe, 0xffff};
    char hex[65];
    struct crt_image image = picture(2, 1, 8);
    memcpy(image.samples, eight, sizeof eight);
    crt_image_hash(&image, hex);
    assert_string_equal(hex, "dd0fee54e9eb28c652402037c2c5c70ba2bbf1c190d0c66b4db2f18384f30c29");
    crt_image_free(&image);
    image = picture(2, 1, 16);
    memcpy(image.samples, sixteen, sizeof sixteen);
    crt_image_hash(&image, hex);
    assert_string_equal(hex, "7a83a775769d00880da4e0b61164a57a69f2d1ab48a8914017ef6a9aa16b7a65");
    crt_image_free(&image);
    /* More than one buffer of bytes: 100 × 100 black pixels. */
    image = picture(100, 100, 16);
    crt_image_hash(&image, hex);
    assert_string_equal(hex, "d317be586e1be48f880affd26bcd3f529722cd03e95679cfc77405fa4445b7ba");
    crt_image_free(&image);
}

static void equal_pictures_do_not_differ(void **state)
{
    (void)state;
    struct crt_image a = picture(10, 10, 8), b = picture(10, 10, 8);
    a.samples[5] = b.samples[5] = 77;
    struct crt_image_difference d = crt_image_compare(&a, &b, 0);
    assert_true(d.same_shape);
    assert_int_equal(d.max_difference, 0);
    assert_int_equal(d.pixels_differing, 0);
    assert_int_equal(d.first_x, -1);
    assert_int_equal(d.first_y, -1);
    assert_true(isinf(d.psnr_db) && d.psnr_db > 0);
    crt_image_free(&a);
    crt_image_free(&b);
}

static void differences_are_counted_by_pixel(void **state)
{
    (void)state;
    struct crt_image a = picture(10, 10, 8), b = picture(10, 10, 8);
    b.samples[3 * (4 * 10 + 7) + 0] = 1;  /* (7, 4): 1 */
    b.samples[3 * (5 * 10 + 2) + 1] = 10; /* (2, 5): 10 and 4 */
    b.samples[3 * (5 * 10 + 2) + 2] = 4;
    a.samples[3 * (9 * 10 + 9) + 2] = 255; /* (9, 9): 255 */
    struct crt_image_difference d = crt_image_compare(&a, &b, 0);
    assert_int_equal(d.max_difference, 255);
    assert_int_equal(d.pixels_differing, 3);
    assert_int_equal(d.first_x, 7);
    assert_int_equal(d.first_y, 4);
    assert_true(fabs(d.mean_difference - 270.0 / 300.0) < 1e-12);
    double mse = (1.0 + 100.0 + 16.0 + 255.0 * 255.0) / 300.0;
    assert_true(fabs(d.psnr_db - 10.0 * log10(255.0 * 255.0 / mse)) < 1e-9);
    d = crt_image_compare(&a, &b, 1);
    assert_int_equal(d.pixels_differing, 2);
    assert_int_equal(d.first_x, 2);
    assert_int_equal(d.first_y, 5);
    d = crt_image_compare(&a, &b, 254);
    assert_int_equal(d.pixels_differing, 1);
    d = crt_image_compare(&a, &b, 255);
    assert_int_equal(d.pixels_differing, 0);
    assert_int_equal(d.first_x, -1);
    crt_image_free(&a);
    crt_image_free(&b);
}

static void pictures_of_other_shapes_are_not_compared(void **state)
{
    (void)state;
    struct crt_image a = picture(10, 10, 8), b = picture(10, 11, 8), c = picture(10, 10, 16), out;
    struct crt_error err = {""};
    assert_false(crt_image_compare(&a, &b, 0).same_shape);
    assert_false(crt_image_compare(&a, &c, 0).same_shape);
    assert_false(crt_image_difference_picture(&a, &b, 0, &out, &err));
    assert_non_null(strstr(err.text, "10 by 11"));
    assert_false(crt_image_difference_picture(&a, &c, 0, &out, &err));
    assert_non_null(strstr(err.text, "16 bits"));
    crt_image_free(&a);
    crt_image_free(&b);
    crt_image_free(&c);
}

static void the_difference_picture_shows_where(void **state)
{
    (void)state;
    struct crt_image a = picture(3, 1, 16), b = picture(3, 1, 16), out;
    struct crt_error err;
    a.samples[0] = b.samples[0] = 40000;
    a.samples[4] = 1000; /* differs by 1000 */
    a.samples[8] = 3;    /* differs by 3, within the tolerance */
    assert_true(crt_image_difference_picture(&a, &b, 3, &out, &err));
    const uint16_t expected[] = {10000, 0, 0, 65535, 0, 65535, 0, 0, 0};
    assert_memory_equal(out.samples, expected, sizeof expected);
    assert_int_equal(out.depth, 16);
    crt_image_free(&a);
    crt_image_free(&b);
    crt_image_free(&out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_new_picture_is_black_and_has_its_shape),
        cmocka_unit_test(impossible_sizes_are_refused),
        cmocka_unit_test(hash_is_sha256_of_shape_and_big_endian_samples),
        cmocka_unit_test(equal_pictures_do_not_differ),
        cmocka_unit_test(differences_are_counted_by_pixel),
        cmocka_unit_test(pictures_of_other_shapes_are_not_compared),
        cmocka_unit_test(the_difference_picture_shows_where),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
