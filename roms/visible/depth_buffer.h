/* depth_buffer.h — the depth of what each pixel shows.
 *
 *      larger z is nearer: the viewer looks along −z. Cleared to the far plane, the smallest depth.
 *
 * Models:     a float a pixel; who draws a pixel compares and writes it.
 * Units:      pixels, origin top left; depth: the scene's, after projection.
 * Ownership:  the floats are the caller's.
 * Errors:     none: who draws keeps within width and height.
 * Source:     E. Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces (1974).
 */
#ifndef ROMS_VISIBLE_DEPTH_BUFFER_H
#define ROMS_VISIBLE_DEPTH_BUFFER_H

struct depth_buffer {
    float *depth; /* row after row */
    int width, height;
};

/* Everything is as far as `far`. Cost: about 1.1 instructions a pixel. */
void depth_clear(const struct depth_buffer *buffer, float far);
/* A rectangle of it, cut off at the edges. */
void depth_clear_part(const struct depth_buffer *buffer, int x, int y, int width, int height,
                      float far);

#endif
