/* lesson_live.h — lessons in a window: their live commands, one after the other, with their captions.
 *
 *      lesson ─▶ live lines ─▶ run's own options ─▶ struct vm_show_page ─▶ vm_show
 *               figures that captions quote, pictures in place of what flashes: steps that are run before
 *
 * Models:     nothing. Only those steps are run whose figures or pictures are shown, so that as a rule the window
 *             opens at once.
 * Ownership:  nothing is kept; results are in a temporary folder, which is removed.
 * Errors:     an exit status and a sentence, of a live line "FILE:LINE: sentence", before a window opens. An empty
 *             sentence: all was told.
 */
#ifndef EMU_LESSON_LIVE_H
#define EMU_LESSON_LIVE_H

#include "emu/lesson/lesson_run.h"
#include "emu/quantity.h"

struct vm_lesson_live_desc {
    const struct vm_lesson *lesson;
    int count;
    const struct vm_lesson_run *run; /* how steps are run, and where roms/ is */
    bool no_flash;       /* of steps that flash a picture or plot; of others the mean light */
    struct vm_size size; /* of the window; 0: as the first page has it */
    bool full_screen;
};

int vm_lesson_live_show(const struct vm_lesson_live_desc *desc, struct crt_error *err);

#endif
