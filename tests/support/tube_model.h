/* tube_model.h — rows for tube tests, and a slow exact tube to compare with.
 *
 * Models:     film light at one point as the integral over time of a Gaussian spot times the share
 * of its light emitted during the exposure, by composite Gauss-Legendre in double precision with
 * the C library's functions: nothing is shared with crt/ but the row's figures.
 */
#ifndef TUBE_MODEL_H
#define TUBE_MODEL_H

#include "crt/tube.h"

/* A row with sigma0 and growth (mm), gun exponent 2.5; a full-drive line at 1 mm/us and 60 Hz is
 * 100 cd/m². */
struct crt_tube_row model_row(double sigma0_mm, double growth_mm);

/* One colour, the given energy shares and time constants (ms). */
struct crt_phosphor model_phosphor(int terms, const double *w, const double *tau_ms);

struct model_stroke {
    struct crt_stroke stroke;
    double power, sigma_mm; /* crt_spot_at */
};

/* Light at (x, y) mm between a and b, of one colour, cd·s/m². */
double model_light(const struct model_stroke *strokes, int count, const struct crt_phosphor *p,
                   int colour, double x, double y, uint64_t a, uint64_t b);

/* A small generator of numbers, the same everywhere. */
uint32_t model_random(uint32_t *state);
double model_uniform(uint32_t *state, double low, double high);

#endif
