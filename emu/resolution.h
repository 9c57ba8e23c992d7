/* resolution.h — how fine a picture a tube can show: modulation against spatial frequency, and what
 * limits it.
 *
 *      light ▲ ╭╮  ╭╮                 modulation = (max − min)/(max + min)
 *            │╱  ╲╱  ╲                 of a grating whose light would be a sine from
 *            └──────────▶ mm           nothing to full, were spot and video perfect
 *
 * Models:     - Spot, any direction: a Gaussian keeps e^(−2π²σ²f²) of the modulation of f line pairs
 *               a mm. σ is that of the given current, and wider in the corner (crt/optics.h).
 *             - Video, along scan lines: the drive is the sine's 1/γ-th power, passes the amplifier
 *               (one pole at `bandwidth`), and its γ-th power is the current. Both by Fourier series.
 *             - Mask: it samples the picture; finer gratings than half a pattern a line show moiré.
 *             - Mode: two dots, or two lines, a line pair.
 *             - Addressable spots: as many as fit side by side when spots are apart by their width at
 *               60 % of the peak.
 * Units:      line pairs a mm; TV lines: lines, dark and light, to the height of the picture.
 * Source:     transforms are elementary; 3 % as the least modulation that is still seen, and 60 % for
 *             spots side by side, are conventions.
 * Ownership:  plain values.
 * Errors:     vm_resolution_on_film: out of memory, one sentence.
 * Not modelled: convergence errors (they colour edges of three-gun pictures); the faceplate's halation,
 *             which takes its share of the modulation at all but the lowest frequencies.
 */
#ifndef EMU_RESOLUTION_H
#define EMU_RESOLUTION_H

#include "crt/tube.h"
#include "raster/mode.h"

#define VM_LEAST_MODULATION 0.03

enum vm_place { VM_CENTRE, VM_CORNER, VM_PLACES };
enum vm_direction { VM_ACROSS, VM_UP, VM_DIRECTIONS }; /* gratings of upright, of level lines */

struct vm_resolution {
    const struct crt_tube_row *row;
    double sigma[VM_PLACES]; /* mm, at the current asked for */
    double sigma_least;      /* mm, centre, vanishing current */
    double dots_x, dots_y;   /* of the mode; of vector tubes addressable units */
    double speed_mm_s;       /* of the beam along a line; vector tubes 0 */
};

/* `timing`: of raster tubes, NULL for vector tubes; `current` 0…1 of full. */
void vm_resolution_init(struct vm_resolution *r, const struct crt_tube_row *row,
                        const struct ras_timing *timing, double current);

/* Modulation left of f line pairs a mm; f > 0. */
double vm_resolution_spot(const struct vm_resolution *r, enum vm_place place, double f);
double vm_resolution_at(const struct vm_resolution *r, enum vm_place place,
                        enum vm_direction direction, double f);

/* The highest frequency at which that is VM_LEAST_MODULATION. */
double vm_resolution_limit(const struct vm_resolution *r, enum vm_place place,
                           enum vm_direction direction);

/* Line pairs a mm that mask and mode allow; 0: no limit. */
double vm_resolution_mask_limit(const struct crt_tube_row *row, enum vm_direction direction);
double vm_resolution_mode_limit(const struct vm_resolution *r, enum vm_direction direction);

/* Width of the spot at 60 % of its peak, mm, for a sigma. */
double vm_resolution_width60(double sigma);

/* A grating of thin full lines, f a mm, as a Gaussian spot shows it: a series. */
double vm_resolution_lines(double sigma, double f);

/* Modulation in the centre of a film on which the tube itself drew a grating: raster tubes the sine of
 * vm_resolution_at, by scan lines of the mode; vector tubes the lines of vm_resolution_lines, by
 * strokes, whatever the direction. Spots of less current are narrower there than here. */
bool vm_resolution_on_film(const struct vm_resolution *r, enum vm_direction direction, double f,
                           double *modulation, struct crt_error *err);

#endif
