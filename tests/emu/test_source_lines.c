/* Line tables: one made here byte by byte, whose rows are known; and bytes that are damaged. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "emu/lab/source_lines.h"

#define BASE 0x80000100u

/* A file of bytes, written from the front. */
struct bytes {
    uint8_t at[2048];
    size_t count;
};

static void put(struct bytes *b, const void *from, size_t count)
{
    assert_true(b->count + count <= sizeof b->at);
    memcpy(b->at + b->count, from, count);
    b->count += count;
}

static void u8(struct bytes *b, unsigned v)
{
    put(b, &(uint8_t){(uint8_t)v}, 1);
}

static void u16(struct bytes *b, unsigned v)
{
    u8(b, v & 0xFF);
    u8(b, v >> 8);
}

static void u32(struct bytes *b, uint32_t v)
{
    u16(b, v & 0xFFFF);
    u16(b, v >> 16);
}

static void patch(struct bytes *b, size_t at, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        b->at[at + (size_t)i] = (uint8_t)(v >> 8 * i);
}

/* DWARF 3, 6.2.5: opcodes. */
enum { COPY = 1, ADVANCE_PC, ADVANCE_LINE, SET_FILE };

static void set_address(struct bytes *b, uint32_t address)
{
    u8(b, 0);
    u8(b, 5);
    u8(b, 2); /* DW_LNE_set_address */
    u32(b, address);
}

static void advance(struct bytes *b, unsigned pc, unsigned line)
{
    u8(b, ADVANCE_PC);
    u8(b, pc); /* below 128: LEB128 is itself */
    u8(b, ADVANCE_LINE);
    u8(b, line); /* below 64 */
}

static void end_sequence(struct bytes *b, unsigned pc)
{
    u8(b, ADVANCE_PC);
    u8(b, pc);
    u8(b, 0);
    u8(b, 1);
    u8(b, 1);
}

/* first.c: line 10 for 8 bytes, 12 for 4; second.c: 40 for 4, which holds line 41 too, that being the
 * last row of its address. Then a gap, then line 7 of first.c; and a sequence that was discarded. */
static void program(struct bytes *b)
{
    set_address(b, BASE);
    advance(b, 0, 9);
    u8(b, COPY);
    advance(b, 8, 2);
    u8(b, COPY);
    u8(b, SET_FILE);
    u8(b, 2);
    advance(b, 4, 28);
    u8(b, COPY);
    advance(b, 0, 1);
    u8(b, COPY);
    end_sequence(b, 4);
    set_address(b, BASE + 0x40);
    advance(b, 0, 6);
    u8(b, COPY);
    end_sequence(b, 8);
    set_address(b, 0);
    u8(b, COPY);
    end_sequence(b, 100);
}

static void table(struct bytes *b)
{
    static const uint8_t lengths[] = {0, 1, 1, 1, 1, 0, 0, 0, 1};
    size_t start = b->count, header;
    u32(b, 0); /* unit_length */
    u16(b, 3);
    u32(b, 0); /* header_length */
    header = b->count;
    u8(b, 1);    /* minimum_instruction_length */
    u8(b, 1);    /* default_is_stmt */
    u8(b, 0xFB); /* line_base -5 */
    u8(b, 14);
    u8(b, 10); /* opcode_base */
    put(b, lengths, sizeof lengths);
    put(b, "roms\0", 6); /* directories */
    put(b, "first.c\0\1\0\0", 11);
    put(b, "second.c\0\1\0\0", 12);
    u8(b, 0);
    patch(b, start + 6, (uint32_t)(b->count - header));
    program(b);
    patch(b, start, (uint32_t)(b->count - start - 4));
}

static void section(struct bytes *b, uint32_t name, uint32_t type, uint32_t offset, uint32_t size)
{
    const uint32_t fields[] = {name, type, 0, 0, offset, size, 0, 0, 1, 0};
    for (size_t i = 0; i < 10; i++)
        u32(b, fields[i]);
}

/* ELF32 with nothing but names of sections and the table. */
static struct bytes file(void)
{
    static const char names[] = "\0.debug_line\0.shstrtab";
    static const uint8_t ident[16] = {0x7F, 'E', 'L', 'F', 1, 1, 1};
    struct bytes b = {.count = 0};
    put(&b, ident, sizeof ident);
    u16(&b, 2); /* executable */
    u16(&b, 243);
    u32(&b, 1);
    for (int i = 0; i < 4; i++)
        u32(&b, 0); /* entry, phoff, shoff, flags */
    u16(&b, 52);
    u16(&b, 32);
    u16(&b, 0);
    u16(&b, 40);
    u16(&b, 3);
    u16(&b, 2);
    size_t lines = b.count;
    table(&b);
    size_t strings = b.count;
    put(&b, names, sizeof names);
    while (b.count % 4)
        u8(&b, 0);
    patch(&b, 32, (uint32_t)b.count);
    section(&b, 0, 0, 0, 0);
    section(&b, 1, 1, (uint32_t)lines, (uint32_t)(strings - lines));
    section(&b, 13, 3, (uint32_t)strings, sizeof names);
    return b;
}

static void is_line(const struct vm_source_lines *l, uint32_t address, const char *name, int line)
{
    int is = 0;
    const char *file_name = vm_source_line(l, address, &is);
    if (!name) {
        assert_null(file_name);
        return;
    }
    assert_non_null(file_name);
    assert_string_equal(file_name, name);
    assert_int_equal(is, line);
}

static void rows_are_found(void **state)
{
    (void)state;
    struct bytes b = file();
    struct vm_source_lines *l = vm_source_lines_open(b.at, b.count);
    assert_non_null(l);
    is_line(l, BASE - 1, NULL, 0);
    is_line(l, BASE, "roms/first.c", 10);
    is_line(l, BASE + 7, "roms/first.c", 10);
    is_line(l, BASE + 8, "roms/first.c", 12);
    is_line(l, BASE + 12, "roms/second.c", 41);
    is_line(l, BASE + 15, "roms/second.c", 41);
    is_line(l, BASE + 16, NULL, 0);
    is_line(l, BASE + 0x40, "roms/first.c", 7);
    is_line(l, BASE + 0x48, NULL, 0);
    is_line(l, 4, NULL, 0);
    is_line(l, 0xFFFFFFFF, NULL, 0);
    vm_source_lines_free(l);
}

static void what_is_no_table_has_no_lines(void **state)
{
    (void)state;
    struct bytes b = file();
    int line;
    assert_null(vm_source_lines_open(b.at, 0));
    assert_null(vm_source_lines_open((const uint8_t *)"text", 4));
    assert_null(vm_source_lines_open(b.at, 52));
    assert_null(vm_source_line(NULL, BASE, &line));
    b.at[b.count - 80] = 2; /* the section is called debug_line, without the dot */
    assert_null(vm_source_lines_open(b.at, b.count));
}

/* A terminal must not be told to do things by a file's name. */
static void names_are_printable(void **state)
{
    (void)state;
    struct bytes b = file();
    size_t at = 0;
    while (memcmp(b.at + at, "first.c", 7) != 0)
        at++;
    b.at[at + 2] = 0x1B;
    struct vm_source_lines *l = vm_source_lines_open(b.at, b.count);
    is_line(l, BASE, "?", 10);
    is_line(l, BASE + 12, "roms/second.c", 41);
    vm_source_lines_free(l);
}

/* Whatever is damaged, what is found are lines of some file. */
static void damage_is_survived(void **state)
{
    (void)state;
    const struct bytes whole = file();
    uint64_t seed = 12345;
    for (int i = 0; i < 3000; i++) {
        struct bytes b = whole;
        for (int k = 0; k < 1 + i % 4; k++) {
            seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
            b.at[(seed >> 33) % b.count] = (uint8_t)(seed >> 20);
        }
        uint8_t *exact = malloc(b.count - (size_t)i % 60); /* for sanitizers */
        assert_non_null(exact);
        memcpy(exact, b.at, b.count - (size_t)i % 60);
        struct vm_source_lines *l = vm_source_lines_open(exact, b.count - (size_t)i % 60);
        int line = 0;
        for (uint32_t a = BASE; a < BASE + 0x50; a += 4) {
            const char *name = vm_source_line(l, a, &line);
            for (; name && *name; name++)
                assert_true((unsigned char)*name >= ' ' && *name != 0x7F);
        }
        vm_source_lines_free(l);
        free(exact);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_found),
        cmocka_unit_test(what_is_no_table_has_no_lines),
        cmocka_unit_test(names_are_printable),
        cmocka_unit_test(damage_is_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
