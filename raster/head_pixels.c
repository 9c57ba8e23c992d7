/* Pixel formats. Every format becomes words xxRRGGBB first (x: anything), these the drives of
 * the guns. The fast ways use whole numbers only, so drives are the same on every processor. */
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
        colour[i] = lut[b >> 7];
        colour[i + 1] = lut[b >> 6 & 1];
        colour[i + 2] = lut[b >> 5 & 1];
        colour[i + 3] = lut[b >> 4 & 1];
        colour[i + 4] = lut[b >> 3 & 1];
        colour[i + 5] = lut[b >> 2 & 1];
        colour[i + 6] = lut[b >> 1 & 1];
        colour[i + 7] = lut[b & 1];
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
static uint32_t spread_16(uint32_t p)
{
    return (p << 8 & 0xf80000) | (p << 3 & 0x070000) | (p << 5 & 0xfc00) | (p >> 1 & 0x0300) |
           (p << 3 & 0xf8) | (p >> 2 & 0x07);
}

#if defined(__SSE2__)
static __m128i spread_16_fast(__m128i p)
{
#define PART(shifted, mask) _mm_and_si128(shifted, _mm_set1_epi32(mask))
    __m128i r =
        _mm_or_si128(PART(_mm_slli_epi32(p, 8), 0xf80000), PART(_mm_slli_epi32(p, 3), 0x070000));
    __m128i g =
        _mm_or_si128(PART(_mm_slli_epi32(p, 5), 0xfc00), PART(_mm_srli_epi32(p, 1), 0x0300));
    __m128i b = _mm_or_si128(PART(_mm_slli_epi32(p, 3), 0xf8), PART(_mm_srli_epi32(p, 2), 0x07));
#undef PART
    return _mm_or_si128(_mm_or_si128(r, g), b);
}

/* As many as make whole registers; the number done. */
static uint32_t read_16_fast(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    const __m128i zero = _mm_setzero_si128();
    uint32_t i = 0;
    for (; i + 8 <= count; i += 8) {
        __m128i p = _mm_loadu_si128((const __m128i *)(from + 2 * i));
        __m128i *to = (__m128i *)(colour + i);
        _mm_storeu_si128(to, spread_16_fast(_mm_unpacklo_epi16(p, zero)));
        _mm_storeu_si128(to + 1, spread_16_fast(_mm_unpackhi_epi16(p, zero)));
    }
    return i;
}
#else
static uint32_t read_16_fast(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    (void)from, (void)count, (void)colour;
    return 0;
}
#endif

static void read_16(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    for (uint32_t i = read_16_fast(from, count, colour); i < count; i++)
        colour[i] = spread_16(from[2 * i] | (uint32_t)from[2 * i + 1] << 8);
}

/* One load on little-endian hosts. */
static uint32_t four_bytes(const uint8_t *from)
{
    return from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16 | (uint32_t)from[3] << 24;
}

static void read_24(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    for (uint32_t i = 0; i + 1 < count; i++, from += 3)
        colour[i] = four_bytes(from);
    colour[count - 1] = from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16;
}

static void read_32(const uint8_t *from, uint32_t count, uint32_t *colour)
{
    for (uint32_t i = 0; i < count; i++, from += 4)
        colour[i] = four_bytes(from);
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
static void load_16(__m128i w[4], const uint32_t *colour)
{
    for (int k = 0; k < 4; k++)
        w[k] = _mm_loadu_si128((const __m128i *)(colour + 4 * k));
}

static void store(uint8_t *to, __m128i bytes)
{
    _mm_storeu_si128((__m128i *)to, bytes);
}

/* Luma of 4 words. */
static __m128i weigh_4(__m128i w)
{
    const __m128i weight = _mm_set_epi16(0, 77, 150, 29, 0, 77, 150, 29);
    const __m128i zero = _mm_setzero_si128();
    __m128 lo = _mm_castsi128_ps(_mm_madd_epi16(_mm_unpacklo_epi8(w, zero), weight));
    __m128 hi = _mm_castsi128_ps(_mm_madd_epi16(_mm_unpackhi_epi8(w, zero), weight));
    __m128i even = _mm_castps_si128(_mm_shuffle_ps(lo, hi, _MM_SHUFFLE(2, 0, 2, 0)));
    __m128i odd = _mm_castps_si128(_mm_shuffle_ps(lo, hi, _MM_SHUFFLE(3, 1, 3, 1)));
    return _mm_srli_epi32(_mm_add_epi32(_mm_add_epi32(even, odd), _mm_set1_epi32(128)), 8);
}

/* As many as make whole registers; the number done. */
static uint32_t guns_fast(const uint32_t *colour, uint32_t count, uint8_t *red, uint8_t *green,
                          uint8_t *blue)
{
    const __m128i low = _mm_set1_epi16(0xff);
    uint32_t i = 0;
    for (; i + 16 <= count; i += 16) {
        __m128i w[4], rb[2], g[2]; /* bytes of 8 dots: blue red blue red …; green x green x … */
        load_16(w, colour + i);
        for (int k = 0; k < 2; k++) {
            const __m128i *v = w + 2 * k;
            rb[k] = _mm_packus_epi16(_mm_and_si128(v[0], low), _mm_and_si128(v[1], low));
            g[k] = _mm_packus_epi16(_mm_srli_epi16(v[0], 8), _mm_srli_epi16(v[1], 8));
        }
        store(red + i, _mm_packus_epi16(_mm_srli_epi16(rb[0], 8), _mm_srli_epi16(rb[1], 8)));
        store(green + i, _mm_packus_epi16(_mm_and_si128(g[0], low), _mm_and_si128(g[1], low)));
        store(blue + i, _mm_packus_epi16(_mm_and_si128(rb[0], low), _mm_and_si128(rb[1], low)));
    }
    return i;
}

static uint32_t luma_fast(const uint32_t *colour, uint32_t count, uint8_t *luma)
{
    uint32_t i = 0;
    for (; i + 16 <= count; i += 16) {
        __m128i w[4];
        load_16(w, colour + i);
        for (int k = 0; k < 4; k++)
            w[k] = weigh_4(w[k]);
        store(luma + i, _mm_packus_epi16(_mm_packs_epi32(w[0], w[1]), _mm_packs_epi32(w[2], w[3])));
    }
    return i;
}
#else
static uint32_t guns_fast(const uint32_t *colour, uint32_t count, uint8_t *red, uint8_t *green,
                          uint8_t *blue)
{
    (void)colour, (void)count, (void)red, (void)green, (void)blue;
    return 0;
}

static uint32_t luma_fast(const uint32_t *colour, uint32_t count, uint8_t *luma)
{
    (void)colour, (void)count, (void)luma;
    return 0;
}
#endif

void ras_drive_guns(const uint32_t *colour, uint32_t count, uint8_t *red, uint8_t *green,
                    uint8_t *blue)
{
    for (uint32_t i = guns_fast(colour, count, red, green, blue); i < count; i++) {
        red[i] = (uint8_t)(colour[i] >> 16);
        green[i] = (uint8_t)(colour[i] >> 8);
        blue[i] = (uint8_t)colour[i];
    }
}

void ras_drive_luma(const uint32_t *colour, uint32_t count, uint8_t *luma)
{
    for (uint32_t i = luma_fast(colour, count, luma); i < count; i++) {
        uint32_t c = colour[i], r = c >> 16 & 255, g = c >> 8 & 255, b = c & 255;
        luma[i] = (uint8_t)((77 * r + 150 * g + 29 * b + 128) >> 8);
    }
}
