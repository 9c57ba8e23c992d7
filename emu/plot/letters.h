/* letters.h — lettering drawn with a round pen: our own stroke letters.
 *
 *      UTF-8 ──▶ code points ──▶ shapes (letters_shapes.c: lines and arcs on a grid) ──▶ plot/ink.h
 *
 * Models:     engineering lettering in the manner of ISO 3098: one pen, upright, proportional widths.
 * Units:      pixels. `size` is the height of a line of text (as a type's size in points is); capitals are 0.72
 *             of it high. The pen is (0.085·size + 0.3)·weight: small letters are a little bolder.
 * Text:       UTF-8: ASCII, Greek letters, superscripts and signs listed in letters_shapes.c. What is unknown, and
 *             bytes that are no UTF-8, show as a box.
 * Errors:     none.
 */
#ifndef EMU_PLOT_LETTERS_H
#define EMU_PLOT_LETTERS_H

#include <stddef.h>
#include <stdint.h>

#include "emu/plot/ink.h"

struct vm_type {
    double size;
    double weight; /* 1: normal; 1.3: bold */
};

#define VM_CAPITALS  0.72 /* height of capitals, of `size` */
#define VM_DESCENDER 0.30 /* how far letters hang below their line */

/* The next code point; *text moves on. 0 at the end, 0xFFFD for bytes that are no UTF-8. */
uint32_t vm_utf8_next(const char **text);

double vm_type_pen(struct vm_type type);
/* From the left end of the ink to its right end; 0 for nothing. */
double vm_text_width(struct vm_type type, const char *text);

/* The ink of the text starts at x and stands on the line y. Turned: it runs upwards, its line is at x, and
 * it starts at y. */
void vm_text_draw(struct vm_ink *ink, struct vm_type type, double x, double y, bool turned,
                  const char *text, struct vm_rgb colour);
/* The same without spreading any ink, with a pen that reaches `halo` further. */
void vm_text_cover(struct vm_ink *ink, struct vm_type type, double x, double y, bool turned,
                   const char *text, double halo);
/* The box of the ink of a text that starts at (0, 0). */
struct vm_rect vm_text_extent(struct vm_type type, const char *text);
/* The text, or as much of it as fits into `width` with an ellipsis. */
void vm_text_cut(struct vm_type type, const char *text, double width, char *cut, size_t size);

/* The longest start of the text that ends before a space (or at its end) and is no wider than `width`; at
 * least one word. In bytes. */
size_t vm_text_fits(struct vm_type type, const char *text, double width);

/* ---- shapes ----------------------------------------------------------------------------------- */

/* Grid: capitals 20 units high, small letters 14, descenders −6; VM_LETTER_GAP between the boxes of two letters.
 * Path:  "M x y" pen up to, "L x y" line to; "h x y" a quarter of an ellipse that leaves level and arrives upright,
 *        "v x y" one that leaves upright and arrives level; "c x y x y x y" a Bézier curve; "D x y" a dot;
 *        "s x y c" the letter c at 0.6 of its size. */
struct vm_letter {
    uint32_t code;
    int width;
    const char *path;
};
#define VM_LETTER_GAP     6
#define VM_LETTER_HEIGHT  20
#define VM_LETTER_SMALLER 0.6

/* The box for what is not known. */
const struct vm_letter *vm_letter_of(uint32_t code);
/* All of them, for tests. */
extern const struct vm_letter vm_letters[];
extern const int vm_letter_count;

#endif
