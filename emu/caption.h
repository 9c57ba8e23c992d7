/* caption.h — a strip of text for a picture: black, the letters of plots, one or several texts.
 *
 * Models:     nothing.
 * Units:      pixels.
 * Ownership:  `strip` need not be initialised, is 8 bit, and the caller's to free.
 * Errors:     out of memory: one sentence. A text too wide for its place is set smaller, and cut where that is
 *             not enough.
 */
#ifndef EMU_CAPTION_H
#define EMU_CAPTION_H

#include "crt/error.h"
#include "crt/image.h"
#include "emu/quantity.h"

/* A text, centred (or at the left end) in the part of the strip that it is for. UTF-8. */
struct vm_caption {
    const char *text;
    int x, width;
    bool left;
};

/* vm_format_time() with the letter µ, and a sign where it is a difference. */
void vm_caption_time(uint64_t ps, bool difference, char *text, size_t size);


/* The size of letters that suits a picture of that height, to be read from the back of a room. */
double vm_caption_letters(int picture_height);
int vm_caption_height(double letters);

bool vm_caption_strip(const struct vm_caption *texts, int count, int width, double letters,
                      struct crt_image *strip, struct crt_error *err);

/* Two halves, a wide gap between them, what each is called above it. The strip of names is made anew, or where
 * `names` is not NULL once: kept there (samples NULL at first) for the next pictures of these sizes, and the
 * caller's to free. */
bool vm_caption_sides(const struct crt_image side[2], const char *left, const char *right,
                      struct crt_image *names, struct crt_image *out, struct crt_error *err);

#endif
