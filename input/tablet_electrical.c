/* The electrical tablet. Wires lie at (i − ½)·pitch, i = −1 …; a pulse goes out along one and comes back
 * along the next, so that each pair is a loop, numbered from 0, loop n with its middle at (n − 1)·pitch.
 * The coil of the stylus, its axis upright, sees the vertical part of the field of both wires.
 *
 * The tablet takes the loop with the strongest signal and its two neighbours, lays a parabola through them,
 * and corrects the place of its crest by a cubic that is right for a stylus that touches. The height
 * follows from the crest's strength. Higher up the correction is a little wrong, and the noise, which is
 * the receiver's, weighs more: the curvature of the signal falls as the fourth power of the height above
 * the wires. */
#include <math.h>

#include "input/tablet_kinds.h"

/* Loops about the stylus that are looked at, to each side: those further off are never the strongest. */
#define AROUND 4
/* Signals below this many times the noise are none. */
#define CLEAR 5

struct grid {
    double pitch, coil;
    double full;  /* signal over the middle of a loop, stylus touching */
    double bend;  /* of the cubic */
    double sigma; /* noise of a signal */
};

struct along {
    long loops;
    double place, height; /* mm */
    long strongest;
    double signal, neighbour;
};

/* Field of a loop, up, at d from its middle and h above the wires; 1 ampere, in µ0/2π of a tesla. */
static double field(double d, double h, double pitch)
{
    double a = d + pitch / 2, b = d - pitch / 2;
    return a / (a * a + h * h) - b / (b * b + h * h);
}

/* Place of the crest of a parabola through three signals one apart, from the middle one. */
static double crest(double before, double at, double after)
{
    double curve = 2 * at - before - after;
    return curve > 0 ? (after - before) / (2 * curve) : 0;
}

static struct grid grid_of(const struct inp_tablet_setup *setup)
{
    double p = setup->pitch.value, h = setup->coil.value;
    struct grid g = {.pitch = p, .coil = h, .full = field(0, h, p)};
    double u = crest(field(1.25 * p, h, p), field(0.25 * p, h, p), field(0.75 * p, h, p));
    g.bend = (0.25 - u) / (u * (1 - 4 * u * u));
    double curve = 2 * (g.full - field(p, h, p));
    g.sigma = setup->noise.value * sqrt(2) * curve / (p * (1 + g.bend));
    return g;
}

static double height_of(const struct grid *g, double strength)
{
    double square = g->pitch / strength - g->pitch * g->pitch / 4;
    return square > g->coil * g->coil ? sqrt(square) - g->coil : 0;
}

/* One direction; false: no signal, or the outermost loop is the strongest. */
static bool measure(const struct grid *g, double place, double z, double extent,
                    struct tablet_noise *noise, struct along *a)
{
    double signal[2 * AROUND + 1];
    a->loops = (long)ceil(extent / g->pitch) + 3;
    long first = (long)floor(place / g->pitch + 0.5) + 1 - AROUND;
    int best = -1;
    for (int i = 0; i <= 2 * AROUND; i++) {
        double d = place - (double)(first + i - 1) * g->pitch;
        signal[i] = field(d, g->coil + z, g->pitch) + g->sigma * tablet_noise_next(noise);
        bool exists = first + i >= 0 && first + i < a->loops;
        if (exists && (best < 0 || signal[i] > signal[best]))
            best = i;
    }
    if (best < 1 || best >= 2 * AROUND || signal[best] < CLEAR * g->sigma)
        return false;
    a->strongest = first + best;
    if (a->strongest == 0 || a->strongest == a->loops - 1)
        return false;
    double before = signal[best - 1], after = signal[best + 1];
    double u = crest(before, signal[best], after);
    a->place = ((double)(a->strongest - 1) + u + g->bend * u * (1 - 4 * u * u)) * g->pitch;
    a->height = height_of(g, signal[best] + (after - before) * u / 4);
    a->signal = signal[best];
    a->neighbour = before > after ? before : after;
    return true;
}

static uint32_t parts(const struct grid *g, double signal)
{
    return signal > 0 ? (uint32_t)floor(65536 * signal / g->full + 0.5) : 0;
}

bool tablet_electrical(const struct inp_tablet_setup *setup, struct inp_place stylus,
                       struct tablet_noise *noise, struct tablet_measure *got)
{
    struct grid g = grid_of(setup);
    struct along x, y;
    if (!measure(&g, stylus.x, stylus.z, setup->width.value, noise, &x) ||
        !measure(&g, stylus.y, stylus.z, setup->height.value, noise, &y))
        return false;
    double z = (x.height + y.height) / 2;
    *got = (struct tablet_measure){.place = {x.place, y.place, z},
                                   .touches = z <= setup->touch.value,
                                   .raw = {(uint32_t)x.strongest, (uint32_t)y.strongest,
                                           parts(&g, x.signal), parts(&g, x.neighbour),
                                           parts(&g, y.signal), parts(&g, y.neighbour)}};
    return z <= setup->near.value;
}
