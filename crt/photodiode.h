/* photodiode.h — a photodiode on the glass: luminance at a place against time, and what lit it.
 *
 *      planes + journal ──when it is opened──▶ light stored there, per phosphor term ──┐
 *      strokes, scan lines since ──▶ deposits (those that reach the place) ────────────┴─▶ cd/m² at any instant
 *
 * Models:     an ideal sensor of luminance: a point, the mean within a disc, or the mean over the whole
 *             screen. What a piece puts there is a polynomial of time, span by span (crt/flux.h), and its
 *             integrals against the phosphor's exponentials are exact: no film, no cells, no sampling rate.
 * Accuracy:   point: 2e-6 of the highest rate at an instant, 1e-9 once a piece is done; disc: 1e-5 of what is seen of a
 *             spot in its middle; screen: strokes exact, scan lines 1e-5 of a full line. Light that was there when it
 *             was opened on a tube that has run before comes from the planes (accuracy: crt_tube_probe; discs by
 *             quadrature; the whole screen from the cells of the grid alone); a diode opened at power-on
 *             has no such light.
 * Observing:  never changes the tube: it is fed as films are. It works with any grid, a close-up's, too:
 *             pieces are integrated where they fall, not where cells are.
 * Time:       picoseconds. Luminance can be asked for from `from`, when it was opened or what came before was
 *             forgotten, to the `now` of the tube's last advance.
 * Units:      mm of the screen, cd/m², fluence cd·s/m²; per phosphor colour, as crt_tube_probe().
 * Threads:    reading moves what the diode keeps: one thread at a time for a diode, and none while its tube is
 *             advanced. What is read does not depend on what was read before.
 * Ownership:  crt_photodiode_open allocates and joins the tube's list, crt_photodiode_close leaves it and
 *             frees; close it before the tube is destroyed. Loading a snapshot into the tube restarts the
 *             diode there: its deposits are gone.
 * Errors:     open: one sentence. Out of memory later: crt_photodiode_intact() is false.
 * Whole screen: strokes and lines count with all their light, which is spread over the useful screen; within a
 *             scan line its light is spread evenly over the time it is lit.
 * Not modelled: a sensor's own bandwidth, noise and spectral sensitivity (input/pen.h has those of light pens);
 *             halation and reflections of the glass.
 */
#ifndef CRT_PHOTODIODE_H
#define CRT_PHOTODIODE_H

#include "crt/tube.h"

enum crt_photodiode_kind { CRT_DIODE_POINT, CRT_DIODE_DISC, CRT_DIODE_SCREEN };

struct crt_photodiode_desc {
    enum crt_photodiode_kind kind;
    double x_mm, y_mm;  /* of the point, or the disc's middle */
    double diameter_mm; /* of the disc, above 0 */
};

/* A piece that has put light there. */
struct crt_deposit {
    uint64_t t0, t1; /* ps, while the piece's beam was lit */
    uint32_t source; /* as crt/piece.h has it: display-file byte address, or scan line */
    double mean_t_s; /* when its light fell, on average, seconds after t0 */
    double fluence[CRT_MAX_COLOURS]; /* cd·s/m²: all that it gives here in the end */
};

struct crt_photodiode;

struct crt_photodiode *crt_photodiode_open(struct crt_tube *tube,
                                           const struct crt_photodiode_desc *desc,
                                           struct crt_error *err);
void crt_photodiode_close(struct crt_photodiode *diode);
const struct crt_photodiode_desc *crt_photodiode_desc(const struct crt_photodiode *diode);
bool crt_photodiode_intact(const struct crt_photodiode *diode, struct crt_error *err);

/* The interval luminance can be asked for. */
uint64_t crt_photodiode_from(const struct crt_photodiode *diode);
uint64_t crt_photodiode_now(const struct crt_photodiode *diode);

/* Luminance at t, cd/m² per colour. Cheap when t does not decrease from call to call. */
void crt_photodiode_read(struct crt_photodiode *diode, uint64_t t, double cd_m2[CRT_MAX_COLOURS]);
/* All colours together: luminance adds. */
double crt_photodiode_luminance(struct crt_photodiode *diode, uint64_t t);
/* The same by phosphor term: desc.phosphor->term[k] of the tube gives terms[k]. */
void crt_photodiode_terms(struct crt_photodiode *diode, uint64_t t, double cd_m2[CRT_MAX_TERMS]);

/* Deposits since `from`, in order of their t0; one that was being drawn then is among them, from there on. Valid until
 * the next advance of the tube or forgetting. */
const struct crt_deposit *crt_photodiode_deposits(const struct crt_photodiode *diode,
                                                  size_t *count);
/* What deposit i gives of the luminance at t, cd/m², all colours; and what light from before `from` gives.
 * The sum over all deposits begun before t, and of the latter, is crt_photodiode_luminance to rounding. */
double crt_photodiode_share(struct crt_photodiode *diode, size_t i, uint64_t t);
double crt_photodiode_older(const struct crt_photodiode *diode, uint64_t t);

/* Forgets deposits that were done before t: their light goes on as stored light; `from` becomes t. Nothing read from
 * then on changes by a bit. The indices of those that stay move down. */
void crt_photodiode_forget(struct crt_photodiode *diode, uint64_t t);

/* ∫ of the luminance over [t0, t1), cd·s/m² per colour; and ∫ luminance·e^(−j2π·hz·(t − t0)), all colours
 * together: both in closed form by the terms (a deposit's own extent counts). */
void crt_photodiode_gather(struct crt_photodiode *diode, uint64_t t0, uint64_t t1,
                           double cd_s_m2[CRT_MAX_COLOURS]);
struct crt_phasor {
    double re, im;
};
struct crt_phasor crt_photodiode_harmonic(struct crt_photodiode *diode, uint64_t t0, uint64_t t1,
                                          double hz);

#endif
