/* waveform.h — what a photodiode saw over some time, as samples and as figures.
 *
 * Models:     nothing. Samples are luminances at instants; figures come from the closed form between deposits,
 *             not from the samples: mean and harmonics by integration, peak and least at the ends of deposits,
 *             the flicker index (area above the mean / total area) by root-finding on each stretch between
 *             deposits. While a piece is drawn, span by span of its light (crt/flux.h): the peak by golden section
 *             next to the highest of their ends, crossings of the mean narrowed to 2^-14 of a span.
 *             A window of whole periods is wanted for harmonics: see hz.
 * Accuracy:   1e-6 against the closed forms of short flashes; peaks of different pieces that differ by less
 *             than their spans' ends show (a tenth, where a phosphor follows the spot) may be confused.
 * Units:      ps, Hz, cd/m²; percent flicker 0…100, c_n 0…2 (amplitude of the n-th harmonic over the mean),
 *             flicker index 0…1.
 * Source:     definitions as in IES RP-16 (percent flicker, flicker index).
 * Ownership:  samples belong to the caller.
 * Errors:     figures of darkness: mean 0, and the others NaN.
 */
#ifndef CRT_WAVEFORM_H
#define CRT_WAVEFORM_H

#include "crt/photodiode.h"

#define CRT_HARMONICS 8

struct crt_waveform_figures {
    double mean_cd_m2, peak_cd_m2, least_cd_m2;
    double hz;               /* of the fundamental: as given */
    double c[CRT_HARMONICS]; /* c[0] is C1 */
    double percent_flicker, flicker_index;
    double
        persistence_10_s; /* from the highest peak until a tenth of it is left without new light, by the
                                 glow that follows it; measured: the sum of the stored terms then, decaying */
    double peak_t_s;      /* of the highest peak, seconds after t0 */
};

/* Over [t0, t1) within what the diode has. `hz` > 0. */
void crt_waveform_measure(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, double hz,
                          struct crt_waveform_figures *figures);

/* c_1 … c_count of `hz`, in parts of the mean, which is above 0: as many as are wanted. */
void crt_waveform_harmonics(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, double hz,
                            double mean_cd_m2, double *c, int count);

/* How often the light repeats at that place: the rate at which deposits of the same source come again in the same
 * order, as the median of their intervals over the window, weighted by light; else, in a picture that changes, at which
 * most of the light of the same source does. 0 when nothing comes again, as in light at random. Interlaced lines come
 * again after two fields. `refresh_hz`, where known (above 0), is that of what draws: the pieces of one source within
 * a refresh are no repeats then, so nothing repeats clearly faster. Not known, and a window of less than a refresh:
 * pieces of one source at even intervals are taken for repeats. */
double crt_waveform_repeats_hz(const struct crt_photodiode *diode, uint64_t t0, uint64_t t1,
                               double refresh_hz);

/* Luminances, all colours, at n instants t0 + i·(t1 − t0)/n, rounded to ps. */
void crt_waveform_sample(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, size_t n,
                         double *cd_m2);
uint64_t crt_waveform_time(uint64_t t0, uint64_t t1, size_t n, size_t i);

/* For plots: the least and the greatest luminance within each of n equal parts of [t0, t1): a peak is seen
 * however short it is. */
struct crt_waveform_range {
    double least, most;
};
void crt_waveform_ranges(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, size_t n,
                         struct crt_waveform_range *range);

#endif
