/* contact_sheet.h — a contact sheet: the pictures of a sequence in one, small, a caption each, a head line.
 *
 *      picture ─▶ linear light ─▶ mean over the area of each small pixel ─▶ its place on the sheet
 *
 * Models:     the mean of light, not of samples: a small picture is as bright as the large one from afar.
 * Units:      pixels.
 * Memory:     the sheet's own; pictures are scaled as they come.
 * Ownership:  vm_contact_sheet_open allocates, vm_contact_sheet_close frees.
 * Errors:     one sentence.
 */
#ifndef EMU_CONTACT_SHEET_H
#define EMU_CONTACT_SHEET_H

#include "crt/error.h"
#include "crt/image.h"
#include "crt/srgb.h"
#include "emu/quantity.h"

#define VM_SHEET_WIDTH 2400 /* at most, unless pictures are to keep their size */
#define VM_SHEET_MOST  4096 /* pictures */

struct vm_contact_sheet {
    struct crt_image image; /* what there is to write */
    int columns;
    struct vm_size cell;
    double letters;
    int top;
    struct crt_srgb_encoder encoder;
    double linear[256];
    double *row; /* of small pixels, light gathered so far */
    bool open;
};

/* COLUMNSxROWS, at most VM_SHEET_MOST places. */
bool vm_contact_sheet_places(const char *text, struct vm_size *places, struct crt_error *err);

/* For `count` pictures of that size in so many columns, and rows as needed. `keep`: pictures keep their
 * size. */
bool vm_contact_sheet_open(struct vm_contact_sheet *sheet, int columns, uint64_t count,
                           struct vm_size picture, bool keep, const char *heading,
                           struct crt_error *err);
/* Picture `number`, 8 bit. */
bool vm_contact_sheet_add(struct vm_contact_sheet *sheet, uint64_t number,
                          const struct crt_image *picture, const char *caption,
                          struct crt_error *err);
void vm_contact_sheet_close(struct vm_contact_sheet *sheet);

/* The mean of light: `out` (initialised, 8 bit, no larger) from `picture`. */
void vm_contact_sheet_reduce(struct vm_contact_sheet *sheet, const struct crt_image *picture,
                             struct crt_image *out);

#endif
