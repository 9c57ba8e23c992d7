/* painter.h — the painter's method: surfaces from far to near, each over those before it.
 *
 *      sorted by their farthest point; then P may be painted before Q if
 *        1  their extents do not overlap              3  Q is wholly in front of P's plane, or
 *        2  P is wholly behind Q's plane, or          4  P is nowhere nearer where outlines overlap
 *      else Q comes first. When Q has been moved before, P and Q overlap in a circle or pierce each
 *      other: no order is right.
 *
 * Models:     depth sorting with its tests; a circle is counted and P is painted as it comes.
 * Cost:       the pixels, 120 instructions a row, and the sort: 20 a pair whose depths overlap, up
 *             to 15 a corner for tests 2 and 3, 60 for test 4. A ball of 256 surfaces: 2.5 million.
 * Domain:     convex surfaces.
 * Units:      pixels, y downwards.
 * Ownership:  the state is the caller's (about 50 KB); the scene must outlive it.
 * Errors:     `circles` says how often no order was right.
 * Source:     M. E. Newell, R. G. Newell, T. L. Sancha, Proceedings of the ACM Annual Conference
 *             (1972) 443.
 * Not modelled: cutting surfaces up, which would make every scene right.
 */
#ifndef ROMS_VISIBLE_PAINTER_H
#define ROMS_VISIBLE_PAINTER_H

#include "roms/raster/canvas.h"
#include "roms/visible/scene.h"

struct painter {
    int circles; /* pairs for which there was no order */
    /* Private. */
    const struct scene *scene;
    int next, count;
    uint16_t order[SCENE_SURFACES]; /* those not yet painted from `next` on */
    bool moved[SCENE_SURFACES];
    struct painter_extent {
        float x0, x1, y0, y1, z0, z1;
    } extent[SCENE_SURFACES];
};

void painter_begin(struct painter *p, const struct scene *scene);
/* The next surface to be painted; -1: all are. */
int painter_next(struct painter *p);

/* The whole picture. */
void painter_scene(struct painter *p, const struct canvas *canvas, const struct scene *scene);
/* One surface over what is there. */
void paint_surface(const struct canvas *canvas, const struct scene *scene,
                   const struct surface *surface);

#endif
