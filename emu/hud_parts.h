/* hud_parts.h — what the files of the hud share; not for others.
 *
 *      hud.c       texts and panels        hud_marks.c     marks on the glass, a picture in a corner
 *      hud_slide.c a caption under the picture, or in place of it
 *
 * Models:     see emu/hud.h.
 * Units:      window pixels.
 * Ownership:  the hud's.
 * Errors:     none.
 */
#ifndef VM_HUD_PARTS_H
#define VM_HUD_PARTS_H

#include "emu/canvas.h"
#include "emu/hud.h"

#define VM_HUD_TEXT  600
#define VM_HUD_HELP  64
#define VM_HUD_SLIDE 1200

#define VM_HUD_PAD_DOTS 5  /* between a panel's edge and its text */
#define VM_HUD_LEVELS   16 /* steps in which a message fades: each is a redraw */

enum {
    VM_PANEL_SLIDE,
    VM_PANEL_STATUS,
    VM_PANEL_MESSAGE,
    VM_PANEL_HELP,
    VM_PANEL_PICTURE,
    VM_PANEL_CAPTION,
    VM_PANEL_LEFT,
    VM_PANEL_RIGHT,
    VM_PANEL_MARKS
};
#define VM_PANELS (VM_PANEL_MARKS + VM_HUD_MARKS)

struct vm_hud_place {
    double x, y, radius; /* radius 0: none */
};

/* What was said with vm_hud_slide(). */
struct vm_hud_kept {
    bool shown, whole, large;
    char title[200], hint[120], text[VM_HUD_SLIDE];
    uint8_t *picture; /* RGB; NULL: none */
    int width, height;
};

struct vm_hud {
    struct vm_canvas canvas;
    struct vm_box drawn[VM_PANELS]; /* what each panel covers on the canvas; w = 0: nothing */
    struct vm_colour ink;
    char status[VM_HUD_TEXT], message[VM_HUD_TEXT];
    double message_end;
    int message_level; /* VM_HUD_LEVELS = opaque, 0 = gone; as drawn */
    struct vm_hud_place mark[VM_HUD_MARKS];
    uint8_t *picture; /* RGB; NULL: none */
    int picture_width, picture_height;
    char caption[VM_HUD_TEXT];
    char side[2][VM_HUD_TEXT]; /* "": it has no halves */
    struct vm_hud_kept slide;
    bool help_shown;
    enum vm_hud_side help_side;
    char *help[VM_HUD_HELP];
    size_t help_count;
    bool stale; /* something changed since the last draw */
};

/* A dark panel with a fine rim of the ink's colour; what it covers is noted as `which`. */
void vm_hud_draw_panel(struct vm_hud *hud, int which, struct vm_box box, int dot, int level);
/* Pixels a dot. */
int vm_hud_dot(int width, int height);
void vm_hud_draw_slide(struct vm_hud *hud);
/* Marks and picture onto the canvas; where they lie is noted in hud->drawn. */
void vm_hud_draw_marks(struct vm_hud *hud);

#endif
