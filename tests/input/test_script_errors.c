/* Scripts that are none: what is said and where; bytes of any kind. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/script.h"

struct wrong {
    const char *text, *sentence;
};

static const struct wrong beginnings[] = {
    {"foo", "1:1: 'foo' is not the beginning of a statement: pen, tablet, touch, mouse, key, type, "
            "knob or wait"},
    {"\n\n  tuch up", "3:3: 'tuch' is not the beginning of a statement; did you mean 'touch'?"},
    {"Pen up", "1:1: 'Pen' is not the beginning of a statement; did you mean 'pen'?"},
    {"\"pen\"", "1:1: \"pen\" is not the beginning of a statement: pen, tablet, touch, mouse, key, "
                "type, knob or wait"},
    {"at 1s # nothing", "1:7: the line ends where the beginning of a statement is expected: pen, "
                        "tablet, touch, mouse, key, type, knob or wait"},
    {"pen up pen down", "1:8: 'pen' is more than belongs to this statement"},
    {"pen down in 3s", "1:10: 'in' is more than belongs to this statement"},
    {"pen down \"x\"", "1:10: \"x\" is more than belongs to this statement"},
};

static const struct wrong times[] = {
    {"at", "1:3: the line ends, where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at 5 pen up", "1:4: '5', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at 5S pen up", "1:4: '5S', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at -5s pen up", "1:4: '-5s', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at .s pen up", "1:4: '.s', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at 1.2.3s pen up",
     "1:4: '1.2.3s', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at \"1s\" pen up", "1:4: \"1s\", where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"+ 5s pen up", "1:1: '+', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"+x pen up", "1:1: '+x', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"wait", "1:5: the line ends, where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"pen tap in x", "1:12: 'x', where a time such as 0.5s, 20ms, 3us, 5ns, 7ps is expected"},
    {"at 1s pen up\nat 0.5s pen up",
     "2:4: 0.5s is before 1s, where the statement before this one begins"},
    {"at 1s pen move 1 1 in 1s\nat 1ms wait 1s\n",
     "2:4: 1ms is before 1s, where the statement before this one begins"},
    {"at 1s wait 1s\nat 999999999999ps pen up",
     "2:4: 999999999999ps is before 1s, where the statement before this one begins"},
    {"at 9223372036854775808ps pen up",
     "1:4: '9223372036854775808ps' is too late: times are below 2^63 ps, 106 days"},
    {"at 9223372.036854775808s pen up",
     "1:4: '9223372.036854775808s' is too late: times are below 2^63 ps, 106 days"},
    {"at 18446744073709551617ps pen up",
     "1:4: '18446744073709551617ps' is too late: times are below 2^63 ps, 106 days"},
    {"at 99999999999999999999999999999999999999999s pen up",
     "1:4: '99999999999999999999999999999999' is too late: times are below 2^63 ps, 106 days"},
    {"at 9223372s pen move 1 1 in 1s",
     "1:26: this ends too late: times are below 2^63 ps, 106 days"},
    {"wait 9223372s\nwait 1s", "2:6: this ends too late: times are below 2^63 ps, 106 days"},
    {"wait 9223372s\n+1s pen up", "2:1: this begins too late: times are below 2^63 ps, 106 days"},
    {"at 9223372.036854775807s key A",
     "1:31: this ends too late: times are below 2^63 ps, 106 days"},
};

static const struct wrong pointing[] = {
    {"pen",
     "1:4: the line ends where something a pen does is expected: move, down, up, tap or away"},
    {"pen mvoe 1 2", "1:5: 'mvoe' is not something a pen does; did you mean 'move'?"},
    {"pen MOVE 1 1", "1:5: 'MOVE' is not something a pen does; did you mean 'move'?"},
    {"pen ~", "1:5: '~' is not something a pen does: move, down, up, tap or away"},
    {"pen rastr up", "1:5: 'rastr' is not something a pen does: move, down, up, tap or away"},
    {"pen move", "1:9: the line ends, where a coordinate x is expected"},
    {"pen move 1", "1:11: the line ends, where a coordinate y is expected"},
    {"pen move 1 2x", "1:12: '2x', where a coordinate y is expected"},
    {"pen move 1 2mm", "1:12: '2mm', where a coordinate y is expected"},
    {"pen move 1 -", "1:12: '-', where a coordinate y is expected"},
    {"pen move . 1", "1:10: '.', where a coordinate x is expected"},
    {"pen move 1e3 1", "1:10: '1e3', where a coordinate x is expected"},
    {"pen move \"1\" 1", "1:10: \"1\", where a coordinate x is expected"},
    {"pen move 1 2.1234", "1:12: '2.1234' has more than three places"},
    {"pen move 10000.001 1",
     "1:10: '10000.001' is out of range: a coordinate x is -10000 to 10000"},
    {"pen move 1 -99999999999999999999999999999999",
     "1:12: '-9999999999999999999999999999999...' is out of range: a coordinate y is -10000 to "
     "10000"},
    {"pen move 1 1 3", "1:14: '3' is more than belongs to this statement"},
    {"tablet scratch 1 1",
     "1:8: 'scratch' is not something done on a tablet: near, touch, move, press, "
     "release, tap or away"},
    {"tablet move 1 1", "1:16: the line ends, where a height z is expected"},
    {"tablet move 1 1 mm", "1:17: 'mm', where a height z is expected"},
    {"tablet press 4", "1:14: '4' is out of range: a button is 0 to 3"},
    {"tablet press left", "1:14: 'left', where a button is expected"},
    {"tablet press", "1:13: the line ends, where a button is expected"},
    {"tablet press -1", "1:14: '-1', where a button is expected"},
    {"touch", "1:6: the line ends where something a finger does is expected: up, tap or X Y"},
    {"touch ra 1 2", "1:7: 'ra' is not something a finger does: up, tap or X Y"},
    {"touch 1 2 force 0", "1:17: '0' is out of range: a force in newtons is 0.001 to 10000"},
    {"touch 1 2 force", "1:16: the line ends, where a force in newtons is expected"},
    {"mouse click", "1:12: the line ends where a button is expected: left, middle or right"},
    {"mouse click lft", "1:13: 'lft' is not a button; did you mean 'left'?"},
    {"mouse jump",
     "1:7: 'jump' is not something done with a mouse: move, press, release, click, lift "
     "or drop"},
    {"knob", "1:5: the line ends where a screen is expected: vector or raster"},
    {"knob vectro focus 1", "1:6: 'vectro' is not a screen; did you mean 'vector'?"},
    {"knob vector volume 1", "1:13: 'volume' is not a knob: brightness, contrast or focus"},
    {"knob raster focus 4.001", "1:19: '4.001' is out of range: focus is 0 to 4"},
    {"knob raster brightness -2", "1:24: '-2' is out of range: brightness is -1 to 1"},
};

static const struct wrong typing[] = {
    {"key", "1:4: the line ends, where the name of a key is expected"},
    {"key \"A\"", "1:5: \"A\", where the name of a key is expected"},
    {"key FF1", "1:5: there is no key 'FF1'; did you mean F1?"},
    {"key return", "1:5: there is no key 'return'; keys are A, 1, F1, ENTER, SPACE, PAD_5 ..."},
    {"key CONTROL+", "1:13: there is no key ''; keys are A, 1, F1, ENTER, SPACE, PAD_5 ..."},
    {"key CONTORL+C as 5", "1:5: there is no key 'CONTORL'; did you mean CONTROL?"},
    {"key A+B+C+D+E+F+G+H+I", "1:5: these are more than 8 keys at once"},
    {"key down SHFT", "1:10: there is no key 'SHFT'; did you mean SHIFT?"},
    {"key up A+B+C", "1:8: there is no key 'A+B+C'; keys are A, 1, F1, ENTER, SPACE, PAD_5 ..."},
    {"key up SHIFT in 1s", "1:14: 'in' is more than belongs to this statement"},
    {"key UNKNOWN", "1:5: there is no key 'UNKNOWN'; keys are A, 1, F1, ENTER, SPACE, PAD_5 ..."},
    {"key down A as", "1:14: the line ends, where a character between quotes or none is expected"},
    {"key down A as b", "1:15: 'b', where a character between quotes or none is expected"},
    {"key A as \"\"", "1:10: \"\" is not one character"},
    {"key A as \"ab\"", "1:10: \"ab\" is not one character"},
    {"key A as \"\\x00\"", "1:10: \"\\x00\" is not one character"},
    {"type", "1:5: the line ends, where a text between quotes is expected"},
    {"type abc", "1:6: 'abc', where a text between quotes is expected"},
    {"type \"abc", "1:6: the text has no closing quote on its line"},
    {"type \"abc\\", "1:6: the text has no closing quote on its line"},
    {"type \"abc\\\"", "1:6: the text has no closing quote on its line"},
    {"type \"abc\npen up\"", "1:6: the text has no closing quote on its line"},
    {"type \"ab\\q\"", "1:9: this is no escape; there are \\n \\r \\t \\b \\e \\\\ \\\" and \\xHH"},
    {"type \"\\q41\"", "1:7: this is no escape; there are \\n \\r \\t \\b \\e \\\\ \\\" and \\xHH"},
    {"type \"\\x4\"", "1:7: this is no escape; there are \\n \\r \\t \\b \\e \\\\ \\\" and \\xHH"},
    {"type \"\\xg0\"", "1:7: this is no escape; there are \\n \\r \\t \\b \\e \\\\ \\\" and \\xHH"},
    {"type \"a\\x80\"", "1:8: character 0x80 is not ASCII: no key makes it"},
    {"type \"\xC3\xA9\"", "1:7: character 0xc3 is not ASCII: no key makes it"},
    {"key \xC3\xA9", "1:5: byte 0xc3 is not ASCII; it can stand in comments only"},
    {"pen\x0Bup", "1:4: byte 0x0b is no text; write it as \\x0b between quotes"},
    {"pen\rup", "1:4: byte 0x0d is no text; write it as \\x0d between quotes"},
    {"type \"a\x01\"", "1:8: byte 0x01 is no text; write it as \\x01 between quotes"},
    {"type \"a\x7F\"", "1:8: byte 0x7f is no text; write it as \\x7f between quotes"},
};

static void check_all(const struct wrong *wrong, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct inp_script script;
        struct crt_error err = {""};
        char expected[sizeof err.text];
        if (inp_script_parse(&script, "a b.script", wrong[i].text, strlen(wrong[i].text), &err))
            fail_msg("'%s' was read", wrong[i].text);
        snprintf(expected, sizeof expected, "a b.script:%s", wrong[i].sentence);
        assert_string_equal(err.text, expected);
        assert_null(script.act);
        assert_int_equal(script.count, 0);
    }
}

static void beginnings_that_are_none(void **state)
{
    (void)state;
    check_all(beginnings, sizeof beginnings / sizeof *beginnings);
}

static void times_that_are_none(void **state)
{
    (void)state;
    check_all(times, sizeof times / sizeof *times);
}

static void statements_that_are_none(void **state)
{
    (void)state;
    check_all(pointing, sizeof pointing / sizeof *pointing);
    check_all(typing, sizeof typing / sizeof *typing);
}

static void nul_has_no_place_anywhere(void **state)
{
    (void)state;
    static const struct {
        const char text[16];
        size_t length;
        const char *sentence;
    } nul[] = {
        {"pen\0up", 6, "s:1:4: byte 0x00 is no text; write it as \\x00 between quotes"},
        {"\0", 1, "s:1:1: byte 0x00 is no text; write it as \\x00 between quotes"},
        {"type \"a\0\"", 9, "s:1:8: byte 0x00 is no text; write it as \\x00 between quotes"},
        {"type \"a\\\0\"", 10, "s:1:9: byte 0x00 is no text; write it as \\x00 between quotes"},
        {"pen up\n#\0", 9, "s:2:2: byte 0x00 has no place in a script"},
    };
    for (size_t i = 0; i < sizeof nul / sizeof *nul; i++) {
        struct inp_script script;
        struct crt_error err;
        assert_false(inp_script_parse(&script, "s", nul[i].text, nul[i].length, &err));
        assert_string_equal(err.text, nul[i].sentence);
    }
}

static void a_name_that_is_long_is_no_trouble(void **state)
{
    (void)state;
    static char name[2000], text[5000];
    struct inp_script script;
    struct crt_error err;
    memset(name, 'n', sizeof name - 1);
    memset(text, 'x', sizeof text);
    assert_false(inp_script_parse(&script, name, text, sizeof text, &err));
    assert_int_equal(strlen(err.text), sizeof err.text - 1);
    assert_false(inp_script_parse(&script, "s", text, sizeof text, &err));
    assert_string_equal(err.text,
                        "s:1:1: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' is not the beginning of a "
                        "statement: pen, tablet, touch, mouse, key, type, knob or wait");
}

/* ---- much of it -------------------------------------------------------------------------------- */

/* A text of `bytes` bytes with the characters of the pattern again and again between quotes. */
static char *long_text(const char *pattern, size_t count, size_t *length)
{
    size_t each = strlen(pattern);
    char *text = malloc(count * each + 16);
    assert_non_null(text);
    strcpy(text, "type \"");
    for (size_t i = 0; i < count; i++)
        memcpy(text + 6 + i * each, pattern, each);
    *length = 6 + count * each + 1;
    text[*length - 1] = '"';
    return text;
}

static void acts_have_a_limit(void **state)
{
    (void)state;
    struct inp_script script;
    struct crt_error err;
    size_t length;
    char *text = long_text("a", INP_SCRIPT_MOST / 2, &length);
    assert_true(inp_script_parse(&script, "s", text, length, &err));
    assert_int_equal(script.count, INP_SCRIPT_MOST);
    inp_script_free(&script);
    free(text);
    text = long_text("a", INP_SCRIPT_MOST / 2 + 1, &length);
    assert_false(inp_script_parse(&script, "s", text, length, &err));
    assert_string_equal(err.text, "s:1:2000009: the script has more than 4000000 acts");
    free(text);
    text = long_text("a", INP_SCRIPT_MOST + 1, &length);
    assert_false(inp_script_parse(&script, "s", text, length, &err));
    assert_string_equal(err.text, "s:1:6: the script has more than 4000000 acts");
    free(text);
}

static void long_lines_and_many_lines_are_read(void **state)
{
    (void)state;
    enum { SIZE = 4000000 };
    struct inp_script script;
    struct crt_error err;
    char *text = malloc(SIZE);
    assert_non_null(text);
    memset(text, ' ', SIZE);
    memcpy(text + SIZE - 6, "pen up", 6);
    assert_true(inp_script_parse(&script, "s", text, SIZE, &err));
    assert_int_equal(script.count, 1);
    inp_script_free(&script);
    memset(text, '\n', SIZE - 6);
    text[SIZE - 1] = 'x';
    assert_false(inp_script_parse(&script, "s", text, SIZE, &err));
    assert_string_equal(err.text,
                        "s:3999995:5: 'ux' is not something a pen does; did you mean 'up'?");
    free(text);
}

/* ---- anything ---------------------------------------------------------------------------------- */

/* xorshift64*: the same numbers everywhere. */
static uint64_t random_bits(uint64_t *seed)
{
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    return *seed * UINT64_C(2685821657736338717);
}

/* Read, or refused with one sentence that names a place in the text; if read, in order. */
static bool reads_or_says_where(const char *text, size_t length)
{
    struct inp_script script;
    struct crt_error err = {""};
    unsigned long line, column;
    if (!inp_script_parse(&script, "s", text, length, &err)) {
        assert_int_equal(sscanf(err.text, "s:%lu:%lu:", &line, &column), 2);
        assert_true(line >= 1 && line <= length + 1 && column >= 1 && column <= length + 1);
        for (const char *c = err.text; *c; c++)
            assert_true(*c >= ' ' && *c <= '~');
        return false;
    }
    for (size_t i = 0; i < script.count; i++) {
        assert_true(i == 0 || script.act[i - 1].t <= script.act[i].t);
        assert_true(script.act[i].t + script.act[i].duration <= script.end);
        assert_true(script.act[i].device < INP_DEVICES && script.act[i].verb < INP_VERBS);
    }
    assert_true(script.end < UINT64_C(1) << 63);
    inp_script_free(&script);
    return true;
}

static void random_bytes_are_refused_or_read(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (int run = 0; run < 20000; run++) {
        size_t length = random_bits(&seed) % 40;
        /* Memory of its own, so that a sanitizer sees reads past it. */
        char *text = malloc(length + 1);
        assert_non_null(text);
        for (size_t i = 0; i < length; i++)
            text[i] = (char)(run % 2 ? random_bits(&seed) >> 7 : ' ' + random_bits(&seed) % 95);
        char *exact = length ? realloc(text, length) : text;
        reads_or_says_where(exact, length);
        free(exact);
    }
}

/* Words of the language in any order: some of it is a script. */
static void random_words_are_refused_or_read(void **state)
{
    (void)state;
    static const char *const words[] = {
        "at",         "1s",     "+1ms",  "20ms",    "pen",   "tablet", "touch",     "mouse",
        "key",        "type",   "knob",  "wait",    "move",  "down",   "up",        "tap",
        "away",       "near",   "press", "release", "click", "lift",   "drop",      "left",
        "vector",     "raster", "in",    "mm",      "force", "as",     "none",      "1",
        "2.5",        "-3",     "\"a\"", "\"\\n\"", "A",     "SHIFT",  "CONTROL+C", "UNKNOWN",
        "brightness", "0",      "\n",    "\n",      "# x"};
    uint64_t seed = 2;
    int read = 0;
    for (int run = 0; run < 60000; run++) {
        char text[256];
        size_t length = 0, count = 1 + random_bits(&seed) % 6;
        for (size_t i = 0; i < count; i++)
            length += (size_t)sprintf(text + length, "%s ",
                                      words[random_bits(&seed) % (sizeof words / sizeof *words)]);
        read += reads_or_says_where(text, length);
    }
    assert_in_range(read, 500, 59000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(beginnings_that_are_none),
        cmocka_unit_test(times_that_are_none),
        cmocka_unit_test(statements_that_are_none),
        cmocka_unit_test(nul_has_no_place_anywhere),
        cmocka_unit_test(a_name_that_is_long_is_no_trouble),
        cmocka_unit_test(acts_have_a_limit),
        cmocka_unit_test(long_lines_and_many_lines_are_read),
        cmocka_unit_test(random_bytes_are_refused_or_read),
        cmocka_unit_test(random_words_are_refused_or_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
