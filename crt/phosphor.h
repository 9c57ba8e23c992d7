/* phosphor.h — phosphors as data: how a screen glows and fades, in which colour.
 *
 *      light h(t) = Σ_k (w_k/τ_k)·e^(−t/τ_k)      Σ w_k = 1, w_k = share of the luminous energy
 *
 * Models:     each phosphor of the table as a sum of exponentials; a power-law tail enters as a
 *             few log-spaced exponentials. Up to three colours: P7's flash and afterglow,
 *             the layers of a penetration screen, the red, green and blue of a three-gun tube.
 * Time:       seconds.
 * Sources:    each row names its own; `made_from` tells which published persistence the terms were
 *             fitted to, since figures for one P-number differ by up to a factor of 1000.
 * Ownership:  built-in rows are constant; rows from an INI file belong to the table that read them.
 * Errors:     a name that is not there gives NULL; nothing else can fail.
 * Not modelled: saturation, burn-in, dependence of decay on excitation and temperature.
 */
#ifndef CRT_PHOSPHOR_H
#define CRT_PHOSPHOR_H

#include <stddef.h>

#define CRT_MAX_TERMS   24
#define CRT_MAX_COLOURS 3

struct crt_phosphor_term {
    double w;     /* share of the luminous energy, Σ = 1 over all terms of all colours */
    double tau_s; /* time constant */
    int colour;   /* index into crt_phosphor.colour */
};

struct crt_chromaticity {
    double x, y; /* CIE 1931 */
};

/* Published persistence: time from the end of excitation until the light has fallen to a fraction
 * of its value. 0 = not published. */
struct crt_persistence {
    double t10_s, t1_s, t01_s; /* to 10 %, 1 %, 0.1 % */
    double t10_high_s;         /* upper end when the 10 % figure is published as a range, else 0 */
    const char *source;        /* never NULL; "" when nothing is published */
};

enum crt_persistence_source { CRT_FROM_TEKTRONIX, CRT_FROM_JEDEC, CRT_FROM_IMPULSE, CRT_FROM_USER };

struct crt_phosphor {
    char name[16];        /* "P31" */
    char letters[8];      /* world-wide designation, "GH" */
    char description[64]; /* "green 525 nm" */
    double peak_nm;
    int colours;
    struct crt_chromaticity colour[CRT_MAX_COLOURS];
    int terms;
    struct crt_phosphor_term term[CRT_MAX_TERMS];
    double relative_luminance; /* P31 = 100; 0 = not published */
    struct crt_persistence tektronix, jedec;
    enum crt_persistence_source made_from;
    const char *source; /* of the colour and the terms */
    const char *note;   /* ranges, doubts; may be "" */
};

/* The built-in rows. */
const struct crt_phosphor *crt_phosphors(size_t *count);

/* Looks a phosphor up by name, without regard to case; NULL when there is none. */
const struct crt_phosphor *crt_phosphor_find(const char *name);

/* Light at time t_s after an impulse of unit energy, in 1/s, all colours together. */
double crt_phosphor_impulse(const struct crt_phosphor *p, double t_s);

/* The time the model takes to fall to `fraction` of its value at t = 0, by root-finding, seconds;
 * 0 for fraction >= 1, infinity for fraction <= 0. */
double crt_phosphor_decay_time(const struct crt_phosphor *p, double fraction);

/* Modulation of the light at `hz` when the phosphor is struck `hz` times a second: the amplitude of
 * the fundamental over the mean, C1 = 2·|Σ w_k/(1 + j2πf·τ_k)|, 0…2. */
double crt_phosphor_c1(const struct crt_phosphor *p, double hz);

#endif
