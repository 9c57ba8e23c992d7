/* lesson_figures.h — the figures that a command prints as JSON, as a flat list of names and values.
 *
 *      {"c1": 0.445, "spots": [{"lit_mm": 2}]}  ─▶  c1 = 0.445, spots.0.lit_mm = 2
 *
 * Ownership:  vm_figures_read allocates, vm_figures_free frees.
 * Errors:     one sentence; more than 4096 figures or 16 levels are refused.
 */
#ifndef EMU_LESSON_LESSON_FIGURES_H
#define EMU_LESSON_LESSON_FIGURES_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/error.h"

enum vm_figure_kind { VM_FIGURE_NUMBER, VM_FIGURE_TEXT, VM_FIGURE_TRUTH, VM_FIGURE_NONE };

struct vm_figure {
    char *name;
    enum vm_figure_kind kind;
    double number; /* of a truth 0 or 1 */
    char *text;    /* NULL unless a text */
};

struct vm_figures {
    struct vm_figure *item;
    size_t count, room;
};

bool vm_figures_read(struct vm_figures *figures, const char *json, struct crt_error *err);
void vm_figures_free(struct vm_figures *figures);
const struct vm_figure *vm_figures_find(const struct vm_figures *figures, const char *name);

/* As text; format: "" or what stands after the colon in {name:format}: .N decimals, N significant digits, then %, s
 * or Hz. False and a sentence when the format is wrong, or is one of numbers and the figure is none. */
bool vm_figure_format(const struct vm_figure *figure, const char *format, char *text, size_t size,
                      struct crt_error *err);
bool vm_figure_format_check(const char *format, struct crt_error *err);

#endif
