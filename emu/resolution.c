#include "emu/resolution.h"

#include <assert.h>
#include <math.h>

#include "crt/maths.h"
#include "crt/optics.h"
#include "crt/spot.h"
#include "crt/white.h"

#define PI 3.14159265358979324

/* ---- the tube -------------------------------------------------------------------------------- */

static double sigma_of(const struct crt_tube_row *row, double current)
{
    const struct crt_knobs neutral = {0, 1, 0};
    return crt_spot_at(row, &neutral, crt_pow(current, 1 / row->gun_exponent.value)).sigma_mm;
}

void vm_resolution_init(struct vm_resolution *r, const struct crt_tube_row *row,
                        const struct ras_timing *timing, double current)
{
    struct crt_optics optics;
    crt_optics_init(&optics, row);
    double x = row->width.value / 2, y = row->height.value / 2, sigma = sigma_of(row, current);
    *r = (struct vm_resolution){
        .row = row,
        .sigma = {sigma, sigma * crt_optics_at(&optics, 0, x, y).spread},
        .sigma_least = crt_spot_sigma0(row),
        .dots_x = row->units_x.value,
        .dots_y = row->units_y.value,
    };
    if (!timing)
        return;
    double clock = (double)timing->clock.num / (double)timing->clock.den;
    r->dots_x = timing->h.visible;
    r->dots_y = timing->v.visible;
    r->speed_mm_s = row->width.value * clock / timing->h.visible;
}

/* ---- modulation ------------------------------------------------------------------------------ */

double vm_resolution_spot(const struct vm_resolution *r, enum vm_place place, double f)
{
    double x = PI * r->sigma[place] * f;
    return crt_exp(-2 * x * x);
}

/* A period of a signal and its Fourier coefficients. */
#define SAMPLES   256
#define HARMONICS 64

struct series {
    double mean, re[HARMONICS], im[HARMONICS];
};

static void analyse(const double *v, const double *cosine, struct series *s)
{
    s->mean = 0;
    for (int i = 0; i < SAMPLES; i++)
        s->mean += v[i] / SAMPLES;
    for (int k = 1; k <= HARMONICS; k++) {
        double re = 0, im = 0;
        for (int i = 0; i < SAMPLES; i++) {
            re += v[i] * cosine[i * k % SAMPLES];
            im += v[i] * cosine[(i * k + SAMPLES / 4) % SAMPLES]; /* −sine */
        }
        s->re[k - 1] = 2 * re / SAMPLES;
        s->im[k - 1] = 2 * im / SAMPLES;
    }
}

static void put_together(const struct series *s, const double *cosine, double *v)
{
    for (int i = 0; i < SAMPLES; i++) {
        v[i] = s->mean;
        for (int k = 1; k <= HARMONICS; k++)
            v[i] += s->re[k - 1] * cosine[i * k % SAMPLES] +
                    s->im[k - 1] * cosine[(i * k + SAMPLES / 4) % SAMPLES];
    }
}

/* One pole at `corner`, in parts of the fundamental's frequency: a/(1 + j·k/corner). */
static void amplify(struct series *s, double corner)
{
    for (int k = 1; k <= HARMONICS; k++) {
        double q = k / corner, n = 1 + q * q, re = s->re[k - 1], im = s->im[k - 1];
        s->re[k - 1] = (re + q * im) / n;
        s->im[k - 1] = (im - q * re) / n;
    }
}

static double modulation_of(const double *v)
{
    double low = v[0], high = v[0];
    for (int i = 1; i < SAMPLES; i++) {
        low = fmin(low, v[i]);
        high = fmax(high, v[i]);
    }
    low = fmax(low, 0);
    return high > 0 ? (high - low) / (high + low) : 0;
}

/* Along a scan line: what amplifier and gun make of the sine, then the spot. */
static double along_line(const struct vm_resolution *r, enum vm_place place, double f)
{
    double gamma = r->row->gun_exponent.value, v[SAMPLES], cosine[SAMPLES];
    double corner = r->row->bandwidth.value * 1e6 / (f * r->speed_mm_s);
    struct series s;
    for (int i = 0; i < SAMPLES; i++)
        cosine[i] = crt_cos(2 * PI * i / SAMPLES);
    for (int i = 0; i < SAMPLES; i++)
        v[i] = crt_pow(fmax((1 + cosine[i]) / 2, 0), 1 / gamma);
    analyse(v, cosine, &s);
    amplify(&s, corner);
    put_together(&s, cosine, v);
    for (int i = 0; i < SAMPLES; i++)
        v[i] = v[i] > 0 ? crt_pow(v[i], gamma) : 0;
    analyse(v, cosine, &s);
    for (int k = 1; k <= HARMONICS; k++) {
        double kept = vm_resolution_spot(r, place, k * f);
        s.re[k - 1] *= kept;
        s.im[k - 1] *= kept;
    }
    put_together(&s, cosine, v);
    return modulation_of(v);
}

double vm_resolution_at(const struct vm_resolution *r, enum vm_place place,
                        enum vm_direction direction, double f)
{
    assert(f > 0);
    if (direction == VM_ACROSS && r->speed_mm_s > 0)
        return along_line(r, place, f);
    return vm_resolution_spot(r, place, f);
}

double vm_resolution_limit(const struct vm_resolution *r, enum vm_place place,
                           enum vm_direction direction)
{
    /* The spot alone is no worse, so its own limit is above. */
    double low = 0;
    double high = sqrt(-crt_log(VM_LEAST_MODULATION) / 2) / (PI * r->sigma[place]);
    for (int i = 0; i < 60; i++) {
        double f = low + (high - low) / 2;
        if (vm_resolution_at(r, place, direction, f) > VM_LEAST_MODULATION)
            low = f;
        else
            high = f;
    }
    return high;
}

/* ---- limits of mask and mode ----------------------------------------------------------------- */

double vm_resolution_mask_limit(const struct crt_tube_row *row, enum vm_direction direction)
{
    double pitch = row->mask_pitch.value;
    switch (row->mask) {
    case CRT_MASK_NONE:
        return 0;
    case CRT_MASK_DELTA: /* columns √3/2 of the pitch apart; levels of holes half of it */
        return direction == VM_ACROSS ? 1 / (1.7320508075688772 * pitch) : 1 / pitch;
    case CRT_MASK_SLOT:
        return direction == VM_ACROSS ? 1 / (2 * pitch) : 0;
    case CRT_MASK_GRILLE:
        return direction == VM_ACROSS ? 1 / (2 * pitch) : 0;
    }
    return 0;
}

double vm_resolution_mode_limit(const struct vm_resolution *r, enum vm_direction direction)
{
    return direction == VM_ACROSS ? r->dots_x / (2 * r->row->width.value)
                                  : r->dots_y / (2 * r->row->height.value);
}

double vm_resolution_width60(double sigma)
{
    return CRT_WIDTH60_SIGMA * sigma;
}

/* ---- on film --------------------------------------------------------------------------------- */

double vm_resolution_lines(double sigma, double f)
{
    /* Poisson: Σ g(x − n/f) = f·(1 + 2·Σ q^(k²)·cos(2πkfx)), q = e^(−2π²σ²f²). */
    double q = crt_exp(-2 * PI * PI * sigma * sigma * f * f), even = 1, odd = 0;
    for (int k = 1; k <= 200; k++) {
        double term = 2 * crt_pow(q, (double)k * k);
        if (k % 2)
            odd += term;
        else
            even += term;
    }
    return odd / even;
}

/* Draws the lines, one after the other, in one epoch. */
static void draw_lines(struct crt_tube *tube, const struct crt_grid *grid, double f, uint64_t epoch)
{
    double x1 = grid->left_mm + grid->cols * grid->cell_mm, top = grid->top_mm;
    double bottom = top - grid->rows * grid->cell_mm, reach = 20 * grid->cell_mm;
    int first = (int)ceil((grid->left_mm - reach) * f), last = (int)floor((x1 + reach) * f);
    uint64_t time = epoch / 2 / (uint64_t)(last - first + 1);
    for (int i = first; i <= last; i++) {
        uint64_t t = (uint64_t)(i - first) * time;
        struct crt_stroke s = {.t0 = t,
                               .t1 = t + time,
                               .x0 = (float)(i / f),
                               .y0 = (float)(top + reach),
                               .x1 = (float)(i / f),
                               .y1 = (float)(bottom - reach),
                               .drive = 1};
        crt_tube_stroke(tube, &s);
    }
}

static double modulation_on(const struct crt_film *film)
{
    double low = INFINITY, high = 0;
    size_t cols = (size_t)film->grid.cols, middle = (size_t)(film->grid.rows / 2) * cols;
    for (size_t c = cols / 4; c < cols * 3 / 4; c++) {
        double sum = 0;
        for (int k = 0; k < film->colours; k++)
            sum += (double)film->light[k][middle + c];
        low = fmin(low, sum);
        high = fmax(high, sum);
    }
    return high > 0 ? (high - low) / (high + low) : 0;
}

bool vm_resolution_on_film(const struct crt_tube_row *row, double f, double *modulation,
                           struct crt_error *err)
{
    assert(row->kind == CRT_VECTOR_TUBE);
    /* It fades at once: persistence would only weigh the lines by their age. */
    static const struct crt_phosphor quick = {.name = "quick",
                                              .colours = 1,
                                              .colour = {{CRT_D65_X, CRT_D65_Y}},
                                              .terms = 1,
                                              .term = {{1, 1e-9, 0}}};
    struct crt_tube_desc close = {.row = row, .phosphor = &quick, .knobs = {0, 1, 0}, .threads = 1};
    struct crt_film film = {.colours = 0};
    /* Eight periods, finely enough that the mean over a cell is as good as a point. */
    close.grid = crt_grid_closeup(0, 0, 8 / f, 512, 64);
    close.epoch = (struct crt_rate){60, 1};
    struct crt_tube *tube = crt_tube_create(&close, err);
    if (!tube)
        return false;
    bool ok = crt_film_init(&film, tube, err);
    if (ok) {
        uint64_t end = crt_tick_time(close.epoch, 1);
        crt_film_open(tube, &film, 0, end);
        draw_lines(tube, &close.grid, f, end);
        crt_tube_advance(tube, end);
        ok = crt_tube_intact(tube, err);
        *modulation = modulation_on(&film);
        crt_film_free(&film);
    }
    crt_tube_destroy(tube);
    return ok;
}
