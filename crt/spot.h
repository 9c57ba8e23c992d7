/* spot.h — gun and spot: drive to beam current, current to light and to the width of the beam.
 *
 * Models:     drive' = clamp(contrast·drive + brightness, 0, 1); relative current
 *             I = drive'^gun_exponent; sigma² = (sigma0² + (growth·I^exponent)²)·(1 + focus²), a
 *             round Gaussian. Light: a full-drive line drawn at line_speed and refreshed
 *             line_refresh times a second has a crest of line_luminance cd/m²; that fixes the
 *             luminous energy per second of beam.
 * Units:      mm; cd·mm²/m² (luminance integrated over the spot's area).
 * Sources:    the tube row (crt/tube_table.h).
 * Ownership:  plain values.
 * Errors:     none; drive that is no number gives no beam.
 * Not modelled: astigmatism, deflection defocus, saturation.
 */
#ifndef CRT_SPOT_H
#define CRT_SPOT_H

#include "crt/tube.h"

struct crt_spot {
    double current; /* 0…1 */
    double sigma_mm;
    double power; /* cd·mm²/m²: luminance integrated over the spot's area, in the steady state */
};

/* Sigma of the spot at vanishing current, best focus. */
double crt_spot_sigma0(const struct crt_tube_row *row);
struct crt_spot crt_spot_at(const struct crt_tube_row *row, const struct crt_knobs *knobs,
                            double drive);

#endif
