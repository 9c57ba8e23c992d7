/* sheet.h — the picture that a plot is drawn on, and where its words have gone.
 *
 * Ownership:  vm_sheet_open makes the picture; on success of the drawing it is the caller's.
 * Errors:     out of memory, impossible sizes.
 */
#ifndef EMU_PLOT_SHEET_H
#define EMU_PLOT_SHEET_H

#include "emu/plot/ink.h"
#include "emu/plot/letters.h"
#include "emu/plot/look.h"
#include "emu/plot/plot.h"

enum vm_word {
    VM_WORD_TITLE,
    VM_WORD_NOTE,
    VM_WORD_X_LABEL,
    VM_WORD_Y_LABEL,
    VM_WORD_X_TICK,
    VM_WORD_Y_TICK,
    VM_WORD_EXPONENT,
    VM_WORD_LEGEND, /* all of it */
    VM_WORD_MARK,
    VM_WORD_CELL, /* heat maps: the text of a cell, and the names of rows and columns are ticks */
    VM_WORD_SCALE
};

/* Where words are: for tests, which check that none covers another. */
struct vm_words {
    struct {
        enum vm_word kind;
        struct vm_rect box;
    } word[2048];
    int count;
    struct vm_rect panel[VM_PLOT_PANELS];
};

struct vm_sheet {
    struct crt_image *image;
    struct vm_ink ink;
    struct vm_look look;
    struct vm_words *words; /* may be NULL */
};

bool vm_sheet_open(struct vm_sheet *sheet, struct crt_image *image, struct vm_size size,
                   enum vm_plot_style style, struct vm_words *words, struct crt_error *err);
/* Frees the picture too unless `keep`. */
void vm_sheet_close(struct vm_sheet *sheet, bool keep);

/* How a text stands at a place: its left end, middle or right end there. */
enum vm_side { VM_LEFT, VM_MIDDLE, VM_RIGHT };

/* The box of a line of text whose place is (x, y), y its base line (turned: x the line, y the place along it). */
struct vm_rect vm_text_box(struct vm_type type, double x, double y, enum vm_side side, bool turned,
                           const char *text);
void vm_sheet_text(struct vm_sheet *sheet, enum vm_word kind, struct vm_type type, double x,
                   double y, enum vm_side side, bool turned, const char *text,
                   struct vm_rgb colour);
void vm_sheet_note(struct vm_sheet *sheet, enum vm_word kind, struct vm_rect box);

/* Lines a text needs at that width, and their drawing from the first base line y down. */
int vm_wrapped_lines(struct vm_type type, const char *text, double width);
void vm_sheet_wrapped(struct vm_sheet *sheet, enum vm_word kind, struct vm_type type, double x,
                      double y, double width, const char *text, struct vm_rgb colour);
/* A title: smaller if it is wider than `width`, on several lines if that is not enough. */
struct vm_heading {
    struct vm_type type;
    int lines;
    double height; /* of all of it */
};
struct vm_heading vm_heading_of(const struct vm_look *look, const char *text, double width);
void vm_sheet_heading(struct vm_sheet *sheet, const struct vm_heading *heading, double x, double y,
                      double width, const char *text);
/* Empty texts count as none. */
bool vm_has(const char *text);

#define VM_LINE_STEP 1.3 /* from base line to base line, of the size */

bool vm_rects_meet(struct vm_rect a, struct vm_rect b);

/* vm_plot_draw and vm_heat_draw that also tell where the words are. */
bool vm_plot_draw_words(const struct vm_plot *plot, struct vm_size size, enum vm_plot_style style,
                        struct crt_image *image, struct vm_words *words, struct crt_error *err);
bool vm_heat_draw_words(const struct vm_heat *heat, struct vm_size size, enum vm_plot_style style,
                        struct crt_image *image, struct vm_words *words, struct crt_error *err);

#endif
