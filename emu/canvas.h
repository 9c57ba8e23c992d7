/* canvas.h — text and rectangles in an RGBA picture, for what is written over the glass.
 *
 * Models:     nothing; the letters are display_file/glyphs.h, a dot is a square of `dot` pixels.
 * Units:      pixels, origin top left; straight alpha. Drawing replaces, it does not blend.
 * Ownership:  vm_canvas_resize allocates, vm_canvas_free frees.
 * Errors:     out of memory: false. What lies outside is cut off.
 */
#ifndef VM_CANVAS_H
#define VM_CANVAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Dots from letter to letter and from line to line, and from a line's top to its base line. */
#define VM_LETTER_DOTS 6
#define VM_LINE_DOTS   12
#define VM_TALL_DOTS   8

struct vm_colour {
    uint8_t r, g, b, a;
};

struct vm_box {
    int x, y, w, h;
};

struct vm_canvas {
    uint8_t *rgba;
    int width, height;
};

/* Makes the canvas width × height and transparent, if it has another size. */
bool vm_canvas_resize(struct vm_canvas *canvas, int width, int height);
void vm_canvas_free(struct vm_canvas *canvas);

void vm_canvas_fill(struct vm_canvas *canvas, struct vm_box box, struct vm_colour colour);

/* One line of text; (x, y) is its top left corner. */
void vm_canvas_text(struct vm_canvas *canvas, int x, int y, int dot, struct vm_colour colour,
                    const char *text, size_t length);

/* A piece of a text that is one line. */
struct vm_line {
    const char *text;
    size_t length;
    bool cut; /* "..." belongs at its end, within `columns` */
};

/* Breaks text at '\n' and between words into lines of at most `columns` letters. */
size_t vm_wrap(const char *text, size_t columns, struct vm_line *lines, size_t max_lines);

#endif
