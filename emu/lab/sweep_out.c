#include "emu/lab/sweep_out.h"

#include <string.h>

#include "emu/out_file.h"

enum { OK, TROUBLE, USAGE };

int vm_sweep_out_check(const struct vm_sweep_out *out, struct crt_error *err)
{
    if (vm_out_is_stdout(out->csv) && vm_out_is_stdout(out->picture)) {
        crt_fail(err, "--csv and -o cannot both go to standard output");
        return USAGE;
    }
    if (out->csv && out->picture && strcmp(out->csv, out->picture) == 0) {
        crt_fail(err, "--csv and -o name the same file");
        return USAGE;
    }
    if (!out->picture && (out->size.width || out->projector)) {
        crt_fail(err, "%s is for a picture; give -o OUT.png, too",
                 out->projector ? "--projector" : "--size");
        return USAGE;
    }
    if ((out->csv && !vm_out_check(out->csv, err)) ||
        (out->picture && !vm_out_check(out->picture, err)))
        return TROUBLE;
    return OK;
}

static bool put_csv(const struct vm_sweep_out *out, const struct vm_sweep_forms *forms,
                    struct crt_error *err)
{
    struct vm_out file;
    struct crt_error closing;
    bool ok = vm_out_open(&file, out->csv, err);
    if (ok)
        forms->csv(file.file, forms->what);
    return vm_out_close(&file, ok, ok ? err : &closing) && ok;
}

static bool put_picture(const struct vm_sweep_out *out, const struct vm_sweep_forms *forms,
                        struct crt_error *err)
{
    struct crt_image image = {0};
    bool ok = forms->draw(forms->what, out->size.width ? out->size : forms->size,
                          out->projector ? VM_PLOT_PROJECTOR : VM_PLOT_PAPER, &image, err) &&
              vm_plot_write(out->picture, &image, NULL, err);
    crt_image_free(&image);
    return ok;
}

int vm_sweep_out_put(const struct vm_sweep_out *out, const struct vm_sweep_forms *forms,
                     struct crt_error *err)
{
    if (!vm_out_is_stdout(out->csv) && !vm_out_is_stdout(out->picture))
        forms->text(stdout, forms->what);
    if (out->csv && !put_csv(out, forms, err))
        return TROUBLE;
    if (out->picture && !put_picture(out, forms, err))
        return TROUBLE;
    return OK;
}
