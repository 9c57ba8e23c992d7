/* capture_parts.h — what the files of capture share; not for others.
 *
 *      cmd_capture.c   options, pictures      capture_plan.c   when, of which head, for how long
 *
 * Time:       picoseconds.
 * Ownership:  the struct is cmd_capture.c's.
 * Errors:     an exit status and one sentence.
 */
#ifndef EMU_CAPTURE_PARTS_H
#define EMU_CAPTURE_PARTS_H

#include "emu/capture_files.h"
#include "emu/expose.h"
#include "emu/moment.h"
#include "emu/picture.h"
#include "emu/roms.h"
#include "emu/saved.h"

struct vm_capture_options {

    const char *out, *y4m, *closeup, *depth;
    struct vm_time exposure, from, to;
    struct crt_rate fps;
    struct vm_size size;
    bool film, glass, buffer, hash, allow_dark;
    struct vm_moment_options moment;
    struct vm_saved_options saved;
    struct vm_roms_options roms;
    struct vm_settings_options settings;
    struct vm_light_options light;
    struct vm_input_options input;
};

/* X,Y,WIDTH_MM of --closeup. */
struct vm_closeup {
    double x, y; /* head units */
    double width_mm;
};

/* Everything a capture needs, from options to frame. */
struct vm_capture {
    struct vm_capture_options o;
    struct vm_input input;
    struct vm_settings settings;
    struct vm_tubes tubes;
    enum vm_view view; /* never auto once planned */
    struct vm_closeup closeup;
    struct vm_shots shots;
    struct vm_studio studio, film_studio; /* the latter for --hash */
    struct vm_y4m y4m;
    struct vm_progress progress;
    bool sequence, strip;
    const struct vm_machine *machine; /* while pictures are taken */
    uint64_t loaded;                  /* when the machine of --load-state was saved; else 0 */
};

/* Takes --closeup apart. */
bool vm_capture_closeup(struct vm_capture *c, struct crt_error *err);

/* Runs the program without light to where the pictures are: when that is, which heads are looked at
 * and by what tubes, how long each picture gathers light; and whether all is well. An exit status. */
int vm_capture_plan(struct vm_capture *c, struct crt_error *err);

#endif
