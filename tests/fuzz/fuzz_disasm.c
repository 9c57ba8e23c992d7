/* Any words at any addresses: assemble(disassemble(x)) == x. The input is runs of words, each an
 * address, a count and the words. */
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

static unsigned take(const uint8_t **data, const uint8_t *end)
{
    unsigned value = 0;
    for (unsigned i = 0; i < 2 && *data < end; i++) {
        value |= (unsigned)*(*data)++ << (8 * i);
    }
    return value;
}

static void load(struct df_program *p, const uint8_t *data, const uint8_t *end)
{
    while (data < end) {
        uint32_t address = take(&data, end) * 2;
        unsigned count = take(&data, end) % 64 + 1;
        for (; count > 0 && data < end && address < DF_MEMORY_BYTES; count--, address += 2) {
            uint16_t word = (uint16_t)take(&data, end);
            df_program_put(p, address, word);
            if (address < DF_ADDRESS_SPACE) {
                p->entry = address;
            }
        }
    }
    if (p->entry == 0) {
        df_program_put(p, 0, 0164000);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct df_program p, again;
    struct crt_error err;
    struct df_asm_report report;
    check(df_program_init(&p, &err));
    load(&p, data, data + size);
    char *text = df_disassemble(&p);
    check(text != NULL);
    check(df_assemble_text("again", text, strlen(text), NULL, &again, &report));
    check(p.low == again.low && p.high == again.high && p.entry == again.entry);
    check(memcmp(p.words, again.words, DF_MEMORY_BYTES) == 0);
    check(memcmp(p.loaded, again.loaded, DF_MEMORY_BYTES / 2) == 0);
    for (unsigned i = 0; i + 1 < size; i += 2) {
        char line[40];
        df_disassemble_word((uint16_t)(data[i] | data[i + 1] << 8), i % 9, line, i % 40);
    }
    df_asm_report_free(&report);
    df_program_free(&again);
    df_program_free(&p);
    free(text);
    return 0;
}
