/* The resistive tablet. The stylus radiates; what the sheet takes up flows to the edges, and divides between
 * two opposite ones by how near they are along the sheet: a pair across is read, then the pair up. The
 * conductors of the pair that is not read bend the current's way a little (figure bow): not at all on
 * the lines through the middle and at the pair's own edges, most at the other pair's.
 *
 * Over a tube the sheet is part of a sphere that touches the tablet's plane in the middle. A stylus at x in
 * the plane, from the middle, is r·asin(x/r) along the sheet from the circle through the middle: on a
 * sphere whatever y is. */
#include <math.h>

#include "crt/maths.h"
#include "input/tablet_kinds.h"

/* Height at which half of the signal of touching is left, mm; estimate: some diameters of the tip. */
#define HALF 3.0
/* Lines bend by bow at most: the greatest value of u·(1 − u²). */
#define BEND 0.38490017945975050967

/* Radius of curvature, mm; 0: flat. */
static double radius_of(const struct inp_tablet_setup *setup)
{
    double w = setup->width.value, h = setup->height.value, r = setup->radius.value;
    double least = 0.55 * sqrt(w * w + h * h);
    return r <= 0 ? 0 : r < least ? least : r;
}

/* asin(s) for |s| < 0.95: Newton's steps on the sine. */
static double arc_sine(double s)
{
    double a = s * (1 + s * s / 6);
    for (int i = 0; i < 6; i++)
        a -= (crt_sin(a) - s) / crt_cos(a);
    return a;
}

static double along(double plane, double radius)
{
    return radius > 0 ? radius * arc_sine(plane / radius) : plane;
}

struct inp_place tablet_sheet(const struct inp_tablet_setup *setup)
{
    double r = radius_of(setup);
    return (struct inp_place){2 * along(setup->width.value / 2, r),
                              2 * along(setup->height.value / 2, r), 0};
}

/* Share of the current that flows to the upper of two edges, parts of 65536. u along the pair, v across,
 * both -1 … 1; signal: 1 when touching. */
static uint32_t divide(const struct inp_tablet_setup *setup, double u, double v, double extent,
                       double signal, struct tablet_noise *noise)
{
    double bent = setup->bow.value / BEND * u * (1 - u * u) * v * v;
    double error = setup->noise.value * tablet_noise_next(noise) / signal - bent;
    double share = 0.5 + u / 2 + error / extent;
    return share <= 0 ? 0 : share >= 1 ? 65536 : (uint32_t)floor(65536 * share + 0.5);
}

bool tablet_resistive(const struct inp_tablet_setup *setup, struct inp_place stylus,
                      struct tablet_noise *noise, struct tablet_measure *got)
{
    double w = setup->width.value, h = setup->height.value, r = radius_of(setup);
    if (stylus.x < 0 || stylus.x > w || stylus.y < 0 || stylus.y > h ||
        stylus.z > setup->near.value)
        return false;
    struct inp_place sheet = tablet_sheet(setup);
    double u = 2 * along(stylus.x - w / 2, r) / sheet.x;
    double v = 2 * along(stylus.y - h / 2, r) / sheet.y;
    double signal = HALF / (HALF + stylus.z);
    uint32_t right = divide(setup, u, v, sheet.x, signal, noise);
    uint32_t upper = divide(setup, v, u, sheet.y, signal, noise);
    *got =
        (struct tablet_measure){.place = {right / 65536.0 * sheet.x, upper / 65536.0 * sheet.y, 0},
                                .raw = {65536 - right, right, 65536 - upper, upper}};
    return true;
}
