/* probe_csv.c — samples as CSV: one line of column names, then a line a sample. */
#include "emu/lab/probe_parts.h"
#include "emu/out_file.h"

static void print_names(FILE *out, const struct vm_probe *probe)
{
    static const char *const guns[] = {"red", "green", "blue"};
    int colours = probe->phosphor->colours;
    fputs("t_s,cd_m2", out);
    for (int c = 0; c < colours && colours > 1; c++)
        if (crt_tube_guns(probe->row) == 3)
            fprintf(out, ",cd_m2_%s", guns[c]);
        else
            fprintf(out, ",cd_m2_colour%d", c + 1);
    putc('\n', out);
}

static void print_sample(FILE *out, const struct vm_probe_wave *w, size_t i)
{
    char t[VM_SECONDS_TEXT];
    vm_plain_seconds(w->t[i], t, sizeof t);
    fprintf(out, "%s,", t);
    vm_probe_number(out, w->cd_m2[i]);
    for (int c = 0; c < w->colours && w->colours > 1; c++) {
        putc(',', out);
        vm_probe_number(out, w->colour[c][i]);
    }
    putc('\n', out);
}

bool vm_probe_write_csv(const char *path, const struct vm_probe *probe,
                        const struct vm_probe_wave *wave, struct crt_error *err)
{
    struct vm_out out;
    struct crt_error closing;
    bool ok = vm_out_open(&out, path, err);
    if (ok) {
        print_names(out.file, probe);
        for (size_t i = 0; i < wave->count; i++)
            print_sample(out.file, wave, i);
    }
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}
