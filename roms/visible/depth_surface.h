/* depth_surface.h — the depth-buffer method: a surface, pixel by pixel, where it is the nearest.
 *
 *      z = (−A·x − B·y − D) / C        one pixel to the right: z − A/C      one row down: z − B/C
 *      z > depth(x, y):  depth(x, y) = z, pixel (x, y) = colour
 *
 * The buffer must begin with the far plane (depth_clear): one that begins with 0 hides whatever has
 * z <= 0.
 *
 * Models:     larger z is nearer; of equal depths the one drawn first stays.
 * Cost:       7 instructions a pixel that is hidden, 9 one that is shown (8 bits a pixel), about 45
 *             a row and 500 a surface: 9.4 a pixel for a box of 77 000 pixels, 15 for a ball of 256
 *             surfaces.
 * Domain:     convex surfaces in any order, which may pierce one another; canvas and buffer of one
 *             size.
 * Units:      pixels, y downwards.
 * Ownership:  nothing.
 * Errors:     none; an edge-on surface shows nothing.
 * Source:     E. Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces (1974).
 */
#ifndef ROMS_VISIBLE_DEPTH_SURFACE_H
#define ROMS_VISIBLE_DEPTH_SURFACE_H

#include "roms/raster/canvas.h"
#include "roms/visible/depth_buffer.h"
#include "roms/visible/scene.h"

void depth_surface(const struct canvas *canvas, const struct depth_buffer *buffer,
                   const struct scene *scene, const struct surface *surface);
/* All surfaces, in the order of the list. */
void depth_scene(const struct canvas *canvas, const struct depth_buffer *buffer,
                 const struct scene *scene);

#endif
