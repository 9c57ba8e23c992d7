/* lesson_page.h — lessons as one page that opens offline anywhere: pictures, tables and style are in it.
 *
 *      results ─▶ contents, a section each step: text, picture, caption, command, what was measured, notes
 *
 * Nothing is fetched and nothing needs a script; a short one adds a mode that shows a step at a time. The same
 * lessons with the same results are the same bytes.
 *
 * Ownership:  nothing.
 * Errors:     "FILE:LINE: sentence", or that of a result which cannot be read.
 */
#ifndef EMU_LESSON_LESSON_PAGE_H
#define EMU_LESSON_LESSON_PAGE_H

#include "emu/lesson/lesson_text.h"

bool vm_lesson_page(FILE *out, const struct vm_lesson_results *results, int count,
                    const struct vm_lesson_look *look, struct crt_error *err);

extern const char vm_lesson_style[], vm_lesson_style_projector[], vm_lesson_script[];

#endif
