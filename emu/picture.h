/* picture.h — frame to picture: the tubes' own light, or what a viewer sees through the glass.
 *
 *      film ─┬─ --film ─▶ crt/develop (CPU, exact, one pixel a cell)      ─┬─▶ crt_image
 *            └─ --glass ▶ crt/glass (GL offscreen: OSMesa, else EGL)      ─┘
 *      both heads: a picture each, side by side, vector head left (emu/side.h)
 *
 * Units:      gain 1/(cd/m²), room light cd/m².
 * Ownership:  vm_studio_open creates a GL context where one is needed, vm_studio_close frees it.
 * Errors:     one sentence.
 */
#ifndef EMU_PICTURE_H
#define EMU_PICTURE_H

#include "crt/gl_context.h"
#include "crt/glass.h"
#include "emu/frame.h"

struct vm_light_options {
    const char *gain;
    double room;  /* below zero: the default */
    bool by_peak; /* --gain peak can be had here */
};

#define VM_LIGHT_ROWS 2
extern const struct vm_option vm_light_rows[VM_LIGHT_ROWS];

/* Gain and glass settings for each tube; an exit status (2: --gain is not understood). */
struct vm_lights {
    struct crt_glass_settings head[VM_HEADS];
    bool by_peak; /* the gains wait for vm_light_peaks() */
    double times; /* what is asked for, of auto or of peak */
};
int vm_light_settings(const struct vm_light_options *options, const struct vm_settings *settings,
                      struct vm_lights *lights, struct crt_error *err);

/* Gains that show these luminances, cd/m², at 0.8 of white; 0: as it is. */
void vm_light_peaks(struct vm_lights *lights, const double cd_m2[VM_HEADS]);

/* Under a microscope a mask shows: what light there is, is in few places, and as many times brighter as
 * those are few. `auto` gain, and what is relative to it, goes down by that. */
void vm_light_microscope(const struct vm_light_options *options, const struct vm_settings *settings,
                         struct vm_lights *lights);

struct vm_studio {
    bool film; /* develop on the CPU */
    int depth, threads;
    struct vm_size size[VM_HEADS]; /* of each head's picture; for glass only */
    struct vm_lights lights;
    const struct vm_settings *settings;
    struct crt_gl_context *context;
    struct crt_glass *glass[VM_HEADS];
};

/* Opens a GL context unless studio->film; the other fields are the caller's to set before. */
bool vm_studio_open(struct vm_studio *studio, struct crt_error *err);
void vm_studio_close(struct vm_studio *studio);
/* Of the heads that are in the frame. The caller frees the image. */
bool vm_studio_picture(struct vm_studio *studio, const struct vm_frame *frame,
                       struct crt_image *image, struct crt_error *err);

/* The refresh buffer as the raster head would read it now, a pixel a dot, its values as sRGB codes.
 * The caller frees the image. */
bool vm_buffer_picture(const struct vm_machine *machine, int depth, struct crt_image *image,
                       struct crt_error *err);

/* The greatest mean luminance of a cell of that head's film, cd/m²; 0: it has none. */
double vm_frame_peak(const struct vm_frame *frame, enum vm_head head);

/* True when no sample of the picture would differ from black. */
bool vm_frame_is_black(const struct vm_frame *frame, const struct vm_lights *lights);

/* The sizes of the heads' pictures: together `wanted`, or by default each tube's glass with a longer
 * side of 1024, of two both as high as the lower. */
void vm_picture_sizes(const struct vm_settings *settings, enum vm_view view, struct vm_size wanted,
                      struct vm_size size[VM_HEADS]);

/* Writes a PNG with text chunks: program, the view's tubes and phosphors, simulated time and
 * exposure. */
bool vm_picture_write(const char *path, const struct crt_image *image, const char *program,
                      const struct vm_settings *settings, enum vm_view view,
                      const struct vm_frame *frame, struct crt_error *err);

#endif
