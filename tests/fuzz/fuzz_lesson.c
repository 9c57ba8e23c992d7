/* Any bytes as a lesson: never a crash; refused with the place, or read into lines each of which is told, printed and
 * shown, and which are the same when they are written and read again. The bytes after a NUL are what a command
 * printed: any JSON or none. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lesson/lesson_results.h"
#include "emu/lesson/lesson_text.h"

static void require(int holds)
{
    if (!holds)
        abort();
}

static void check_round_trip(const struct vm_lesson *l, size_t length)
{
    size_t size = length + (size_t)l->lines * 10 + 1, n = 0;
    char *text = malloc(size);
    struct vm_lesson again;
    struct crt_error err;
    require(text != NULL);
    for (int i = 0; i < l->lines; i++)
        n += (size_t)snprintf(text + n, size - n, "%s %s\n", vm_lesson_word_name(l->line[i].word),
                              l->line[i].text);
    require(n < size && vm_lesson_read(&again, "fuzz", text, n, &err));
    require(again.lines == l->lines);
    for (int i = 0; i < l->lines; i++)
        require(again.line[i].word == l->line[i].word &&
                strcmp(again.line[i].text, l->line[i].text) == 0 &&
                strcmp(again.line[i].file, l->line[i].file) == 0);
    vm_lesson_free(&again);
    free(text);
}

/* All commands print the same. */
static void check_printing(const struct vm_lesson *l, const char *said)
{
    static const struct vm_lesson_look look = {0};
    struct vm_lesson_results r;
    struct crt_error err;
    FILE *out = fopen("/dev/null", "w");
    require(out && vm_lesson_results_init(&r, l, "/nowhere", &err));
    require(vm_lesson_print(out, l, NULL, &look, &err));
    bool ok = true;
    for (int i = 0; ok && i < l->lines; i++)
        if (vm_lesson_runs(&l->line[i]))
            ok = vm_lesson_results_take(&r, i, strdup(said), &err);
    if (ok && !vm_lesson_print(out, l, &r, &look, &err))
        require(strncmp(err.text, "fuzz:", 5) == 0);
    vm_lesson_results_free(&r);
    fclose(out);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    const unsigned char *nul = size ? memchr(data, 0, size) : NULL;
    size_t length = nul ? (size_t)(nul - data) : size;
    char *said = calloc(1, size - length + 1);
    struct vm_lesson l;
    struct crt_error err;
    require(said != NULL);
    if (nul)
        memcpy(said, nul + 1, size - length - 1);
    if (vm_lesson_read(&l, "fuzz", (const char *)data, length, &err)) {
        check_round_trip(&l, length);
        check_printing(&l, said);
        vm_lesson_free(&l);
    } else {
        int line = 0;
        require(sscanf(err.text, "fuzz:%d: ", &line) == 1 && line > 0);
    }
    free(said);
    return 0;
}
