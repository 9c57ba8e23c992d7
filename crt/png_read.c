#include "crt/png_file.h"

#include <errno.h>
#include <string.h>

#include <png.h>

/* Memory one chunk of a stranger's file may claim. */
#define MAX_CHUNK_BYTES 8000000

/* Everything that outlives a jump out of libpng lives here, not in locals. */
struct reader {
    png_structp png;
    png_infop info;
    FILE *in;
    struct crt_image *image;
    struct crt_error *err;
    char trouble[160]; /* what libpng or the file said; "" when err has the sentence already */
};

static void on_error(png_structp png, png_const_charp message)
{
    struct reader *r = png_get_error_ptr(png);
    snprintf(r->trouble, sizeof r->trouble, "%s", message);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void read_bytes(png_structp png, png_bytep bytes, size_t count)
{
    struct reader *r = png_get_io_ptr(png);
    errno = 0;
    if (fread(bytes, 1, count, r->in) != count)
        png_error(png, ferror(r->in) ? strerror(errno) : "it ends too early");
}

/* Asks libpng for rows of 16-bit R, G, B in the host's byte order, whatever the file holds. */
static void ask_for_rgb16(struct reader *r)
{
    const uint16_t one = 1;
    const png_color_16 black = {0, 0, 0, 0, 0};
    png_set_expand_16(r->png); /* palette, grey and transparent colour too */
    png_set_gray_to_rgb(r->png);
    png_set_background(r->png, &black, PNG_BACKGROUND_GAMMA_SCREEN, 0, 1.0);
    if (*(const uint8_t *)&one == 1)
        png_set_swap(r->png);
}

static bool read_header(struct reader *r, const char *name)
{
    png_uint_32 width, height;
    int bits, colour;
    png_read_info(r->png, r->info);
    png_get_IHDR(r->png, r->info, &width, &height, &bits, &colour, NULL, NULL, NULL);
    if (width > CRT_IMAGE_MAX_SIDE || height > CRT_IMAGE_MAX_SIDE)
        return crt_fail(r->err, "%s: %lu by %lu pixels are too many; each side may be 1 to %d",
                        name, (unsigned long)width, (unsigned long)height, CRT_IMAGE_MAX_SIDE);
    return crt_image_init(r->image, (int)width, (int)height, bits == 16 ? 16 : 8, r->err);
}

static void read_rows(struct reader *r)
{
    ask_for_rgb16(r);
    int passes = png_set_interlace_handling(r->png);
    png_read_update_info(r->png, r->info);
    size_t row = (size_t)r->image->width * 3;
    if (png_get_rowbytes(r->png, r->info) != row * sizeof *r->image->samples)
        png_error(r->png, "its rows are of an unknown kind");
    for (int pass = 0; pass < passes; pass++)
        for (int y = 0; y < r->image->height; y++)
            png_read_row(r->png, (png_bytep)(r->image->samples + row * (size_t)y), NULL);
    png_read_end(r->png, NULL);
}

static bool decode(struct reader *r, const char *name)
{
    r->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, r, on_error, on_warning);
    r->info = r->png ? png_create_info_struct(r->png) : NULL;
    if (!r->info)
        return crt_fail(r->err, "%s: not enough memory to read it", name);
    if (setjmp(png_jmpbuf(r->png)))
        return crt_fail(r->err, "%s: not a PNG that can be read: %s", name, r->trouble);
    png_set_read_fn(r->png, r, read_bytes);
    png_set_user_limits(r->png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); /* read_header has its own */
    png_set_chunk_malloc_max(r->png, MAX_CHUNK_BYTES);
    if (!read_header(r, name))
        return false;
    read_rows(r);
    return true;
}

/* 8-bit samples s came as 257·s. */
static void narrow(struct crt_image *image)
{
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++)
        image->samples[i] = (uint16_t)(image->samples[i] >> 8);
}

bool crt_png_read_stream(FILE *in, const char *name, struct crt_image *image, struct crt_error *err)
{
    struct reader r = {.in = in, .image = image, .err = err};
    *image = (struct crt_image){0};
    bool ok = decode(&r, name);
    png_destroy_read_struct(&r.png, &r.info, NULL);
    if (!ok)
        crt_image_free(image);
    else if (image->depth == 8)
        narrow(image);
    return ok;
}

bool crt_png_read(const char *path, struct crt_image *image, struct crt_error *err)
{
    *image = (struct crt_image){0};
    FILE *in = fopen(path, "rb");
    if (!in)
        return crt_fail(err, "%s: cannot open it: %s", path, strerror(errno));
    bool ok = crt_png_read_stream(in, path, image, err);
    fclose(in);
    return ok;
}
