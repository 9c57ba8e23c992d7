/* out_file.h — a file that is written whole or not at all.
 *
 *      vm_out_open ─▶ out.file ─▶ vm_out_close(keep) ─▶ the name holds the whole file, or what it held
 *
 * The bytes go into a file without a name in the same folder, which gets its name when it is
 * complete: a full disk, an error half-way or Ctrl-C leaves neither half a file nor a stray one.
 * Where the file system has no nameless files (O_TMPFILE), a file "NAME.pid.tmp" stands in, and
 * only a signal leaves that behind.
 * Pipes, devices and "-" (standard output) are written directly.
 * Ownership:  vm_out_open allocates, vm_out_close frees; the path must live as long.
 * Errors:     one sentence that names the file.
 */
#ifndef EMU_OUT_FILE_H
#define EMU_OUT_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "crt/error.h"

struct vm_out {
    FILE *file;
    const char *path;
    char *target;    /* what is replaced: links are followed */
    char *temporary; /* NULL: written directly */
    bool nameless;   /* `temporary` does not exist yet */
};

bool vm_out_open(struct vm_out *out, const char *path, struct crt_error *err);

/* Finishes the file; without `keep` it is dropped. Also after a vm_out_open that failed. */
bool vm_out_close(struct vm_out *out, bool keep, struct crt_error *err);

/* Whether the name is "-"; NULL is none. */
bool vm_out_is_stdout(const char *path);

/* Whether the file could be written, asked before long work; it stays as it is. */
bool vm_out_check(const char *path, struct crt_error *err);

/* Refuses to write over `input`, under whatever name. */
bool vm_out_spares(const char *path, const char *input, struct crt_error *err);

#endif
