/* The disassembler: its text for known words, and that its text assembles to the same words. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/asm.h"
#include "display_file/disasm.h"
#include "display_file/df_regs.h"
#include "tests/support/source.h"

/* ---- known words ---- */

/* The statements alone: comments, columns and line ends are taken off. */
static void statements_of(const struct df_program *p, char *out, size_t size)
{
    char *text = df_disassemble(p);
    assert_non_null(text);
    size_t used = 0;
    for (char *line = strtok(text, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        char *comment = strstr(line, " ; ");
        size_t length = comment != NULL ? (size_t)(comment - line) : strlen(line);
        while (length > 0 && line[length - 1] == ' ') {
            length--;
        }
        size_t skip = strspn(line, " ");
        used +=
            (size_t)snprintf(out + used, size - used, "%.*s\n", (int)(length - skip), line + skip);
    }
    free(text);
}

#define assert_disassembly(text, ...)                                                              \
    check((text), (const uint16_t[]){__VA_ARGS__},                                                 \
          sizeof((const uint16_t[]){__VA_ARGS__}) / sizeof(uint16_t), __LINE__)

static void check(const char *expected, const uint16_t *words, size_t count, int line)
{
    struct df_program p;
    struct crt_error err;
    char got[4096];
    assert_true(df_program_init(&p, &err));
    for (size_t i = 0; i < count; i++) {
        df_program_put(&p, (uint32_t)(2 * i), words[i]);
    }
    statements_of(&p, got, sizeof got);
    if (strcmp(got, expected) != 0) {
        print_error("line %d: got\n%sexpected\n%s", line, got, expected);
        fail();
    }
    df_program_free(&p);
}

static void control_words(void **state)
{
    (void)state;
    assert_disassembly("L000000: char i=7 pen=on blink=on line=dotdash\nlongv\npoint i=0 pen=off\n"
                       "relpoint blink=off line=solid\n",
                       0103777, 0110000, 0116100, 0130024);
}

static void status_words(void **state)
{
    (void)state;
    assert_disassembly("L000000: status\nstop\nsync\nstop sync\nstop stopint=on\n"
                       "status stopint=off penlight=on italics=on\nstatus penlight=off "
                       "italics=off\nstep 63\nnop\n",
                       0170000, 0172000, 0170004, 0172004, 0173400, 0171260, 0170340, 0174177,
                       0164000);
    assert_disassembly("L000000: colour green\ncolour yellow\ncolour orange step=8\ncolour red\n"
                       "colour red step=0\n.word 0o175001\n.word 0o174200\n.word 0o174300\n"
                       ".word 0o177000\n",
                       0175000, 0175200, 0175510, 0175600, 0175700, 0175001, 0174200, 0174300,
                       0177000);
}

static void data_words(void **state)
{
    (void)state;
    assert_disassembly(
        "L000000: point\nat 0, 0\nplot 1023, 1\nlongv\ndraw -1023, -1\nmove 5, 0\n"
        "shortv\ndraw -63, 63\nmove 1, -1\nrelpoint\ndraw 2, 3\ngraphx\n"
        "value 0, 1023\nchar\ntext \"ABC\"\ntext \"\\\"\\\\\\r\\n\"\ntext \"\\x0e~\"\n",
        0114000, 0, 0, 041777, 1, 0110000, 061777, 020001, 5, 0, 0104000, 077677, 0301, 0130000,
        040403, 0120000, 0, 01777, 0100000, 041101, 0103, 056042, 05015, 077016);
}

static void jumps_get_labels(void **state)
{
    (void)state;
    assert_disassembly("L000000: jump L000006\nnop\nL000006: jump L000000\njump 0o001000\n",
                       0160000, 6, 0164000, 0160000, 0, 0160000, 01000);
    /* Into the middle of a datum: the datum is not written as one. */
    assert_disassembly("L000000: longv\n.word 0o000001\nL000004: move 2, 0\njump L000004\n",
                       0110000, 1, 2, 0, 0160000, 4);
    assert_disassembly("L000000: nop\n.word 0o160000\n.word 0o000003\n", 0164000, 0160000, 3);
}

static void what_no_statement_says(void **state)
{
    (void)state;
    assert_disassembly("L000000: .word 0o000001\n.word 0o110200\n.mode   longv\ndraw 1, 2\n", 1,
                       0110200, 040001, 2);
    assert_disassembly("L000000: .word 0o134000\n.word 0o150000\n.word 0o160001\n.word 0o164001\n"
                       ".word 0o174000\n.word 0o170400\n.word 0o176000\n",
                       0134000, 0150000, 0160001, 0164001, 0174000, 0170400, 0176000);
    /* Negative zero, beam on in a second word, bits in between, a datum cut short by a control
     * word. */
    assert_disassembly("L000000: longv\n.word 0o020000\n.word 0o000001\n.word 0o002000\nnop\n",
                       0110000, 020000, 1, 02000, 0164000);
    assert_disassembly(
        "L000000: shortv\n.word 0o020000\n.word 0o000100\ngraphy\n.word 0o040001\nchar\n"
        ".word 0o000200\n",
        0104000, 020000, 0100, 0124000, 040001, 0100000, 0200);
}

static void places_and_entry(void **state)
{
    (void)state;
    struct df_program p;
    source_program(".org 0o100\n.word 7\n.org 0o1000\ngo: nop\n.word 8\n.start go", &p);
    char got[1024];
    statements_of(&p, got, sizeof got);
    assert_string_equal(got, ".start  L001000\n.org    0o000100\n.word 0o000007\n.org    0o001000\n"
                             "L001000: nop\n.word 0o000010\n");
    df_program_free(&p);
}

static void tube_comes_back(void **state)
{
    (void)state;
    static const char *const names[] = {
        "VR17", "VR17/P31", "My tube; No 2", "a", "", "123456789012345678901234567890/45678901"};
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
        char source[128], expected[128], got[128];
        struct df_program p;
        struct df_program again;
        snprintf(source, sizeof source, ".tube \"%s\"\nnop", names[i]);
        source_program(names[i][0] != '\0' ? source : "nop", &p);
        assert_string_equal(p.tube, names[i]);
        statements_of(&p, got, sizeof got);
        snprintf(expected, sizeof expected, ".tube   \"%s\"\nL000000: nop\n", names[i]);
        assert_string_equal(got, names[i][0] != '\0' ? expected : "L000000: nop\n");
        char *text = df_disassemble(&p);
        assert_non_null(text);
        source_program(text, &again);
        assert_string_equal(again.tube, names[i]);
        assert_true(source_same(&p, &again));
        free(text);
        df_program_free(&p);
        df_program_free(&again);
    }
}

static void firmware_comes_back(void **state)
{
    (void)state;
    static const char *const names[] = {
        "rt11", "A", "my_own-2", "123456789012345678901234567890123456789012345678901234567890123"};
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
        char source[128], expected[128], got[128];
        struct df_program p;
        snprintf(source, sizeof source, ".firmware \"%s\"\nnop", names[i]);
        source_program(source, &p);
        assert_string_equal(p.firmware, names[i]);
        assert_string_equal(p.tube, "");
        statements_of(&p, got, sizeof got);
        snprintf(expected, sizeof expected, ".firmware \"%s\"\nL000000: nop\n", names[i]);
        assert_string_equal(got, expected);
        df_program_free(&p);
    }
    struct df_program p;
    source_program(".dialect dec\n.firmware \"rt11\"\n.tube \"VR14\"\n1", &p);
    assert_string_equal(p.firmware, "rt11");
    assert_string_equal(p.tube, "VR14");
    df_program_free(&p);
}

static void special_characters_are_named(void **state)
{
    (void)state;
    struct df_program p;
    source_program(
        "char\ntext \"A\", so, 0, 1, si, 1\nnop\ntext so, 2\nnop\ntext 3, 4\nchar\ntext 5, 5", &p);
    char *text = df_disassemble(&p);
    assert_non_null(text);
    assert_non_null(strstr(text, "; 000002 lambda alpha\n")); /* and 1 is nothing after si */
    assert_non_null(strstr(text, "; 000012 phi\n"));
    assert_non_null(strstr(text, "; 000014\n"));
    assert_non_null(strstr(text, "; 000016 Sigma delta\n")); /* still shifted out */
    assert_non_null(strstr(text, "; 000020\n"));             /* a mode word shifts in */
    free(text);
    df_program_free(&p);
}

static void nothing(void **state)
{
    (void)state;
    struct df_program p;
    struct crt_error err;
    assert_true(df_program_init(&p, &err));
    char *text = df_disassemble(&p);
    assert_string_equal(text, "; no words\n");
    free(text);
    df_program_free(&p);
}

static void single_words(void **state)
{
    (void)state;
    const struct {
        uint16_t word;
        unsigned mode;
        const char *text;
    } cases[] = {
        {0117600, 0, "point i=7"},
        {041101, DF_MODE_CHAR, "text \"AB\""},
        {077677, DF_MODE_SHORT, "draw -63, 63"},
        {061777, DF_MODE_LONG, "delta -1023, lit"},
        {5, DF_MODE_LONG, "delta 5"},
        {040005, DF_MODE_POINT, "coordinate 5, lit"},
        {5, DF_MODE_GRAPHX, "value 5"},
        {0160000, 0, "jump"},
        {0163777, 0, "jump"},
        {0167777, 0, "nop"},
        {0173400, 0, "stop stopint=on"},
        {0134000, 0, ".word 0o134000"},
        {0, 99, ".word 0o000000"},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[64];
        df_disassemble_word(cases[i].word, cases[i].mode, text, sizeof text);
        assert_string_equal(text, cases[i].text);
    }
    char small[8];
    memset(small, 'x', sizeof small);
    df_disassemble_word(0117777, 0, small, 5);
    assert_string_equal(small, "poin");
    assert_int_equal(small[5], 'x');
    df_disassemble_word(0, 0, small, 0);
    assert_int_equal(small[0], 'p');
}

/* ---- assemble(disassemble(x)) == x ---- */

static uint64_t seed = UINT64_C(0x9e3779b97f4a7c15);

static uint32_t random_below(uint32_t limit)
{
    seed ^= seed << 13; /* xorshift64 */
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)((seed >> 32) % limit);
}

static void assert_round_trip(const struct df_program *p)
{
    char *text = df_disassemble(p);
    assert_non_null(text);
    struct df_program again;
    struct df_asm_report report;
    if (!df_assemble_text("disassembly", text, strlen(text), NULL, &again, &report)) {
        print_error("%s", report.text);
        fail();
    }
    if (!source_same(p, &again)) {
        for (uint32_t a = 0; a < DF_MEMORY_BYTES / 2; a++) {
            if (p->words[a] != again.words[a] || p->loaded[a] != again.loaded[a]) {
                print_error("at %06o: %06o became %06o\n", 2 * a, p->words[a], again.words[a]);
                break;
            }
        }
        print_error("entry %06o became %06o\n", (unsigned)p->entry, (unsigned)again.entry);
        fail();
    }
    free(text);
    df_asm_report_free(&report);
    df_program_free(&again);
}

/* Words of all kinds: some any 16 bits, some a valid control word, some with few bits set. */
static uint16_t random_word(void)
{
    uint16_t any = (uint16_t)random_below(65536);
    switch (random_below(8)) {
    case 0:
        return (uint16_t)(0100000 | any % 7 << 11 | (any & 03777));
    case 1:
        return (uint16_t)(0100000 | any % 7 << 11);
    case 2:
        return any & (uint16_t)random_below(65536) & 077777;
    case 3:
        return (uint16_t)(any & 0077577);
    case 4:
        return DF_JUMP;
    case 5:
        return any & 01776;
    case 6:
        return 0170000 | (any & 07777);
    default:
        return any;
    }
}

static uint32_t fill(struct df_program *p, uint32_t words)
{
    uint32_t done = 0;
    while (done < words) {
        uint32_t address = 2 * random_below(DF_MEMORY_BYTES / 2);
        uint32_t run = 1 + random_below(random_below(4) == 0 ? 8 : 2000);
        for (; run > 0 && address < DF_MEMORY_BYTES && done < words; run--, address += 2) {
            done += !p->loaded[address / 2];
            df_program_put(p, address, random_word());
        }
    }
    return done;
}

static void choose_entry(struct df_program *p)
{
    df_program_put(p, 0100, random_word()); /* at least one word can be started */
    p->entry = 0100;
    for (unsigned i = 0; i < 50; i++) {
        uint32_t address = 2 * random_below(DF_ADDRESS_SPACE / 2);
        if (p->loaded[address / 2]) {
            p->entry = address;
        }
    }
}

static void a_million_random_words_come_back(void **state)
{
    (void)state;
    uint32_t words = 0;
    for (unsigned round = 0; words < 1000000; round++) {
        struct df_program p;
        struct crt_error err;
        assert_true(df_program_init(&p, &err));
        words += fill(&p, round % 20 == 19 ? 100000 : 1 + random_below(20000));
        choose_entry(&p);
        assert_round_trip(&p);
        df_program_free(&p);
    }
}

static void every_word_in_every_mode_comes_back(void **state)
{
    (void)state;
    for (unsigned mode = 0; mode <= DF_MODE_RELPOINT; mode++) {
        struct df_program p;
        struct crt_error err;
        assert_true(df_program_init(&p, &err));
        /* The mode word, then the word, so that each is read in that mode; data come in both
         * halves. */
        uint32_t a = 0;
        for (uint32_t word = 0; word < 0100000; word++) {
            df_program_put(&p, a, (uint16_t)(DF_SET_MODE | mode << DF_MODE_SHIFT));
            df_program_put(&p, a + 2, (uint16_t)word);
            df_program_put(&p, a + 4, (uint16_t)(word * 40503u & 077777));
            a += 6;
        }
        assert_round_trip(&p);
        df_program_free(&p);
    }
    struct df_program p;
    struct crt_error err;
    assert_true(df_program_init(&p, &err));
    for (uint32_t word = 0100000; word <= 0177777; word++) {
        df_program_put(&p, (word - 0100000) * 4, (uint16_t)word);
        df_program_put(&p, (word - 0100000) * 4 + 2, 040001);
    }
    assert_round_trip(&p);
    df_program_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(control_words),
        cmocka_unit_test(status_words),
        cmocka_unit_test(data_words),
        cmocka_unit_test(jumps_get_labels),
        cmocka_unit_test(what_no_statement_says),
        cmocka_unit_test(places_and_entry),
        cmocka_unit_test(tube_comes_back),
        cmocka_unit_test(firmware_comes_back),
        cmocka_unit_test(special_characters_are_named),
        cmocka_unit_test(nothing),
        cmocka_unit_test(single_words),
        cmocka_unit_test(a_million_random_words_come_back),
        cmocka_unit_test(every_word_in_every_mode_comes_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
