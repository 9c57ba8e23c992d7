#include "emu/record.h"

#include "emu/out_file.h"
#include "input/script.h"

static bool write_acts(FILE *file, const struct vm_machine *m)
{
    struct vm_done done = {0, 0};
    const struct inp_act *act;
    char text[INP_STATEMENT_MOST];
    while ((done.script < m->done.script || done.live < m->done.live) &&
           (act = vm_operator_next(m->desc.person, &done))) {
        size_t n = inp_script_write(act, text);
        if (n == 0) /* nothing that a hand does in the window is such */
            fputs("# here something was done that a script has no words for\n", file);
        fwrite(text, 1, n, file);
        vm_operator_done(m->desc.person, &done);
    }
    return !ferror(file);
}

bool vm_record_save(const char *path, const struct vm_machine *m, const char *program,
                    struct crt_error *err)
{
    struct vm_out out;
    struct crt_error closing;
    bool ok = vm_out_open(&out, path, err);
    if (ok) {
        fprintf(out.file,
                "# What a person did with %s; kinescope run FILE --input does it again.\n",
                program);
        ok = write_acts(out.file, m) || crt_fail(err, "%.300s cannot be written", path);
    }
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}
