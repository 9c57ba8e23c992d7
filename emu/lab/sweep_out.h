/* sweep_out.h — where a sweep goes: a table on standard output, CSV, a picture.
 *
 *      --csv FILE|-     -o FILE.png --size WxH --projector
 *
 * Models:     nothing.
 * Ownership:  plain values; strings point into argv.
 * Errors:     an exit status and one sentence; files are written whole or not at all.
 */
#ifndef EMU_LAB_SWEEP_OUT_H
#define EMU_LAB_SWEEP_OUT_H

#include <stdio.h>

#include "crt/image.h"
#include "emu/options.h"
#include "emu/plot/plot.h"

struct vm_sweep_out {
    const char *csv, *picture;
    struct vm_size size;
    bool projector;
};

/* The rows of an option table whose struct has one of these. */
#define VM_SWEEP_OUT_ROWS(at)                                                                      \
    {"csv",                                                                                        \
     0,                                                                                            \
     VM_OPT_STRING,                                                                                \
     (at) + offsetof(struct vm_sweep_out, csv),                                                    \
     "FILE",                                                                                       \
     "write all figures as CSV; - is standard output, in place of the table",                      \
     0,                                                                                            \
     0},                                                                                           \
        {"out",                                                                                    \
         'o',                                                                                      \
         VM_OPT_STRING,                                                                            \
         (at) + offsetof(struct vm_sweep_out, picture),                                            \
         "OUT.png",                                                                                \
         "draw it; - is standard output, in place of the table",                                   \
         0,                                                                                        \
         0},                                                                                       \
        {"size",      0,                                                                           \
         VM_OPT_SIZE, (at) + offsetof(struct vm_sweep_out, size),                                  \
         "WxH",       "of the picture, in pixels; default by what is in it",                       \
         0,           0},                                                                          \
    {                                                                                              \
        "projector", 0, VM_OPT_FLAG, (at) + offsetof(struct vm_sweep_out, projector), "",          \
            "the picture with large letters", 0, 0                                                 \
    }

/* What makes the three forms of it. */
struct vm_sweep_forms {
    const void *what;
    void (*text)(FILE *to, const void *what);
    void (*csv)(FILE *to, const void *what);
    bool (*draw)(const void *what, struct vm_size size, enum vm_plot_style style,
                 struct crt_image *image, struct crt_error *err);
    struct vm_size size; /* by default */
};

/* Before long work. */
int vm_sweep_out_check(const struct vm_sweep_out *out, struct crt_error *err);
int vm_sweep_out_put(const struct vm_sweep_out *out, const struct vm_sweep_forms *forms,
                     struct crt_error *err);

#endif
