/* Any bytes as a script: never a crash; refused with the place, or read into acts in order of time, each of
 * which survives being written and read again, bit for bit, alone and all together. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/script.h"

static void require(int holds)
{
    if (!holds)
        abort();
}

static void same(const struct inp_act *a, const struct inp_act *b)
{
    require(a->t == b->t && a->duration == b->duration && a->device == b->device &&
            a->verb == b->verb && a->screen == b->screen && a->space == b->space && a->x == b->x &&
            a->y == b->y && a->z == b->z && a->code == b->code && a->character == b->character);
}

static void check_sentence(const struct crt_error *err)
{
    unsigned long line = 0, column = 0;
    require(sscanf(err->text, "fuzz:%lu:%lu:", &line, &column) == 2 && line > 0 && column > 0);
    for (const char *c = err->text; *c; c++)
        require(*c >= ' ' && *c <= '~');
}

static void check_round_trip(const struct inp_script *script)
{
    char *text = malloc(script->count * INP_STATEMENT_MOST + 1);
    size_t length = 0;
    struct inp_script again;
    struct crt_error err;
    require(text != NULL);
    for (size_t i = 0; i < script->count; i++) {
        const struct inp_act *act = &script->act[i];
        require(i == 0 || act[-1].t <= act->t);
        require(act->t + act->duration <= script->end);
        size_t n = inp_script_write(act, text + length);
        require(n > 0 && n < INP_STATEMENT_MOST && strlen(text + length) == n);
        length += n;
    }
    require(inp_script_parse(&again, "again", text, length, &err));
    require(again.count == script->count);
    for (size_t i = 0; i < script->count; i++)
        same(&script->act[i], &again.act[i]);
    inp_script_free(&again);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    /* Memory of its own, so that a sanitizer sees reads past it. */
    char *text = malloc(size + !size);
    struct inp_script script;
    struct crt_error err = {""};
    require(text != NULL);
    if (size > 0)
        memcpy(text, data, size);
    if (inp_script_parse(&script, "fuzz", text, size, &err)) {
        check_round_trip(&script);
        inp_script_free(&script);
    } else {
        check_sentence(&err);
    }
    free(text);
    return 0;
}
