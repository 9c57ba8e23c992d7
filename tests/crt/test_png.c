/* PNG files: what is written is read back the same; files of every kind made with libpng's own
 * calls are read as their definition says; broken and hostile files give a sentence. */
#define _XOPEN_SOURCE 700
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>
#include <png.h>

#include "crt/png_file.h"
#include "tests/support/png_crc.h"

/* A file in memory. */
struct bytes {
    uint8_t *data;
    size_t count;
};

static char folder[256];

static int make_folder(void **state)
{
    (void)state;
    const char *out = getenv("TEST_OUT");
    snprintf(folder, sizeof folder, "%s/pngXXXXXX", out ? out : "/tmp");
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    return rmdir(folder); /* fails when a test left a file behind */
}

static const char *in_folder(const char *name)
{
    static char path[300];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static struct crt_image noise(int width, int height, int depth)
{
    struct crt_image image;
    struct crt_error err;
    assert_true(crt_image_init(&image, width, height, depth, &err));
    uint32_t seed = (uint32_t)(width * 31 + height);
    for (int i = 0; i < width * height * 3; i++) {
        seed = seed * 1664525u + 1013904223u;
        image.samples[i] = (uint16_t)(depth == 8 ? seed >> 24 : seed >> 16);
    }
    return image;
}

static struct bytes written(const struct crt_image *image, const struct crt_png_text *texts,
                            size_t text_count)
{
    char *data;
    size_t count;
    struct crt_error err = {""};
    FILE *out = open_memstream(&data, &count);
    assert_true(crt_png_write_stream(out, "memory", image, texts, text_count, &err));
    fclose(out);
    return (struct bytes){(uint8_t *)data, count};
}

static bool read_bytes(const uint8_t *data, size_t count, struct crt_image *image,
                       struct crt_error *err)
{
    /* fmemopen refuses no bytes at all. */
    FILE *in = count ? fmemopen((void *)(uintptr_t)data, count, "rb") : fopen("/dev/null", "rb");
    bool ok = crt_png_read_stream(in, "memory", image, err);
    fclose(in);
    if (!ok)
        assert_null(image->samples);
    return ok;
}

static void pictures_survive_a_round_trip(void **state)
{
    (void)state;
    const int sizes[][2] = {{1, 1}, {7, 3}, {64, 1}, {1, 65}, {200, 133}};
    for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++)
        for (int depth = 8; depth <= 16; depth += 8) {
            struct crt_image in = noise(sizes[s][0], sizes[s][1], depth), out;
            struct crt_error err = {""};
            const char *path = in_folder("trip.png");
            assert_true(crt_png_write(path, &in, NULL, 0, &err));
            assert_true(crt_png_read(path, &out, &err));
            assert_int_equal(unlink(path), 0);
            struct crt_image_difference d = crt_image_compare(&in, &out, 0);
            assert_true(d.same_shape);
            assert_int_equal(d.max_difference, 0);
            crt_image_free(&in);
            crt_image_free(&out);
        }
}

/* Lists the chunks of a PNG in order, IDAT once; also checks each length. */
static void chunk_names(struct bytes png, char *names, size_t size)
{
    names[0] = '\0';
    for (size_t at = 8; at + 12 <= png.count;) {
        const uint8_t *c = png.data + at;
        size_t length = (size_t)c[0] << 24 | (size_t)c[1] << 16 | (size_t)c[2] << 8 | c[3];
        char name[6] = {(char)c[4], (char)c[5], (char)c[6], (char)c[7], ' ', '\0'};
        if (strcmp(name, "IDAT ") != 0 || !strstr(names, "IDAT "))
            strncat(names, name, size - strlen(names) - 1);
        at += 12 + length;
        assert_true(at <= png.count);
    }
}

static void the_chunks_are_these(void **state)
{
    (void)state;
    const struct crt_png_text texts[] = {{"Title", "card"}, {"Tube", "VR17"}, {"Time", "0.5 s"}};
    struct crt_image image = noise(20, 20, 16);
    struct bytes png = written(&image, texts, 3), again = written(&image, texts, 3);
    char names[200];
    chunk_names(png, names, sizeof names);
    /* libpng's versions order the colour chunks differently. */
    const char *const wanted[] = {"gAMA ", "cHRM ", "sRGB ", "tEXt tEXt tEXt IDAT IEND "};
    for (int i = 0; i < 4; i++)
        assert_non_null(strstr(names, wanted[i]));
    assert_int_equal(strlen(names), strlen("IHDR gAMA cHRM sRGB tEXt tEXt tEXt IDAT IEND "));
    assert_int_equal(png.count, again.count);
    assert_memory_equal(png.data, again.data, png.count);

    /* Read back by libpng itself. */
    png_structp p = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(p);
    FILE *in = fmemopen(png.data, png.count, "rb");
    png_init_io(p, in);
    png_read_info(p, info);
    double gamma, wx, wy, rx, ry, gx, gy, bx, by;
    int intent, count;
    png_textp text;
    assert_true(png_get_sRGB(p, info, &intent));
    assert_true(png_get_gAMA(p, info, &gamma));
    assert_true(gamma > 0.45454 && gamma < 0.45456);
    assert_true(png_get_cHRM(p, info, &wx, &wy, &rx, &ry, &gx, &gy, &bx, &by));
    assert_true(wx > 0.3126 && wx < 0.3128 && gy > 0.5999 && gy < 0.6001);
    assert_int_equal(png_get_text(p, info, &text, &count), 3);
    for (int i = 0; i < 3; i++) {
        assert_string_equal(text[i].key, texts[i].keyword);
        assert_string_equal(text[i].text, texts[i].text);
    }
    png_destroy_read_struct(&p, &info, NULL);
    fclose(in);
    free(png.data);
    free(again.data);
    crt_image_free(&image);
}

/* What ImageMagick makes of our file, where it is installed: the samples as big-endian bytes. */
static void imagemagick_reads_the_same_samples(void **state)
{
    (void)state;
    for (int depth = 8; depth <= 16; depth += 8) {
        struct crt_image image = noise(31, 17, depth);
        struct crt_error err = {""};
        const char *path = in_folder("magick.png");
        assert_true(crt_png_write(path, &image, NULL, 0, &err));
        char command[400];
        snprintf(command, sizeof command,
                 "command -v convert >/dev/null && convert '%s' -depth %d -endian MSB rgb:-", path,
                 depth);
        FILE *in = popen(command, "r");
        assert_non_null(in);
        uint8_t got[31 * 17 * 6 + 1];
        size_t count = fread(got, 1, sizeof got, in), samples = 31 * 17 * 3;
        pclose(in);
        unlink(path);
        if (count == 0)
            print_message("# ImageMagick is not installed; nothing compared\n");
        else
            assert_int_equal(count, samples * (size_t)depth / 8);
        for (size_t i = 0; count && i < samples; i++)
            assert_int_equal(depth == 8 ? got[i] : got[2 * i] << 8 | got[2 * i + 1],
                             image.samples[i]);
        crt_image_free(&image);
    }
}

#define W 13
#define H 9

/* The k-th raw sample of pixel (x, y) of the test files, `bits` bits wide. */
static unsigned raw_sample(int x, int y, int k, int bits)
{
    uint32_t h = (uint32_t)(x * 73856093) ^ (uint32_t)(y * 19349663) ^ (uint32_t)(k * 83492791);
    h = (h ^ h >> 13) * 0x5bd1e995u;
    return (h >> 8) & ((1u << bits) - 1u);
}

static void pack_row(uint8_t *row, int y, int channels, int bits)
{
    memset(row, 0, W * 8);
    for (int x = 0, bit = 0; x < W; x++)
        for (int k = 0; k < channels; k++, bit += bits) {
            unsigned s = raw_sample(x, y, k, bits);
            if (bits == 16) {
                row[bit / 8] = (uint8_t)(s >> 8);
                row[bit / 8 + 1] = (uint8_t)s;
            } else {
                row[bit / 8] |= (uint8_t)(s << (8 - bits - bit % 8));
            }
        }
}

static struct bytes made_file(int colour, int bits, int interlace, bool transparent)
{
    char *data;
    size_t count;
    FILE *out = open_memstream(&data, &count);
    png_structp p = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(p);
    png_init_io(p, out);
    png_set_IHDR(p, info, W, H, bits, colour, interlace, 0, 0);
    png_color palette[256];
    for (int i = 0; i < 256; i++)
        palette[i] = (png_color){(png_byte)(i * 3), (png_byte)(i * 5 + 1), (png_byte)(255 - i)};
    if (colour == PNG_COLOR_TYPE_PALETTE)
        png_set_PLTE(p, info, palette, 1 << bits);
    png_byte alphas[2] = {0, 128};
    unsigned s = raw_sample(4, 4, 0, bits);
    png_color_16 clear = {0, (png_uint_16)s, (png_uint_16)raw_sample(4, 4, 1, bits),
                          (png_uint_16)raw_sample(4, 4, 2, bits), (png_uint_16)s};
    if (transparent)
        png_set_tRNS(p, info, alphas, colour == PNG_COLOR_TYPE_PALETTE ? 2 : 0, &clear);
    png_write_info(p, info);
    int channels = png_get_channels(p, info), passes = png_set_interlace_handling(p);
    uint8_t row[W * 8];
    for (int pass = 0; pass < passes; pass++)
        for (int y = 0; y < H; y++) {
            pack_row(row, y, channels, bits);
            png_write_row(p, row);
        }
    png_write_end(p, info);
    png_destroy_write_struct(&p, &info);
    fclose(out);
    return (struct bytes){(uint8_t *)data, count};
}

/* What the pixel must read as, from the definition of the format. */
static void expected_pixel(int x, int y, int colour, int bits, bool transparent, double rgb[3])
{
    double full = bits == 16 ? 65535.0 : 255.0, alpha = 1.0;
    double to_full = full / ((1 << bits) - 1);
    unsigned s[4];
    for (int k = 0; k < 4; k++)
        s[k] = raw_sample(x, y, k, bits);
    if (colour == PNG_COLOR_TYPE_PALETTE) {
        rgb[0] = (uint8_t)(s[0] * 3);
        rgb[1] = (uint8_t)(s[0] * 5 + 1);
        rgb[2] = 255 - s[0];
        if (transparent && s[0] < 2)
            alpha = s[0] == 0 ? 0.0 : 128.0 / 255.0;
    } else if (colour & PNG_COLOR_MASK_COLOR) {
        for (int k = 0; k < 3; k++)
            rgb[k] = s[k] * to_full;
        if (colour & PNG_COLOR_MASK_ALPHA)
            alpha = s[3] / full;
        if (transparent && s[0] == raw_sample(4, 4, 0, bits) && s[1] == raw_sample(4, 4, 1, bits) &&
            s[2] == raw_sample(4, 4, 2, bits))
            alpha = 0.0;
    } else {
        rgb[0] = rgb[1] = rgb[2] = s[0] * to_full;
        if (colour & PNG_COLOR_MASK_ALPHA)
            alpha = s[1] / full;
        if (transparent && s[0] == raw_sample(4, 4, 0, bits))
            alpha = 0.0;
    }
    for (int k = 0; k < 3; k++)
        rgb[k] *= alpha;
}

static void expect_file(int colour, int bits, int interlace, bool transparent)
{
    struct bytes png = made_file(colour, bits, interlace, transparent);
    struct crt_image image;
    struct crt_error err = {""};
    if (!read_bytes(png.data, png.count, &image, &err))
        fail_msg("colour %d, %d bits, interlace %d: %s", colour, bits, interlace, err.text);
    assert_int_equal(image.width, W);
    assert_int_equal(image.height, H);
    assert_int_equal(image.depth, bits == 16 ? 16 : 8);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            double rgb[3];
            expected_pixel(x, y, colour, bits, transparent, rgb);
            for (int k = 0; k < 3; k++) {
                double off = image.samples[3 * (y * W + x) + k] - rgb[k];
                if (off < -0.51 || off > 0.51)
                    fail_msg("colour %d, %d bits, interlace %d, transparent %d: (%d,%d).%d is %d, "
                             "not %g",
                             colour, bits, interlace, transparent, x, y, k,
                             image.samples[3 * (y * W + x) + k], rgb[k]);
            }
        }
    crt_image_free(&image);
    free(png.data);
}

static void every_kind_of_png_is_read(void **state)
{
    (void)state;
    const struct {
        int colour, bits;
    } kinds[] = {{0, 1}, {0, 2}, {0, 4}, {0, 8}, {0, 16}, {2, 8}, {2, 16}, {3, 1},
                 {3, 2}, {3, 4}, {3, 8}, {4, 8}, {4, 16}, {6, 8}, {6, 16}};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        for (int interlace = 0; interlace < 2; interlace++) {
            expect_file(kinds[i].colour, kinds[i].bits, interlace, false);
            if (!(kinds[i].colour & PNG_COLOR_MASK_ALPHA))
                expect_file(kinds[i].colour, kinds[i].bits, interlace, true);
        }
}

static void cut_files_are_refused(void **state)
{
    (void)state;
    for (int interlace = 0; interlace < 2; interlace++) {
        struct bytes png = made_file(6, 16, interlace, false);
        for (size_t n = 0; n < png.count; n++) {
            struct crt_image image;
            struct crt_error err = {""};
            assert_false(read_bytes(png.data, n, &image, &err));
            assert_memory_equal(err.text, "memory: ", 8);
        }
        free(png.data);
    }
}

static void damaged_files_are_refused_or_read_whole(void **state)
{
    (void)state;
    struct bytes png = made_file(3, 4, 1, true);
    unsigned refused = 0;
    for (size_t i = 0; i < png.count * 8; i++) {
        struct crt_image image;
        struct crt_error err = {""};
        png.data[i / 8] ^= (uint8_t)(1u << i % 8);
        /* A bit of a chunk's name may make it one that a reader skips. */
        if (read_bytes(png.data, png.count, &image, &err)) {
            assert_int_equal(image.width, W);
            crt_image_free(&image);
        } else {
            refused++;
        }
        png.data[i / 8] ^= (uint8_t)(1u << i % 8);
    }
    assert_true(refused > png.count * 8 / 2);
    free(png.data);
}

static void put_number(uint8_t *at, uint32_t n)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(n >> (24 - 8 * i));
}

static void giant_and_empty_sizes_are_refused(void **state)
{
    (void)state;
    struct bytes png = made_file(2, 8, 0, false);
    const uint32_t sizes[][2] = {
        {0, 5},          {5, 0},         {16385, 1}, {1, 16385}, {0x7fffffff, 0x7fffffff},
        {0xffffffff, 1}, {0x40000000, 4}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct crt_image image;
        struct crt_error err = {""};
        put_number(png.data + 16, sizes[i][0]);
        put_number(png.data + 20, sizes[i][1]);
        put_number(png.data + 29, png_crc(png.data + 12, 17));
        assert_false(read_bytes(png.data, png.count, &image, &err));
    }
    /* The largest allowed, cut short: refused for its missing rows. */
    struct crt_image image;
    struct crt_error err = {""};
    put_number(png.data + 16, 16384);
    put_number(png.data + 20, 1024);
    put_number(png.data + 29, png_crc(png.data + 12, 17));
    assert_false(read_bytes(png.data, png.count, &image, &err));
    assert_non_null(strstr(err.text, "not a PNG that can be read"));
    free(png.data);
}

static void trouble_with_files_is_one_sentence(void **state)
{
    (void)state;
    struct crt_image image, picture = noise(50, 50, 8);
    struct crt_error err;
    assert_false(crt_png_read("/nonexistent/x.png", &image, &err));
    assert_string_equal(err.text, "/nonexistent/x.png: cannot open it: No such file or directory");
    assert_false(crt_png_read("/", &image, &err));
    assert_non_null(strstr(err.text, "Is a directory"));
    assert_false(crt_png_read("/dev/null", &image, &err));
    assert_non_null(strstr(err.text, "ends too early"));
    assert_false(crt_png_write("/nonexistent/x.png", &picture, NULL, 0, &err));
    assert_non_null(strstr(err.text, "/nonexistent/x.png: cannot write there: No such file"));
    assert_false(crt_png_write("/", &picture, NULL, 0, &err));
    assert_non_null(strstr(err.text, "is a folder"));
    assert_false(crt_png_write("/dev/full", &picture, NULL, 0, &err));
    assert_non_null(strstr(err.text, "/dev/full: cannot write the picture: No space left"));
    assert_true(crt_png_write("/dev/null", &picture, NULL, 0, &err)); /* stays a device */
    struct stat status;
    assert_true(stat("/dev/null", &status) == 0 && S_ISCHR(status.st_mode));
    crt_image_free(&picture);
}

static void a_failed_write_leaves_the_old_file(void **state)
{
    (void)state;
    const char *path = in_folder("kept.png");
    struct crt_image small = noise(4, 4, 8), large = noise(300, 300, 16), got;
    struct crt_error err = {""};
    assert_true(crt_png_write(path, &small, NULL, 0, &err));
    struct rlimit old, tight;
    getrlimit(RLIMIT_FSIZE, &old);
    tight = old;
    tight.rlim_cur = 20000;
    void (*was)(int) = signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tight);
    bool ok = crt_png_write(path, &large, NULL, 0, &err);
    setrlimit(RLIMIT_FSIZE, &old);
    signal(SIGXFSZ, was);
    assert_false(ok);
    assert_non_null(strstr(err.text, "kept.png: cannot write the picture: File too large"));
    assert_true(crt_png_read(path, &got, &err));
    assert_int_equal(crt_image_compare(&small, &got, 0).max_difference, 0);
    crt_image_free(&got);
    /* Written through a symbolic link, the link stays. */
    char link_path[300];
    snprintf(link_path, sizeof link_path, "%s/link.png", folder);
    assert_int_equal(symlink("kept.png", link_path), 0);
    assert_true(crt_png_write(link_path, &large, NULL, 0, &err));
    struct stat status;
    assert_true(lstat(link_path, &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(crt_png_read(path, &got, &err));
    assert_int_equal(got.width, 300);
    crt_image_free(&got);
    unlink(link_path);
    unlink(path);
    crt_image_free(&small);
    crt_image_free(&large);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_survive_a_round_trip),
        cmocka_unit_test(the_chunks_are_these),
        cmocka_unit_test(imagemagick_reads_the_same_samples),
        cmocka_unit_test(every_kind_of_png_is_read),
        cmocka_unit_test(cut_files_are_refused),
        cmocka_unit_test(damaged_files_are_refused_or_read_whole),
        cmocka_unit_test(giant_and_empty_sizes_are_refused),
        cmocka_unit_test(trouble_with_files_is_one_sentence),
        cmocka_unit_test(a_failed_write_leaves_the_old_file),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
