/* roms.h — the programs that come with kinescope: the monitor, and the tour through the others.
 *
 * tour.txt in the folder has one program a line; '#' starts a comment:
 *
 *      FILE TUBE Caption to the end of the line
 *      rose.df VR17 A rose drawn by short vectors
 *
 * Tube:       - means the default.
 * Folder:     --roms DIR, else roms/ beside the command, two folders above it (where it is built),
 *             in ../share/kinescope/, or in the current folder.
 * Ownership:  plain value; at most VM_TOUR_MAX programs.
 * Errors:     one sentence with file and line.
 */
#ifndef EMU_ROMS_H
#define EMU_ROMS_H

#include <stdbool.h>

#include "crt/error.h"
#include "emu/options.h"

#define VM_TOUR_MAX 64

struct vm_roms_options {
    const char *folder; /* NULL: look for it */
};

#define VM_ROMS_ROWS 1
extern const struct vm_option vm_roms_rows[VM_ROMS_ROWS];

struct vm_rom {
    char file[64], tube[24], caption[160];
};

struct vm_roms {
    char folder[4096];
    struct vm_rom rom[VM_TOUR_MAX];
    int count;
};

/* `folder` may be NULL: it is looked for. */
bool vm_roms_find(struct vm_roms *roms, const char *folder, struct crt_error *err);
/* The file to show: `named`, or when that is NULL the monitor, whose path goes into `path`. NULL and a
 * sentence when it is not found. */
const char *vm_roms_program(const struct vm_roms_options *options, const char *named, char *path,
                            unsigned long size, struct crt_error *err);
/* The path of rom `i`. */
bool vm_roms_path(const struct vm_roms *roms, int i, char *path, unsigned long size);

#endif
