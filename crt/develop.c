#include "crt/develop.h"

#include <assert.h>
#include <math.h>
#include <pthread.h>

#include "crt/srgb.h"

#define MAX_THREADS 64
/* t of crt_tone's definition for v = 1. */
#define TONE_SCALE ((CRT_TONE_SIZE - 1) * (double)(CRT_TONE_SIZE - 1) / CRT_TONE_MAX)

static double tone_formula(double v)
{
    const double s = CRT_TONE_SHOULDER;
    const double end = (CRT_TONE_MAX - s) / (1.0 - s);
    if (v <= s)
        return v;
    double u = (v - s) / (1.0 - s);
    return s + (1.0 - s) * (end * u / (end + (end - 1.0) * u));
}

void crt_tone_init(struct crt_tone *tone)
{
    for (int i = 0; i < CRT_TONE_SIZE; i++)
        tone->curve[i] = (float)tone_formula((double)i * (double)i / TONE_SCALE);
    tone->curve[CRT_TONE_SIZE - 1] = 1.0f;
}

double crt_tone_at(const struct crt_tone *tone, double v)
{
    if (!(v > 0.0))
        return 0.0;
    if (v <= CRT_TONE_SHOULDER)
        return v;
    if (v >= CRT_TONE_MAX)
        return (double)tone->curve[CRT_TONE_SIZE - 1];
    double t = v * TONE_SCALE;
    int i = (int)sqrt(t);
    if (i > CRT_TONE_SIZE - 2) /* by rounding only */
        i = CRT_TONE_SIZE - 2;
    double a = (double)tone->curve[i], b = (double)tone->curve[i + 1];
    return a + (b - a) * ((t - (double)i * i) / (2 * i + 1));
}

double crt_full_luminance(const struct crt_tube_row *row)
{
    return row->kind == CRT_RASTER_TUBE ? row->field_luminance.value : row->line_luminance.value;
}

double crt_auto_gain(const struct crt_tube_row *row)
{
    double full = crt_full_luminance(row);
    assert(full > 0.0);
    return 0.8 / full;
}

/* fmin and fmax would be calls, for the sake of NaN. */
static inline double least(double a, double b)
{
    return a < b ? a : b;
}

static inline double greatest(double a, double b)
{
    return a > b ? a : b;
}

static inline struct crt_hue with_limits(struct crt_hue hue)
{
    double low = -least(least(hue.e[0], hue.e[1]), hue.e[2]);
    hue.keep = low > 1.0 ? 1.0 / low : 1.0;
    hue.high = greatest(greatest(hue.e[0], hue.e[1]), hue.e[2]);
    return hue;
}

struct crt_hue crt_hue_of(struct crt_chromaticity c)
{
    assert(c.y > 0.0);
    struct crt_hue hue = {{0.0, 0.0, 0.0}, 0.0, 0.0};
    crt_srgb_of(c, hue.e);
    for (int i = 0; i < 3; i++)
        hue.e[i] -= 1.0;
    return with_limits(hue);
}

struct crt_hue crt_hue_mix(const struct crt_hue *a, const struct crt_hue *b, double share)
{
    struct crt_hue hue = *a;
    for (int i = 0; i < 3; i++)
        hue.e[i] += share * (b->e[i] - a->e[i]);
    return with_limits(hue);
}

static inline void fit(double y, const struct crt_hue *hue, double rgb[3])
{
    y = y > 0.0 ? least(y, 1.0) : 0.0;
    double chroma = y * hue->keep;
    double room = 1.0 - y, rise = chroma * hue->high;
    if (rise > 0.0)
        chroma *= room / sqrt(room * room + rise * rise);
    /* The ends take only the dust of rounding. No loop: it would go through memory. */
    rgb[0] = least(greatest(y + chroma * hue->e[0], 0.0), 1.0);
    rgb[1] = least(greatest(y + chroma * hue->e[1], 0.0), 1.0);
    rgb[2] = least(greatest(y + chroma * hue->e[2], 0.0), 1.0);
}

void crt_fit_hue(double y, const struct crt_hue *hue, double rgb[3])
{
    fit(y, hue, rgb);
}

void crt_fit_srgb(double y, struct crt_chromaticity c, double rgb[3])
{
    struct crt_hue hue = crt_hue_of(c);
    fit(y, &hue, rgb);
}

struct development {
    const struct crt_film *film;
    double scale; /* relative luminance of one cd·s/m² */
    struct crt_hue hue[CRT_MAX_COLOURS];
    struct crt_tone tone;
    struct crt_srgb_encoder encoder;
    double max; /* the greatest sample */
    struct crt_image *out;
};

static inline void put_pixel(const struct development *d, double light, const struct crt_hue *hue,
                             uint16_t *rgb)
{
    double v = light * d->scale, linear[3];
    fit(v <= CRT_TONE_SHOULDER ? v : crt_tone_at(&d->tone, v), hue, linear);
    rgb[0] = crt_srgb_sample(&d->encoder, linear[0], d->max);
    rgb[1] = crt_srgb_sample(&d->encoder, linear[1], d->max);
    rgb[2] = crt_srgb_sample(&d->encoder, linear[2], d->max);
}

static inline double light_at(const float *light, size_t c)
{
    return light[c] > 0.0f ? (double)light[c] : 0.0;
}

static void develop_row_of_one_colour(const struct development *d, int row)
{
    size_t cols = (size_t)d->film->grid.cols;
    const float *light = d->film->light[0] + cols * (size_t)row;
    uint16_t *rgb = d->out->samples + 3 * cols * (size_t)row;
    for (size_t c = 0; c < cols; c++, rgb += 3)
        if (light[c] > 0.0f) /* the picture starts black */
            put_pixel(d, (double)light[c], &d->hue[0], rgb);
}

static void develop_row_of_two_colours(const struct development *d, int row)
{
    size_t cols = (size_t)d->film->grid.cols;
    const float *light0 = d->film->light[0] + cols * (size_t)row;
    const float *light1 = d->film->light[1] + cols * (size_t)row;
    uint16_t *rgb = d->out->samples + 3 * cols * (size_t)row;
    for (size_t c = 0; c < cols; c++, rgb += 3) {
        double a = light_at(light0, c), b = light_at(light1, c);
        double sum = a + b;
        if (!(sum > 0.0))
            continue;
        struct crt_hue hue = crt_hue_mix(&d->hue[0], &d->hue[1], b / sum);
        put_pixel(d, sum, &hue, rgb);
    }
}

static void develop_row_of_three_colours(const struct development *d, int row)
{
    size_t cols = (size_t)d->film->grid.cols, start = cols * (size_t)row;
    const float *light0 = d->film->light[0] + start, *light1 = d->film->light[1] + start,
                *light2 = d->film->light[2] + start;
    const double *e0 = d->hue[0].e, *e1 = d->hue[1].e, *e2 = d->hue[2].e;
    uint16_t *rgb = d->out->samples + 3 * start;
    for (size_t c = 0; c < cols; c++, rgb += 3) {
        double l0 = light_at(light0, c), l1 = light_at(light1, c), l2 = light_at(light2, c);
        double sum = l0 + l1 + l2;
        if (!(sum > 0.0))
            continue;
        double per_light = 1.0 / sum;
        struct crt_hue hue = {{(l0 * e0[0] + l1 * e1[0] + l2 * e2[0]) * per_light,
                               (l0 * e0[1] + l1 * e1[1] + l2 * e2[1]) * per_light,
                               (l0 * e0[2] + l1 * e1[2] + l2 * e2[2]) * per_light},
                              0.0,
                              0.0};
        hue = with_limits(hue);
        put_pixel(d, sum, &hue, rgb);
    }
}

struct band {
    const struct development *development;
    int first_row, end_row;
};

static void *develop_band(void *argument)
{
    const struct band *band = argument;
    for (int row = band->first_row; row < band->end_row; row++) {
        switch (band->development->film->colours) {
        case 1:
            develop_row_of_one_colour(band->development, row);
            break;
        case 2:
            develop_row_of_two_colours(band->development, row);
            break;
        default:
            develop_row_of_three_colours(band->development, row);
        }
    }
    return NULL;
}

/* Shares the rows out; a band whose thread cannot be started is done here. */
static void develop_rows(const struct development *d, int threads)
{
    struct band bands[MAX_THREADS];
    pthread_t thread[MAX_THREADS];
    bool running[MAX_THREADS] = {false};
    int rows = d->film->grid.rows;
    for (int i = 0; i < threads; i++) {
        bands[i] = (struct band){d, (int)((int64_t)rows * i / threads),
                                 (int)((int64_t)rows * (i + 1) / threads)};
        if (i > 0)
            running[i] = pthread_create(&thread[i], NULL, develop_band, &bands[i]) == 0;
    }
    for (int i = 0; i < threads; i++)
        if (!running[i])
            develop_band(&bands[i]);
    for (int i = 1; i < threads; i++)
        if (running[i])
            pthread_join(thread[i], NULL);
}

bool crt_develop(const struct crt_film *film, const struct crt_phosphor *phosphor, double gain,
                 int depth, int threads, struct crt_image *out, struct crt_error *err)
{
    assert(film->t1 > film->t0);
    assert(film->colours >= 1 && film->colours <= CRT_MAX_COLOURS);
    assert(film->colours <= phosphor->colours);
    assert(gain >= 0.0 && isfinite(gain));
    if (!crt_image_init(out, film->grid.cols, film->grid.rows, depth, err))
        return false;
    struct development d = {
        .film = film,
        .scale = gain / ((double)(film->t1 - film->t0) * 1e-12),
        .max = depth == 8 ? 255.0 : 65535.0,
        .out = out,
    };
    for (int i = 0; i < film->colours; i++)
        d.hue[i] = crt_hue_of(phosphor->colour[i]);
    crt_tone_init(&d.tone);
    crt_srgb_encoder_init(&d.encoder);
    threads = threads < 1 ? 1 : threads > MAX_THREADS ? MAX_THREADS : threads;
    develop_rows(&d, threads);
    return true;
}
