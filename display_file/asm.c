#include "display_file/asm.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm_state.h"

static void begin_pass(struct df_asm *as, int pass)
{
    df_asm_macros_free(as);
    as->pass = pass;
    as->steps = 0;
    as->frame_ids = 0;
    as->address = 0;
    as->address_lost = false;
    as->emitted = 0;
    as->start_given = false;
    as->mode = DF_MODE_UNSET;
    as->position = DF_NOT_KNOWN;
    as->chain = 0;
    as->frame = NULL;
}

static void run_pass(struct df_asm *as, int pass)
{
    begin_pass(as, pass);
    df_asm_run_file(as, 0);
    df_asm_even(as);
}

/* Where the display processor starts, unless .start says. */
static void settle_entry(struct df_asm *as)
{
    struct df_program *p = as->program;
    if (as->error_count > 0) {
        return;
    }
    if (p->low == p->high) {
        df_asm_error_at(as, 0, 0, 0, "no words in this program; expected at least one statement");
    } else if (as->start_given && !p->loaded[p->entry / 2]) {
        df_asm_error_at(as, as->start_file, as->start_line, as->start_column,
                        "the start address 0o%o holds no word; expected one of the program",
                        (unsigned)p->entry);
    } else if (!as->start_given && p->low >= DF_ADDRESS_SPACE) {
        df_asm_error_at(as, 0, 0, 0,
                        "no words below 0o%o, which is as far as the display processor reaches",
                        DF_ADDRESS_SPACE);
    } else if (!as->start_given) {
        p->entry = p->low;
    }
}

static bool name_files(struct df_asm *as)
{
    struct df_program *p = as->program;
    p->files = calloc(as->source_count, sizeof *p->files);
    if (p->files == NULL) {
        return false;
    }
    for (uint32_t i = 0; i < as->source_count; i++) {
        /* The assembly is over: its names pass on. */
        p->files[i] = as->sources[i].name;
        as->sources[i].name = NULL;
        p->file_count = i + 1;
    }
    return true;
}

static void release(struct df_asm *as)
{
    df_asm_errors_free(as);
    df_asm_symbols_free(as);
    df_asm_macros_free(as);
    df_asm_sources_free(as);
    free(as->rows);
    free(as->list_words);
    free(as);
}

static char *copy_text(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    return copy == NULL ? NULL : strcpy(copy, text);
}

/* A report of one sentence, for what happens before there is any source. */
static bool fail(struct df_asm_report *report, const char *sentence)
{
    report->text = copy_text(sentence);
    report->errors = 1;
    return false;
}

static bool finish(struct df_asm *as, struct df_asm_report *report)
{
    settle_entry(as);
    report->errors = as->error_count + as->errors_dropped;
    report->text = df_asm_errors_text(as);
    if (as->failures > 0 && report->errors == 0) {
        report->errors = 1; /* cannot happen: whatever fails is reported once */
    }
    if (as->listing) {
        report->listing = df_asm_listing(as);
    }
    bool ok = report->errors == 0 && name_files(as);
    if (!ok && report->errors == 0) {
        free(report->text);
        release(as);
        return fail(report, "Out of memory while assembling; close other programs.\n");
    }
    release(as);
    return ok;
}

/* Takes over `text`. */
static bool assemble(const char *name, char *text, size_t length,
                     const struct df_asm_options *options, struct df_program *program,
                     struct df_asm_report *report)
{
    struct crt_error err;
    struct df_asm *as = calloc(1, sizeof *as);
    struct df_source *sources = calloc(DF_ASM_FILES, sizeof *sources);
    if (as == NULL || sources == NULL || !df_program_init(program, &err)) {
        free(as);
        free(sources);
        free(text);
        return fail(report, "Out of memory while assembling; close other programs.\n");
    }
    as->program = program;
    as->sources = sources;
    as->listing = options != NULL && options->listing;
    if (df_asm_add_source(as, name, text, length) != UINT32_MAX && as->error_count == 0) {
        run_pass(as, 1);
        if (!as->fatal) {
            run_pass(as, 2);
        }
    } else if (as->source_count > 0 && as->sources[0].line_count > 0) {
        run_pass(as, 1);
        run_pass(as, 2);
    }
    bool ok = finish(as, report);
    if (!ok) {
        df_program_free(program);
    }
    return ok;
}

bool df_assemble_text(const char *name, const char *text, size_t length,
                      const struct df_asm_options *options, struct df_program *program,
                      struct df_asm_report *report)
{
    *report = (struct df_asm_report){0};
    *program = (struct df_program){0};
    char *copy = malloc(length + 1);
    if (copy == NULL) {
        return fail(report, "Out of memory while assembling; close other programs.\n");
    }
    if (length > 0) {
        memcpy(copy, text, length);
    }
    return assemble(name, copy, length, options, program, report);
}

bool df_assemble_file(const char *path, const struct df_asm_options *options,
                      struct df_program *program, struct df_asm_report *report)
{
    *report = (struct df_asm_report){0};
    *program = (struct df_program){0};
    char reason[128];
    size_t length = 0;
    char *text = df_asm_read(path, false, &length, reason, sizeof reason);
    if (text == NULL) {
        char sentence[512];
        snprintf(sentence, sizeof sentence, "%s: cannot be read (%s); expected a .df source file\n",
                 path, reason);
        return fail(report, sentence);
    }
    return assemble(path, text, length, options, program, report);
}

void df_asm_report_free(struct df_asm_report *report)
{
    free(report->text);
    free(report->listing);
    *report = (struct df_asm_report){0};
}
