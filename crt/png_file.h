/* png_file.h — pictures to and from PNG files, through libpng.
 *
 * Written:    8 or 16 bit RGB with sRGB, gAMA and cHRM chunks and tEXt chunks (keyword, text) in
 *             the order given. No date, path or library version, so the same picture gives the
 *             same samples and the same chunks.
 * Read:       any PNG of at most CRT_IMAGE_MAX_SIDE pixels a side; palette, grey and alpha are
 *             expanded to RGB (alpha over black, sample by sample), depth kept (below 8 becomes
 *             8). Samples are taken as they stand: colour profiles and gamma are not applied.
 * Ownership:  a picture read belongs to the caller (crt_image_free); it is left empty on failure.
 * Errors:     one sentence naming the file. A failed write removes nothing that existed before:
 *             the picture goes to a temporary file beside it, then is renamed (a device or pipe
 *             is written to directly). "-" is standard output.
 */
#ifndef CRT_PNG_FILE_H
#define CRT_PNG_FILE_H

#include <stddef.h>
#include <stdio.h>

#include "crt/image.h"

struct crt_png_text {
    const char *keyword, *text; /* Latin-1; keyword 1…79 characters */
};

bool crt_png_write(const char *path, const struct crt_image *image,
                   const struct crt_png_text *texts, size_t text_count, struct crt_error *err);
bool crt_png_read(const char *path, struct crt_image *image, struct crt_error *err);

/* The same for an open file, `name` in sentences; the caller closes it. */
bool crt_png_write_stream(FILE *out, const char *name, const struct crt_image *image,
                          const struct crt_png_text *texts, size_t text_count,
                          struct crt_error *err);
bool crt_png_read_stream(FILE *in, const char *name, struct crt_image *image,
                         struct crt_error *err);

#endif
