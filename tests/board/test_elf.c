/* Executable files: built here byte by byte, then damaged one thing at a time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/board/elf.h"

/* ---- a small linker ---------------------------------------------------------------------------------- */

/* Two segments, three sections (none, .symtab, .strtab, .text, .data), some symbols. */
enum {
    PHDRS = 52,
    TEXT = PHDRS + 2 * 32,
    TEXT_SIZE = 32,
    DATA = TEXT + TEXT_SIZE,
    DATA_SIZE = 8,
    SYMBOLS = DATA + DATA_SIZE,
    SYMBOL_COUNT = 12,
    STRINGS = SYMBOLS + SYMBOL_COUNT * 16,
    STRINGS_SIZE = 64,
    SECTIONS = STRINGS + STRINGS_SIZE,
    SECTION_COUNT = 5,
    SIZE = SECTIONS + SECTION_COUNT * 40,
};

static void put16(uint8_t *b, size_t at, unsigned v)
{
    b[at] = (uint8_t)v;
    b[at + 1] = (uint8_t)(v >> 8);
}

static void put32(uint8_t *b, size_t at, uint32_t v)
{
    put16(b, at, v & 0xFFFF);
    put16(b, at + 2, v >> 16);
}

static void put_words(uint8_t *b, size_t at, const uint32_t *v, size_t count)
{
    for (size_t i = 0; i < count; i++)
        put32(b, at + 4 * i, v[i]);
}

/* name, value, size; type and binding; section */
static void put_symbol(uint8_t *b, unsigned i, uint32_t name, uint32_t value, uint32_t size,
                       unsigned info, unsigned section)
{
    put_words(b, SYMBOLS + 16 * i, (const uint32_t[]){name, value, size}, 3);
    put16(b, SYMBOLS + 16 * i + 12, info);
    put16(b, SYMBOLS + 16 * i + 14, section);
}

enum { LOCAL_LABEL = 0x00, LOCAL_FUNC = 0x02, GLOBAL_LABEL = 0x10, GLOBAL_OBJECT = 0x11 };
enum { GLOBAL_FUNC = 0x12, SECTION_NAME = 0x03 };

static void put_symbols(uint8_t *b)
{
    static const char names[STRINGS_SIZE] =
        "\0_start\0main\0.L1\0$x\0counter\0end_of_all\0a\033[2Jb";
    memcpy(b + STRINGS, names, sizeof names);
    put_symbol(b, 1, 1, 0x80000000, 0, GLOBAL_LABEL, 3);       /* _start: 0 … (8) */
    put_symbol(b, 2, 8, 0x80000008, 12, GLOBAL_FUNC, 3);       /* main: 8 … 20 */
    put_symbol(b, 3, 13, 0x8000000C, 0, LOCAL_LABEL, 3);       /* .L1 */
    put_symbol(b, 4, 17, 0x80000000, 0, LOCAL_LABEL, 3);       /* $x */
    put_symbol(b, 5, 20, 0x80001000, 4, GLOBAL_OBJECT, 4);     /* counter */
    put_symbol(b, 6, 28, 0x80001010, 0, GLOBAL_LABEL, 0xFFF1); /* end_of_all, absolute */
    put_symbol(b, 7, 1, 0x80000008, 0, GLOBAL_LABEL, 3);       /* _start again, beside main */
    put_symbol(b, 8, 0, 0x80000000, 0, SECTION_NAME, 3);
    put_symbol(b, 9, 39, 0x80001004, 4, GLOBAL_OBJECT, 4); /* would clear the terminal */
    put_symbol(b, 10, 8, 0x80002000, 4, GLOBAL_FUNC, 3);   /* outside its section */
    put_symbol(b, 11, 8, 0x80000018, 4, GLOBAL_FUNC, 0);   /* undefined */
}

static void put_sections(uint8_t *b)
{
    const uint32_t section[SECTION_COUNT][10] = {
        {0},
        {0, 2, 0, 0, SYMBOLS, SYMBOL_COUNT * 16, 2, 1, 4, 16},
        {0, 3, 0, 0, STRINGS, STRINGS_SIZE, 0, 0, 1, 0},
        {0, 1, 6, 0x80000000, TEXT, TEXT_SIZE, 0, 0, 4, 0},
        {0, 1, 3, 0x80001000, DATA, DATA_SIZE, 0, 0, 4, 0},
    };
    for (unsigned i = 0; i < SECTION_COUNT; i++)
        put_words(b, SECTIONS + 40 * i, section[i], 10);
}

static void build(uint8_t b[SIZE])
{
    memset(b, 0, SIZE);
    memcpy(b, "\177ELF\1\1\1", 7);
    put16(b, 16, 2);   /* executable */
    put16(b, 18, 243); /* RISC-V */
    put32(b, 20, 1);
    put32(b, 24, 0x80000000); /* entry */
    put32(b, 28, PHDRS);
    put32(b, 32, SECTIONS);
    put32(b, 36, 2); /* single-float ABI */
    put16(b, 40, 52);
    put16(b, 42, 32);
    put16(b, 44, 2);
    put16(b, 46, 40);
    put16(b, 48, SECTION_COUNT);
    put_words(b, PHDRS,
              (const uint32_t[]){1, TEXT, 0x80000000, 0x80000000, TEXT_SIZE, TEXT_SIZE, 5, 4}, 8);
    put_words(b, PHDRS + 32,
              (const uint32_t[]){1, DATA, 0x80001000, 0x80001000, DATA_SIZE, 0x40, 6, 4}, 8);
    for (unsigned i = 0; i < TEXT_SIZE + DATA_SIZE; i++)
        b[TEXT + i] = (uint8_t)(i + 1);
    put_symbols(b);
    put_sections(b);
}

/* A copy in exactly as much memory, so that a sanitizer sees reads past it. */
static bool parse(struct vm_elf *elf, const uint8_t *b, size_t size, uint8_t **copy, char *text)
{
    struct crt_error err = {""};
    *copy = malloc(size ? size : 1);
    assert_non_null(*copy);
    memcpy(*copy, b, size);
    bool ok = vm_elf_parse(elf, "t.elf", *copy, size, &err);
    if (!ok)
        strcpy(text, err.text);
    return ok;
}

/* ---- what is right ------------------------------------------------------------------------------------- */

static void good(void **state)
{
    (void)state;
    uint8_t b[SIZE], *copy;
    struct vm_elf elf;
    char text[512] = "";
    build(b);
    assert_true(vm_elf_is(b, SIZE));
    assert_false(vm_elf_is(b, 3));
    if (!parse(&elf, b, SIZE, &copy, text))
        fail_msg("%s", text);
    assert_int_equal(elf.segments, 2);
    assert_int_equal(elf.entry, 0x80000000);
    const struct vm_elf_segment *s = elf.segment;
    assert_int_equal(s[0].address, 0x80000000);
    assert_int_equal(s[0].file_size, TEXT_SIZE);
    assert_int_equal(s[0].memory_size, TEXT_SIZE);
    assert_true(s[0].executable && !s[0].writable);
    assert_ptr_equal(s[0].bytes, copy + TEXT);
    assert_int_equal(s[1].address, 0x80001000);
    assert_int_equal(s[1].file_size, DATA_SIZE);
    assert_int_equal(s[1].memory_size, 0x40);
    assert_true(!s[1].executable && s[1].writable);
    assert_ptr_equal(s[1].bytes, copy + DATA);
    vm_elf_free(&elf);
    free(copy);
}

static void name_is(const struct vm_elf *elf, uint32_t address, const char *name, uint32_t offset)
{
    uint32_t found = 0xDEAD;
    const char *is = vm_elf_symbol(elf, address, &found);
    if (name == NULL) {
        assert_null(is);
        return;
    }
    assert_non_null(is);
    assert_string_equal(is, name);
    assert_int_equal(found, offset);
}

static void symbols(void **state)
{
    (void)state;
    uint8_t b[SIZE], *copy;
    struct vm_elf elf;
    char text[512];
    uint32_t address;
    build(b);
    assert_true(parse(&elf, b, SIZE, &copy, text));
    assert_int_equal(elf.symbols, 3);
    name_is(&elf, 0x7FFFFFFF, NULL, 0);
    name_is(&elf, 0x80000000, "_start", 0);
    name_is(&elf, 0x80000004, "_start", 4);
    name_is(&elf, 0x80000008, "main", 0);
    name_is(&elf, 0x8000000C, "main", 4);
    name_is(&elf, 0x80000013, "main", 11);
    name_is(&elf, 0x80000014, NULL, 0); /* past its size */
    name_is(&elf, 0x80001003, "counter", 3);
    name_is(&elf, 0x80001004, NULL, 0);
    name_is(&elf, 0xFFFFFFFF, NULL, 0);
    assert_true(vm_elf_find(&elf, "main", &address));
    assert_int_equal(address, 0x80000008);
    assert_false(vm_elf_find(&elf, "end_of_all", &address));
    vm_elf_free(&elf);
    free(copy);
}

/* Without size: to the end of the section. */
static void symbol_without_size(void **state)
{
    (void)state;
    uint8_t b[SIZE], *copy;
    struct vm_elf elf;
    char text[512];
    build(b);
    put32(b, SYMBOLS + 2 * 16 + 8, 0);
    assert_true(parse(&elf, b, SIZE, &copy, text));
    name_is(&elf, 0x8000001F, "main", 0x17);
    name_is(&elf, 0x80000020, NULL, 0);
    vm_elf_free(&elf);
    free(copy);
}

/* Loaded at the physical address, entered there, too. */
static void loaded_elsewhere(void **state)
{
    (void)state;
    uint8_t b[SIZE], *copy;
    struct vm_elf elf;
    char text[512];
    build(b);
    put32(b, PHDRS + 8, 0x20000000);
    put32(b, 24, 0x20000010);
    put32(b, PHDRS + 32 + 8, 0x40000000);
    assert_true(parse(&elf, b, SIZE, &copy, text));
    assert_int_equal(elf.segment[0].address, 0x80000000);
    assert_int_equal(elf.segment[1].address, 0x80001000);
    assert_int_equal(elf.entry, 0x80000010);
    vm_elf_free(&elf);
    free(copy);
}

/* In any order in the file; neighbours may touch; empty ones anywhere are left out; the last byte of
 * program memory is within it. */
static void segments(void **state)
{
    (void)state;
    uint8_t b[SIZE], *copy;
    struct vm_elf elf;
    char text[512];
    build(b);
    put32(b, PHDRS + 12, 0x80000000 + 0x01000000 - TEXT_SIZE);
    put32(b, PHDRS + 8, 0x80000000 + 0x01000000 - TEXT_SIZE);
    put32(b, 24, 0x80FFFFFC);
    put32(b, PHDRS + 32 + 12, 0x80000000 + 0x01000000 - TEXT_SIZE - 0x40);
    assert_true(parse(&elf, b, SIZE, &copy, text));
    assert_int_equal(elf.segments, 2);
    assert_int_equal(elf.segment[0].address, 0x80FFFFA0);
    assert_int_equal(elf.segment[1].address, 0x80FFFFE0);
    assert_int_equal(elf.entry, 0x80FFFFFC);
    vm_elf_free(&elf);
    free(copy);
    build(b);
    put_words(b, PHDRS + 32, (const uint32_t[]){1, 0xFFFFFFFF, 0, 0, 0, 0, 6, 4}, 8);
    assert_true(parse(&elf, b, SIZE, &copy, text));
    assert_int_equal(elf.segments, 1);
    vm_elf_free(&elf);
    free(copy);
}

/* ---- what is wrong ------------------------------------------------------------------------------------- */

struct defect {
    size_t at;
    unsigned width; /* bytes replaced by value; 0: the file is cut to `at` bytes */
    uint32_t value;
    const char *sentence;
};

#define WITH "-march=rv32imf -mabi=ilp32f"

static const struct defect defect[] = {
    {0, 0, 0, "t.elf: not an ELF file"},
    {3, 0, 0, "t.elf: not an ELF file"},
    {0, 1, 'M', "t.elf: not an ELF file"},
    {4, 0, 0, "t.elf: cut short within its ELF header, after 4 bytes"},
    {51, 0, 0, "t.elf: cut short within its ELF header, after 51 bytes"},
    {4, 1, 2, "t.elf: a 64-bit ELF file; build it for 32 bits, with " WITH "."},
    {5, 1, 2, "t.elf: a big-endian ELF file; the processor is little-endian"},
    {4, 1, 3,
     "t.elf: an ELF file of class 3, byte order 1, version 1, which do not exist; it is "
     "damaged"},
    {5, 1, 0,
     "t.elf: an ELF file of class 1, byte order 0, version 1, which do not exist; it is "
     "damaged"},
    {6, 1, 0,
     "t.elf: an ELF file of class 1, byte order 1, version 0, which do not exist; it is "
     "damaged"},
    {18, 2, 3,
     "t.elf: for machine 3, not for RISC-V (243); build it with a RISC-V compiler and " WITH "."},
    {16, 2, 1, "t.elf: an object file; link it to an executable"},
    {16, 2, 3, "t.elf: position-independent or a shared library; link it with -static -no-pie"},
    {16, 2, 4, "t.elf: of ELF type 4, not an executable (2)"},
    {36, 4, 3,
     "t.elf: has compressed instructions, which the processor has not; build all of it "
     "with " WITH " (no c)"},
    {36, 4, 4,
     "t.elf: passes floats as doubles, which the processor has not; build it with " WITH "."},
    {36, 4, 6,
     "t.elf: passes floats as quadruples, which the processor has not; build it with " WITH "."},
    {36, 4, 8, "t.elf: for the embedded RV32E; build it with " WITH "."},
    {42, 2, 56, "t.elf: program headers of 56 bytes, not 32; it is damaged"},
    {28, 4, SIZE, "t.elf: cut short: its program headers end at byte 676 of 612"},
    {28, 4, 0xFFFFFFF0, "t.elf: cut short: its program headers end at byte 4294967344 of 612"},
    {TEXT - 1, 0, 0, "t.elf: cut short: its program headers end at byte 116 of 115"},
    {44, 2, 0xFFFF, "t.elf: cut short: its program headers end at byte 2097172 of 612"},
    {44, 2, 0, "t.elf: nothing in it to load"},
    {PHDRS, 4, 2, "t.elf: dynamically linked; link it with -static"},
    {PHDRS, 4, 3, "t.elf: dynamically linked; link it with -static"},
    {PHDRS + 16, 4, 33,
     "t.elf: segment 0 has 33 bytes in the file but 32 in memory; it is damaged"},
    {PHDRS + 20, 4, 0, "t.elf: segment 0 has 32 bytes in the file but 0 in memory; it is damaged"},
    {PHDRS + 4, 4, SIZE - 31, "t.elf: cut short: segment 0 ends at byte 613 of 612"},
    {PHDRS + 4, 4, 0xFFFFFFFF, "t.elf: cut short: segment 0 ends at byte 4294967327 of 612"},
    {DATA + 7, 0, 0, "t.elf: cut short: segment 1 ends at byte 156 of 155"},
    {PHDRS + 12, 4, 0x7FFFFFFC,
     "t.elf: segment 0 is at 0x7ffffffc, 32 bytes long: not within program memory, 0x80000000 to "
     "0x80ffffff; link it there"},
    {PHDRS + 12, 4, 0x80FFFFE4,
     "t.elf: segment 0 is at 0x80ffffe4, 32 bytes long: not within program memory, 0x80000000 to "
     "0x80ffffff; link it there"},
    {PHDRS + 12, 4, 0xFFFFFFF0,
     "t.elf: segment 0 is at 0xfffffff0, 32 bytes long: not within program memory, 0x80000000 to "
     "0x80ffffff; link it there"},
    {PHDRS + 32 + 20, 4, 0xFFFFFFFF,
     "t.elf: segment 1 is at 0x80001000, 4294967295 bytes long: not within program memory, "
     "0x80000000 to 0x80ffffff; link it there"},
    {PHDRS + 32 + 12, 4, 0x8000001F,
     "t.elf: two segments overlap at 0x8000001f; correct the linker script"},
    {PHDRS + 12, 4, 0x8000103C,
     "t.elf: two segments overlap at 0x8000103c; correct the linker script"},
    {PHDRS + 20, 4, 0x00100000,
     "t.elf: two segments overlap at 0x80001000; correct the linker script"},
    {24, 4, 0x80000020,
     "t.elf: its entry 0x80000020 is in no executable segment; name it in the "
     "linker script (ENTRY)"},
    {24, 4, 0x80001000,
     "t.elf: its entry 0x80001000 is in no executable segment; name it in the "
     "linker script (ENTRY)"},
    {24, 4, 0,
     "t.elf: its entry 0x00000000 is in no executable segment; name it in the linker "
     "script (ENTRY)"},
    {24, 4, 0x80000002,
     "t.elf: its entry 0x80000002 is not a multiple of 4, as the address of an "
     "instruction is"},
};

static void defects(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof defect / sizeof defect[0]; i++) {
        const struct defect *d = &defect[i];
        uint8_t b[SIZE], *copy;
        struct vm_elf elf;
        char text[512] = "nothing";
        build(b);
        for (unsigned n = 0; n < d->width; n++)
            b[d->at + n] = (uint8_t)(d->value >> 8 * n);
        assert_false(parse(&elf, b, d->width ? SIZE : d->at, &copy, text));
        assert_string_equal(text, d->sentence);
        assert_null(elf.symbol);
        free(copy);
    }
}

/* Sixteen segments are taken, a seventeenth is one too many. */
static void many_segments(void **state)
{
    (void)state;
    static uint8_t b[52 + 17 * 32 + 4];
    for (unsigned count = 16; count <= 17; count++) {
        uint8_t whole[SIZE], *copy;
        struct vm_elf elf;
        char text[512] = "";
        build(whole);
        memset(b, 0, sizeof b);
        memcpy(b, whole, 52);
        put16(b, 44, count);
        for (unsigned i = 0; i < count; i++)
            put_words(b, 52 + 32 * i,
                      (const uint32_t[]){1, 0, 0x80000000 + (i * 7 % 17) * 16,
                                         0x80000000 + (i * 7 % 17) * 16, 4, 16, 5, 4},
                      8);
        assert_int_equal(parse(&elf, b, sizeof b, &copy, text), count == 16);
        if (count == 17)
            assert_string_equal(text, "t.elf: more than 16 segments to load; link it with fewer");
        for (int i = 1; i < elf.segments && count == 16; i++)
            assert_true(elf.segment[i - 1].address + 16 <= elf.segment[i].address);
        if (count == 16)
            vm_elf_free(&elf);
        free(copy);
    }
}

/* Tables of symbols that are wrong, each in one way: the program loads, the names are left out. */
static void bad_symbols(void **state)
{
    (void)state;
    static const struct {
        size_t at;
        unsigned width;
        uint32_t value;
        size_t left; /* symbols */
    } bad[] = {
        {32, 4, 0xFFFFFFFF, 0},                 /* section headers: where */
        {32, 4, SIZE - 199, 0},                 /* … end outside */
        {46, 2, 64, 0},                         /* … of another size */
        {48, 2, 0, 0},                          /* … none */
        {48, 2, 0xFFFF, 0},                     /* … too many */
        {SECTIONS + 40 + 4, 4, 11, 0},          /* .symtab: of another type */
        {SECTIONS + 40 + 16, 4, SIZE, 0},       /* … outside */
        {SECTIONS + 40 + 20, 4, 0xFFFFFFF0, 0}, /* … too long */
        {SECTIONS + 40 + 20, 4, 15, 0},         /* … less than one symbol */
        {SECTIONS + 40 + 24, 4, 5, 0},          /* … its strings: no such section */
        {SECTIONS + 40 + 24, 4, 3, 0},          /* … not strings */
        {SECTIONS + 80 + 16, 4, 0xFFFFFFC0, 0}, /* .strtab: outside */
        {SECTIONS + 80 + 20, 4, 0xFFFFFFFF, 0}, /* … too long */
        {SECTIONS + 80 + 20, 4, 0, 0},          /* … empty */
        {SECTIONS + 80 + 20, 4, 11, 2},         /* … cut within "main" */
        {SYMBOLS + 16, 4, 64, 2},               /* _start: name outside */
        {SYMBOLS + 16, 4, 0xFFFFFFFF, 2},       /* … far outside */
        {SYMBOLS + 16 + 4, 4, 0, 2},            /* … address outside its section */
        {SYMBOLS + 16 + 14, 2, 5, 2},           /* … no such section */
        {SYMBOLS + 16 + 14, 2, 0xFFFF, 2},      /* … reserved section number */
        {SYMBOLS + 32 + 8, 4, 0xFFFFFFFF, 3},   /* main: runs over the address space */
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        uint8_t b[SIZE], *copy;
        struct vm_elf elf;
        char text[512] = "";
        build(b);
        for (unsigned n = 0; n < bad[i].width; n++)
            b[bad[i].at + n] = (uint8_t)(bad[i].value >> 8 * n);
        if (!parse(&elf, b, SIZE, &copy, text))
            fail_msg("%s", text);
        if (elf.symbols != bad[i].left)
            fail_msg("bad[%zu]: %zu symbols", i, elf.symbols);
        uint32_t offset;
        for (uint32_t a = 0x7FFFFFF0; a < 0x80001100; a++)
            vm_elf_symbol(&elf, a, &offset);
        vm_elf_free(&elf);
        free(copy);
    }
}

/* Every length of the file: a sentence, or a program whose bytes are all there. */
static void every_length(void **state)
{
    (void)state;
    uint8_t b[SIZE], *copy;
    build(b);
    for (size_t size = 0; size <= SIZE; size++) {
        struct vm_elf elf;
        char text[512] = "";
        bool ok = parse(&elf, b, size, &copy, text);
        assert_int_equal(ok, size >= DATA + DATA_SIZE);
        if (ok)
            vm_elf_free(&elf);
        else
            assert_true(strncmp(text, "t.elf: ", 7) == 0);
        free(copy);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good),
        cmocka_unit_test(symbols),
        cmocka_unit_test(symbol_without_size),
        cmocka_unit_test(loaded_elsewhere),
        cmocka_unit_test(segments),
        cmocka_unit_test(defects),
        cmocka_unit_test(many_segments),
        cmocka_unit_test(bad_symbols),
        cmocka_unit_test(every_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
