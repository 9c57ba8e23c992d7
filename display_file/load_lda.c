/* .lda: DEC absolute loader tapes. */
#include "display_file/loaders.h"

#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"

#define HEADER 6 /* 001 000, count, address: the count includes them */

struct tape {
    const char *name;
    const uint8_t *bytes;
    size_t length, position;
    struct df_program *program;
    struct crt_error *err;
    uint8_t *memory; /* bytes as loaded */
    uint8_t *present;
    bool transfer_given;
    uint32_t transfer;
};

static unsigned word_at(const struct tape *t, size_t at)
{
    return (unsigned)(t->bytes[at] | t->bytes[at + 1] << 8);
}

/* To the next block: zeros between blocks are blank tape. False at the end. */
static bool skip_blank(struct tape *t)
{
    while (t->position < t->length && t->bytes[t->position] == 0) {
        t->position++;
    }
    return t->position < t->length;
}

static bool check_sum(const struct tape *t, size_t count)
{
    unsigned sum = 0;
    for (size_t i = 0; i <= count; i++) {
        sum += t->bytes[t->position + i];
    }
    return (sum & 0xff) == 0;
}

/* The block at the position: whole, and with a right checksum. */
static bool check_block(struct tape *t, size_t *count)
{
    size_t left = t->length - t->position;
    if (t->bytes[t->position] != 1 || (left > 1 && t->bytes[t->position + 1] != 0)) {
        return crt_fail(t->err,
                        "%s: byte %zu is not the start of a block (001 000); this is not "
                        "an absolute tape, or it is damaged.",
                        t->name, t->position);
    }
    *count = left < HEADER ? 0 : word_at(t, t->position + 2);
    bool bare_end = *count == HEADER && left == HEADER; /* some tapes end without a checksum */
    if (left < HEADER || (left < *count + 1 && !bare_end)) {
        return crt_fail(t->err, "%s: the block at byte %zu is cut short; read the tape again.",
                        t->name, t->position);
    }
    if (*count < HEADER) {
        return crt_fail(t->err,
                        "%s: the block at byte %zu has a count of %zu, less than its "
                        "header; the tape is damaged.",
                        t->name, t->position, *count);
    }
    if (!bare_end && !check_sum(t, *count)) {
        return crt_fail(t->err,
                        "%s: the block at byte %zu has a wrong checksum; read the tape "
                        "again.",
                        t->name, t->position);
    }
    return true;
}

/* A PDP-11 address is 16 bits, so the bytes fit the address space if they do not wrap. */
static bool take_block(struct tape *t, size_t count, bool *last)
{
    uint32_t address = word_at(t, t->position + 4);
    size_t bytes = count - HEADER;
    *last = bytes == 0;
    if (*last) {
        t->transfer_given = address % 2 == 0;
        t->transfer = address;
    }
    if (bytes > DF_ADDRESS_SPACE - address) {
        return crt_fail(t->err,
                        "%s: the block at byte %zu goes beyond address 177777; the tape is "
                        "damaged.",
                        t->name, t->position);
    }
    memcpy(t->memory + address, t->bytes + t->position + HEADER, bytes);
    memset(t->present + address, 1, bytes);
    t->position += count + 1;
    return true;
}

static bool read_blocks(struct tape *t)
{
    bool last = false;
    while (!last) {
        size_t count = 0;
        if (!skip_blank(t)) {
            return crt_fail(t->err,
                            "%s: the tape has no end block (count 6); it is cut short or "
                            "not an absolute tape.",
                            t->name);
        }
        if (!check_block(t, &count) || !take_block(t, count, &last)) {
            return false;
        }
    }
    return true;
}

static void put_words(struct tape *t)
{
    for (uint32_t a = 0; a < DF_ADDRESS_SPACE; a += 2) {
        if (t->present[a] || t->present[a + 1]) {
            df_program_put(t->program, a, (uint16_t)(t->memory[a] | t->memory[a + 1] << 8));
        }
    }
}

/* ---- display file or PDP-11 program? ---- */

static bool executes(uint16_t word)
{
    return !(word & DF_CONTROL) || word < DF_SET_MODE + ((DF_MODE_RELPOINT + 1) << DF_MODE_SHIFT) ||
           word >= DF_JUMP;
}

/* A display file starts with a control word, and going on from there comes to a stop or back to a
 * word it has been at, over loaded words the VT11 executes. PDP-11 programs start with data words
 * (MOV, RESET, BR, JMP have bit 15 clear) or soon run into an illegal or missing word. */
static bool could_be_display_file(const struct df_program *p, uint32_t entry, uint8_t *visited)
{
    uint32_t address = entry;
    if (!p->loaded[address / 2] || !(p->words[address / 2] & DF_CONTROL)) {
        return false;
    }
    memset(visited, 0, DF_ADDRESS_SPACE);
    while (address < DF_ADDRESS_SPACE && p->loaded[address / 2] && !visited[address]) {
        uint16_t word = p->words[address / 2];
        visited[address] = 1;
        if (!executes(word)) {
            return false;
        }
        if (word >= DF_STATUS_A && word < DF_STATUS_B && word & DF_LSA_STOP) {
            return true;
        }
        if (word >= DF_JUMP && word < DF_NOP) {
            if (address + 2 >= DF_ADDRESS_SPACE || !p->loaded[address / 2 + 1]) {
                return false;
            }
            address = p->words[address / 2 + 1] & ~1u;
        } else {
            address += 2;
        }
    }
    return address < DF_ADDRESS_SPACE && visited[address];
}

static bool settle_entry(struct tape *t)
{
    struct df_program *p = t->program;
    if (p->low == p->high) {
        return crt_fail(t->err, "%s: the tape loads no words; there is nothing to show.", t->name);
    }
    p->entry = t->transfer_given ? t->transfer : p->low;
    if (!could_be_display_file(p, p->entry, t->present)) {
        return crt_fail(t->err,
                        "%s: no display file starts at %s %06o; this looks like a PDP-11 "
                        "program, which needs a PDP-11: only tapes of display words can be shown.",
                        t->name, t->transfer_given ? "the transfer address" : "the lowest address",
                        (unsigned)p->entry);
    }
    return true;
}

bool df_load_lda(const char *name, const uint8_t *bytes, size_t length, struct df_program *program,
                 struct crt_error *err)
{
    struct tape t = {
        .name = name, .bytes = bytes, .length = length, .program = program, .err = err};
    if (!df_program_init(program, err)) {
        return false;
    }
    t.memory = calloc(DF_ADDRESS_SPACE, 1);
    t.present = calloc(DF_ADDRESS_SPACE, 1);
    bool ok = t.memory != NULL && t.present != NULL;
    if (!ok) {
        crt_fail(err, "%s: out of memory while reading the tape; close other programs.", name);
    }
    ok = ok && df_program_name_file(program, name, err) && read_blocks(&t);
    if (ok) {
        put_words(&t);
        ok = settle_entry(&t);
    }
    free(t.memory);
    free(t.present);
    if (!ok) {
        df_program_free(program);
    }
    return ok;
}
