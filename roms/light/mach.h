/* mach.h — intensity along a row of facets, and what the eye makes of it: Mach bands.
 *
 *      flat  ──┐       Gouraud  ──╲        seen  ─╭┐      at every step, and at every bend, the eye
 *              └──              ╲──            └╯─     sees two stripes that are not there
 *
 * Models:     facets round a shiny cylinder under one light; lateral inhibition: each receptor is
 *             hindered by the mean of those around it, (1 + k)·I − k·mean, with k = MACH_INHIBITION
 *             and MACH_REACH samples to each side.
 * Cost:       about 250 instructions a sample, 350 more for what is seen.
 * Domain:     2…MACH_FACETS facets, 2…MACH_SAMPLES samples.
 * Units:      intensities 0…1; what is seen may lie beyond.
 * Ownership:  arrays of the caller's.
 * Errors:     none; counts beyond the domain are moved to its end.
 * Source:     E. Mach, Sitzungsberichte der Akademie der Wissenschaften Wien 52/2 (1865) 303; F.
 *             Ratliff, Mach Bands (1965), for the model.
 * Not modelled: the eye's logarithmic response and its resolution.
 */
#ifndef ROMS_LIGHT_MACH_H
#define ROMS_LIGHT_MACH_H

#include <stdbool.h>

enum { MACH_FACETS = 24, MACH_SAMPLES = 640, MACH_REACH = 20 };
#define MACH_INHIBITION 1.2f
#define MACH_AMBIENT    0.12f

/* The light at a place 0…1 across the facets, one intensity a facet or interpolated between its
 * edges. */
float mach_intensity(int facets, bool interpolated, float place);
/* `count` samples from edge to edge. */
void mach_profile(int facets, bool interpolated, float *intensity, int count);
/* What the eye sees of them; beyond the ends it goes on as at the ends. */
void mach_seen(const float *intensity, float *seen, int count);

#endif
