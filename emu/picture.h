/* picture.h — film to picture: the tube's own light, or what a viewer sees through the glass.
 *
 *      film ─┬─ --film ─▶ crt/develop (CPU, exact, one pixel a cell)      ─┬─▶ crt_image
 *            └─ --glass ▶ crt/glass (GL offscreen: OSMesa, else EGL)      ─┘
 *
 * Units:      gain 1/(cd/m²), room light cd/m².
 * Ownership:  vm_studio_open creates a GL context where one is needed, vm_studio_close frees it.
 * Errors:     one sentence.
 */
#ifndef EMU_PICTURE_H
#define EMU_PICTURE_H

#include "crt/gl_context.h"
#include "crt/glass.h"
#include "emu/settings.h"

struct vm_light_options {
    const char *gain;
    double room; /* below zero: the default */
};

#define VM_LIGHT_ROWS 2
extern const struct vm_option vm_light_rows[VM_LIGHT_ROWS];

/* Gain and glass settings for a tube; an exit status (2: --gain is not understood). */
int vm_light_settings(const struct vm_light_options *options, const struct vm_settings *settings,
                      struct crt_glass_settings *glass, struct crt_error *err);

struct vm_studio {
    bool film;                         /* develop on the CPU */
    int width, height, depth, threads; /* width and height for glass only */
    struct crt_glass_settings light;
    const struct crt_phosphor *phosphor;
    struct crt_gl_context *context;
    struct crt_glass *glass;
};

/* Opens a GL context unless studio->film; the other fields are the caller's to set before. */
bool vm_studio_open(struct vm_studio *studio, struct crt_error *err);
void vm_studio_close(struct vm_studio *studio);
/* The caller frees the image. */
bool vm_studio_picture(struct vm_studio *studio, const struct crt_film *film,
                       struct crt_image *image, struct crt_error *err);

/* True when no sample of the picture would differ from black. */
bool vm_film_is_black(const struct crt_film *film, double gain);

/* The size a picture of this tube has by default: its glass with a longer side of 1024. */
struct vm_size vm_picture_size(const struct crt_tube_row *row);

/* Writes a PNG with text chunks: program, tube, phosphor, simulated time and exposure. */
bool vm_picture_write(const char *path, const struct crt_image *image, const char *program,
                      const struct vm_settings *settings, const struct crt_film *film,
                      struct crt_error *err);

#endif
