#include "crt/spot.h"

#include <math.h>

#include "crt/maths.h"

#define ROOT_TWO_PI 2.50662827463100050

double crt_spot_sigma0(const struct crt_tube_row *row)
{
    return row->spot.value / CRT_WIDTH60_SIGMA;
}

static double sigma_at(const struct crt_tube_row *row, double current, double focus)
{
    double sigma0 = crt_spot_sigma0(row);
    double growth = row->spot_growth.value * crt_pow(current, row->spot_exponent.value);
    return sqrt((sigma0 * sigma0 + growth * growth) * (1 + focus * focus));
}

/* The crest of a line of energy e per second, speed v, seen f times a second: e·f /
 * (v·√(2π)·sigma). */
static double full_power(const struct crt_tube_row *row)
{
    double speed = row->line_speed.value * 1e6; /* mm/s */
    return row->line_luminance.value * ROOT_TWO_PI * sigma_at(row, 1, 0) * speed /
           row->line_refresh.value;
}

struct crt_spot crt_spot_at(const struct crt_tube_row *row, const struct crt_knobs *knobs,
                            double drive)
{
    double driven = knobs->contrast * drive + knobs->brightness;
    driven = driven > 0 ? fmin(driven, 1) : 0; /* NaN gives no beam */
    double current = driven > 0 ? crt_pow(driven, row->gun_exponent.value) : 0;
    return (struct crt_spot){
        .current = current,
        .sigma_mm = sigma_at(row, current, knobs->focus),
        .power = current * full_power(row),
    };
}
