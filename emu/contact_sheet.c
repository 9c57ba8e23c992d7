#include "emu/contact_sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "emu/caption.h"
#include "emu/side.h"

#define GAP 10

bool vm_contact_sheet_places(const char *text, struct vm_size *places, struct crt_error *err)
{
    int used = 0;
    bool digits = strspn(text, "0123456789x") == strlen(text) && strlen(text) < 12;
    if (!digits || sscanf(text, "%4dx%4d%n", &places->width, &places->height, &used) != 2 ||
        text[used] || places->width < 1 || places->height < 1)
        return crt_fail(err, "--sheet: '%.60s' is not COLUMNSxROWS, such as 8x4", text);
    return (int64_t)places->width * places->height <= VM_SHEET_MOST ||
           crt_fail(err, "--sheet: %dx%d are more than %d pictures", places->width, places->height,
                    VM_SHEET_MOST);
}

/* ---- scaling ------------------------------------------------------------------------------------
 */

/* Adds a line of the picture, weighted, to the small pixels' light: each gets what of it lies over it. */
static void add_line(struct vm_contact_sheet *s, const uint16_t *samples, int width, int small,
                     double weight)
{
    double scale = (double)small / width;
    for (int x = 0; x < width; x++) {
        double from = x * scale, to = from + scale;
        int first = (int)from, last = (int)to;
        double share = last > first ? (last - from) / scale : 1;
        for (int c = 0; c < 3; c++) {
            double light = s->linear[samples[3 * x + c]] * weight * scale;
            s->row[3 * first + c] += light * share;
            if (last > first && last < small)
                s->row[3 * last + c] += light * (1 - share);
        }
    }
}

void vm_contact_sheet_reduce(struct vm_contact_sheet *s, const struct crt_image *picture,
                             struct crt_image *out)
{
    double scale = (double)out->height / picture->height;
    for (int y = 0; y < out->height; y++) {
        memset(s->row, 0, (size_t)out->width * 3 * sizeof *s->row);
        int first = (int)floor(y / scale), last = (int)ceil((y + 1) / scale);
        for (int line = first; line < last && line < picture->height; line++) {
            double from = fmax(line * scale, y), to = fmin((line + 1) * scale, y + 1);
            if (to > from)
                add_line(s, picture->samples + (size_t)line * (size_t)picture->width * 3,
                         picture->width, out->width, to - from);
        }
        uint16_t *to = out->samples + (size_t)y * (size_t)out->width * 3;
        for (int i = 0; i < 3 * out->width; i++)
            to[i] = crt_srgb_sample(&s->encoder, s->row[i], 255);
    }
}

/* The standard's curve (IEC 61966-2-1), the other way. */
static double decoded(double v)
{
    return v <= 0.04045 ? v / 12.92 : crt_pow((v + 0.055) / 1.055, 2.4);
}

/* ---- the sheet ----------------------------------------------------------------------------------
 */

static void plan(struct vm_contact_sheet *s, int columns, struct vm_size picture, bool keep)
{
    int most = (VM_SHEET_WIDTH - (columns + 1) * GAP) / columns;
    s->columns = columns;
    s->cell = picture;
    if (!keep && picture.width > most) {
        s->cell.width = most > 16 ? most : 16;
        s->cell.height =
            (int)fmax(8, round((double)picture.height * s->cell.width / picture.width));
    }
    s->letters = fmin(fmax(s->cell.width / 13.0, 11), 28);
}

static int pitch_y(const struct vm_contact_sheet *s)
{
    return s->cell.height + vm_caption_height(s->letters) + GAP;
}

static bool head(struct vm_contact_sheet *s, const char *heading, struct crt_error *err)
{
    struct crt_image strip;
    const struct vm_caption caption = {heading, GAP, s->image.width - 2 * GAP, true};
    if (!vm_caption_strip(&caption, 1, s->image.width, s->letters * 1.25, &strip, err))
        return false;
    vm_image_place(&strip, 0, GAP / 2, &s->image);
    crt_image_free(&strip);
    return true;
}

bool vm_contact_sheet_open(struct vm_contact_sheet *s, int columns, uint64_t count,
                           struct vm_size picture, bool keep, const char *heading,
                           struct crt_error *err)
{
    *s = (struct vm_contact_sheet){.columns = columns};
    if ((uint64_t)columns > count)
        columns = (int)count;
    plan(s, columns, picture, keep);
    int rows = (int)((count + (uint64_t)columns - 1) / (uint64_t)columns);
    s->top = GAP + vm_caption_height(s->letters * 1.25);
    if (!crt_image_init(&s->image, GAP + columns * (s->cell.width + GAP),
                        s->top + rows * pitch_y(s), 8, err))
        return false;
    s->open = true;
    s->row = malloc((size_t)s->cell.width * 3 * sizeof *s->row);
    if (!s->row)
        return crt_fail(err, "not enough memory for the sheet");
    crt_srgb_encoder_init(&s->encoder);
    for (int i = 0; i < 256; i++)
        s->linear[i] = decoded(i / 255.0);
    return head(s, heading, err);
}

/* A dim line around a picture, in the gap: where a dark picture ends. */
static void outline(struct crt_image *image, int x, int y, struct vm_size size)
{
    const uint16_t dim = 44;
    for (int row = y - 1; row <= y + size.height; row++)
        for (int column = x - 1; column <= x + size.width; column++) {
            bool edge = row < y || row == y + size.height || column < x || column == x + size.width;
            uint16_t *p =
                image->samples + ((size_t)row * (size_t)image->width + (size_t)column) * 3;
            for (int c = 0; edge && c < 3; c++)
                p[c] = dim;
        }
}

bool vm_contact_sheet_add(struct vm_contact_sheet *s, uint64_t number,
                          const struct crt_image *picture, const char *caption,
                          struct crt_error *err)
{
    struct crt_image small, strip;
    int x = GAP + (int)(number % (uint64_t)s->columns) * (s->cell.width + GAP);
    int y = s->top + (int)(number / (uint64_t)s->columns) * pitch_y(s);
    if (!crt_image_init(&small, s->cell.width, s->cell.height, 8, err))
        return false;
    vm_contact_sheet_reduce(s, picture, &small);
    vm_image_place(&small, x, y, &s->image);
    crt_image_free(&small);
    outline(&s->image, x, y, s->cell);
    const struct vm_caption text = {caption, 0, s->cell.width, false};
    if (!vm_caption_strip(&text, 1, s->cell.width, s->letters, &strip, err))
        return false;
    vm_image_place(&strip, x, y + s->cell.height + 1, &s->image);
    crt_image_free(&strip);
    return true;
}

void vm_contact_sheet_close(struct vm_contact_sheet *s)
{
    if (s->open)
        crt_image_free(&s->image);
    free(s->row);
    s->row = NULL;
    s->open = false;
}
