/* compare — do two pictures differ, where, and by how much? */
#include <math.h>
#include <stdio.h>

#include "crt/png_file.h"
#include "emu/command.h"
#include "emu/out_file.h"

enum { SAME = 0, DIFFER = 1, TROUBLE = 2 };

struct options {
    long tolerance;
    const char *diff;
    bool json;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"tolerance", 0, VM_OPT_INTEGER, ROW(tolerance), "N",
     "samples may differ by this many steps; default 0", 0, 65535},
    {"diff", 0, VM_OPT_STRING, ROW(diff), "OUT.png", "write a picture of where they differ", 0, 0},
    {"json", 0, VM_OPT_FLAG, ROW(json), "", "print the figures as JSON", 0, 0},
};

static void print_json(const struct crt_image_difference *d, bool same)
{
    printf("{\"same\": %s, \"same_shape\": %s", same ? "true" : "false",
           d->same_shape ? "true" : "false");
    if (d->same_shape) {
        printf(", \"max_difference\": %d, \"mean_difference\": %.9g, \"psnr_db\": ",
               d->max_difference, d->mean_difference);
        if (isfinite(d->psnr_db))
            printf("%.6g", d->psnr_db);
        else
            printf("null");
        printf(", \"pixels_differing\": %llu, \"first\": ",
               (unsigned long long)d->pixels_differing);
        if (d->first_x >= 0)
            printf("[%d, %d]", d->first_x, d->first_y);
        else
            printf("null");
    }
    printf("}\n");
}

static void print_text(const struct crt_image *a, const struct crt_image *b,
                       const struct crt_image_difference *d, bool same)
{
    if (!d->same_shape)
        printf("differ: %dx%d with %d bits a sample, and %dx%d with %d\n", a->width, a->height,
               a->depth, b->width, b->height, b->depth);
    else if (d->max_difference == 0)
        printf("same: every sample is equal\n");
    else if (same)
        printf("same within the tolerance: at most %d steps apart, PSNR %.1f dB\n",
               d->max_difference, d->psnr_db);
    else
        printf("differ: %llu pixels, first at %d,%d; at most %d steps apart, mean %.4g, PSNR %.1f "
               "dB\n",
               (unsigned long long)d->pixels_differing, d->first_x, d->first_y, d->max_difference,
               d->mean_difference, d->psnr_db);
}

static bool write_difference(const char *path, const struct crt_image *a, const struct crt_image *b,
                             int tolerance, struct crt_error *err)
{
    struct crt_image out;
    if (!crt_image_difference_picture(a, b, tolerance, &out, err))
        return false;
    struct vm_out file;
    struct crt_error closing;
    bool ok = vm_out_open(&file, path, err) &&
              crt_png_write_stream(file.file, file.path, &out, NULL, 0, err);
    crt_image_free(&out);
    return vm_out_close(&file, ok, ok ? err : &closing) && ok;
}

static int compare(const struct options *o, const struct crt_image *a, const struct crt_image *b)
{
    struct crt_error err;
    struct crt_image_difference d = crt_image_compare(a, b, (int)o->tolerance);
    bool same = d.same_shape && d.pixels_differing == 0;
    if (o->json)
        print_json(&d, same);
    else
        print_text(a, b, &d, same);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        crt_fail(&err, "standard output cannot be written");
        return vm_command_fail(&vm_command_compare, TROUBLE, &err);
    }
    if (o->diff && !d.same_shape)
        fprintf(stderr,
                "kinescope compare: pictures of different shape have no difference picture\n");
    else if (o->diff && !write_difference(o->diff, a, b, (int)o->tolerance, &err))
        return vm_command_fail(&vm_command_compare, TROUBLE, &err);
    return same ? SAME : DIFFER;
}

static int run(int argc, char **argv)
{
    struct options o = {0};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct vm_args args;
    struct crt_error err;
    struct crt_image a, b;
    int status = vm_command_parse(&vm_command_compare, tables, 1, argc, argv, &args, 2, 2);
    if (status >= 0)
        return status;
    if (!vm_out_spares(o.diff, args.item[0], &err) || !vm_out_spares(o.diff, args.item[1], &err))
        return vm_command_fail(&vm_command_compare, TROUBLE, &err);
    if (!crt_png_read(args.item[0], &a, &err))
        return vm_command_fail(&vm_command_compare, TROUBLE, &err);
    if (!crt_png_read(args.item[1], &b, &err)) {
        crt_image_free(&a);
        return vm_command_fail(&vm_command_compare, TROUBLE, &err);
    }
    status = compare(&o, &a, &b);
    crt_image_free(&a);
    crt_image_free(&b);
    return status;
}

const struct vm_command vm_command_compare = {
    "compare",
    "A.png B.png",
    "Compare two pictures, sample for sample",
    "Exit status: 0 same, 1 differ, 2 trouble.",
    "  kinescope compare got.png golden.png --diff diff.png\n"
    "  kinescope compare got.png golden.png --tolerance 2 --json",
    run,
};
