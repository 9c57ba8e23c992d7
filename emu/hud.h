/* hud.h — text over the glass: a status line at the bottom, messages that fade, the help panel.
 *
 *      status, help, messages ─▶ vm_hud_draw (CPU, glyphs.h dots) ─▶ RGBA ─▶ crt_glass_overlay
 *
 * Models:     nothing. Text is set in the character generator's own dots, each dot a square of an
 *             integer number of window pixels, chosen from the window's size: 2 for 800 × 800,
 *             4 for 3840 × 2160. The help takes smaller dots where it would not fit.
 * Units:      window pixels; seconds for messages.
 * Text:       ASCII; '\n' ends a line. Other bytes show as a filled block. All wrap between
 *             words; what still does not fit is cut and ends in "...".
 * Ownership:  vm_hud_create allocates, vm_hud_destroy frees; texts are copied. The pixels
 *             vm_hud_draw returns are the hud's, valid until the next call of it.
 * Errors:     out of memory gives a sentence at creation, later no overlay.
 */
#ifndef VM_HUD_H
#define VM_HUD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "crt/image.h"

struct vm_hud;

struct vm_hud *vm_hud_create(struct crt_error *err);
void vm_hud_destroy(struct vm_hud *hud);

/* The status line; "" or NULL hides it. */
void vm_hud_status(struct vm_hud *hud, const char *text);

/* Letters that fit into one line of a window of width × height. */
int vm_hud_columns(int width, int height);

/* A message above the status line from `now` for `seconds`, the last of them fading; it replaces
 * the one before. */
void vm_hud_message(struct vm_hud *hud, const char *text, double now, double seconds);

/* The help panel. A line "KEY\tmeaning" is set in two columns, a line without a tab is a heading.
 */
void vm_hud_help(struct vm_hud *hud, bool shown, const char *const *lines, size_t line_count);
/* Where the panel lies from now on; at the edges alone, without status and message. */
enum vm_hud_side { VM_HUD_MIDDLE, VM_HUD_TOP, VM_HUD_BOTTOM };
void vm_hud_help_side(struct vm_hud *hud, enum vm_hud_side side);
bool vm_hud_help_shown(const struct vm_hud *hud);

/* Marks, window pixels from the top left; radius 0: none. What a light pen sees is a circle, the place of the
 * beam a cross with an open middle, a photodiode and a place asked about both. */
enum vm_hud_mark {
    VM_MARK_PEN,
    VM_MARK_BEAM,
    VM_MARK_BEAM_RASTER,
    VM_MARK_BEAM_RIGHT, /* of the right machine's heads */
    VM_MARK_BEAM_RASTER_RIGHT,
    VM_MARK_DIODE,
    VM_MARK_ASKED, /* about */
    VM_HUD_MARKS
};
void vm_hud_mark(struct vm_hud *hud, enum vm_hud_mark which, double x, double y, double radius);
/* The pen's. */
void vm_hud_ring(struct vm_hud *hud, double x, double y, double radius);

/* A picture of 8 bits in the upper right corner (of two halves between them) and a text under it, copied; NULL: none. Not shown where it
 * does not fit. */
void vm_hud_picture(struct vm_hud *hud, const struct crt_image *image, const char *caption);

/* What the left and right half of the window show, at their top; NULL: it has no halves. Text is copied. How
 * high that strip is. */
void vm_hud_sides(struct vm_hud *hud, const char *left, const char *right);
int vm_hud_strip(int width, int height);

/* A caption in large letters at the bottom, the window's width, under a title and a hint (what keys do); or
 * `whole`: in place of all that is behind, with a picture of 8 bits above the caption, or the text alone. Texts are
 * UTF-8 and copied, as the picture is. NULL: none. And how high it is: nothing else is to be drawn there. */
struct vm_hud_slide {
    const char *title, *hint, *text;
    bool whole, large; /* larger letters still */
    const struct crt_image *picture;
};
void vm_hud_slide(struct vm_hud *hud, const struct vm_hud_slide *slide);
int vm_hud_slide_height(const struct vm_hud *hud, int width, int height);

/* The colour of the text, 0…255 sRGB: the tube's phosphor. Mixed with white until it is legible. */
void vm_hud_tint(struct vm_hud *hud, int red, int green, int blue);

/* The overlay for a window of width × height at time `now`: straight alpha RGBA, top row first;
 * NULL when there is nothing to show. *changed tells whether it differs from the last call's: only
 * then need crt_glass_overlay be called. */
const uint8_t *vm_hud_draw(struct vm_hud *hud, int width, int height, double now, bool *changed);

#endif
