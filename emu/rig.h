/* rig.h — a machine with its program and, when somebody looks, its tubes; with firmware a board, a
 * console and a raster head, too: made and freed together.
 *
 * Models:     nothing; puts together what the program needs.
 * Ownership:  vm_rig_open allocates, vm_rig_close frees; settings and input must outlive the rig.
 * Errors:     one sentence.
 */
#ifndef EMU_RIG_H
#define EMU_RIG_H

#include "emu/input_file.h"
#include "emu/machine.h"
#include "emu/settings.h"

struct vm_rig {
    struct vm_machine *machine;
    struct crt_tube *tube[VM_HEADS]; /* NULL: nobody looks */
    struct vm_board *board;          /* NULL: the program has no firmware */
    uint8_t *buffer;                 /* of the raster head; the same */
    struct vm_console *console;      /* the same; its desc is for the front end to fill in */
    struct vm_operator *person;      /* with the acts of the input's script */
};

/* `tubes` may be NULL: no light at all. A raster tube is only made for a program with firmware. */
bool vm_rig_open(struct vm_rig *rig, const struct vm_settings *settings,
                 const struct vm_input *input, enum df_timing_choice timing,
                 const struct vm_tubes *tubes, struct crt_error *err);
void vm_rig_close(struct vm_rig *rig);

#endif
