/* capture_parts.h — what the files of capture share; not for others.
 *
 *      cmd_capture.c    options, sides       capture_plan.c  when, of which head, for how long
 *      capture_steps.c  --step, --captions   capture_take.c  frames to pictures
 *      capture_write.c  pictures to files, film strips, sheets
 *
 * Sides:      a capture is of one machine, or with --versus of two: left and right. One is the case of two with
 *             one left out: all that is done is done for each side.
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
#include "emu/contact_sheet.h"
#include "emu/versus.h"

/* What may be different from side to side. */
struct vm_side_options {
    struct vm_time exposure;
    struct vm_settings_options settings;
    struct vm_light_options light;
};

/* Tables that fill it: exposure, light, settings. */
#define VM_SIDE_TABLES 3

/* Of seconds since power-on in captions: whole nanoseconds. */
#define VM_CAPTION_DIGITS 9

struct vm_capture_options {
    const char *out, *y4m, *closeup, *depth, *versus, *step, *sheet;
    struct vm_time from, to;
    struct crt_rate fps;
    struct vm_size size;
    long count;
    bool film, glass, buffer, hash, allow_dark, captions;
    struct vm_moment_options moment;
    struct vm_saved_options saved;
    struct vm_roms_options roms;
    struct vm_input_options input;
};

/* X,Y,WIDTH_MM of --closeup. */
struct vm_closeup {
    double x, y; /* head units */
    double width_mm;
};

/* The word that a step executes. */
struct vm_step_word {
    uint16_t address, word;
    uint8_t mode; /* DF_MODE_… that it is read in */
};

/* One machine and how it is looked at; its parts point at each other, so it stays where it is. */
struct vm_capture_side {
    struct vm_side_options o;
    struct vm_option_table tables[VM_SIDE_TABLES]; /* of o */
    struct vm_settings settings;
    struct vm_lights lights;
    enum vm_view view; /* never auto once planned */
    struct vm_tubes tubes;
    struct ras_timing timing;             /* of the raster head where the pictures end */
    uint64_t exposure;                    /* 0: each picture gathers the light of its step */
    uint64_t loaded;                      /* when the machine of --load-state was saved; else 0 */
    struct vm_studio studio, film_studio; /* the latter for --hash */
    struct vm_rig rig;                    /* while pictures are taken */
};

/* Everything a capture needs, from options to frame. */
struct vm_capture {
    struct vm_capture_options o;
    struct vm_versus versus;
    char caption[VM_SIDES][VM_VERSUS_CAPTION]; /* with it: of each side */
    struct vm_input input;
    struct vm_capture_side side[VM_SIDES];
    int sides;
    struct vm_closeup closeup;
    bool step; /* by units: --step */
    enum vm_unit unit;
    uint64_t all;          /* shots before some were chosen for --sheet */
    struct vm_size places; /* of --sheet; 0: there is none */
    struct vm_shots shots;
    struct crt_rate fps;       /* of the sequence; of steps, as they are played */
    struct vm_step_word *word; /* of each shot, where a step is a word; else NULL */
    struct vm_y4m y4m;
    struct vm_contact_sheet sheet;
    struct crt_image names; /* the strip of captions above two sides; samples NULL: not drawn yet */
    struct vm_progress progress;
    bool sequence, strip;
};

/* Takes --closeup apart. */
bool vm_capture_closeup(struct vm_capture *c, struct crt_error *err);

/* Runs each side without light to where the pictures are: when that is (the left side's events), which heads
 * are looked at and by what tubes, how long each picture gathers light; and whether all is well. An exit
 * status. */
int vm_capture_plan(struct vm_capture *c, struct crt_error *err);

/* What --step names; the shots from the machine's present time on, which must have no light: an exit status. */
enum vm_unit vm_capture_unit(const char *name);
int vm_capture_steps(struct vm_capture *c, struct vm_machine *m, struct crt_error *err);
/* What --captions says under picture `number`. UTF-8. */
void vm_capture_caption(const struct vm_capture *c, uint64_t number, char *text, size_t size);

/* Runs the sides with light and takes the pictures. */
bool vm_capture_take(struct vm_capture *c, struct crt_error *err);

/* capture_write.c: the place they go to can be written; a finished picture goes there; the last one has. */
bool vm_capture_check_place(const struct vm_capture *c, struct crt_error *err);
bool vm_capture_write(struct vm_capture *c, const struct crt_image *image,
                      const struct vm_frame *frame, uint64_t number, struct crt_error *err);
bool vm_capture_finish(struct vm_capture *c, bool ok, struct crt_error *err);

#endif
