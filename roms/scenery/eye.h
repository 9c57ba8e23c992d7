/* eye.h — pictures about the eye: Mach bands with their profile, a shaded ball in few levels.
 *
 * Models:     parts of pictures that the lesson and the commands about shading share.
 * Units:      stage units; intensities 0…1.
 * Ownership:  plain values; work space is the caller's or on the stack.
 * Errors:     none.
 */
#ifndef ROMS_SCENERY_EYE_H
#define ROMS_SCENERY_EYE_H

#include "roms/light/mach.h"
#include "roms/raster/dither.h"
#include "roms/stage/stage.h"

/* ---- Mach bands ------------------------------------------------------------------------------ */

struct eye_profile {
    int facets;
    bool interpolated;
    float intensity[MACH_SAMPLES], seen[MACH_SAMPLES];
    float over, under; /* how much more and less is seen than there is, at most */
};

struct eye_facet {
    float left, middle, right, least, most;
};

void eye_profile_make(struct eye_profile *p, int facets, bool interpolated);
struct eye_facet eye_facet(const struct eye_profile *p, int facet);
/* Bands in the upper half of the picture (raster head), the profile below (both). */
void eye_mach_draw(struct stage *stage, const struct eye_profile *p);

/* ---- few levels ------------------------------------------------------------------------------ */

/* A ball in grey levels; on the vector head in dots. */
void eye_halftone_draw(struct stage *stage, float x, float y, float radius, int levels,
                       enum dither_method method);

/* Means over bands of rows of a ball of EYE_BALL pixels. */
enum { EYE_BALL = 128, EYE_BANDS = 8 };
struct eye_means {
    float wanted[EYE_BANDS], shown[EYE_BANDS];
    float all_wanted, all_shown;
};
struct eye_means eye_halftone_means(int levels, enum dither_method method);

#endif
