/* The electrical tablet. Wires lie at (i − ½)·pitch, i = −1 …; a pulse goes out along one and comes back
 * along the next, so that each pair is a loop, numbered from 0, loop n with its middle at (n − 1)·pitch.
 * The coil of the stylus, its axis upright, sees the vertical part of the field of both wires.
 *
 * The tablet takes the loop with the strongest signal and its two neighbours and lays a parabola through
 * them. A table in its memory tells from the parabola's crest where the stylus is, for heights STEP apart
 * and places a 16th of the pitch apart; between them it interpolates. Which height it is follows from the
 * strength, so that both are found in turns. Higher up the noise, which is the receiver's, weighs more: the
 * curvature of the signal falls as the fourth power of the height above the wires. */
#include <math.h>

#include "input/tablet_kinds.h"

/* Loops about the stylus that are looked at, to each side: those further off are never the strongest. */
#define AROUND 4
/* Signals below this many times the noise are none. */
#define CLEAR 5
/* The table: heights this far apart, mm; so many places from the middle of a loop to its edge. */
#define STEP   3.0
#define PLACES 8
/* Turns of finding place and height. */
#define TURNS 3

struct grid {
    double pitch, coil;
    double full;  /* signal over the middle of a loop, stylus touching */
    double sigma; /* noise of a signal */
    double clear; /* weaker signals are none */
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

/* The same of a stylus at d pitches from the middle: what the table is made of. */
static double crest_of(const struct grid *g, double d, double h)
{
    double x = d * g->pitch, p = g->pitch;
    return crest(field(x + p, h, p), field(x, h, p), field(x - p, h, p));
}

static struct grid grid_of(const struct inp_tablet_setup *setup)
{
    double p = setup->pitch.value, h = setup->coil.value;
    struct grid g = {.pitch = p, .coil = h, .full = field(0, h, p)};
    double curve = 2 * (g.full - field(p, h, p));
    double slope = crest_of(&g, 1.0 / 16, h) * 16;
    g.sigma = setup->noise.value * sqrt(2) * curve * slope / p;
    double least = field(p / 2, h + 1.5 * setup->near.value, p);
    g.clear = CLEAR * g.sigma > least ? CLEAR * g.sigma : least;
    return g;
}

/* The row of the table for one height, searched: pitches from the middle, 0 … ½. */
static double look_up(const struct grid *g, double u, double h)
{
    double low = 0;
    for (int i = 1; i <= PLACES; i++) {
        double high = crest_of(g, i / (2.0 * PLACES), h);
        if (u <= high)
            return (i - 1 + (u - low) / (high - low)) / (2.0 * PLACES);
        low = high;
    }
    return 0.5;
}

/* Pitches from the middle for the crest u, between two rows. */
static double place_of(const struct grid *g, double u, double height)
{
    double row = floor(height / STEP), part = height / STEP - row;
    double lower = look_up(g, fabs(u), g->coil + row * STEP);
    double upper = look_up(g, fabs(u), g->coil + (row + 1) * STEP);
    double d = lower + (upper - lower) * part;
    return u < 0 ? -d : d;
}

/* Height of the stylus above the surface at d pitches from the middle: the field's formula is an equation
 * of the second degree for h². */
static double height_of(const struct grid *g, double signal, double d)
{
    double b = g->pitch / 2, x = d * g->pitch, out = b * b - x * x;
    double linear = 2 * signal * (x * x + b * b) - 2 * b, rest = out * (signal * out - 2 * b);
    double root = linear * linear - 4 * signal * rest;
    double square = root > 0 ? (sqrt(root) - linear) / (2 * signal) : 0;
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
    if (best < 1 || best >= 2 * AROUND || signal[best] < g->clear)
        return false;
    a->strongest = first + best;
    if (a->strongest == 0 || a->strongest == a->loops - 1)
        return false;
    double before = signal[best - 1], after = signal[best + 1];
    double u = crest(before, signal[best], after), d = u;
    for (int turn = 0; turn < TURNS; turn++) {
        a->height = height_of(g, signal[best], d);
        d = place_of(g, u, a->height);
    }
    a->place = ((double)(a->strongest - 1) + d) * g->pitch;
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
