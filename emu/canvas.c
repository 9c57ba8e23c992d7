#include "emu/canvas.h"

#include <stdlib.h>
#include <string.h>

#include "display_file/glyphs.h"

/* Dots that a descending letter is lowered by (display_file/glyphs.h). */
#define DESCENT 2

bool vm_canvas_resize(struct vm_canvas *canvas, int width, int height)
{
    if (canvas->rgba && canvas->width == width && canvas->height == height)
        return true;
    free(canvas->rgba);
    canvas->rgba = calloc((size_t)width * (size_t)height, 4);
    canvas->width = width;
    canvas->height = height;
    return canvas->rgba != NULL;
}

void vm_canvas_free(struct vm_canvas *canvas)
{
    free(canvas->rgba);
    canvas->rgba = NULL;
}

void vm_canvas_fill(struct vm_canvas *canvas, struct vm_box box, struct vm_colour colour)
{
    int left = box.x > 0 ? box.x : 0, top = box.y > 0 ? box.y : 0;
    int right = box.x + box.w < canvas->width ? box.x + box.w : canvas->width;
    int bottom = box.y + box.h < canvas->height ? box.y + box.h : canvas->height;
    for (int y = top; y < bottom; y++) {
        uint8_t *p = canvas->rgba + ((size_t)y * (size_t)canvas->width + (size_t)left) * 4;
        for (int x = left; x < right; x++, p += 4) {
            p[0] = colour.r;
            p[1] = colour.g;
            p[2] = colour.b;
            p[3] = colour.a;
        }
    }
}

static void draw_letter(struct vm_canvas *canvas, int x, int y, int dot, struct vm_colour colour,
                        unsigned char letter)
{
    const struct df_glyph *glyph = df_glyph_ascii(letter);
    if (!glyph)
        glyph = df_glyph_ascii(0177);
    if (glyph->descends)
        y += DESCENT * dot;
    for (int column = 0; column < DF_GLYPH_COLUMNS; column++)
        for (int row = 0; row < DF_GLYPH_ROWS; row++)
            if (glyph->column[column] >> (DF_GLYPH_ROWS - 1 - row) & 1)
                vm_canvas_fill(canvas, (struct vm_box){x + column * dot, y + row * dot, dot, dot},
                               colour);
}

void vm_canvas_text(struct vm_canvas *canvas, int x, int y, int dot, struct vm_colour colour,
                    const char *text, size_t length)
{
    for (size_t i = 0; i < length && x < canvas->width; i++, x += VM_LETTER_DOTS * dot)
        draw_letter(canvas, x, y, dot, colour, (unsigned char)text[i]);
}

/* The length of the line that starts at text: all of it, or up to the last gap that fits. */
static size_t line_length(const char *text, size_t columns)
{
    size_t end = strcspn(text, "\n");
    if (end <= columns)
        return end;
    for (size_t i = columns; i > 0; i--)
        if (text[i] == ' ')
            return i;
    return columns;
}

size_t vm_wrap(const char *text, size_t columns, struct vm_line *lines, size_t max_lines)
{
    size_t count = 0;
    if (columns == 0)
        return 0;
    while (*text && count < max_lines) {
        size_t length = line_length(text, columns);
        const char *rest = text + length;
        bool broken = *rest == '\n';
        rest += broken;
        while (!broken && *rest == ' ')
            rest++;
        while (length > 0 && text[length - 1] == ' ')
            length--;
        lines[count] = (struct vm_line){text, length, false};
        text = rest;
        count++;
    }
    if (*text && count > 0) {
        struct vm_line *last = &lines[count - 1];
        last->cut = true;
        if (last->length > columns - (columns > 3 ? 3 : 0))
            last->length = columns - (columns > 3 ? 3 : 0);
    }
    return count;
}
