/* .oct, .lda and raw images: good ones, bad ones, and what is said about the bad ones. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/loaders.h"
#include "tests/support/source.h"

/* ---- .oct ---- */

static void load_oct(const char *text, struct df_program *p)
{
    struct crt_error err;
    if (!df_load_oct("t.oct", text, strlen(text), p, &err)) {
        print_error("%s\n", err.text);
        fail();
    }
}

static void oct_error(const char *text, const char *sentence)
{
    struct df_program p;
    struct crt_error err;
    assert_false(df_load_oct("t.oct", text, strlen(text), &p, &err));
    assert_string_equal(err.text, sentence);
    assert_null(p.words);
}

static void oct_words(void **state)
{
    (void)state;
    struct df_program p;
    load_oct("; a comment\n114000\n 100 ; x\r\n\t200\r\n\n@1000\n=1002\n0\n177777", &p);
    assert_int_equal(p.low, 0);
    assert_int_equal(p.high, 01004);
    assert_int_equal(p.entry, 01002);
    assert_int_equal(p.words[0], 0114000);
    assert_int_equal(p.words[1], 0100);
    assert_int_equal(p.words[2], 0200);
    assert_int_equal(p.loaded[3], 0);
    assert_int_equal(p.words[01000 / 2], 0);
    assert_int_equal(p.loaded[01000 / 2], 1);
    assert_int_equal(p.words[01002 / 2], 0177777);
    assert_int_equal(p.line[1], 3);
    assert_string_equal(p.files[0], "t.oct");
    df_program_free(&p);
    load_oct("@1000\n1\n@100\n2", &p);
    assert_int_equal(p.entry, 0100); /* without =, the lowest address */
    df_program_free(&p);
    load_oct("1\n@777776\n2", &p);
    assert_int_equal(p.high, 01000000);
    df_program_free(&p);
}

static void oct_errors(void **state)
{
    (void)state;
    oct_error("", "t.oct: no words in it; write one octal word a line.");
    oct_error("=0\n; nothing", "t.oct: no words in it; write one octal word a line.");
    oct_error("1\n8", "t.oct:2: '8' is not an octal word, at most 177777.");
    oct_error("200000", "t.oct:1: '200000' is not an octal word, at most 177777.");
    oct_error("00000001", "t.oct:1: '00000001' is not an octal word, at most 177777.");
    oct_error("1 2", "t.oct:1: '1 2' is not an octal word, at most 177777.");
    oct_error("-1", "t.oct:1: '-1' is not an octal word, at most 177777.");
    oct_error("longv\n", "t.oct:1: 'longv' is not an octal word, at most 177777.");
    oct_error("\x01\xff"
              "z",
              "t.oct:1: '??z' is not an octal word, at most 177777.");
    oct_error("1\n@3", "t.oct:2: '@3' is not @ and an even octal address below 1000000.");
    oct_error("@", "t.oct:1: '@' is not @ and an even octal address below 1000000.");
    oct_error("@1000000", "t.oct:1: '@1000000' is not @ and an even octal address below 1000000.");
    oct_error("@ 10", "t.oct:1: '@ 10' is not @ and an even octal address below 1000000.");
    oct_error("=200000", "t.oct:1: '=200000' is not = and an even octal address below 200000.");
    oct_error("=1", "t.oct:1: '=1' is not = and an even octal address below 200000.");
    oct_error("0\n=0\n=0", "t.oct:3: the entry is already given in line 2; keep one of them.");
    oct_error("0\n=2", "t.oct:2: the entry 000002 has no word; name an address that has one.");
    oct_error("@777776\n1\n2", "t.oct:3: the words go beyond address 777776, the last of display "
                               "memory; move them down with @.");
    oct_error("1\n2\n@2\n3",
              "t.oct:4: address 000002 already has a word, from line 2; move one of them with @.");
    oct_error("@200000\n1", "t.oct: no words below address 200000, which is as far as the display "
                            "processor reaches; move some down with @.");
}

static uint32_t seed = 12345;

static uint32_t random_below(uint32_t limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % limit;
}

static void oct_round_trip(void **state)
{
    (void)state;
    for (unsigned round = 0; round < 20; round++) {
        struct df_program p, again;
        struct crt_error err;
        assert_true(df_program_init(&p, &err));
        for (unsigned i = 0; i < 1000; i++) {
            uint32_t a = 2 * random_below(round % 2 ? 600 : DF_MEMORY_BYTES / 2);
            df_program_put(&p, a, (uint16_t)random_below(65536));
        }
        p.entry = 2 * random_below(500);
        df_program_put(&p, p.entry, 0164000);
        FILE *out = tmpfile();
        assert_non_null(out);
        df_write_oct(out, &p);
        long length = ftell(out);
        rewind(out);
        char *text = malloc((size_t)length);
        assert_non_null(text);
        assert_int_equal(fread(text, 1, (size_t)length, out), length);
        fclose(out);
        assert_true(df_load_oct("again", text, (size_t)length, &again, &err));
        assert_true(source_same(&p, &again));
        free(text);
        df_program_free(&p);
        df_program_free(&again);
    }
}

/* ---- .lda ---- */

struct tape {
    uint8_t bytes[4096];
    size_t length;
};

static void byte(struct tape *t, unsigned value)
{
    t->bytes[t->length++] = (uint8_t)value;
}

/* A block of words from an address on; the checksum makes the sum of all its bytes 0. */
static void block(struct tape *t, unsigned address, const uint16_t *words, size_t count)
{
    size_t start = t->length;
    unsigned bytes = 6 + 2 * (unsigned)count, sum = 0;
    byte(t, 1);
    byte(t, 0);
    byte(t, bytes & 255);
    byte(t, bytes >> 8);
    byte(t, address & 255);
    byte(t, address >> 8);
    for (size_t i = 0; i < count; i++) {
        byte(t, words[i] & 255);
        byte(t, words[i] >> 8);
    }
    for (size_t i = start; i < t->length; i++) {
        sum += t->bytes[i];
    }
    byte(t, 0u - sum);
}

static const uint16_t picture[] = {0117600, 0100, 0200, 0110000, 040100, 0, 0172000};

static void good_tape(struct tape *t, unsigned transfer)
{
    t->length = 0;
    for (int i = 0; i < 20; i++) {
        byte(t, 0); /* leader */
    }
    block(t, 01000, picture, 4);
    byte(t, 0);
    block(t, 01010, picture + 4, 3);
    block(t, transfer, NULL, 0);
}

static void tape_error(const struct tape *t, const char *sentence)
{
    struct df_program p;
    struct crt_error err;
    assert_false(df_load_lda("t.lda", t->bytes, t->length, &p, &err));
    assert_string_equal(err.text, sentence);
    assert_null(p.words);
}

static void assert_picture(const struct tape *t)
{
    struct df_program p;
    struct crt_error err;
    if (!df_load_lda("t.lda", t->bytes, t->length, &p, &err)) {
        print_error("%s\n", err.text);
        fail();
    }
    assert_int_equal(p.low, 01000);
    assert_int_equal(p.high, 01016);
    assert_int_equal(p.entry, 01000);
    assert_memory_equal(p.words + 01000 / 2, picture, sizeof picture);
    df_program_free(&p);
}

static void good_tapes(void **state)
{
    (void)state;
    struct tape t;
    good_tape(&t, 01000);
    assert_picture(&t);
    t.length--; /* some tapes end without the last checksum */
    assert_picture(&t);
    good_tape(&t, 1); /* no transfer address: the lowest */
    assert_picture(&t);
    memset(t.bytes + t.length, 0xff, 100); /* after the end anything may follow */
    t.length += 100;
    assert_picture(&t);
}

static void bad_tapes(void **state)
{
    (void)state;
    struct tape t;
    t.length = 0;
    tape_error(&t, "t.lda: the tape has no end block (count 6); it is cut short or not an absolute "
                   "tape.");
    good_tape(&t, 01000);
    t.length = 20 + 15 + 1 + 13;
    tape_error(&t, "t.lda: the tape has no end block (count 6); it is cut short or not an absolute "
                   "tape.");
    t.length = 20 + 10;
    tape_error(&t, "t.lda: the block at byte 20 is cut short; read the tape again.");
    t.length = 21;
    tape_error(&t, "t.lda: the block at byte 20 is cut short; read the tape again.");
    good_tape(&t, 01000);
    t.bytes[28] ^= 1;
    tape_error(&t, "t.lda: the block at byte 20 has a wrong checksum; read the tape again.");
    good_tape(&t, 01000);
    t.bytes[20] = 7;
    tape_error(&t, "t.lda: byte 20 is not the start of a block (001 000); this is not an absolute "
                   "tape, or it is damaged.");
    good_tape(&t, 01000);
    t.bytes[22] = 5;
    tape_error(&t,
               "t.lda: the block at byte 20 has a count of 5, less than its header; the tape is "
               "damaged.");
    t.length = 0;
    block(&t, 0177776, picture, 2);
    block(&t, 1, NULL, 0);
    tape_error(&t, "t.lda: the block at byte 0 goes beyond address 177777; the tape is damaged.");
    t.length = 0;
    block(&t, 1, NULL, 0);
    tape_error(&t, "t.lda: the tape loads no words; there is nothing to show.");
}

static void program_tape(const uint16_t *words, size_t count, const char *where)
{
    struct tape t = {.length = 0};
    char sentence[300];
    bool transfer = strcmp(where, "the transfer address") == 0;
    block(&t, 01000, words, count);
    block(&t, transfer ? 01000 : 1, NULL, 0);
    snprintf(sentence, sizeof sentence,
             "t.lda: no display file starts at %s 001000; this looks like a PDP-11 program, which "
             "needs a PDP-11: only tapes of display words can be shown.",
             where);
    tape_error(&t, sentence);
}

static void pdp11_programs_need_a_pdp11(void **state)
{
    (void)state;
    const char *transfer = "the transfer address", *lowest = "the lowest address";
    /* MOV #1000, SP; RESET; HALT */
    const uint16_t code[] = {012706, 01000, 5, 0};
    program_tape(code, 4, transfer);
    program_tape(code, 4, lowest);
    /* CLRB @#177546 runs off its end; MOVB, then BICB is illegal as a display word. */
    const uint16_t bytes_off[] = {0105037, 0177546};
    program_tape(bytes_off, 2, transfer);
    const uint16_t illegal[] = {0112700, 1, 0142700, 2, 0172000};
    program_tape(illegal, 5, transfer);
    /* A jump that leads nowhere; a jump cut short. */
    const uint16_t nowhere[] = {0160000, 02000};
    program_tape(nowhere, 2, transfer);
    const uint16_t cut[] = {0114000, 0160000};
    program_tape(cut, 2, transfer);
    /* The transfer address itself is not on the tape. */
    struct tape t;
    good_tape(&t, 04000);
    tape_error(&t,
               "t.lda: no display file starts at the transfer address 004000; this looks like a "
               "PDP-11 program, which needs a PDP-11: only tapes of display words can be shown.");
}

static void loops_are_display_files(void **state)
{
    (void)state;
    const uint16_t loop[] = {0114000, 1, 2, 0160000, 01000};
    struct tape t = {.length = 0};
    struct df_program p;
    struct crt_error err;
    block(&t, 01000, loop, 5);
    block(&t, 01000, NULL, 0);
    assert_true(df_load_lda("t.lda", t.bytes, t.length, &p, &err));
    df_program_free(&p);
}

/* ---- raw images ---- */

static void raw_error(size_t length, uint32_t base, uint32_t start, const char *sentence)
{
    static const uint8_t bytes[DF_MEMORY_BYTES + 2];
    struct df_program p;
    struct crt_error err;
    assert_false(df_load_raw("t.img", bytes, length, base, start, &p, &err));
    assert_string_equal(err.text, sentence);
    assert_null(p.words);
}

static void raw_images(void **state)
{
    (void)state;
    const uint8_t bytes[] = {0x34, 0x12, 0xff, 0x80};
    struct df_program p;
    struct crt_error err;
    assert_true(df_load_raw("t.img", bytes, 4, 0100, 0102, &p, &err));
    assert_int_equal(p.words[0100 / 2], 0x1234);
    assert_int_equal(p.words[0102 / 2], 0x80ff);
    assert_int_equal(p.low, 0100);
    assert_int_equal(p.high, 0104);
    assert_int_equal(p.entry, 0102);
    df_program_free(&p);
    raw_error(0, 0, 0, "t.img: 0 bytes are not a memory image; it needs an even number of bytes.");
    raw_error(3, 0, 0, "t.img: 3 bytes are not a memory image; it needs an even number of bytes.");
    raw_error(2, 1, 0, "t.img: base 000001 is not an address; choose an even one below 1000000.");
    raw_error(2, DF_MEMORY_BYTES, 0,
              "t.img: base 1000000 is not an address; choose an even one below 1000000.");
    raw_error(4, DF_MEMORY_BYTES - 2, 0,
              "t.img: 4 bytes from 777776 go beyond display memory, which ends at 777776; choose a "
              "lower base or a shorter image.");
    raw_error(
        DF_MEMORY_BYTES + 2, 0, 0,
        "t.img: 262146 bytes from 000000 go beyond display memory, which ends at 777776; choose "
        "a lower base or a shorter image.");
    raw_error(4, 0100, 0104,
              "t.img: start 000104 is not in the image, 000100 to 000102; choose an "
              "even address in it below 200000.");
    raw_error(4, 0100, 0101,
              "t.img: start 000101 is not in the image, 000100 to 000102; choose an "
              "even address in it below 200000.");
    raw_error(4, 0200000, 0200000,
              "t.img: start 200000 is not in the image, 200000 to 200002; choose "
              "an even address in it below 200000.");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oct_words),
        cmocka_unit_test(oct_errors),
        cmocka_unit_test(oct_round_trip),
        cmocka_unit_test(good_tapes),
        cmocka_unit_test(bad_tapes),
        cmocka_unit_test(pdp11_programs_need_a_pdp11),
        cmocka_unit_test(loops_are_display_files),
        cmocka_unit_test(raw_images),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
