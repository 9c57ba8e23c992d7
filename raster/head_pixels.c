/* Pixel formats. Every format becomes words 00RRGGBB first, these the drives of the guns. */
#include "raster/head_parts.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

bool ras_format_exists(uint32_t format)
{
    return format == VIDEO_FORMAT_1 || format == VIDEO_FORMAT_2 || format == VIDEO_FORMAT_4 ||
           format == VIDEO_FORMAT_8 || format == VIDEO_FORMAT_16 || format == VIDEO_FORMAT_24 ||
           format == VIDEO_FORMAT_32;
}

uint32_t ras_format_bytes(uint32_t format, uint32_t count)
{
    return (count * format + 7) / 8; /* a format's number is its bits */
}

/* ---- pixels to colours ------------------------------------------------------------------------ */

static void read_1(const uint8_t *from, uint32_t count, const uint32_t *lut, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i += 8) {
        uint32_t b = *from++;
        for (uint32_t k = 0; k < 8; k++)
            colour[i + k] = lut[b >> (7 - k) & 1];
    }
}

static void read_2(const uint8_t *from, uint32_t count, const uint32_t *lut, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i += 4) {
        uint32_t b = *from++;
        colour[i] = lut[b >> 6];
        colour[i + 1] = lut[b >> 4 & 3];
        colour[i + 2] = lut[b >> 2 & 3];
        colour[i + 3] = lut[b & 3];
    }
}

static void read_4(const uint8_t *from, uint32_t count, const uint32_t *lut, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i += 2) {
        uint32_t b = *from++;
        colour[i] = lut[b >> 4];
        colour[i + 1] = lut[b & 15];
    }
}

static void read_8(const uint8_t *from, uint32_t count, const uint32_t *lut, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i++)
        colour[i] = lut[from[i]];
}

/* 5 and 6 bits to 8: the high bits again below, so that all ones are 255. */
static void read_16(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t p = from[2 * i] | (uint32_t)from[2 * i + 1] << 8;
        uint32_t r = p >> 11, g = p >> 5 & 63, b = p & 31;
        colour[i] = (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | b << 3 | b >> 2;
    }
}

static void read_24(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i++, from += 3)
        colour[i] = from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16;
}

static void read_32(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i++, from += 4)
        colour[i] = from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16;
}

void ras_read_pixels(uint32_t format, const uint8_t *from, uint32_t count,
                     const uint32_t lut[VIDEO_LUT_ENTRIES], uint32_t *colour)
{
    switch (format) {
    case VIDEO_FORMAT_1:
        read_1(from, count, lut, colour);
        break;
    case VIDEO_FORMAT_2:
        read_2(from, count, lut, colour);
        break;
    case VIDEO_FORMAT_4:
        read_4(from, count, lut, colour);
        break;
    case VIDEO_FORMAT_8:
        read_8(from, count, lut, colour);
        break;
    case VIDEO_FORMAT_16:
        read_16(from, count, colour);
        break;
    case VIDEO_FORMAT_24:
        read_24(from, count, colour);
        break;
    default:
        read_32(from, count, colour);
        break;
    }
}

/* ---- colours to drives ------------------------------------------------------------------------ */

#if defined(__SSE2__)
/* The low bytes of 16 words. */
static void pack_16(const __m128i w[4], int shift, uint8_t *to)
{
    const __m128i low = _mm_set1_epi32(0xff);
    __m128i v[4];
    for (int k = 0; k < 4; k++)
        v[k] = _mm_and_si128(_mm_srli_epi32(w[k], shift), low);
    __m128i bytes = _mm_packus_epi16(_mm_packs_epi32(v[0], v[1]), _mm_packs_epi32(v[2], v[3]));
    _mm_storeu_si128((__m128i *)to, bytes);
}

/* As many as make whole registers; the number done. */
static uint32_t drive_guns_fast(const uint32_t *colour, uint32_t count, uint8_t *red,
                                uint8_t *green, uint8_t *blue)
{
    uint32_t i = 0;
    for (; i + 16 <= count; i += 16) {
        __m128i w[4];
        for (int k = 0; k < 4; k++)
            w[k] = _mm_loadu_si128((const __m128i *)(colour + i + 4 * k));
        pack_16(w, 16, red + i);
        pack_16(w, 8, green + i);
        pack_16(w, 0, blue + i);
    }
    return i;
}
#else
static uint32_t drive_guns_fast(const uint32_t *colour, uint32_t count, uint8_t *red,
                                uint8_t *green, uint8_t *blue)
{
    (void)colour, (void)count, (void)red, (void)green, (void)blue;
    return 0;
}
#endif

void ras_drive_guns(const uint32_t *colour, uint32_t count, uint8_t *red, uint8_t *green,
                    uint8_t *blue)
{
    for (uint32_t i = drive_guns_fast(colour, count, red, green, blue); i < count; i++) {
        red[i] = (uint8_t)(colour[i] >> 16);
        green[i] = (uint8_t)(colour[i] >> 8);
        blue[i] = (uint8_t)colour[i];
    }
}

void ras_drive_luma(const uint32_t *colour, uint32_t count, uint8_t *luma)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t c = colour[i], r = c >> 16 & 255, g = c >> 8 & 255, b = c & 255;
        luma[i] = (uint8_t)((77 * r + 150 * g + 29 * b + 128) >> 8);
    }
}
