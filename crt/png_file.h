/* png_file.h — pictures to and from PNG files, through libpng.
 *
 * Written:    8 or 16 bit RGB with sRGB, gAMA and cHRM chunks and tEXt chunks (keyword, text) in the order
 *             given. No date, path or library version, so the same picture gives the same samples and
 *             the same chunks.
 * Read:       any PNG; palette, grey and alpha are expanded to RGB (alpha over black), depth kept.
 * Errors:     one sentence naming the file. A failed write removes nothing that existed before: the picture
 *             goes to a temporary file beside it, then is renamed. "-" is standard output.
 */
#ifndef CRT_PNG_FILE_H
#define CRT_PNG_FILE_H

#include <stddef.h>

#include "crt/image.h"

struct crt_png_text {
    const char *keyword, *text; /* Latin-1; keyword 1…79 characters */
};

bool crt_png_write(const char *path, const struct crt_image *image, const struct crt_png_text *texts,
                   size_t text_count, struct crt_error *err);
bool crt_png_read(const char *path, struct crt_image *image, struct crt_error *err);

#endif
