#include "emu/caption.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "emu/plot/letters.h"
#include "emu/side.h"

#define SHARE    30.0 /* letters' height in a picture's height */
#define SMALLEST 9.0

#define SIDES_GAP (2 * VM_SIDE_GAP) /* wider than between the two tubes of one machine */

static const struct vm_rgb paper_white = {235, 235, 225};

double vm_caption_letters(int picture_height)
{
    double letters = picture_height / SHARE;
    return letters > 14 ? letters : 14;
}

int vm_caption_height(double letters)
{
    return (int)ceil(letters * 1.5);
}

void vm_caption_time(uint64_t ps, bool difference, char *text, size_t size)
{
    char plain[40];
    vm_format_time(ps, plain, sizeof plain);
    size_t n = strlen(plain);
    bool micro = n > 2 && plain[n - 2] == 'u';
    if (micro)
        plain[n - 2] = '\0';
    snprintf(text, size, "%s%s%s", difference ? "+" : "", ps ? plain : "0",
             micro ? "\xC2\xB5s" : "");
}

/* Cuts letters off the end, whole ones, until the text is no wider. */
static void cut(struct vm_type type, char *text, double width)
{
    size_t n = strlen(text);
    while (n > 0 && vm_text_width(type, text) > width) {
        do
            n--;
        while (n > 0 && ((unsigned char)text[n] & 0xC0) == 0x80);
        text[n] = '\0';
    }
}

/* The size at which every text fits: those of one strip are of one size. */
static double common_size(const struct vm_caption *texts, int count, double letters)
{
    double size = letters;
    for (int i = 0; i < count; i++) {
        double wide = vm_text_width((struct vm_type){letters, 1}, texts[i].text);
        double room = texts[i].width - letters;
        if (wide > room)
            size = fmin(size, letters * room / wide);
    }
    return fmax(size, SMALLEST);
}

static void draw(struct vm_ink *ink, const struct vm_caption *caption, double size, int height)
{
    char text[512];
    struct vm_type type = {size, 1};
    snprintf(text, sizeof text, "%s", caption->text);
    cut(type, text, caption->width - size / 2);
    double width = vm_text_width(type, text);
    double x = caption->left ? size / 4 : (caption->width - width) / 2;
    vm_text_draw(ink, type, caption->x + x, height / 2.0 + VM_CAPITALS * size / 2, false, text,
                 paper_white);
}

bool vm_caption_strip(const struct vm_caption *texts, int count, int width, double letters,
                      struct crt_image *strip, struct crt_error *err)
{
    struct vm_ink ink;
    int height = vm_caption_height(letters);
    if (!crt_image_init(strip, width, height, 8, err))
        return false;
    if (!vm_ink_open(&ink, strip, err)) {
        crt_image_free(strip);
        return false;
    }
    double size = common_size(texts, count, letters);
    for (int i = 0; i < count; i++)
        draw(&ink, &texts[i], size, height);
    vm_ink_close(&ink);
    return true;
}

bool vm_caption_sides(const struct crt_image side[2], const char *left, const char *right,
                      struct crt_image *names, struct crt_image *out, struct crt_error *err)
{
    struct crt_image halves, strip = {0}, *kept = names ? names : &strip;
    if (!vm_side_by_side_apart(&side[0], &side[1], SIDES_GAP, &halves, err))
        return false;
    const struct vm_caption text[] = {{left, 0, side[0].width, false},
                                      {right, halves.width - side[1].width, side[1].width, false}};
    bool ok = kept->samples ||
              vm_caption_strip(text, 2, halves.width, vm_caption_letters(halves.height), kept, err);
    ok = ok && vm_above(kept, &halves, out, err);
    crt_image_free(&halves);
    if (strip.samples)
        crt_image_free(&strip);
    return ok;
}
