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

/* They fade at once: persistence would only weigh lines by their age. */
static const struct crt_phosphor quick = {.name = "quick",
                                          .colours = 1,
                                          .colour = {{CRT_D65_X, CRT_D65_Y}},
                                          .terms = 1,
                                          .term = {{1, 1e-9, 0}}};
static const struct crt_phosphor quick_colours = {
    .name = "quick",
    .colours = 3,
    .colour = {{.64, .33}, {.30, .60}, {.15, .06}},
    .terms = 3,
    .term = {{.2126, 1e-9, 0}, {.7152, 1e-9, 1}, {.0722, 1e-9, 2}}};

/* Eight periods in the middle of the screen, along the first side. */
static struct crt_grid grid_for(enum vm_direction direction, double f)
{
    if (direction == VM_ACROSS)
        return crt_grid_closeup(0, 0, 8 / f, 512, 64);
    return crt_grid_closeup(0, 0, 1 / f, 64, 512);
}

/* Upright lines at full drive, one after the other, in half an epoch. */
static void draw_lines(struct crt_tube *tube, const struct crt_grid *grid, double f, uint64_t epoch)
{
    double x1 = grid->left_mm + grid->cols * grid->cell_mm, top = grid->top_mm;
    double bottom = top - grid->rows * grid->cell_mm, reach = 20 * grid->cell_mm;
    int first = (int)ceil((grid->left_mm - 4 / f) * f), last = (int)floor((x1 + 4 / f) * f);
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

/* Drive for which the current is a sine at `mm`. */
static uint8_t sine_drive(const struct vm_resolution *r, double f, double mm)
{
    double current = (1 + crt_cos(2 * PI * f * mm)) / 2;
    return (uint8_t)(255 * crt_pow(current, 1 / r->row->gun_exponent.value) + 0.5);
}

#define FINE_DOTS 4096 /* a line: far finer than spots */

/* Scan lines at the mode's pitch and speed over the grid: of one gun, the green one of three. */
static void scan_lines(struct crt_tube *tube, const struct vm_resolution *r,
                       const struct crt_grid *grid, enum vm_direction direction, double f)
{
    uint8_t drive[FINE_DOTS], dark[FINE_DOTS] = {0};
    double width = r->row->width.value, pitch = r->row->height.value / r->dots_y;
    double reach = grid->rows * grid->cell_mm / 2 + 8 * r->sigma[VM_CENTRE];
    uint64_t time = (uint64_t)(width / r->speed_mm_s * 1e12);
    int guns = crt_tube_guns(r->row), last = (int)ceil(reach / pitch);
    for (int i = 0; i < FINE_DOTS; i++)
        drive[i] = sine_drive(r, f, ((i + 0.5) / FINE_DOTS - 0.5) * width);
    for (int k = -last; k <= last; k++) {
        float y = (float)(-k * pitch);
        struct crt_scan_line line = {.t0 = (uint64_t)(k + last) * (time + time / 4),
                                     .x0 = (float)(-width / 2),
                                     .x1 = (float)(width / 2),
                                     .y0 = y,
                                     .y1 = y,
                                     .dots = FINE_DOTS,
                                     .guns = guns,
                                     .drive = {dark, dark, dark},
                                     .source = (uint32_t)(k + last)};
        line.t1 = line.t0 + time;
        if (direction == VM_UP)
            for (int i = 0; i < FINE_DOTS; i++)
                drive[i] = sine_drive(r, f, k * pitch);
        line.drive[guns / 2] = drive;
        crt_tube_scan_line(tube, &line);
    }
}

/* Along the middle of the film, its outer quarters left out. */
static double modulation_on(const struct crt_film *film, enum vm_direction direction)
{
    double low = INFINITY, high = 0;
    size_t cols = (size_t)film->grid.cols, rows = (size_t)film->grid.rows;
    size_t n = direction == VM_ACROSS ? cols : rows, step = direction == VM_ACROSS ? 1 : cols;
    size_t start = direction == VM_ACROSS ? rows / 2 * cols : cols / 2;
    for (size_t i = n / 4; i < n * 3 / 4; i++) {
        double sum = 0;
        for (int k = 0; k < film->colours; k++)
            sum += (double)film->light[k][start + i * step];
        low = fmin(low, sum);
        high = fmax(high, sum);
    }
    return high > 0 ? (high - low) / (high + low) : 0;
}

static bool expose(struct crt_tube *tube, const struct vm_resolution *r,
                   enum vm_direction direction, double f, double *modulation, struct crt_error *err)
{
    struct crt_grid grid = grid_for(direction, f);
    const uint64_t end = CRT_PS_PER_S;
    struct crt_film film;
    if (!crt_film_init(&film, tube, err))
        return false;
    crt_film_open(tube, &film, 0, end);
    if (r->row->kind == CRT_RASTER_TUBE)
        scan_lines(tube, r, &grid, direction, f);
    else
        draw_lines(tube, &grid, f, end);
    crt_tube_advance(tube, end);
    bool ok = crt_tube_intact(tube, err);
    *modulation = modulation_on(&film, direction);
    crt_film_free(&film);
    return ok;
}

bool vm_resolution_on_film(const struct vm_resolution *r, enum vm_direction direction, double f,
                           double *modulation, struct crt_error *err)
{
    bool raster = r->row->kind == CRT_RASTER_TUBE;
    direction = raster ? direction : VM_ACROSS;
    struct crt_tube_desc desc = {.row = r->row,
                                 .phosphor = crt_tube_guns(r->row) == 3 ? &quick_colours : &quick,
                                 .grid = grid_for(direction, f),
                                 .epoch = {1, 1},
                                 .knobs = {0, 1, 0},
                                 .threads = 1};
    struct crt_tube *tube = crt_tube_create(&desc, err);
    if (!tube)
        return false;
    bool ok = expose(tube, r, direction, f, modulation, err);
    crt_tube_destroy(tube);
    return ok;
}
