/* The reader of lessons: every mistake is told with file and line; any bytes are read or refused; what is read is
 * what was written. Figures of JSON, formats and expectations by hand. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/json_out.h"
#include "emu/lesson/lesson.h"
#include "emu/lesson/lesson_command.h"
#include "emu/lesson/lesson_results.h"

#define HEAD "title T\nsummary S\norder 1\n"

static bool read_text(struct vm_lesson *l, const char *text, struct crt_error *err)
{
    return vm_lesson_read(l, "x/my.lesson", text, strlen(text), err);
}

/* ---- mistakes -------------------------------------------------------------------------------- */

static void mistakes_have_a_line(void **state)
{
    static const struct {
        const char *text;
        int line;
        const char *says;
    } cases[] = {
        {"", 1, "no title"},
        {"# only\n\n", 1, "no title"},
        {"titel T\n", 1, "did you mean title?"},
        {"  T\n", 1, "goes on with the one above"},
        {"title T\nsummary S\nstep a A\n", 1, "no order"},
        {"title T\norder 1\nstep a A\n", 1, "no summary"},
        {HEAD, 1, "no step"},
        {HEAD "title U\nstep a A\n", 4, "said above"},
        {HEAD "order 2\nstep a A\n", 4, "said above"},
        {"title T\nsummary S\norder 0\nstep a A\n", 3, "from 1 to 999"},
        {"title T\nsummary S\norder 1000\nstep a A\n", 3, "from 1 to 999"},
        {"title T\nsummary S\norder two\nstep a A\n", 3, "from 1 to 999"},
        {"title\nsummary S\norder 1\n", 1, "has no value"},
        {HEAD "picture capture roms/rose.df\n", 4, "belongs to a step"},
        {HEAD "step a A\norder 3\n", 5, "before the first step"},
        {HEAD "step\n", 4, "a-z, 0-9"},
        {HEAD "step Decay D\n", 4, "a-z, 0-9"},
        {HEAD "step decay\n", 4, "heading"},
        {HEAD "step a A\n\nstep a B\n", 6, "another step"},
        {HEAD "step a A\n# c\ncaption C\n", 6, "no picture, plot, table or live above"},
        {HEAD "step a A\nlive run\ncaption C\ncaption D\n", 7, "a caption already"},
        {HEAD "step a A\nlive capture roms/rose.df\n", 5, "begins with run"},
        {HEAD "step a A\npicture run roms/rose.df\n", 5, "no command 'run'"},
        {HEAD "step a A\npicture captur roms/rose.df\n", 5, "did you mean capture?"},
        {HEAD "step a A\ntable trace x | head\n", 5, "'|' has no meaning"},
        {HEAD "step a A\ntable trace 'x\n", 5, "not closed"},
        {HEAD "step a A\nplot probe x --csv -\n", 5, "'-' has no meaning"},
        {HEAD "step a A\nplot probe x -o b.png\nstep c C\nplot probe x -o b.png\n", 7,
         "b.png is made already"},
        {HEAD "step a A\nplot probe x\nfigures probe x --csv a.png\n", 6, "a.png is made already"},
        {HEAD "step a A\nfigures probe x --csv w.csv\nfigures probe x --csv=w.csv\n", 6,
         "w.csv is made already"},
        {HEAD "step a A\nplot probe x -o a.png --csv a.png\n", 5, "a.png is made already"},
        {HEAD "step a A\ntable probe x --csv my.txt\n", 5, "text of the lesson itself"},
        {HEAD "step a A\nplot probe x -o /tmp/a.png\n", 5, "'/tmp/a.png' is no plain name"},
        {HEAD "step a A\nplot probe x -o../a.png\n", 5, "'../a.png' is no plain name"},
        {HEAD "step a A\npicture capture x --out=sub/a.png\n", 5, "no plain name"},
        {HEAD "step a A\nfigures probe x --save-state .profile\n", 5, "no plain name"},
        {HEAD "step a A\nfigures sweep length --write /a.df\n", 5, "no plain name"},
        {HEAD "step a A\npicture compare x y --diff ''\n", 5, "no plain name"},
        {HEAD "step a A\ntable probe x --csv=-\n", 5, "'-' has no meaning"},
        {HEAD "step a A\nsays words\n", 5, "no command above"},
        {HEAD "step a A\nflashes\n", 5, "needs a picture or plot"},
        {HEAD "step a A\nplot probe x\nflashes\nflashes\n", 7, "said above"},
        {HEAD "step a A\ntext {c1}\n", 5, "no command here prints 'c1'"},
        {HEAD "text {c1}\nstep a A\nplot probe x\n", 4, "STEP.FIGURE"},
        {HEAD "text a\n\n  {a.c1:.}\nstep a A\nplot probe x\n", 4, "digit after the dot"},
        {HEAD "text {a.c1:furlong}\nstep a A\n", 4, "is no format"},
        {HEAD "text {a.c1\nstep a A\n", 4, "stands alone"},
        {HEAD "text a}\nstep a A\n", 4, "stands alone"},
        {HEAD "text {a b}\nstep a A\n", 4, "is not {NAME}"},
        {HEAD "step a A\nplot probe x\nexpect c1\n", 6, "what is expected is missing"},
        {HEAD "step a A\nplot probe x\nexpect c1 0.5\n", 6, "neither a range"},
        {HEAD "step a A\nplot probe x\nexpect c1 2..1\n", 6, "is empty"},
        {HEAD "step a A\nplot probe x\nexpect c1 10..20ms\n", 6, "each end has its own unit"},
        {HEAD "step a A\nplot probe x\nexpect c1 1..2q\n", 6, "range of two numbers"},
        {HEAD "step a A\nplot probe x\nexpect {c1} 1..2\n", 6, "without braces"},
        {HEAD "step a A\nplot probe x\nexpect c1 < much\n", 6, "neither a number"},
        {HEAD "step a A\nexpect c1 1..2\n", 5, "no command here"},
        {HEAD "step a A\ntext \xff\n", 5, "byte 0xFF"},
        {HEAD "step a A\ntext \x01\n", 5, "byte 0x01"},
        {HEAD "step a A\ntext \xc0\x80\n", 5, "byte 0xC0"},
        {HEAD "step a A\ntext \xed\xa0\x80\n", 5, "byte 0xED"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct vm_lesson l;
        struct crt_error err;
        char place[40];
        snprintf(place, sizeof place, "x/my.lesson:%d: ", cases[i].line);
        if (read_text(&l, cases[i].text, &err))
            fail_msg("case %zu was read: %s", i, cases[i].text);
        if (strncmp(err.text, place, strlen(place)) != 0 || !strstr(err.text, cases[i].says))
            fail_msg("case %zu: '%s' is not '%s…%s'", i, err.text, place, cases[i].says);
        vm_lesson_free(&l);
    }
}

static void limits_hold(void **state)
{
    struct vm_lesson l;
    struct crt_error err;
    size_t room = VM_LESSON_BYTES + 100;
    char *text = malloc(room);
    (void)state;
    assert_non_null(text);
    memset(text, '\n', room);
    assert_false(vm_lesson_read(&l, "m", text, VM_LESSON_BYTES + 1, &err));
    assert_non_null(strstr(err.text, "256 KiB"));
    size_t n = (size_t)sprintf(text, HEAD);
    for (int i = 0; i <= VM_LESSON_STEPS; i++)
        n += (size_t)sprintf(text + n, "step s%d S\n", i);
    assert_false(vm_lesson_read(&l, "m", text, n, &err));
    assert_non_null(strstr(err.text, "m:64: a lesson has at most 60 steps"));
    n = (size_t)sprintf(text, HEAD "step a A\n");
    for (int i = 4; i <= VM_LESSON_LINES; i++)
        n += (size_t)sprintf(text + n, "text t\n");
    assert_false(vm_lesson_read(&l, "m", text, n, &err));
    assert_non_null(strstr(err.text, "m:1001: a lesson has at most 1000"));
    assert_true(vm_lesson_read(&l, "m", text, n - 7, &err));
    assert_int_equal(l.lines, VM_LESSON_LINES);
    vm_lesson_free(&l);
    free(text);
}

/* ---- what is read is what was written -------------------------------------------------------- */

static void a_lesson_is_read(void **state)
{
    static const char text[] =
        "\xef\xbb\xbf# comment\ntitle  Phosphors \r\nsummary One\n\n\tline\norder 42\ntext a  b\n"
        "# between\n c\nstep one  Heading here\npicture capture roms/rose.df\ncaption Seen\n"
        "plot probe x --csv w.csv\nplot probe x -o own.png\ntable sweep\ntable list tubes --csv\n"
        "figures probe x\nlive run roms/rose.df\ncaption Watch\nlive run\nflashes at 20 Hz\n"
        "step two Two\ntext {one.c1:.2} {{µ}}\nlive run roms/spin.df\n";
    struct vm_lesson l;
    struct vm_lesson_live live;
    struct crt_error err;
    (void)state;
    if (!read_text(&l, text, &err))
        fail_msg("%s", err.text);
    assert_string_equal(l.name, "my");
    assert_string_equal(l.title, "Phosphors");
    assert_string_equal(l.summary, "One line");
    assert_int_equal(l.order, 42);
    assert_int_equal(l.head, 4);
    assert_int_equal(l.steps, 2);
    assert_string_equal(l.line[3].text, "a b c");
    assert_string_equal(l.step[0].name, "one");
    assert_string_equal(l.step[0].heading, "Heading here");
    const char *files[] = {"one.png", "", "one-2.png", "own.png", "one.txt", "one.csv", "", ""};
    for (int i = 0; i < 8; i++)
        assert_string_equal(l.line[l.step[0].first + i].file, files[i]);
    assert_string_equal(l.line[l.line[l.step[0].first].caption].text, "Seen");
    assert_true(vm_lesson_flashes(&l));
    assert_int_equal(vm_lesson_live_count(&l), 3);
    assert_true(vm_lesson_live(&l, 0, &live));
    assert_string_equal(live.caption, "Watch");
    assert_true(live.flashes);
    assert_true(vm_lesson_live(&l, 2, &live));
    assert_string_equal(live.command, "run roms/spin.df");
    assert_string_equal(live.caption, "Two");
    assert_false(live.flashes);
    assert_false(vm_lesson_live(&l, 3, &live));
    char *filled = vm_lesson_filled(&l, NULL, l.step[1].first, &err);
    assert_string_equal(filled, "[one.c1] {µ}");
    free(filled);
    vm_lesson_free(&l);
}

static void a_lesson_is_called_as_its_file(void **state)
{
    static const struct {
        const char *path, *name;
    } cases[] = {{"a/decay.lesson", "decay"},
                 {"My_First lesson.lesson", "my-first-lesson"},
                 {"../_x.lesson", "x"},
                 {"\xc3\xa9.lesson", "lesson"},
                 {".lesson", "lesson"},
                 {"a234567890123456789012345678901234567890123.lesson",
                  "a23456789012345678901234567890123456789"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static const char text[] = HEAD "step a A\n";
        struct vm_lesson l;
        struct crt_error err;
        assert_true(vm_lesson_read(&l, cases[i].path, text, strlen(text), &err));
        assert_string_equal(l.name, cases[i].name);
        vm_lesson_free(&l);
    }
}

/* Not into the text of the lesson itself, which is called as the lesson is. */
static void a_step_called_as_the_lesson_has_its_own_file(void **state)
{
    struct vm_lesson l;
    struct crt_error err;
    (void)state;
    assert_true(read_text(&l, HEAD "step my A\ntable calc refresh\n", &err));
    assert_string_equal(l.line[l.step[0].first].file, "my-2.txt");
    vm_lesson_free(&l);
}

/* Writes the lesson again, a line each. */
static void write_again(const struct vm_lesson *l, char *text)
{
    char *p = text;
    for (int i = 0; i < l->lines; i++)
        p += sprintf(p, "%s %s\n", vm_lesson_word_name(l->line[i].word), l->line[i].text);
}

static uint32_t random_state;
static uint32_t next_random(uint32_t below)
{
    random_state = random_state * 1664525 + 1013904223;
    return (random_state >> 8) % below;
}

static void any_bytes_are_read_or_refused(void **state)
{
    static const char seed[] =
        HEAD "text a {s.c1:.2}\n b\nstep s S\nplot probe roms/rose.df --at 1,2\n"
             "caption {c1} of µ\nexpect c1 < {refresh_hz} x\nlive run r\n"
             "flashes\nsays y\nnotes {mean_cd_m2:3}\n";
    static char text[512], again[2 * sizeof text];
    int read = 0;
    (void)state;
    random_state = 7;
    for (int n = 0; n < 20000; n++) {
        struct vm_lesson l, m;
        struct crt_error err;
        size_t length = sizeof seed - 1;
        memcpy(text, seed, length);
        for (uint32_t i = next_random(4); i > 0; i--)
            switch (next_random(3)) {
            case 0:
                text[next_random((uint32_t)length)] = (char)next_random(256);
                break;
            case 1:
                text[next_random((uint32_t)length)] = "\n {}:.#'\"=-"[next_random(11)];
                break;
            default:
                length = 1 + next_random((uint32_t)length);
            }
        if (!vm_lesson_read(&l, "fuzz", text, length, &err)) {
            int line = 0;
            if (sscanf(err.text, "fuzz:%d: ", &line) != 1 || line < 1)
                fail_msg("no place: %s", err.text);
            continue;
        }
        read++;
        write_again(&l, again);
        if (!vm_lesson_read(&m, "fuzz", again, strlen(again), &err))
            fail_msg("%s, of:\n%s", err.text, again);
        assert_int_equal(l.lines, m.lines);
        for (int i = 0; i < l.lines; i++) {
            assert_int_equal(l.line[i].word, m.line[i].word);
            assert_string_equal(l.line[i].text, m.line[i].text);
            assert_string_equal(l.line[i].file, m.line[i].file);
            assert_int_equal(l.line[i].caption, m.line[i].caption);
        }
        vm_lesson_free(&l);
        vm_lesson_free(&m);
    }
    assert_true(read > 2000 && read < 18000);
}

/* ---- commands -------------------------------------------------------------------------------- */

static void join(const struct vm_words *words, char *text)
{
    *text = '\0';
    for (int i = 0; i < words->count; i++)
        strcat(strcat(text, i ? "|" : ""), words->item[i]);
}

static void commands_are_started_elsewhere(void **state)
{
    static const struct vm_lesson_places places = {"/k/roms", "/out/my"};
    static const struct {
        const char *text, *started, *shown;
    } cases[] = {
        {"picture capture roms/rose.df --type 'circle 0 0 8'",
         "capture|/k/roms/rose.df|--type|circle 0 0 8|-o|/out/my/a.png",
         "kinescope capture roms/rose.df --type 'circle 0 0 8' -o a.png"},
        {"picture capture --firmware=roms/rt11.elf x.df -o b.png",
         "capture|--firmware=/k/roms/rt11.elf|x.df|-o|/out/my/b.png",
         "kinescope capture --firmware=roms/rt11.elf x.df -o b.png"},
        {"plot probe \"roms/a b.df\" --csv=w.csv",
         "probe|/k/roms/a b.df|--csv=/out/my/w.csv|--projector|-o|/out/my/a.png",
         "kinescope probe \"roms/a b.df\" --csv=w.csv --projector -o a.png"},
        {"table trace x.df -ow.txt --from 1s", "trace|x.df|-o/out/my/w.txt|--from|1s",
         "kinescope trace x.df -ow.txt --from 1s"},
        {"table disasm x.oct -o again.df", "disasm|x.oct|-o|/out/my/again.df",
         "kinescope disasm x.oct -o again.df"},
        {"table measure resolution --csv", "measure|resolution|--csv",
         "kinescope measure resolution --csv"},
        {"table calc mode 1024x768@60", "calc|mode|1024x768@60", "kinescope calc mode 1024x768@60"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[300], joined[300];
        struct vm_lesson l;
        struct vm_words words;
        struct crt_error err;
        snprintf(text, sizeof text, HEAD "step a A\n%s\n", cases[i].text);
        if (!read_text(&l, text, &err))
            fail_msg("%s", err.text);
        const struct vm_lesson_line *line = &l.line[l.step[0].first];
        assert_true(vm_lesson_command_start(line, &places, true, &words, &err));
        join(&words, joined);
        assert_string_equal(joined, cases[i].started);
        char *shown = vm_lesson_command_shown(line, true);
        assert_string_equal(shown, cases[i].shown);
        free(shown);
        vm_words_free(&words);
        vm_lesson_free(&l);
    }
}

/* ---- figures --------------------------------------------------------------------------------- */

static void json_is_read(void **state)
{
    static const char json[] =
        " {\"c1\": 0.445, \"a\": [1, {\"b\": -2.5e3}, []], \"t\": \"x \\\"y\\\" \\u00b5\", "
        "\"yes\": true, \"no\": false, \"none\": null, \"o\": {}}\n";
    struct vm_figures f;
    struct crt_error err;
    (void)state;
    assert_true(vm_figures_read(&f, json, &err));
    assert_int_equal(f.count, 7);
    assert_true(vm_figures_find(&f, "c1")->number == 0.445);
    assert_true(vm_figures_find(&f, "a.0")->number == 1);
    assert_true(vm_figures_find(&f, "a.1.b")->number == -2500);
    assert_string_equal(vm_figures_find(&f, "t")->text, "x \"y\" µ");
    assert_int_equal(vm_figures_find(&f, "none")->kind, VM_FIGURE_NONE);
    assert_null(vm_figures_find(&f, "a"));
    vm_figures_free(&f);
    static const char *const wrong[] = {
        "",           "[1]",        "{",     "{\"a\"",        "{\"a\":}",    "{\"a\":1",
        "{\"a\":1}x", "{\"a\":1,}", "{a:1}", "{\"a\":1e999}", "{\"a\":\"x}", "{\"a\":\"\\u00g0\"}",
        "{\"a\":[1}"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        if (vm_figures_read(&f, wrong[i], &err))
            fail_msg("%s was read", wrong[i]);
        vm_figures_free(&f);
    }
    char deep[100] = "{\"a\":";
    memset(deep + 5, '[', 60);
    assert_false(vm_figures_read(&f, deep, &err));
    vm_figures_free(&f);
}

/* All that can be in a text but control characters, which are read as spaces. */
static void texts_are_printed_as_json(void **state)
{
    char text[60], read[60], json[500];
    (void)state;
    random_state = 11;
    for (int n = 0; n < 300; n++) {
        struct vm_figures f;
        struct crt_error err;
        size_t length = next_random(sizeof text);
        for (size_t i = 0; i < length; i++) {
            text[i] = (char)(1 + next_random(255));
            if (next_random(3) == 0)
                text[i] = "\"\\\n/"[next_random(4)];
            read[i] = (unsigned char)text[i] < ' ' ? ' ' : text[i];
        }
        text[length] = read[length] = '\0';
        FILE *out = fmemopen(json, sizeof json, "w");
        assert_non_null(out);
        fputs("{\"t\": ", out);
        vm_json_text(out, text);
        fputs("}", out);
        fclose(out);
        for (const char *p = json; *p; p++)
            assert_true((unsigned char)*p >= ' ');
        if (!vm_figures_read(&f, json, &err))
            fail_msg("%s", err.text);
        assert_string_equal(vm_figures_find(&f, "t")->text, read);
        vm_figures_free(&f);
    }
}

/* Of UTF-8 whole characters are left. */
static void long_texts_are_cut(void **state)
{
    (void)state;
    for (size_t before = 0; before < 4; before++) {
        char json[1000] = "{\"t\": \"";
        struct vm_figures f;
        struct crt_error err;
        for (size_t i = 0; i < before; i++)
            strcat(json, "x");
        for (size_t i = 0; i < 150; i++)
            strcat(json, "\xe2\x82\xac");
        strcat(json, "\"}");
        assert_true(vm_figures_read(&f, json, &err));
        const char *text = vm_figures_find(&f, "t")->text;
        size_t n = strlen(text);
        assert_true(n > 240 && n < 256 && (n - before) % 3 == 0);
        assert_memory_equal(text, json + 7, n);
        vm_figures_free(&f);
    }
}

static void figures_are_formatted(void **state)
{
    static char name[] = "f", word[] = "low risk";
    static const struct {
        double v;
        const char *format, *text;
    } cases[] = {
        {0.4449, "", "0.445"},     {0.4449, ".2", "0.44"},   {60, "", "60"},
        {1234.5, "", "1234"},      {0.00034, "s", "340 µs"}, {0.15, "s", "150 ms"},
        {2.2, "s", "2.20 s"},      {5e-9, "s", "5.00 ns"},   {0.9999, "s", "1.00 s"},
        {31500, "Hz", "31.5 kHz"}, {60, "Hz", "60.0 Hz"},    {60, ".0Hz", "60 Hz"},
        {0.445, "%", "44.5 %"},    {0.445, ".0%", "44 %"},   {-0.0123456, "2", "-0.012"},
        {59.9402, ".2", "59.94"},  {0, "s", "0.00 s"},       {0.00034, "2s", "340 µs"},
    };
    char text[64];
    struct crt_error err;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct vm_figure f = {name, VM_FIGURE_NUMBER, cases[i].v, NULL};
        assert_true(vm_figure_format(&f, cases[i].format, text, sizeof text, &err));
        assert_string_equal(text, cases[i].text);
    }
    struct vm_figure f = {name, VM_FIGURE_TEXT, 0, word};
    assert_true(vm_figure_format(&f, "", text, sizeof text, &err));
    assert_string_equal(text, "low risk");
    assert_false(vm_figure_format(&f, ".2", text, sizeof text, &err));
    f.kind = VM_FIGURE_NONE;
    assert_true(vm_figure_format(&f, ".2", text, sizeof text, &err));
    assert_string_equal(text, "not applicable");
}

/* Two steps whose commands print figures; the lines to check are the last step's. */
static void expectations_are_checked(void **state)
{
    static const struct {
        const char *line;
        bool holds;
        const char *measured, *expected;
    } cases[] = {
        {"c1 0.43..0.46 first harmonic", true, "0.445", "0.43 to 0.46"},
        {"c1 0.445..0.5", true, "0.445", "0.445 to 0.5"},
        {"c1 0.45..0.46", false, "0.445", "0.45 to 0.46"},
        {"c1 40%..45%", true, "44.5 %", "40 % to 45 %"},
        {"p 330us..350us", true, "340 µs", "330 µs to 350 µs"},
        {"p > 1ms", false, "0.34 ms", "more than 1 ms"},
        {"p <= 340us", true, "340 µs", "at most 340 µs"},
        {"c1 < {one.c1}", true, "0.445", "less than one.c1, which is 1.2"},
        {"one.c1 >= {c1}", true, "1.2", "at least c1, which is 0.445"},
        {"2.c1 = 7", true, "7", "exactly 7"},
        {"t_s > {one.t_s}", true, "340.0 µs", "more than one.t_s, which is 33.00 ns"},
        {"flickers true", true, "yes", "yes"},
        {"flickers false", false, "yes", "no"},
        {"svm none", true, "not applicable", "not applicable"},
        {"c1 none", false, "0.445", "not applicable"},
        {"class = low", true, "low", "low"},
        {"class = high", false, "low", "high"},
        {"class < 3", false, "low", "a number"},
        {"nested.0.x 4..4", true, "4", "4 to 4"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[300];
        struct vm_lesson l;
        struct vm_lesson_results r;
        struct vm_expect_outcome o;
        struct crt_error err;
        snprintf(text, sizeof text,
                 HEAD "step one A\nfigures probe x\nstep two B\nfigures probe x\nfigures probe y\n"
                      "expect %s\n",
                 cases[i].line);
        if (!read_text(&l, text, &err))
            fail_msg("%s", err.text);
        assert_true(vm_lesson_results_init(&r, &l, "/out", &err));
        assert_true(vm_lesson_results_take(&r, 4, strdup("{\"c1\": 1.2, \"t_s\": 3.3e-8}"), &err));
        assert_true(vm_lesson_results_take(&r, 6,
                                           strdup("{\"c1\": 0.445, \"p\": 0.00034, \"t_s\": "
                                                  "0.00034, \"flickers\": true, \"svm\": null, "
                                                  "\"class\": \"low\", \"nested\": [{\"x\": 4}]}"),
                                           &err));
        assert_true(vm_lesson_results_take(&r, 7, strdup("{\"c1\": 7}"), &err));
        if (!vm_lesson_outcome(&r, l.lines - 1, &o, &err))
            fail_msg("%s: %s", cases[i].line, err.text);
        if (o.holds != cases[i].holds)
            fail_msg("%s: holds is %d", cases[i].line, o.holds);
        assert_string_equal(o.measured, cases[i].measured);
        assert_string_equal(o.expected, cases[i].expected);
        vm_lesson_results_free(&r);
        vm_lesson_free(&l);
    }
}

static void a_figure_that_is_missing_is_told(void **state)
{
    struct vm_lesson l;
    struct vm_lesson_results r;
    struct vm_expect_outcome o;
    struct crt_error err;
    (void)state;
    assert_true(
        read_text(&l, HEAD "step one A\nfigures probe x\nexpect c2 1..2\ntext {c3}\n", &err));
    assert_true(vm_lesson_results_init(&r, &l, "/out", &err));
    assert_true(vm_lesson_results_take(&r, 4, strdup("{\"c1\": 1.2, \"cff_hz\": 50}"), &err));
    assert_false(vm_lesson_outcome(&r, 5, &o, &err));
    assert_string_equal(err.text, "x/my.lesson:6: there is no figure 'c2'; step one has c1 cff_hz");
    assert_null(vm_lesson_filled(&l, &r, 6, &err));
    assert_non_null(strstr(err.text, "my.lesson:7: there is no figure 'c3'"));
    vm_lesson_results_free(&r);
    vm_lesson_free(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_have_a_line),
        cmocka_unit_test(limits_hold),
        cmocka_unit_test(a_lesson_is_read),
        cmocka_unit_test(a_lesson_is_called_as_its_file),
        cmocka_unit_test(a_step_called_as_the_lesson_has_its_own_file),
        cmocka_unit_test(any_bytes_are_read_or_refused),
        cmocka_unit_test(commands_are_started_elsewhere),
        cmocka_unit_test(json_is_read),
        cmocka_unit_test(texts_are_printed_as_json),
        cmocka_unit_test(long_texts_are_cut),
        cmocka_unit_test(figures_are_formatted),
        cmocka_unit_test(expectations_are_checked),
        cmocka_unit_test(a_figure_that_is_missing_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
