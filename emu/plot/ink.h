/* ink.h — thick lines, boxes and areas with smooth edges on an 8 bit RGB picture.
 *
 *      segments, areas ──cover──▶ coverage 0…1 of every pixel ──spread(colour)──▶ the picture
 *
 * Models:     a pen with a round tip: a pixel is covered by the share of its square that lies within the line (exact
 *             along straight edges; round ends by their tangent). Coverage of the parts of one curve
 *             combines by maximum, so that joints are no darker than the rest; areas add up.
 * Light:      ink is blended in linear light (sRGB decoded), so a grey edge is as bright as the covered share
 *             and a thin line has the same weight at every angle.
 * Units:      pixels; (0, 0) is the top left corner of the top left pixel, whose centre is (½, ½).
 * Determinism: + − × ÷ sqrt floor ceil and crt/srgb.h.
 * Ownership:  the picture is the caller's; vm_ink_open allocates the coverage, vm_ink_close frees it.
 * Errors:     out of memory. What lies outside the clip is cut off; coordinates that are not finite draw nothing.
 */
#ifndef EMU_PLOT_INK_H
#define EMU_PLOT_INK_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/error.h"
#include "crt/image.h"
#include "crt/srgb.h"

struct vm_rgb {
    uint8_t r, g, b;
};

/* From (x0, y0) to, not including, (x1, y1). */
struct vm_rect {
    double x0, y0, x1, y1;
};

struct vm_ink {
    struct crt_image *image;
    float *coverage;        /* width × height, all 0 between spreads */
    int x0, y0, x1, y1;     /* clip, whole pixels */
    int bx0, by0, bx1, by1; /* what has been covered since the last spread */
    double linear[256];     /* of a sample */
    struct crt_srgb_encoder encoder;
};

bool vm_ink_open(struct vm_ink *ink, struct crt_image *image, struct crt_error *err);
void vm_ink_close(struct vm_ink *ink);

/* Nothing outside is drawn from now on; `box` is rounded to whole pixels. vm_ink_unclip: the whole picture. */
void vm_ink_clip(struct vm_ink *ink, struct vm_rect box);
void vm_ink_unclip(struct vm_ink *ink);

/* ---- cover ------------------------------------------------------------------------------------ */

void vm_ink_segment(struct vm_ink *ink, double x0, double y0, double x1, double y1, double width);
/* Between the line (x0, y0)–(x1, y1) and the level y = base; neighbours that share an x add up to one area. */
void vm_ink_area(struct vm_ink *ink, double x0, double y0, double x1, double y1, double base);

/* A curve that is drawn point by point, with or without dashes. */
struct vm_ink_pen {
    double width, on, off; /* on = 0: without dashes */
    double x, y, done;     /* where it is, and how far into the pattern */
    bool down;
};
void vm_ink_lift(struct vm_ink_pen *pen);
void vm_ink_to(struct vm_ink *ink, struct vm_ink_pen *pen, double x, double y);

/* How much is covered within the box, pixels; counted no further than `enough`. */
double vm_ink_covered(const struct vm_ink *ink, struct vm_rect box, double enough);

/* ---- spread ----------------------------------------------------------------------------------- */

/* Blends the colour into what is covered, as opaque as 0…1 says, and forgets the coverage. */
void vm_ink_spread(struct vm_ink *ink, struct vm_rgb colour, double opacity);
void vm_ink_forget(struct vm_ink *ink);

void vm_ink_box(struct vm_ink *ink, struct vm_rect box, struct vm_rgb colour, double opacity);

#endif
