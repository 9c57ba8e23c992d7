/* aperture.h — what of a beam's spot a photodiode sees: at a point, on a disc, on the whole screen; private to
 * photodiodes.
 *
 * Models:     density of a spot's light, 1/mm²: a Gaussian at the point's distance; its mean over a disc; or
 *             1/(useful screen area). The mean over a disc of radius R at distance d from its middle is
 *             1/(πR²)·∫ g(u − d)·erf(h(u)/(√2·sigma)) du over the disc's breadth, h(u) = sqrt(R² − u²), tabled
 *             against d for sigmas in steps of 1/256 of their logarithm.
 * Units:      mm.
 * Accuracy:   of the disc, 1e-5 of what is seen of a spot in its middle; point and screen are exact.
 * Ownership:  crt_aperture_free releases the tables; views borrow them and hold until then.
 * Errors:     a view without memory for its tables sees nothing; the aperture notes it in `lost`.
 */
#ifndef CRT_APERTURE_H
#define CRT_APERTURE_H

#include <stddef.h>
#include <stdint.h>

#include "crt/photodiode.h"

/* Light further from a place than this is left out, sigma: e^−32 = 1e-14. */
#define CRT_APERTURE_REACH 8.0

struct crt_disc_table;

struct crt_aperture {
    enum crt_photodiode_kind kind;
    double x_mm, y_mm;
    double radius_mm; /* 0: a point */
    double area_mm2;  /* of the screen */
    struct crt_disc_table **table;
    size_t tables, room;
    uint64_t lost;
};

/* For spots of one sigma. */
struct crt_view {
    double scale, per2; /* point: scale·e^(−per2·d²); else scale is the most */
    const struct crt_disc_table *low, *high;
    double blend;
};

void crt_aperture_init(struct crt_aperture *a, const struct crt_photodiode_desc *desc,
                       const struct crt_tube_row *row);
void crt_aperture_free(struct crt_aperture *a);

struct crt_view crt_aperture_view(struct crt_aperture *a, double sigma_mm);
/* 1/mm² of a spot whose square of distance is d2. */
double crt_aperture_density(const struct crt_aperture *a, const struct crt_view *view, double d2);
/* Spots further off, mm, are not seen. */
double crt_aperture_reach(const struct crt_aperture *a, double sigma_mm);

#endif
