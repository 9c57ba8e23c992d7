/* Any bytes as .df source: the assembler ends, says why when it fails, and what it makes comes back
 * from the disassembler. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm.h"
#include "display_file/disasm.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(bool holds)
{
    if (!holds) {
        abort();
    }
}

/* Does a message end in this? The source lines shown below the messages do not count. */
static bool says(const char *report, const char *sentence)
{
    size_t length = strlen(sentence);
    for (const char *line = report; *line != 0;) {
        const char *end = strchr(line, '\n');
        if (line[0] != ' ' && (size_t)(end - line) >= length &&
            memcmp(end - length, sentence, length) == 0) {
            return true;
        }
        line = end + 1;
    }
    return false;
}

static void come_back(const struct df_program *p)
{
    char *text = df_disassemble(p);
    struct df_program again;
    struct df_asm_report report;
    check(text != NULL);
    check(df_assemble_text("again", text, strlen(text), NULL, &again, &report));
    check(p->low == again.low && p->high == again.high && p->entry == again.entry);
    check(strcmp(p->tube, again.tube) == 0);
    check(strcmp(p->firmware, again.firmware) == 0);
    check(memcmp(p->words, again.words, DF_MEMORY_BYTES) == 0);
    check(memcmp(p->loaded, again.loaded, DF_MEMORY_BYTES / 2) == 0);
    df_asm_report_free(&report);
    df_program_free(&again);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct df_program p;
    struct df_asm_report report;
    struct df_asm_options options = {.listing = true};
    bool ok = df_assemble_text("fuzz.df", (const char *)data, size, &options, &p, &report);
    check(ok == (report.errors == 0));
    check(ok == (report.text[0] == 0));
    check(!says(report.text, "between the passes"));
    check(!says(report.text, "is not known here"));
    if (ok) {
        check(p.low < p.high && p.loaded[p.entry / 2] && report.listing != NULL);
        come_back(&p);
        df_program_free(&p);
    } else {
        check(p.words == NULL && p.files == NULL);
    }
    df_asm_report_free(&report);
    return 0;
}
