/* input_file.h — what kinescope can be given to show: programs and recordings, told apart.
 *
 *      .df source   .oct words   .lda DEC absolute tape   raw image (--base) ─▶ display file
 *      .elf executable                                                      ─▶ firmware
 *      .beam recording                                                      ─▶ strokes
 *
 * A display file may have firmware beside it (--firmware, or .firmware in its source) that runs it;
 * without, the stand-in does.
 *
 * Ownership:  vm_input_free releases what vm_input_load allocated.
 * Errors:     one sentence; for source with errors `report` also holds all of them (malloced, else
 *             NULL).
 */
#ifndef EMU_INPUT_FILE_H
#define EMU_INPUT_FILE_H

#include "crt/beam_file.h"
#include "display_file/program.h"
#include "emu/board/elf.h"
#include "emu/machine.h"
#include "emu/options.h"
#include "input/script.h"

struct vm_input_options {
    struct vm_octal base, start; /* of a raw image */
    const char *firmware;        /* for a display file; NULL: what the file says */
    const char *type;            /* typed on the console, with escapes; NULL: nothing */
    const char *script;          /* of acts, input/script.h; NULL: none */
};

#define VM_INPUT_ROWS 5
extern const struct vm_option vm_input_rows[VM_INPUT_ROWS];

struct vm_input {
    bool is_recording;
    bool has_firmware;
    char name[64];             /* the file's base name, printable */
    struct df_program program; /* words NULL: there is no display file */
    struct vm_elf elf;         /* the firmware, when it has some; it lies in `image` */
    char *image;
    size_t image_size; /* bytes */
    char *typed; /* malloced, typed_length bytes; NULL: nothing */
    size_t typed_length;
    struct inp_script script; /* what a person does; count 0: nothing */
    char tube[48];            /* that firmware names; "": none */
    char hand[16];            /* that firmware is made for (emu/hand.h); "": it does not say */
    char tablet[80];          /* what firmware says a tablet stands for (emu/hand.h) */
    struct crt_beam_header header;
    struct crt_stroke *strokes;
    size_t count;
};

/* Whether the options are such as can be used: escapes of --type. */
bool vm_input_check(const struct vm_input_options *options, struct crt_error *err);
/* Whether writing `out` would leave alone what is read: the program (NULL: not known), --firmware and
 * --input. */
bool vm_input_spared(const struct vm_input_options *options, const char *program, const char *out,
                     struct crt_error *err);
/* Options must have been checked. */
bool vm_input_load(struct vm_input *input, const char *path, const struct vm_input_options *options,
                   struct crt_error *err, char **report);
void vm_input_free(struct vm_input *input);

/* The tube the program was made for, as it says it: .tube in a source, or in firmware the text at the
 * symbol kinescope_tube (const char kinescope_tube[] = "VR17/P31"); NULL when it does not. */
const char *vm_input_tube(const struct vm_input *input);

/* Loads it into a machine: words and entry, firmware, or the recording. The machine of an input with
 * firmware must have a board. */
bool vm_input_insert(const struct vm_input *input, struct vm_machine *m, struct crt_error *err);

/* A regular file's bytes, malloced, with a NUL after them; NULL and a sentence, which calls it a
 * `what`, also when it has more than `most`. */
char *vm_read_file(const char *path, const char *what, uint64_t most, size_t *length,
                   struct crt_error *err);
/* The part after the last '/', with what is not printable ASCII shown as '?'. */
void vm_base_name(const char *path, char *name, size_t size);

#endif
