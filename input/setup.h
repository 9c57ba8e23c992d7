/* setup.h — which input devices are connected, and their figures with range and source.
 *
 *      --set tablet=sonic --set tablet.rate=30 --set pen.room=500 ─▶ inp_setup_set ─▶ struct inp_setup
 *
 * Models:     nothing; the figures are those of pen.h, tablet.h, touch.h, mouse.h, keyboard.h.
 * Units:      there.
 * Ownership:  plain values; sources and names are constant.
 * Errors:     one sentence.
 */
#ifndef INPUT_SETUP_H
#define INPUT_SETUP_H

#include <stdbool.h>

#include "crt/error.h"
#include "input/keyboard.h"
#include "input/mouse.h"
#include "input/pen.h"
#include "input/tablet.h"
#include "input/touch.h"

struct inp_setup {
    unsigned has_pen, has_keyboard; /* 0 or 1 */
    struct inp_pen_setup pen;
    struct inp_tablet_setup tablet;
    struct inp_touch_setup touch;
    struct inp_mouse_setup mouse;
    struct inp_keyboard_setup keyboard;
};

/* Pen, electrical tablet, optical panel over the raster head, mechanical mouse, keyboard; every figure as
 * listed. */
void inp_setup_default(struct inp_setup *setup);

/* What is known of a screen that a pen looks at: the infrared band of a doped phosphor. Sets pen.infrared and
 * its decay for those, nothing for others. */
void inp_setup_screen(struct inp_setup *setup, const char *tube, const char *phosphor);

/* The kind of a device: pen, keyboard (none, connected), tablet, touch, mouse; touch.screen (vector,
 * raster). False: no such key (*ours false), or no such value (a sentence). */
bool inp_setup_set_kind(struct inp_setup *setup, const char *key, const char *value, bool *ours,
                        struct crt_error *err);
/* The figure "pen.aperture" …; NULL: there is none. */
struct crt_figure *inp_setup_figure(struct inp_setup *setup, const char *key, const char **unit,
                                    const char **meaning);
/* All keys in order, kinds first, for lists and suggestions; NULL at the end. */
const char *inp_setup_key(unsigned index);
/* What a kind may be, NULL at the end; NULL: that key is a figure's. */
const char *const *inp_setup_kinds(unsigned index);
/* Whether the device that an act is for is connected, and has that head, button; `heads`: a bit for each
 * enum inp_screen that there is. */
bool inp_setup_has(const struct inp_setup *setup, unsigned heads, const struct inp_act *act);
/* Whether the value lies within the range that the device can have. */
bool inp_setup_check(const struct inp_setup *setup, const char *key, struct crt_error *err);

#endif
