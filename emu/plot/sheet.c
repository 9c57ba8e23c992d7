#include "emu/plot/sheet.h"

#include <math.h>

#include <string.h>

bool vm_sheet_open(struct vm_sheet *sheet, struct crt_image *image, struct vm_size size,
                   enum vm_plot_style style, struct vm_words *words, struct crt_error *err)
{
    sheet->image = image;
    sheet->words = words;
    sheet->look = vm_look_of(style, size);
    if (words)
        words->count = 0;
    if (!crt_image_init(image, size.width, size.height, 8, err))
        return false;
    if (!vm_ink_open(&sheet->ink, image, err)) {
        crt_image_free(image);
        return false;
    }
    vm_ink_box(&sheet->ink, (struct vm_rect){0, 0, size.width, size.height}, sheet->look.paper, 1);
    return true;
}

void vm_sheet_close(struct vm_sheet *sheet, bool keep)
{
    vm_ink_close(&sheet->ink);
    if (!keep)
        crt_image_free(sheet->image);
}

bool vm_rects_meet(struct vm_rect a, struct vm_rect b)
{
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

struct vm_rect vm_text_box(struct vm_type type, double x, double y, enum vm_side side, bool turned,
                           const char *text)
{
    struct vm_rect e = vm_text_extent(type, text);
    double before = side == VM_LEFT ? 0 : side == VM_MIDDLE ? e.x1 / 2 : e.x1;
    if (turned)
        return (struct vm_rect){x + e.y0, y + before - e.x1, x + e.y1, y + before};
    return (struct vm_rect){x - before, y + e.y0, x - before + e.x1, y + e.y1};
}

void vm_sheet_note(struct vm_sheet *sheet, enum vm_word kind, struct vm_rect box)
{
    struct vm_words *w = sheet->words;
    if (!w || w->count == (int)(sizeof w->word / sizeof *w->word))
        return;
    w->word[w->count].kind = kind;
    w->word[w->count++].box = box;
}

void vm_sheet_text(struct vm_sheet *sheet, enum vm_word kind, struct vm_type type, double x,
                   double y, enum vm_side side, bool turned, const char *text, struct vm_rgb colour)
{
    /* Base lines in the middle of a pixel are sharper. */
    if (turned)
        x = floor(x) + 0.5;
    else
        y = floor(y) + 0.5;
    struct vm_rect box = vm_text_box(type, x, y, side, turned, text);
    vm_sheet_note(sheet, kind, box);
    vm_text_draw(&sheet->ink, type, turned ? x : box.x0, turned ? box.y1 : y, turned, text, colour);
}

int vm_wrapped_lines(struct vm_type type, const char *text, double width)
{
    int lines = 0;
    while (*text) {
        text += vm_text_fits(type, text, width);
        text += strspn(text, " ");
        lines++;
    }
    return lines;
}

void vm_sheet_wrapped(struct vm_sheet *sheet, enum vm_word kind, struct vm_type type, double x,
                      double y, double width, const char *text, struct vm_rgb colour)
{
    char line[512], cut[512];
    while (*text) {
        size_t n = vm_text_fits(type, text, width),
               copied = n < sizeof line - 1 ? n : sizeof line - 1;
        memcpy(line, text, copied);
        line[copied] = '\0';
        vm_text_cut(type, line, width, cut, sizeof cut);
        vm_sheet_text(sheet, kind, type, x, y, VM_LEFT, false, cut, colour);
        y += type.size * VM_LINE_STEP;
        text += n;
        text += strspn(text, " ");
    }
}

bool vm_has(const char *text)
{
    return text && text[0];
}

struct vm_heading vm_heading_of(const struct vm_look *look, const char *text, double width)
{
    struct vm_heading h = {look->title, 1, 0};
    if (!vm_has(text))
        return (struct vm_heading){look->title, 0, 0};
    double wide = vm_text_width(h.type, text);
    if (wide > width)
        h.type.size = h.type.size * width / wide * 0.99;
    if (h.type.size < look->type.size) {
        h.type.size = look->type.size;
        h.lines = vm_wrapped_lines(h.type, text, width);
    }
    h.height = (h.lines - 1) * h.type.size * VM_LINE_STEP + h.type.size * (look->scope ? 1.2 : 1.4);
    return h;
}

void vm_sheet_heading(struct vm_sheet *sheet, const struct vm_heading *heading, double x, double y,
                      double width, const char *text)
{
    if (heading->lines > 0)
        vm_sheet_wrapped(sheet, VM_WORD_TITLE, heading->type, x, y + 0.85 * heading->type.size,
                         heading->lines == 1 ? 1e9 : width, text, sheet->look.text);
}
