/* flicker.h — flicker: how a phosphor struck again and again is modulated, and what of it a person sees.
 *
 *      phosphor, refresh rate ──▶ harmonics, percent flicker, flicker index (closed forms)
 *                                   │
 *      luminance, field, pupil ─────┴──▶ critical fusion frequency ──▶ flickers or does not
 *
 * Models:     steady periodic light: short pulses of equal energy through the phosphor's sum of
 *             exponentials. What is seen: Farrell, Benson and Haynie's critical fusion frequency (CFF) of
 *             95 % of viewers looking straight at a field of a given size, by retinal illuminance of the
 *             fundamental; Ferry and Porter's law for comparison; IEEE 1789's limits of modulation; the
 *             stroboscopic visibility measure only where it is valid.
 * Units:      Hz, cd/m², degrees (diameter of the field), mm (diameter of the pupil), trolands.
 * Sources:    stated with each constant in flicker.c.
 * Ownership:  plain values.
 * Errors:     none; figures that do not apply are NaN.
 * Not modelled: differences between people beyond the 95 %, surround and adaptation, eye movements, fields
 *             seen aside; that the CFF levels off above some 10⁴ trolands (CRT_FLICKER_TROLANDS).
 */
#ifndef CRT_FLICKER_H
#define CRT_FLICKER_H

#include <stdbool.h>

#include "crt/phosphor.h"

/* Light that is made anew `hz` times a second, as terms; of a phosphor, or as measured. */
struct crt_glow {
    int terms;
    double share[CRT_MAX_TERMS]; /* of the mean luminance; their sum is 1 */
    double tau_s[CRT_MAX_TERMS]; /* above 0 */
    double
        pulse; /* amplitude of the excitation's fundamental over its mean, /2: 1 for short pulses */
};
struct crt_glow crt_glow_of(const struct crt_phosphor *p);

/* C_n at `hz`, n = 1…: 2·pulse·|Σ share/(1 + j2πn·hz·tau)| (pulse counts for n = 1 only; else 1). */
double crt_glow_harmonic(const struct crt_glow *g, double hz, int n);
/* Of short pulses (whatever `pulse` is), from the steady state. Percent flicker 0…100, flicker index 0…1; NaN
 * outside 1 µHz … 1 THz. */
double crt_glow_percent_flicker(const struct crt_glow *g, double hz);
double crt_glow_flicker_index(const struct crt_glow *g, double hz);

/* Sizes in between have no published constants. */
#define CRT_FIELDS 4
extern const double crt_fields_deg[CRT_FIELDS]; /* 10, 30, 50, 70 */

struct crt_viewer {
    int field;       /* index into crt_fields_deg */
    double pupil_mm; /* 3 by default */
};

/* Up to here the CFF is known to rise with the logarithm: Tyler and Hamer, J. Opt. Soc. Am. A 7, 1990;
 * Fernandez-Alonso, Innes and Read, Vision 7, 26, 2023, who saw it level off above. */
#define CRT_FLICKER_TROLANDS 1e4

double crt_trolands(double cd_m2, double pupil_mm);
/* The CFF of modulation C1 at that frequency itself, the only one at which both agree; luminance is the mean.
 * 0: no frequency flickers; NaN: no such viewer. */
double crt_cff(const struct crt_viewer *viewer, double cd_m2, const struct crt_glow *g);
/* Whether harmonic modulation `c` at `hz` of a mean luminance is seen. */
bool crt_flickers(const struct crt_viewer *viewer, double cd_m2, double hz, double c);
/* The luminance above which refreshing at hz flickers; infinity: never. crt_flickers, crt_cff and this agree. */
double crt_flicker_luminance(const struct crt_viewer *viewer, double hz, const struct crt_glow *g);
/* Of a small field in the centre of the eye, fully modulated. */
double crt_cff_ferry_porter(double cd_m2, double pupil_mm);

/* IEEE 1789-2015's classes, by percent flicker. */
enum crt_ieee1789 { CRT_IEEE_NO_EFFECT, CRT_IEEE_LOW_RISK, CRT_IEEE_ABOVE };
enum crt_ieee1789 crt_ieee1789(double hz, double percent_flicker);
const char *crt_ieee1789_name(enum crt_ieee1789 c);

/* Stroboscopic visibility measure of harmonics c[0 … count-1] at hz, 2·hz …, of which all up to 2 kHz count; NaN where the fundamental is outside
 * 80 Hz … 2 kHz, where it says nothing. */
#define CRT_SVM_HARMONICS 25 /* as many as 80 Hz has up to 2 kHz */
double crt_svm(double hz, const double *c, int count);

#endif
