#include "emu/cpu/rv_disasm.h"

#include <assert.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "emu/cpu/rv_disasm_rows.h"

/* ---- fields ---- */

static unsigned rd_of(uint32_t word)
{
    return word >> 7 & 31;
}

static unsigned rs1_of(uint32_t word)
{
    return word >> 15 & 31;
}

static unsigned rs2_of(uint32_t word)
{
    return word >> 20 & 31;
}

static unsigned mode_of(uint32_t word)
{
    return word >> 12 & 7;
}

/* The low `bits` as a signed number. */
static int32_t signed_of(uint32_t value, unsigned bits)
{
    uint32_t sign = UINT32_C(1) << (bits - 1);
    return (int32_t)((value & (2 * sign - 1)) ^ sign) - (int32_t)sign;
}

static int32_t i_immediate(uint32_t word)
{
    return signed_of(word >> 20, 12);
}

static int32_t s_immediate(uint32_t word)
{
    return signed_of((word >> 25 & 0x7f) << 5 | rd_of(word), 12);
}

static uint32_t branch_target(uint32_t pc, uint32_t word)
{
    uint32_t offset = (word >> 31 & 1) << 12 | (word >> 7 & 1) << 11 | (word >> 25 & 0x3f) << 5 |
                      (word >> 8 & 0xf) << 1;
    return pc + (uint32_t)signed_of(offset, 13);
}

static uint32_t jump_target(uint32_t pc, uint32_t word)
{
    uint32_t offset = (word >> 31 & 1) << 20 | (word >> 12 & 0xff) << 12 | (word >> 20 & 1) << 11 |
                      (word >> 21 & 0x3ff) << 1;
    return pc + (uint32_t)signed_of(offset, 21);
}

/* ---- rows ---- */

/* Static rounding modes; 5 and 6 are reserved, 7 is dynamic. */
static const char *const modes[8] = {",rne", ",rtz", ",rdn", ",rup", ",rmm", NULL, NULL, ""};

static bool conditions_hold(const char *text, uint32_t word)
{
    if (strstr(text, "%m") != NULL && modes[mode_of(word)] == NULL) {
        return false;
    }
    return strstr(text, "%=") == NULL || rs1_of(word) == rs2_of(word);
}

static const struct rv_disasm_row *row_of(uint32_t word)
{
    for (size_t i = 0; i < rv_disasm_row_count; i++) {
        const struct rv_disasm_row *row = &rv_disasm_rows[i];
        if ((word & row->mask) == row->match && conditions_hold(row->text, word)) {
            return row;
        }
    }
    return NULL;
}

/* ---- text ---- */

struct line {
    char *text;
    size_t size, used;
};

static void add(struct line *line, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
static void add(struct line *line, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    int length = vsnprintf(line->text + line->used, line->size - line->used, format, args);
    va_end(args);
    size_t room = line->size - line->used - 1;
    line->used += length < 0 ? 0 : (size_t)length < room ? (size_t)length : room;
}

/* The accesses that a fence orders. */
static void add_set(struct line *line, unsigned set)
{
    if (set == 0) {
        add(line, "unknown");
    }
    for (unsigned i = 0; i < 4; i++) {
        if (set & 8u >> i) {
            add(line, "%c", "iorw"[i]);
        }
    }
}

static void add_csr(struct line *line, unsigned csr)
{
    const char *name = rv_csr_name(csr);
    if (name != NULL) {
        add(line, "%s", name);
    } else {
        add(line, "0x%x", csr);
    }
}

static void add_number(struct line *line, char letter, uint32_t pc, uint32_t word)
{
    switch (letter) {
    case 'i':
        add(line, "%" PRId32, i_immediate(word));
        break;
    case 'o':
        add(line, "%" PRId32, s_immediate(word));
        break;
    case 'u':
        add(line, "0x%" PRIx32, word >> 12);
        break;
    case 'h':
        add(line, "0x%x", rs2_of(word));
        break;
    case 'z':
        add(line, "%u", rs1_of(word));
        break;
    case 'b':
        add(line, "0x%" PRIx32, branch_target(pc, word));
        break;
    case 'j':
        add(line, "0x%" PRIx32, jump_target(pc, word));
        break;
    default:
        assert(false && "a letter of rv_disasm_rows.h");
    }
}

static void add_operand(struct line *line, char letter, uint32_t pc, uint32_t word)
{
    switch (letter) {
    case 'd':
        add(line, "%s", rv_x_name(rd_of(word)));
        break;
    case 's':
        add(line, "%s", rv_x_name(rs1_of(word)));
        break;
    case 't':
        add(line, "%s", rv_x_name(rs2_of(word)));
        break;
    case 'D':
        add(line, "%s", rv_f_name(rd_of(word)));
        break;
    case 'S':
        add(line, "%s", rv_f_name(rs1_of(word)));
        break;
    case 'T':
        add(line, "%s", rv_f_name(rs2_of(word)));
        break;
    case 'R':
        add(line, "%s", rv_f_name(word >> 27));
        break;
    case 'c':
        add_csr(line, word >> 20);
        break;
    case 'p':
        add_set(line, word >> 24 & 15);
        break;
    case 'q':
        add_set(line, word >> 20 & 15);
        break;
    case 'm':
        add(line, "%s", modes[mode_of(word)]);
        break;
    case '=':
        break;
    default:
        add_number(line, letter, pc, word);
    }
}

void rv_disasm(uint32_t pc, uint32_t word, char *text, size_t size)
{
    assert(size > 0);
    struct line line = {text, size, 0};
    const struct rv_disasm_row *row = row_of(word);
    text[0] = '\0';
    if (row == NULL) {
        add(&line, ".word 0x%08" PRIx32, word);
        return;
    }
    for (const char *c = row->text; *c != '\0'; c++) {
        if (*c == '%') {
            add_operand(&line, *++c, pc, word);
        } else {
            add(&line, "%c", *c);
        }
    }
}

/* ---- what it writes ---- */

/* Of the float operations those that compare, classify, convert to and move to x. */
static bool float_writes_x(uint32_t word)
{
    unsigned group = word >> 27; /* of funct7, without the format */
    return group == 0x14 || group == 0x18 || group == 0x1c;
}

int rv_destination(uint32_t word)
{
    int rd = (int)rd_of(word);
    if (row_of(word) == NULL) {
        return -1;
    }
    switch (word & 0x7f) {
    case 0x53:
        if (!float_writes_x(word)) {
            return 32 + rd;
        }
        break;
    case 0x07: /* flw */
    case 0x43: /* fused operations */
    case 0x47:
    case 0x4b:
    case 0x4f:
        return 32 + rd;
    case 0x0f: /* fences, stores, branches */
    case 0x23:
    case 0x27:
    case 0x63:
        return -1;
    default:
        break;
    }
    return rd > 0 ? rd : -1;
}
