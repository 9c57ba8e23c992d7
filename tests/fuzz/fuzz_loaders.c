/* Any bytes as .oct, .lda or raw image (the first byte chooses): a program that can be started and
 * comes back through .oct, or a sentence. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/loaders.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(bool holds)
{
    if (!holds) {
        abort();
    }
}

static void come_back(const struct df_program *p)
{
    static char text[DF_MEMORY_BYTES * 8];
    struct df_program again;
    struct crt_error err;
    FILE *out = fmemopen(text, sizeof text, "w");
    check(out != NULL);
    df_write_oct(out, p);
    long length = ftell(out);
    fclose(out);
    check(length > 0 && df_load_oct("again", text, (size_t)length, &again, &err));
    check(p->low == again.low && p->high == again.high && p->entry == again.entry);
    check(memcmp(p->words, again.words, DF_MEMORY_BYTES) == 0);
    check(memcmp(p->loaded, again.loaded, DF_MEMORY_BYTES / 2) == 0);
    df_program_free(&again);
}

static bool load_raw(const uint8_t *data, size_t size, struct df_program *p, struct crt_error *err)
{
    uint32_t base = 0, start = 0;
    if (size < 8) {
        return df_load_raw("fuzz", data, size, 0, 0, p, err);
    }
    memcpy(&base, data, 4);
    memcpy(&start, data + 4, 4);
    return df_load_raw("fuzz", data + 8, size - 8, base, start, p, err);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct df_program p;
    struct crt_error err = {""};
    if (size == 0) {
        return 0;
    }
    bool ok = data[0] % 3 == 0   ? df_load_oct("fuzz", (const char *)data + 1, size - 1, &p, &err)
              : data[0] % 3 == 1 ? df_load_lda("fuzz", data + 1, size - 1, &p, &err)
                                 : load_raw(data + 1, size - 1, &p, &err);
    if (ok) {
        check(p.low < p.high && p.loaded[p.entry / 2] && p.entry % 2 == 0);
        come_back(&p);
        df_program_free(&p);
    } else {
        check(err.text[0] != 0 && p.words == NULL);
    }
    return 0;
}
