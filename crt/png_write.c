#define _XOPEN_SOURCE 700 /* realpath */

#include "crt/png_file.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <png.h>

/* Everything that outlives a jump out of libpng lives here, not in locals. */
struct writer {
    png_structp png;
    png_infop info;
    png_bytep row;
    FILE *out;
    char trouble[160]; /* what libpng or the file said */
};

static void on_error(png_structp png, png_const_charp message)
{
    struct writer *w = png_get_error_ptr(png);
    if (!w->trouble[0])
        snprintf(w->trouble, sizeof w->trouble, "%s", message);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void write_bytes(png_structp png, png_bytep bytes, size_t count)
{
    struct writer *w = png_get_io_ptr(png);
    errno = 0;
    if (fwrite(bytes, 1, count, w->out) != count)
        png_error(png, errno ? strerror(errno) : "the file takes no more bytes");
}

static void flush_bytes(png_structp png)
{
    (void)png;
}

static void put_texts(struct writer *w, const struct crt_png_text *texts, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        assert(texts[i].keyword[0] && strlen(texts[i].keyword) <= 79);
        png_text text = {
            .compression = PNG_TEXT_COMPRESSION_NONE,
            /* libpng copies both and changes neither. */
            .key = (png_charp)(uintptr_t)texts[i].keyword,
            .text = (png_charp)(uintptr_t)texts[i].text,
        };
        png_set_text(w->png, w->info, &text, 1);
    }
}

static void put_row(struct writer *w, const struct crt_image *image, int y)
{
    size_t count = (size_t)image->width * 3;
    const uint16_t *samples = image->samples + count * (size_t)y;
    png_bytep byte = w->row;
    for (size_t i = 0; i < count; i++) {
        if (image->depth == 16)
            *byte++ = (png_byte)(samples[i] >> 8);
        *byte++ = (png_byte)samples[i];
    }
    png_write_row(w->png, w->row);
}

static bool encode(struct writer *w, const struct crt_image *image,
                   const struct crt_png_text *texts, size_t text_count)
{
    w->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, w, on_error, on_warning);
    w->info = w->png ? png_create_info_struct(w->png) : NULL;
    w->row = malloc((size_t)image->width * 6);
    if (!w->info || !w->row) {
        snprintf(w->trouble, sizeof w->trouble, "not enough memory");
        return false;
    }
    if (setjmp(png_jmpbuf(w->png)))
        return false;
    png_set_write_fn(w->png, w, write_bytes, flush_bytes);
    png_set_user_limits(w->png, CRT_IMAGE_MAX_SIDE, CRT_IMAGE_MAX_SIDE);
    png_set_IHDR(w->png, w->info, (png_uint_32)image->width, (png_uint_32)image->height,
                 image->depth, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    png_set_sRGB_gAMA_and_cHRM(w->png, w->info, PNG_sRGB_INTENT_RELATIVE);
    put_texts(w, texts, text_count);
    /* Lines of light on black: within a tenth of the smallest file, in half the time. */
    png_set_filter(w->png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_compression_level(w->png, 3);
    png_write_info(w->png, w->info);
    for (int y = 0; y < image->height; y++)
        put_row(w, image, y);
    png_write_end(w->png, w->info);
    return true;
}

bool crt_png_write_stream(FILE *out, const char *name, const struct crt_image *image,
                          const struct crt_png_text *texts, size_t text_count,
                          struct crt_error *err)
{
    struct writer w = {.out = out};
    bool ok = encode(&w, image, texts, text_count);
    png_destroy_write_struct(&w.png, &w.info);
    free(w.row);
    errno = 0;
    if (ok && fflush(out) != 0) {
        ok = false;
        snprintf(w.trouble, sizeof w.trouble, "%s", strerror(errno));
    }
    if (!ok)
        return crt_fail(err, "%s: cannot write the picture: %s", name, w.trouble);
    return true;
}

/* Creates a new file beside `path` with the permissions a plain fopen would give. */
static FILE *open_beside(const char *path, char **temporary)
{
    size_t size = strlen(path) + 40;
    *temporary = malloc(size);
    for (int attempt = 0; *temporary && attempt < 1000; attempt++) {
        snprintf(*temporary, size, "%s.%ld-%d.tmp", path, (long)getpid(), attempt);
        int fd = open(*temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (fd >= 0) {
            FILE *out = fdopen(fd, "wb");
            if (out)
                return out;
            close(fd);
            unlink(*temporary);
            break;
        }
        if (errno != EEXIST)
            break;
    }
    free(*temporary);
    *temporary = NULL;
    return NULL;
}

static bool write_directly(const char *path, const struct crt_image *image,
                           const struct crt_png_text *texts, size_t text_count,
                           struct crt_error *err)
{
    FILE *out = fopen(path, "wb");
    if (!out)
        return crt_fail(err, "%s: cannot open it for writing: %s", path, strerror(errno));
    bool ok = crt_png_write_stream(out, path, image, texts, text_count, err);
    if (fclose(out) != 0 && ok)
        return crt_fail(err, "%s: cannot write the picture: %s", path, strerror(errno));
    return ok;
}

static bool write_and_rename(const char *path, const struct crt_image *image,
                             const struct crt_png_text *texts, size_t text_count,
                             struct crt_error *err)
{
    char *temporary;
    FILE *out = open_beside(path, &temporary);
    if (!out)
        return crt_fail(err, "%s: cannot write there: %s; choose another file with -o", path,
                        strerror(errno));
    bool ok = crt_png_write_stream(out, path, image, texts, text_count, err);
    if (fclose(out) != 0 && ok)
        ok = crt_fail(err, "%s: cannot write the picture: %s", path, strerror(errno));
    if (ok && rename(temporary, path) != 0)
        ok = crt_fail(err, "%s: cannot replace it: %s; choose another file with -o", path,
                      strerror(errno));
    if (!ok)
        unlink(temporary);
    free(temporary);
    return ok;
}

bool crt_png_write(const char *path, const struct crt_image *image,
                   const struct crt_png_text *texts, size_t text_count, struct crt_error *err)
{
    if (strcmp(path, "-") == 0)
        return crt_png_write_stream(stdout, "standard output", image, texts, text_count, err);
    struct stat status;
    bool exists = stat(path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode))
        return crt_fail(err, "%s: is a folder; name a file in it", path);
    if (exists && !S_ISREG(status.st_mode)) /* renaming would replace the device or pipe itself */
        return write_directly(path, image, texts, text_count, err);
    char *target = exists ? realpath(path, NULL) : NULL; /* keeps a symbolic link a link */
    bool ok = write_and_rename(target ? target : path, image, texts, text_count, err);
    free(target);
    return ok;
}
