/* glass_shaders.h — the GLSL 3.30 sources of the glass; private to it.
 *
 * Models:     see crt/glass.h. Each source follows a prefix of #version and #defines; those of the
 *             face are COLOURS 1|2|3, SAMPLE one of SAMPLE_*, CURVED, HALO, ROOM, MASK 0|1.
 * Ownership:  constant lists of pieces ended by NULL, since C99 promises only 4095 characters a
 *             string.
 */
#ifndef CRT_GLASS_SHADERS_H
#define CRT_GLASS_SHADERS_H

enum crt_glass_sample {
    CRT_SAMPLE_SMOOTH, /* the film is dark here, and what else shines varies slowly */
    CRT_SAMPLE_NONE,   /* the film is dark here */
    CRT_SAMPLE_EXACT,  /* one film cell is one pixel */
    CRT_SAMPLE_CUBIC,  /* enlarging */
    CRT_SAMPLE_AREA3,  /* reducing to no less than half: the mean over the pixel's area */
    CRT_SAMPLE_AREA,   /* reducing further */
    CRT_SAMPLES
};

extern const char *const crt_glass_vertex[];       /* the whole framebuffer: 3 vertices */
extern const char *const crt_glass_place_vertex[]; /* vertices from an array, attribute 0 */
extern const char *const crt_glass_shrink[];
extern const char *const crt_glass_blur[];
extern const char *const crt_glass_face[];
extern const char *const crt_glass_text[];

#endif
